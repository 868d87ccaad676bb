#include "analyzer/flow/interpreter/new_machine.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "analyzer/flow/domain/modes.h"
#include "analyzer/flow/facts/accesses.h"

namespace owlint::flow {
namespace {

/// Of each numbered parameter, whether a line reads it that comes before all that set it.
std::vector<bool> read_before_set(const Program& program) {
  std::vector<bool> read(kLastNumber + 1), set(kLastNumber + 1), elsewhere(kLastNumber + 1);
  const auto number_of = [](ParameterKey key) { return key == kComputedKey ? kLastNumber + 1 : key & ~kGlobalKey; };
  std::vector<StatementId> lines(program.size());
  std::iota(lines.begin(), lines.end(), 0);
  const AccessTable table(program, lines);
  const Accesses all = table.lines(0, lines.size());
  for (StatementId id = 0; id < lines.size(); ++id) {
    const bool of_main = program.region_of[id] == kMainRegion;
    for (const ParameterKey key : all.reads(id)) {
      const auto number = number_of(key);
      if (number > kLastNumber || set[number]) continue;
      // A sub has numbers of its own, and of the others it reads what may have been set before its call.
      if (of_main) read[number] = true;
      if (!of_main && !is_own_number(key)) elsewhere[number] = true;
    }
    for (const Write& write : all.writes(id)) {
      if (const auto number = number_of(write.key); number <= kLastNumber) set[number] = true;
    }
  }
  for (size_t number = 0; number < read.size(); ++number)
    read[number] = read[number] || (elsewhere[number] && !set[number]);
  return read;
}

}  // namespace

std::vector<uint32_t> read_and_not_set(const Program& program, const TrackedParameters& tracked) {
  std::vector<uint32_t> numbers;
  if (tracked.computes_targets()) return numbers;
  std::ranges::copy_if(tracked.numbers(), std::back_inserter(numbers),
                       [](uint32_t number) { return number < kFirstVolatileNumber; });
  if (numbers.empty()) return numbers;
  std::ranges::sort(numbers);
  const std::vector<bool> read = read_before_set(program);
  std::erase_if(numbers, [&](uint32_t number) { return !read[number]; });
  return numbers;
}

void begin_on_new_machine(std::span<const uint32_t> numbers, Parameters& p, Evaluator& evaluator,
                          PersistentMap::Pool& pool) {
  for (const uint32_t number : numbers) evaluator.set_number(p, number, evaluator.values().intern(0));
  p.globals.set(pool, kNewMachineKey, evaluator.values().intern(1));
}

bool is_on_new_machine(const Parameters& p) { return KnownValues::is_constant(p.globals.get(kNewMachineKey)); }

}  // namespace owlint::flow
