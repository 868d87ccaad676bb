// Which numbers are 0 on a machine that was just started, and what is read where it stands.
#include <catch2/catch.hpp>

#include "analyzer/flow/interpreter/new_machine.h"
#include "support/analysis.h"

using namespace owlint;
using namespace owlint::flow;

namespace {

std::vector<uint32_t> unset_of(const std::string& text) {
  const test::Engine engine(text);
  return read_and_not_set(*engine.source.program, engine.machine.tracked());
}

using UnsetNumbers = std::vector<uint32_t>;

}  // namespace

TEST_CASE("numbers that are read and not set begin with 0", "[new_machine]") {
  CHECK(unset_of("o1 if [#100 GT 1]\no1 endif\nM2\n") == UnsetNumbers{100});
  CHECK(unset_of("o1 if [#100 GT #2]\no1 endif\nM2\n") == UnsetNumbers{2, 100});
  CHECK(unset_of("#100 = 1\no1 if [#100 GT 1]\no1 endif\nM2\n").empty());
  CHECK(unset_of("o1 if [#100 GT 1]\no1 endif\n#100 = 1\nM2\n") == UnsetNumbers{100});
}

TEST_CASE("a sub has numbers of its own, and reads what may have been set before its call", "[new_machine]") {
  CHECK(unset_of("o<f> sub\n  o1 if [#1 GT #100]\n  o1 endif\no<f> endsub\no<f> call\nM2\n") == UnsetNumbers{100});
  CHECK(unset_of("o<f> sub\n  o1 if [#100 GT 1]\n  o1 endif\no<f> endsub\n#100 = 1\no<f> call\nM2\n").empty());
}

TEST_CASE("numbers that the machine keeps, and those of which one is computed, are not known", "[new_machine]") {
  CHECK(unset_of("o1 if [#5399 GT #5221]\no1 endif\nM2\n").empty());
  CHECK(unset_of("#[#3 + 1] = 1\no1 if [#100 GT 1]\no1 endif\nM2\n").empty());
}

TEST_CASE("numbers on whose values nothing depends are none of them", "[new_machine]") {
  CHECK(unset_of("G0 X#100\nM2\n").empty());
}

TEST_CASE("a run is known for one on a new machine until it is joined with another", "[new_machine]") {
  test::Engine engine("o1 if [#100 GT 1]\no1 endif\nM2\n");
  State any, started;
  Evaluator& evaluator = engine.machine.evaluator();
  begin_on_new_machine(UnsetNumbers{100}, started.parameters, evaluator, engine.pool);
  CHECK_FALSE(is_on_new_machine(any.parameters));
  CHECK(is_on_new_machine(started.parameters));
  CHECK(evaluator.values().value(started.parameters.globals.get(100)) == 0);
  StateDomain states(evaluator.values(), engine.machine.definers(), engine.pool);
  CHECK_FALSE(is_on_new_machine(states.join(any, started).parameters));
}
