// From the fixpoint to stops and hazards: what is collected, and how often.
#include <catch2/catch.hpp>

#include "analyzer/flow/verdicts/verdicts.h"
#include "support/analysis.h"

using namespace owlint;
using namespace owlint::flow;

namespace {

FlowResult verdicts_of(const std::string& text, const Limits& limits = {}) {
  test::LinkedText source(text);
  Iteration analysis(source.linked, source.profile, Detail::kBySize, nullptr, limits);
  Verdicts verdicts(analysis);
  analysis.run(verdicts);
  return verdicts.finish();
}

}  // namespace

TEST_CASE("a stop is found once, and is proven if one of its states is", "[verdicts]") {
  test::Engine engine("M2\n");
  Stops stops(engine.source.linked, engine.trace);
  const RecordId first = engine.trace.add({});
  const RecordId second = engine.trace.add({});
  FlowStop stop;
  stop.statement = 0;
  stop.kind = StopKind::kWrongEnd;
  stop.unproven = true;
  stop.interpreter = std::string(1000, 'x');
  const uint32_t key = stops.add(first, stop);
  CHECK(key != kNormalEnd);
  stop.unproven = false;
  CHECK(stops.add(second, stop) == key);
  stop.detail = "name";
  CHECK(stops.add(second, stop) != key);
  REQUIRE(std::distance(stops.begin(), stops.end()) == 2);
  const Stops::Found& found = stops.begin()->second;
  CHECK_FALSE(found.stop.unproven);
  CHECK(found.record == second);
  CHECK(found.stop.interpreter.size() == 254);
}

TEST_CASE("hazards are found once by kind and places", "[verdicts]") {
  Hazards hazards;
  Hazard hazard = hazard_at(HazardKind::kStaleBreak, 3, 5);
  hazard.unproven = true;
  hazards.add(hazard);
  hazard.unproven = false;
  hazards.add(hazard);
  hazards.add(hazard_at(HazardKind::kStaleBreak, 3, 6));
  CHECK(std::distance(hazards.begin(), hazards.end()) == 2);
  CHECK_FALSE(hazards.begin()->second.unproven);
  CHECK(hazards.has(HazardKind::kStaleBreak));
  CHECK_FALSE(hazards.has(HazardKind::kHang));
}

TEST_CASE("a stop on one branch is maybe, with the branch as its path", "[verdicts]") {
  const FlowResult result = verdicts_of("o1 if [#5061 GT 0]\n  o2 endif\no1 endif\nM2\n");
  REQUIRE(result.stops.size() == 1);
  CHECK(result.stops[0].reach == Reach::kMaybe);
  REQUIRE(result.stops[0].path.size() == 1);
  CHECK(result.stops[0].path[0].statement == 0);
  CHECK(result.stops[0].path[0].taken);
  CHECK(result.ends);
}

TEST_CASE("a stop of every run has no path", "[verdicts]") {
  const FlowResult result = verdicts_of("o2 endif\nM2\n");
  REQUIRE(result.stops.size() == 1);
  CHECK(result.stops[0].reach == Reach::kAlways);
  CHECK(result.stops[0].path.empty());
  CHECK_FALSE(result.ends);
}

TEST_CASE("with a small budget a path shows its last decisions", "[verdicts]") {
  std::string text;
  for (int i = 1; i <= 6; ++i) text += "o" + std::to_string(i) + " if [#" + std::to_string(5060 + i) + " GT 0]\n";
  text += "o9 endif\n";
  for (int i = 6; i >= 1; --i) text += "o" + std::to_string(i) + " endif\n";
  text += "M2\n";
  Limits limits;
  limits.shown_decisions = 2;
  REQUIRE(verdicts_of(text).stops.size() == 1);
  CHECK(verdicts_of(text).stops[0].path.size() == 6);
  const FlowResult few = verdicts_of(text, limits);
  REQUIRE(few.stops[0].path.size() == 2);
  CHECK(few.stops[0].path[1].statement == 5);
  limits.paths = 0;
  CHECK(verdicts_of(text, limits).stops[0].path.empty());
}

TEST_CASE("an endless loop is a hazard, and no run ends", "[verdicts]") {
  const FlowResult result = verdicts_of("o1 while [1]\n  #1=1\no1 endwhile\nM2\n");
  REQUIRE(result.hazards.size() == 1);
  CHECK(result.hazards[0].kind == HazardKind::kEndlessLoop);
  CHECK(result.hazards[0].statement == 0);
  CHECK_FALSE(result.ends);
}
