// The fixpoint iteration, seen by what it reports.
#include <catch2/catch.hpp>

#include "support/analysis.h"

using namespace owlint;
using namespace owlint::flow;

namespace {

struct Recorder final : Events {
  void stop(const State& at, StopReport report) override { stops.emplace_back(at.position, report.kind); }
  void hazard(const State& at, HazardReport report) override { hazards.emplace_back(at.position, report.kind); }
  void end(const State& at) override { ends.push_back(at.position); }
  void end_of_file(const State& at) override { file_ends.push_back(at.position); }

  std::vector<std::pair<StatementId, StopKind>> stops;
  std::vector<std::pair<StatementId, HazardKind>> hazards;
  std::vector<StatementId> ends, file_ends;
};

struct Ran {
  explicit Ran(const std::string& text, Limits given = {}, Detail detail = Detail::kBySize)
      : limits(given), source(text), analysis(source.linked, source.profile, detail, nullptr, limits) {
    analysis.run(events);
  }

  Limits limits;
  test::LinkedText source;
  Iteration analysis;
  Recorder events;
};

const std::string kBranches =
    "#1 = #5061\n"  // a probe result: not known
    "o1 if [#1 GT 0]\n  #<a> = 1\no1 else\n  #<a> = 2\no1 endif\n"
    "o2 if [#<a> EQ 1]\n  o3 break\no2 endif\nM2\n";

}  // namespace

TEST_CASE("both branches are followed, each to its end", "[engine]") {
  const Ran ran(kBranches);
  CHECK(ran.events.stops == std::vector<std::pair<StatementId, StopKind>>{{7, StopKind::kLabelUndefined}});
  CHECK(ran.events.ends == std::vector<StatementId>{9});
  CHECK(ran.analysis.statistics().merges == 0);
  CHECK(ran.analysis.statistics().steps == ran.analysis.trace()->size());
}

TEST_CASE("joined, the same lines are reached in fewer steps", "[engine]") {
  const Ran precise(kBranches);
  const Ran joined(kBranches, test::at_most(1, 1));
  CHECK(joined.analysis.statistics().merges > 0);
  CHECK(joined.analysis.trace()->executed() == precise.analysis.trace()->executed());
  CHECK(joined.events.stops.size() >= precise.events.stops.size());
}

TEST_CASE("a loop whose variable grows comes to rest", "[engine]") {
  const Ran ran("#1 = 0\no1 while [#1 LT 1000000]\n  #1 = [#1 + 1]\no1 endwhile\nM2\n");
  CHECK(ran.events.ends.size() >= 1);
  CHECK(ran.analysis.statistics().steps < 2'000);
}

TEST_CASE("at the last level, harmless lines are one step", "[engine]") {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "#<a> = [#<b> + 1]\n#<b> = [#<a> + 1]\n";
  text = "#<b> = 1\n" + text + "M2\n";
  const Ran stepwise(text, {}, Detail::kStepwise);
  const Ran coarse(text, {}, Detail::kCoarse);
  CHECK(coarse.analysis.statistics().steps * 10 < stepwise.analysis.statistics().steps);
  CHECK(coarse.analysis.trace()->executed() == stepwise.analysis.trace()->executed());
}

TEST_CASE("the end of a file is an event of its own", "[engine]") {
  const Ran ran("o1 if [#5061]\n");
  CHECK(ran.events.ends.empty());
  CHECK_FALSE(ran.events.file_ends.empty());
}
