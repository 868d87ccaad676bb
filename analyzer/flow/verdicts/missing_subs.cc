#include "analyzer/flow/verdicts/missing_subs.h"

#include <algorithm>
#include <map>
#include <set>

#include "analyzer/flow/interpreter/new_machine.h"

namespace owlint::flow {
namespace {

/// The states that seek the sub of a context where the file ends.
struct Seeking {
  std::vector<const Partition*> at_end;      ///< behind its last line
  std::vector<const Partition*> at_percent;  ///< at a line with `%` above that
};

/// One call of a context whose states seek its sub: at the end of a file it has not been found.
void add_if_missing(const Iteration& analysis, ContextId context, const Caller& caller, const Seeking& seeking,
                    Stops& stops) {
  const Linked& linked = analysis.linked();
  const Program& program = analysis.program();
  const AbstractMachine& machine = analysis.machine();
  const NameId sub = analysis.calls()[context].info.sub;
  const StatementId call = caller.state.position;
  const CallTarget target = machine.target(sub);
  const bool has_file = target.file != CallTarget::kNotFound;
  const LinkedFile& file = linked.files()[has_file ? target.file : linked.file_of(call)];
  const bool at_end = std::ranges::any_of(seeking.at_end, [&](const Partition* p) { return p->position == file.last; });
  const bool percent = !at_end && std::ranges::any_of(seeking.at_percent, [&](const Partition* p) {
    return p->position >= std::max(file.first, 1U) && p->position < file.last;
  });
  if (!at_end && !percent) return;
  FlowStop stop;
  stop.statement = call;
  stop.call = analysis.calls().call_of(linked, caller.state.context, call);
  stop.detail = machine.name(sub);
  const uint32_t from = has_file || program.at(call).kind == LineKind::kRemap ? 0 : program.at(call).line;
  const std::string sought(called_label(stop.detail, machine.version()));
  stop.interpreter = percent ? "Failed to find sub 'O" + sought + "' before EOF"
                             : "EOF in file:" + file.program->source->path() + " seeking o-word: o<" + sought +
          "> from line: " + std::to_string(from);
  if (has_file) {
    stop.kind = percent ? StopKind::kFilePercent : StopKind::kFileLacksSub;
    stop.file = file.program.get();
  } else {
    stop.kind = why_not_found(analysis, sub, call);
    stop.unproven = machine.may_be_elsewhere(sub);
  }
  stop.unproven = stop.unproven || caller.state.mixed;
  stop.on_new_machine = is_on_new_machine(caller.state.parameters);
  if (stop.on_new_machine) stop.unset = analysis.unset();
  const uint32_t key = stops.add(caller.state.record, std::move(stop));
  for (const Partition* partition : percent ? seeking.at_percent : seeking.at_end) {
    for (const auto& [hash, record] : partition->seen) analysis.trace()->terminate(record, key);
  }
}

}  // namespace

StopKind why_not_found(const Iteration& analysis, NameId sub, StatementId call) {
  const Linked& linked = analysis.linked();
  const Program& program = analysis.program();
  const LinkedFile& file = linked.files()[linked.file_of(call)];
  const bool called_file = file.first != 0 || program.sub_file;
  if (called_file && sub < program.by_label.size()) {
    for (const StatementId id : program.by_label[sub]) {
      if (!program.at(id).opens_sub() || id < file.first || id >= file.last) continue;
      return id < call ? StopKind::kSubBeforeEntry : StopKind::kHelperRefused;
    }
  }
  const bool other_case = linked.search_path().find_other_case(analysis.machine().name(sub)).has_value();
  return other_case ? StopKind::kFileNameCase : StopKind::kSubNotFound;
}

void find_missing_subs(const Iteration& analysis, Stops& stops) {
  const Program& program = analysis.program();
  std::set<StatementId> ends;
  for (const LinkedFile& file : analysis.linked().files()) ends.insert(file.last);
  std::map<ContextId, Seeking> seeking;
  for (const Partition& partition : analysis.partitions().all()) {
    if (!partition.seek) continue;
    const StatementId at = partition.position;
    if (ends.contains(at)) seeking[partition.context].at_end.push_back(&partition);
    if (program.syntax.percent && at < program.size() && program.at(at).kind == LineKind::kPercent)
      seeking[partition.context].at_percent.push_back(&partition);
  }
  for (const auto& [context, found] : seeking) {
    for (const Caller& caller : analysis.calls()[context].callers)
      add_if_missing(analysis, context, caller, found, stops);
  }
}

}  // namespace owlint::flow
