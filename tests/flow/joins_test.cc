// Where states are joined nothing may be lost but precision. Each program is followed with the usual limits, and again with
// so small ones that two states at a line are already joined: every stop must still be there, and one that not every
// run makes may not become one that every run makes.
#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <tuple>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/flow/verdicts/analyze.h"
#include "analyzer/text/memory_files.h"
#include "support/analysis.h"
#include "support/damage.h"

using namespace owlint;

namespace {

struct Stop {
  Reach reach;
  bool of_values;  ///< only some values make it: it is not seen where these are joined with others (README, "Limits")
};
using Stops = std::map<std::tuple<StatementId, StatementId, StopKind, std::string>, Stop>;

FlowResult analyzed(const std::shared_ptr<const Program>& program, const flow::Limits& limits) {
  const MemoryFiles files;  // none: a program is analysed alone
  Library library(files);
  Linked linked(program, {}, library);
  return std::move(analyze_flow(linked, {}, Detail::kBySize, nullptr, limits).front());
}

bool is_of_values(const FlowStop& stop) {
  constexpr std::array kKinds = {StopKind::kValueFails,      StopKind::kParameterRange,   StopKind::kParameterReadOnly,
                                 StopKind::kLabelNotInteger, StopKind::kM98Words,         StopKind::kNumberOutOfRange,
                                 StopKind::kArcRadiiDiffer,  StopKind::kArcRadiusTooSmall};
  // Of the other kinds, those for which it matters where the machine stands, or which spindle a number is.
  constexpr std::array kMessages = {"R less than", "polar coordinate", "Start point too close", "rotary axes with G76",
                                    "Invalid spindle"};
  return std::ranges::find(kKinds, stop.kind) != kKinds.end() || stop.words.arc != nullptr ||
      std::ranges::any_of(kMessages,
                          [&](const char* part) { return stop.interpreter.find(part) != std::string::npos; });
}

Stops stops_of(const FlowResult& result) {
  Stops out;
  for (const FlowStop& stop : result.stops)
    out[{stop.statement, stop.end_of, stop.kind, stop.detail}] = {stop.reach, is_of_values(stop)};
  return out;
}

/// A call whose label is joined from many values calls no sub that is followed (README, "Limits").
bool computes_labels(const Program& program) {
  return std::ranges::any_of(program.syntax.statements, [](const Statement& s) { return s.label_expr != kNoExpr; });
}

struct Compared {
  size_t stops = 0;
  size_t merges = 0;
};

void check_sound(const std::string& name, const std::string& text, const flow::Limits& limits, Compared& count) {
  const MemoryFiles files;  // none: a program is analysed alone
  Library library(files);
  const auto program = library.load(Source::own("joins.ngc", text));
  if (computes_labels(*program)) return;
  const FlowResult precise = analyzed(program, {});
  const FlowResult joined = analyzed(program, limits);
  const Stops all = stops_of(joined);
  std::string wrong;
  // Where a stop that only some values make is not seen, the lines behind it seem to be those of every run.
  const Stops expected = stops_of(precise);
  const bool sees_values = std::ranges::all_of(
      expected, [&](const auto& entry) { return !entry.second.of_values || all.contains(entry.first); });
  for (const auto& [stop, seen] : expected) {
    const auto& [statement, end, kind, detail] = stop;
    if (seen.of_values) continue;
    const auto found = all.find(stop);
    const auto what = fmt::format("stop {} at statement {} ({}, {})", static_cast<int>(kind), statement, end, detail);
    if (found == all.end())
      wrong += what + " is lost\n";
    else if (sees_values && seen.reach != Reach::kAlways && found->second.reach == Reach::kAlways)
      wrong += what + " is said to be every run's\n";
    ++count.stops;
  }
  for (StatementId id = 0; id < precise.executed.size(); ++id) {
    if (precise.executed[id] && !joined.executed[id]) wrong += fmt::format("statement {} is not executed\n", id);
  }
  if (precise.ends && !joined.ends) wrong += "no run comes to an end\n";
  count.merges += joined.statistics.merges;
  if (wrong.empty()) return;
  INFO(name << '\n' << text);
  CHECK(wrong == "");
}

}  // namespace

TEST_CASE("joining states and calls early loses no stop", "[joins]") {
  Compared count;
  for (const auto& [name, text] : test::all_programs()) {
    check_sound(name, text, test::at_most(2, 2), count);
    check_sound(name, text, test::at_most(1, 1), count);
  }
  CHECK(count.stops > 500);
  CHECK(count.merges > 500);
}

TEST_CASE("joining states and calls of damaged programs early loses no stop", "[joins]") {
  std::mt19937 random(20261129);
  const auto all = test::all_programs();
  Compared count;
  for (int i = 0; i < 3000; ++i) {
    const auto& [name, text] = all[std::uniform_int_distribution<size_t>(0, all.size() - 1)(random)];
    check_sound(name, test::damaged(text, random), test::at_most(2, 2), count);
  }
  CHECK(count.merges > 1000);
}
