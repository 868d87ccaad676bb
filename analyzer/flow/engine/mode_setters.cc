#include "analyzer/flow/engine/mode_setters.h"

#include <algorithm>
#include <set>
#include <utility>

namespace owlint::flow {
namespace {

uint32_t last_of(std::span<const ModeChange> changes, ModeMask modes) {
  uint32_t last = 0;
  for (const ModeChange& change : changes) {
    if ((mask_of(change.mode) & modes) != 0) last = std::max(last, change.line);
  }
  return last;
}

/// The line of a statement that sets one of the modes, or one of those behind it if `next` comes next.
ModeSetter setter_at(const Iteration& analysis, StatementId here, StatementId next, ModeMask modes) {
  const Linked& linked = analysis.linked();
  const Program& program = linked.program();
  const auto file_of = [&](StatementId id) { return linked.files()[linked.file_of(id)].program.get(); };
  // The lines behind a statement have run where the next statement comes next.
  if (here + 1 == next) {
    if (const uint32_t line = last_of(program.syntax.changes_after(here), modes); line != 0)
      return {file_of(here), line};
  }
  const Statement& s = program.at(here);
  if (s.kind == LineKind::kModeLine && (analysis.machine().mode_uses().set_at(here) & modes) != 0)
    return {file_of(here), s.line};
  return {};
}

/// The lines before the first statement.
ModeSetter setter_before(const Iteration& analysis, ModeMask modes) {
  const Linked& linked = analysis.linked();
  const uint32_t line = last_of(linked.program().syntax.first_changes, modes);
  return line == 0 ? ModeSetter{} : ModeSetter{linked.files()[0].program.get(), line};
}

}  // namespace

ModeSetter last_setter(const Iteration& analysis, RecordId record, StatementId next, ModeMask modes) {
  const Trace& trace = *analysis.trace();
  for (; record != kNoRecord; record = trace.at(record).parent) {
    const StatementId here = trace.at(record).statement;
    if (here == kNoStatement) continue;
    if (const ModeSetter setter = setter_at(analysis, here, next, modes); setter.file != nullptr) return setter;
    next = here;
  }
  return setter_before(analysis, modes);
}

ModeSetters::ModeSetters(const Iteration& analysis) : analysis_(analysis), first_(analysis.trace()->size() + 1) {
  Trace& trace = *analysis.trace();
  trace.finish();
  std::vector<std::pair<RecordId, RecordId>> edges;  // backwards
  trace.for_edges([&](RecordId from, RecordId to) {
    // Where a call comes back, its own last line comes before, not the call.
    const Trace::Record& back = trace.at(to);
    const bool past_the_call = back.after_call && from == back.parent && trace.at(from).statement != kNoStatement &&
        analysis.program().at(trace.at(from).statement).calls();
    if (!past_the_call) edges.emplace_back(to, from);
  });
  std::ranges::sort(edges);
  for (const auto& [to, from] : edges) {
    ++first_[to + 1];
    previous_.push_back(from);
  }
  for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

std::vector<ModeSetter> ModeSetters::of(std::span<const RecordId> records, StatementId next, ModeMask modes) const {
  constexpr size_t kMostSteps = 20000;
  const Trace& trace = *analysis_.trace();
  std::vector<ModeSetter> found;
  const auto add = [&](const ModeSetter& setter) {
    if (setter.file != nullptr && std::ranges::find(found, setter) == found.end()) found.push_back(setter);
  };
  std::set<std::pair<RecordId, StatementId>> seen;
  std::vector<std::pair<RecordId, StatementId>> todo;
  const auto go = [&](RecordId record, StatementId to) {
    if (seen.emplace(record, to).second) todo.emplace_back(record, to);
  };
  for (const RecordId record : records) {
    if (record == kNoRecord) add(setter_before(analysis_, modes));
    if (record != kNoRecord) go(record, next);
  }
  while (!todo.empty() && seen.size() < kMostSteps) {
    auto [record, to] = todo.back();
    todo.pop_back();
    if (const StatementId here = trace.at(record).statement; here != kNoStatement) {
      const ModeSetter setter = setter_at(analysis_, here, to, modes);
      add(setter);
      if (setter.file != nullptr) continue;
      to = here;
    }
    if (first_[record] == first_[record + 1]) add(setter_before(analysis_, modes));
    // The lines behind a condition that is false are skipped.
    if (trace.at(record).branch == Branch::kFalse) to = kNoStatement;
    for (uint32_t i = first_[record]; i < first_[record + 1]; ++i) go(previous_[i], to);
  }
  if (!todo.empty() && !records.empty()) found = {last_setter(analysis_, records.front(), next, modes)};
  std::erase_if(found, [](const ModeSetter& setter) { return setter.file == nullptr; });
  std::ranges::sort(found, {}, &ModeSetter::line);
  return found;
}

}  // namespace owlint::flow
