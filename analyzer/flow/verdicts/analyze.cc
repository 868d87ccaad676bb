#include "analyzer/flow/verdicts/analyze.h"

#include "analyzer/flow/engine/iteration.h"
#include "analyzer/flow/engine/known_calls.h"
#include "analyzer/flow/engine/reachability.h"
#include "analyzer/flow/verdicts/verdicts.h"

namespace owlint {
namespace {

/// Splits the result for a joined program into those of its files.
std::vector<FlowResult> by_file(const Linked& linked, FlowResult result) {
  const auto& files = linked.files();
  std::vector<FlowResult> out(files.size());
  if (files.size() == 1) {
    out[0] = std::move(result);
    return out;
  }
  for (size_t i = 0; i < files.size(); ++i) {
    const LinkedFile& file = files[i];
    out[i].first = file.first;
    out[i].reachability = result.reachability;
    out[i].ends = result.ends;
    out[i].executed.assign(result.executed.begin() + file.first, result.executed.begin() + file.last);
  }
  out[0].statistics = result.statistics;
  out[0].learned = std::move(result.learned);
  // Moves a statement number into its file, or out of it if that is another file than `home`.
  const auto localize = [&](uint32_t home, StatementId* id, Elsewhere* elsewhere) {
    if (*id == kNoStatement) return;
    const uint32_t file = linked.file_of(*id);
    const StatementId local = *id - files[file].first;
    *id = file == home ? local : kNoStatement;
    if (file != home) *elsewhere = {files[file].program.get(), local};
  };
  for (FlowStop& stop : result.stops) {
    const StatementId place = stop.statement != kNoStatement ? stop.statement : stop.end_of;
    const uint32_t home = place == kNoStatement ? 0 : linked.file_of(place);
    if (stop.statement != kNoStatement) stop.statement -= files[home].first;
    localize(home, &stop.other, &stop.other_elsewhere);
    localize(home, &stop.call, &stop.call_elsewhere);
    Elsewhere end;  // of a file that was called: nobody asks
    localize(home, &stop.end_of, &end);
    for (Decision& decision : stop.path) {
      const uint32_t file = linked.file_of(decision.statement);
      decision.statement -= files[file].first;
      if (file != home) decision.program = files[file].program.get();
    }
    out[home].stops.push_back(std::move(stop));
  }
  for (Hazard& hazard : result.hazards) {
    const uint32_t home = linked.file_of(hazard.statement);
    hazard.statement -= files[home].first;
    localize(home, &hazard.other, &hazard.other_elsewhere);
    out[home].hazards.push_back(std::move(hazard));
  }
  return out;
}

}  // namespace

Reach FlowResult::reach(StatementId statement) const { return reachability->reach(first + statement); }

std::vector<FlowResult> analyze_flow(Linked& linked, const Profile& profile, Detail detail, flow::KnownCalls* known,
                                     const flow::Limits& limits) {
  for (int round = 1;; ++round) {
    flow::Iteration analysis(linked, profile, detail, known, limits);
    flow::Verdicts verdicts(analysis);
    analysis.run(verdicts, flow::Machines::kAlsoNew);
    FlowResult result = verdicts.finish();
    bool grown = false;
    for (const std::string& name : analysis.computed_calls()) grown |= linked.add(name);
    if (grown && round < limits.rounds) continue;
    if (linked.files().size() == 1)
      result.structure = std::make_shared<const flow::Structure>(analysis.machine().structure());
    return by_file(linked, std::move(result));
  }
}

bool remember(const FlowResult& result, flow::KnownCalls& known) {
  if (result.reachability->missed()) {
    known.clear();
    return false;
  }
  if (result.learned == nullptr) return true;
  for (flow::LearnedCall& call : *result.learned) {
    // A call with a finding must be followed the next time, too.
    const auto end = call.opener + static_cast<StatementId>(call.outcome.lines.size());
    if (!result.reachability->asked(call.opener + 1, end)) known.learn(std::move(call));
  }
  return true;
}

}  // namespace owlint
