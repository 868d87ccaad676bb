// The states at a line: kept apart while they are few, then joined.
#include <catch2/catch.hpp>

#include "support/analysis.h"

using namespace owlint;
using namespace owlint::flow;

namespace {

State at_first_line(test::Engine& engine, double value) {
  State state;
  engine.machine.evaluator().set_name(state.parameters, engine.source.program->syntax.names.find("a"),
                                      engine.machine.evaluator().values().intern(value));
  return state;
}

/// Takes a state in as the iteration does; true if it is kept apart.
bool arrive(test::Engine& engine, const State& state) {
  Partition& partition = engine.partitions.at(state);
  if (engine.partitions.joins(state, partition)) {
    engine.partitions.join(state, partition);
    return false;
  }
  partition.seen.emplace_back(state.hash(), 0);
  return true;
}

}  // namespace

TEST_CASE("states in another mode are another partition", "[engine]") {
  test::Engine engine("#<a> = 1\no1 if [#<a> EQ 2]\no1 endif\nM2\n");
  State state;
  Partition& plain = engine.partitions.at(state);
  CHECK(&engine.partitions.at(state) == &plain);
  State looped = state;
  looped.looped = true;
  State called = state;
  called.context = 4;
  State skipping = state;
  skipping.skip = 1;
  CHECK(&engine.partitions.at(looped) != &plain);
  CHECK(&engine.partitions.at(called) != &plain);
  Partition& skipped = engine.partitions.at(skipping);
  CHECK(&skipped != &plain);
  // While lines are skipped, a branch that was taken has assigned what others have not.
  skipping.flags.executed = kYes;
  CHECK(&engine.partitions.at(skipping) != &skipped);
  State other_values = state;
  other_values.flags.executed = kYes;
  CHECK(&engine.partitions.at(other_values) == &plain);
}

TEST_CASE("a partition is found again where there are many", "[engine]") {
  test::Engine engine("M2\n");
  State state;
  std::vector<uint32_t> numbers;
  for (state.context = 0; state.context < 40; ++state.context) numbers.push_back(engine.partitions.at(state).number);
  for (state.context = 0; state.context < 40; ++state.context)
    CHECK(engine.partitions.at(state).number == numbers[state.context]);
  CHECK(engine.partitions.all().size() == 40);
}

TEST_CASE("the first states are kept apart, the rest is one join", "[engine]") {
  test::Engine engine("#<a> = 1\no1 if [#<a> EQ 2]\no1 endif\nM2\n", test::at_most(2, 2));
  CHECK(arrive(engine, at_first_line(engine, 1)));
  CHECK(arrive(engine, at_first_line(engine, 2)));
  CHECK_FALSE(arrive(engine, at_first_line(engine, 3)));
  CHECK_FALSE(arrive(engine, at_first_line(engine, 4)));
  CHECK(engine.partitions.joined_states() == 2);
  const std::vector<uint32_t> joined = engine.partitions.take_joined();
  REQUIRE(joined.size() == 1);
  CHECK(engine.partitions.take_joined().empty());
  const Partition& partition = engine.partitions[joined[0]];
  REQUIRE(partition.joined != nullptr);
  CHECK(partition.joined->joined);
}

TEST_CASE("a state for which an operation will fail is kept apart longer", "[engine]") {
  test::Engine engine("#<a> = 1\n#<b> = [10 / [#<a> - 3]]\nM2\n", test::at_most(2, 2));
  CHECK(arrive(engine, at_first_line(engine, 1)));
  CHECK(arrive(engine, at_first_line(engine, 2)));
  CHECK_FALSE(arrive(engine, at_first_line(engine, 4)));
  CHECK(arrive(engine, at_first_line(engine, 3)));
}
