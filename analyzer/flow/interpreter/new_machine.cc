#include "analyzer/flow/interpreter/new_machine.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "analyzer/flow/domain/modes.h"
#include "analyzer/flow/facts/accesses.h"

namespace owlint::flow {
namespace {

/// What the lines so far do with one number.
struct NumberUse {
  bool read = false;       ///< before all that set it
  bool elsewhere = false;  ///< in a sub, which reads what may have been set before its call
  bool set = false;
};

/// Those of `numbers` (sorted) that a line reads before any sets them.
std::vector<uint32_t> read_before_set(const Program& program, const std::vector<uint32_t>& numbers) {
  std::vector<NumberUse> uses(numbers.size());
  const auto use_of = [&](ParameterKey key) -> NumberUse* {
    if (key == kComputedKey) return nullptr;
    const ParameterKey number = key & ~kGlobalKey;
    const auto at = std::ranges::lower_bound(numbers, number);
    return at != numbers.end() && *at == number ? &uses[static_cast<size_t>(at - numbers.begin())] : nullptr;
  };
  std::vector<StatementId> lines(program.size());
  std::iota(lines.begin(), lines.end(), 0);
  const AccessTable table(program, lines);
  const Accesses all = table.lines(0, lines.size());
  for (StatementId id = 0; id < lines.size(); ++id) {
    const bool of_main = program.region_of[id] == kMainRegion;
    for (const ParameterKey key : all.reads(id)) {
      NumberUse* use = use_of(key);
      if (use == nullptr || use->set) continue;
      if (of_main) use->read = true;
      if (!of_main && !is_own_number(key)) use->elsewhere = true;
    }
    for (const Write& write : all.writes(id)) {
      if (NumberUse* use = use_of(write.key)) use->set = true;
    }
  }
  std::vector<uint32_t> read;
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (uses[i].read || (uses[i].elsewhere && !uses[i].set)) read.push_back(numbers[i]);
  }
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
  return read_before_set(program, numbers);
}

void begin_on_new_machine(std::span<const uint32_t> numbers, Parameters& p, Evaluator& evaluator,
                          PersistentMap::Pool& pool) {
  for (const uint32_t number : numbers) evaluator.set_number(p, number, evaluator.values().intern(0));
  p.globals.set(pool, kNewMachineKey, evaluator.values().intern(1));
}

bool is_on_new_machine(const Parameters& p) { return KnownValues::is_constant(p.globals.get(kNewMachineKey)); }

}  // namespace owlint::flow
