#include "rules/driver/behind_stops.h"

#include <algorithm>

#include "analyzer/syntax/last_statement.h"
#include "rules/driver/stops.h"

namespace owlint::rules {
namespace {

bool calls(const Statement& s) { return s.calls() || s.runs_remap(); }

/// A text without what stands in backticks, which differs between places of one mistake.
std::string without_code(std::string_view text) {
  std::string out;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (!code) out += c;
  }
  return out;
}

}  // namespace

const FlowStop* stop_that_ends_all(const FlowResult& flow) {
  const auto stop = std::ranges::find_if(
      flow.stops, [](const FlowStop& s) { return s.reach == Reach::kAlways && s.kind != StopKind::kFileEnd; });
  return stop == flow.stops.end() ? nullptr : &*stop;
}

StatementId stop_of_every_run(const FlowResult& flow) {
  const FlowStop* const stop = stop_that_ends_all(flow);
  return stop == nullptr ? kNoStatement : stop->statement;
}

std::string group_behind(const Finding& finding, const FlowStop& stop) {
  const std::string own = finding.group.empty() ? stop.interpreter + '\n' + without_code(finding.help) : finding.group;
  return std::string(kBehind) + own;
}

BehindStops::BehindStops(const Program& program, const FlowResult& flow)
    : program_(program), flow_(flow), stop_(stop_of_every_run(flow)) {
  if (stop_ == kNoStatement) return;
  behind_.resize(program.size());
  follow_lines();
  follow_calls();
}

/// Down through the main program, and through the sub that stops.
void BehindStops::follow_lines() {
  std::vector<StatementId> last(program_.regions.size(), kNoStatement);  // the last line that runs
  std::vector<bool> over(program_.regions.size());
  for (StatementId id = 0; id < program_.size(); ++id) {
    const RegionId region = program_.region_of[id];
    const Statement& s = program_.at(id);
    if (flow_.executed[id]) last[region] = id;
    if (flow_.executed[id] || over[region] || last[region] == kNoStatement) continue;
    const bool in_call = calls(program_.at(last[region])) && program_.region_of[stop_] != region;
    if (s.line == program_.at(stop_).line && region == program_.region_of[stop_])
      continue;  // further mistakes of its line
    behind_[id] = last[region] == stop_ || in_call;
    const bool ends = s.kind == LineKind::kProgramEnd || s.kind == LineKind::kPercent || s.kind == LineKind::kFileEnd;
    over[region] = behind_[id] && ends && program_.block_of[id] == kNoBlock && !s.block_delete;
  }
}

/// Into the subs that only such lines call.
void BehindStops::follow_calls() {
  std::vector<RegionId> entered;
  std::vector<bool> known(program_.regions.size());
  known[kMainRegion] = true;
  const auto enter = [&](const Call& call) {
    if (call.target == kNoRegion || known[call.target]) return;
    known[call.target] = true;
    const StatementId body = program_.regions[call.target].opener + 1;
    const bool has_run = body < program_.size() && program_.region_of[body] == call.target && flow_.executed[body];
    if (!has_run) entered.push_back(call.target);
  };
  std::vector<std::vector<const Call*>> calls_of(program_.regions.size());
  for (const Call& call : program_.calls) {
    calls_of[call.caller].push_back(&call);
    if (behind_[call.statement]) enter(call);
  }
  std::vector<bool> runs(program_.regions.size());
  for (size_t i = 0; i < entered.size(); ++i) {
    runs[entered[i]] = true;
    for (const Call* call : calls_of[entered[i]]) enter(*call);
  }
  for (StatementId id = 0; id < program_.size(); ++id) {
    if (runs[program_.region_of[id]]) behind_[id] = true;
  }
}

bool BehindStops::contains_line(uint64_t offset) const {
  if (behind_.empty()) return false;
  const StatementId id = last_statement(program_.syntax, offset);
  return id != kNoStatement && (behind_[id] || (id == stop_ && offset > program_.at(id).end()));
}

}  // namespace owlint::rules
