#include "analyzer/flow/engine/mode_map.h"

#include <algorithm>

#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

/// The states of one place, joined.
struct ModeMap::Seen {
  std::optional<ModeState> modes;
  std::vector<RecordId> records;  ///< some of them

  void add(const ModeState& state, RecordId record) {
    constexpr size_t kMostRecords = 16;
    modes = modes ? ModeState{join(modes->now, state.now), join(modes->saved, state.saved)} : state;
    if (records.size() < kMostRecords) records.push_back(record);
  }
};

class ModeMap::Collector final : public Events, public ModeWatch {
 public:
  explicit Collector(Iteration& analysis)
      : analysis_(analysis), before_(analysis.program().size()), left_(before_.size()) {
    analysis.machine().set_watch(this);
  }

  void stop(const State&, StopReport) override {}
  void hazard(const State&, HazardReport) override {}
  void end(const State&) override {}
  void end_of_file(const State&) override {}
  void executed(const State& at) override {
    if (at.skip != kNoLabel || at.position >= before_.size()) return;
    before_[at.position].add(modes(at), analysis_.trace()->at(at.record).parent);
  }
  void left(const State& at, StatementId line) override { left_[line].add(modes(at), at.record); }
  void came_back(const State&, const State&) override {}

  const Seen& before(StatementId id) const { return before_[id]; }
  const Seen& left(StatementId id) const { return left_[id]; }

 private:
  ModeState modes(const State& at) const { return analysis_.machine().modes().state(at.parameters); }

  Iteration& analysis_;
  std::vector<Seen> before_, left_;
};

ModeMap::ModeMap(const Linked& linked, const Profile& profile, const Limits& limits)
    : linked_(linked),
      analysis_(linked, profile, Detail::kBySize, nullptr, limits, kAllModes),
      collector_(std::make_unique<Collector>(analysis_)) {
  analysis_.run(*collector_);
}

ModeMap::~ModeMap() = default;

void ModeMap::add_setters(const Seen& seen, StatementId next, std::vector<ModeThere>* modes) const {
  for (ModeThere& there : *modes) {
    for (const RecordId record : seen.records) {
      const ModeSetter setter = last_setter(analysis_, record, next, mask_of(there.mode));
      const auto same = [&](const ModeSetter& one) { return one.file == setter.file && one.line == setter.line; };
      if (setter.file != nullptr && std::ranges::none_of(there.set_on, same)) there.set_on.push_back(setter);
    }
  }
}

/// Lines without a statement of their own, from `first` on, before `last`.
void ModeMap::carry_on(uint32_t first, uint32_t last, ModeState* state, std::vector<ModeThere>* modes) const {
  const Program& file = *linked_.files()[0].program;
  const MachineWords& machine = analysis_.machine().machine_words();
  for (uint32_t line = first; line < last && line <= file.syntax.lines; ++line) {
    Syntax syntax;
    LineParser parser(syntax, machine);
    Statement statement;
    const Span span = file.source->line(line);
    parser.parse(file.source->slice(span), span.begin, &statement);
    if (parser.words() == nullptr || statement.has_error()) continue;
    const ModeState before = *state;
    std::vector<ModeFault> faults;
    if (!ModeRun(machine, *parser.words()).run(state, &faults)) *state = before;
    for (ModeThere& there : *modes) {
      if (state->now[there.mode] != before.now[there.mode]) there.set_on = {{&file, line}};
    }
  }
}

std::optional<std::vector<ModeThere>> ModeMap::before(uint32_t line) const {
  const Program& file = *linked_.files()[0].program;
  const auto& statements = file.syntax.statements;
  const auto at = std::ranges::lower_bound(statements, line, {}, &Statement::line);
  const auto id = static_cast<StatementId>(at - statements.begin());
  const bool own = at != statements.end() && at->line == line;
  std::vector<ModeThere> modes;
  for (size_t i = 0; i < kModes; ++i) modes.push_back({static_cast<Mode>(i), 0, false, {}});
  ModeState state = analysis_.machine().start();
  if (own || id > 0) {
    const Seen& seen = own ? collector_->before(id) : collector_->left(id - 1);
    if (!seen.modes) return std::nullopt;
    state = *seen.modes;
    add_setters(seen, own ? id : kNoStatement, &modes);
  }
  if (!own) carry_on(id > 0 ? statements[id - 1].line + 1 : 1, line, &state, &modes);
  for (ModeThere& there : modes) {
    there.may = state.now[there.mode];
    there.known = !state.now.is_open(there.mode);
  }
  return modes;
}

}  // namespace owlint::flow
