#include "analyzer/flow/interpreter/new_machine.h"

#include <algorithm>
#include <iterator>

#include "analyzer/flow/domain/modes.h"
#include "analyzer/flow/facts/accesses.h"

namespace owlint::flow {
namespace {

/// Whether the main program itself reads each of these numbers below kFirstGlobalNumber: a sub has its own.
std::vector<bool> read_in_main(const Program& program) {
  std::vector<bool> read(kFirstGlobalNumber);
  std::vector<uint32_t> lines;
  for (StatementId id = 0; id < program.size(); ++id) {
    if (program.region_of[id] == kMainRegion) lines.push_back(id);
  }
  const AccessTable table(program, lines);
  for (const ParameterKey key : table.lines(0, lines.size()).all_reads()) {
    if (is_own_number(key)) read[key] = true;
  }
  return read;
}

}  // namespace

std::vector<uint32_t> read_and_never_set(const Program& program, const TrackedParameters& tracked) {
  std::vector<uint32_t> numbers;
  if (tracked.computes_targets()) return numbers;
  std::ranges::copy_if(tracked.numbers(), std::back_inserter(numbers),
                       [](uint32_t number) { return number < kFirstVolatileNumber; });
  if (numbers.empty()) return numbers;
  std::ranges::sort(numbers);
  std::vector<bool> set(kLastNumber + 1);
  for (const Item& item : program.syntax.items) {
    if (item.target == kNoExpr) continue;
    if (const ParameterKey key = key_of_number(program.syntax, item.target); key != kComputedKey)
      set[key & ~kGlobalKey] = true;
  }
  std::erase_if(numbers, [&](uint32_t number) { return set[number]; });
  if (numbers.empty() || numbers.front() >= kFirstGlobalNumber) return numbers;
  const std::vector<bool> read = read_in_main(program);
  std::erase_if(numbers, [&](uint32_t number) { return number < kFirstGlobalNumber && !read[number]; });
  return numbers;
}

void begin_on_new_machine(std::span<const uint32_t> numbers, Parameters& p, Evaluator& evaluator,
                          PersistentMap::Pool& pool) {
  for (const uint32_t number : numbers) evaluator.set_number(p, number, evaluator.values().intern(0));
  p.globals.set(pool, kNewMachineKey, evaluator.values().intern(1));
}

bool is_on_new_machine(const Parameters& p) { return KnownValues::is_constant(p.globals.get(kNewMachineKey)); }

}  // namespace owlint::flow
