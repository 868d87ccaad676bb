#include "analyzer/flow/engine/mode_map.h"

#include <algorithm>
#include <unordered_set>

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

  void stop(const State& at, StopReport) override {
    if (at.position < before_.size()) stops_.insert(analysis_.program().at(at.position).line);
  }
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
  const std::unordered_set<uint32_t>& stops() const { return stops_; }

 private:
  ModeState modes(const State& at) const { return analysis_.machine().modes().state(at.parameters); }

  Iteration& analysis_;
  std::vector<Seen> before_, left_;
  std::unordered_set<uint32_t> stops_;  // lines
};

ModeMap::ModeMap(const Linked& linked, const Profile& profile, const Limits& limits)
    : linked_(linked),
      analysis_(linked, profile, Detail::kBySize, nullptr, limits, kAllModes),
      collector_(std::make_unique<Collector>(analysis_)) {
  analysis_.run(*collector_);
  setters_ = std::make_unique<ModeSetters>(analysis_);
}

ModeMap::~ModeMap() = default;

namespace {

/// One line of a file, read by itself.
class LineAlone {
 public:
  LineAlone(const Program& file, uint32_t line, const MachineWords& machine) : parser_(syntax_, machine) {
    const Span span = file.source->line(line);
    parser_.parse(file.source->slice(span), span.begin, &statement_);
  }
  /// Null if it has none.
  const WordLine* words() const { return parser_.words(); }
  bool has_error() const { return statement_.has_error(); }

 private:
  Syntax syntax_;
  LineParser parser_;
  Statement statement_;
};

}  // namespace

/// Lines without a statement of their own, from `first` on, before `last`.
void ModeMap::carry_on(uint32_t first, uint32_t last, ModeState* state, std::vector<ModeThere>* modes) const {
  const Program& file = *linked_.files()[0].program;
  const MachineWords& machine = analysis_.machine().machine_words();
  for (uint32_t line = first; line < last && line <= file.syntax.lines; ++line) {
    const LineAlone alone(file, line, machine);
    if (alone.words() == nullptr || alone.has_error()) continue;
    const ModeState before = *state;
    state->now.assigned = 0;
    std::vector<ModeFault> faults;
    if (!ModeRun(machine, *alone.words()).run(state, &faults)) *state = before;
    for (ModeThere& there : *modes) {
      const bool sets = (state->now.assigned & mask_of(there.mode)) != 0;
      const bool changes = state->now[there.mode] != before.now[there.mode];
      if (changes || (sets && there.set_on.empty())) there.set_on = {{&file, line}};
    }
  }
}

/// Whether an M6 puts a tool into the spindle: the `T` on its line, or on the nearest line above it, is not 0.
bool ModeMap::loads_tool(const ModeSetter& setter) const {
  constexpr uint32_t kMostLines = 100;
  const Program& file = *setter.file;
  const MachineWords& machine = analysis_.machine().machine_words();
  for (uint32_t line = setter.line; line > 0 && setter.line - line < kMostLines; --line) {
    const LineAlone alone(file, line, machine);
    const WordLine* const words = alone.words();
    if (words == nullptr) return false;
    const MCode* const change = words->code(MGroup::kToolChange);
    if (line == setter.line && (change == nullptr || change->number != code::kM6)) return false;
    if (const uint8_t t = words->find('t'); t != kNoWord) return (*words)[t].known && (*words)[t].value >= 1;
  }
  return false;
}

/// Goes down the lines of the program, and knows the modes before each that it is asked for.
class ModeMap::Walk {
 public:
  explicit Walk(const ModeMap& map) : map_(map), file_(*map.linked_.files()[0].program) {}

  /// Whether a run gets to the line. Lines ascend.
  bool go(uint32_t line) {
    const auto& statements = file_.syntax.statements;
    const auto at = std::ranges::lower_bound(statements, line, {}, &Statement::line);
    const auto id = static_cast<StatementId>(at - statements.begin());
    if (at != statements.end() && at->line == line) {
      next_ = id;
      return begin(map_.collector_->before(id));
    }
    if (id == 0 && carried_ == 0) {
      state_ = map_.analysis_.machine().start();
      carried_ = 1;
    } else if (id > 0 && (next_ != kNoStatement || above_ != id - 1)) {
      next_ = kNoStatement;
      above_ = id - 1;
      if (!begin(map_.collector_->left(above_))) return false;
      carried_ = statements[above_].line + (carries_out_its_line(above_) ? 1 : 0);
    }
    if (id > 0 && !seen_->modes) return false;
    map_.carry_on(carried_, line, &state_, &modes_);
    carried_ = line;
    return true;
  }

  /// The modes behind the line that go() went to; nothing if no run goes on from there.
  std::optional<ModeState> behind(uint32_t line) const {
    std::vector<ModeThere> modes = no_modes();
    ModeState state = state_;
    bool acted = false;
    if (next_ != kNoStatement) {
      const auto& statements = file_.syntax.statements;
      StatementId last = next_;
      while (last + 1 < statements.size() && statements[last + 1].line == line) ++last;
      const Seen& left = map_.collector_->left(last);
      if (!left.modes) return std::nullopt;
      state = *left.modes;
      acted = carries_out_its_line(last);
    }
    if (!acted) map_.carry_on(line, line + 1, &state, &modes);
    return state;
  }

  const ModeState& state() const { return state_; }
  ModeThere there(Mode mode) const {
    ModeThere there = modes_[static_cast<size_t>(mode)];
    there.may = state_.now[mode];
    there.known = !state_.now.is_open(mode);
    if (there.set_on.empty() && seen_ != nullptr)
      there.set_on = map_.setters_->of(seen_->records, next_, mask_of(mode));
    if (mode == Mode::kLoaded && !there.known && there.set_on.size() == 1 && map_.loads_tool(there.set_on.front())) {
      there.may = value_bit(modes::kSomeTool);
      there.known = true;
    }
    return there;
  }

 private:
  static std::vector<ModeThere> no_modes() {
    std::vector<ModeThere> modes;
    for (size_t i = 0; i < kModes; ++i) modes.push_back({static_cast<Mode>(i), 0, false, {}});
    return modes;
  }

  /// Whether the modes behind a statement are those behind its line. A question about the line's place alone changes none: what
  /// the line sets, the flow takes in further down.
  bool carries_out_its_line(StatementId id) const {
    const auto& statements = file_.syntax.statements;
    for (StatementId at = id; statements[at].line == statements[id].line; --at) {
      const Statement& s = statements[at];
      if (s.kind == LineKind::kRemap || (s.kind == LineKind::kModeLine && !s.for_place)) return true;
      if (at == 0) break;
    }
    return false;
  }

  bool begin(const Seen& seen) {
    seen_ = &seen;
    modes_ = no_modes();
    if (!seen.modes) return false;
    state_ = *seen.modes;
    return true;
  }

  const ModeMap& map_;
  const Program& file_;
  const Seen* seen_ = nullptr;        // where the state was taken from; null: the start
  StatementId next_ = kNoStatement;   // the statement of the line, if it has one
  StatementId above_ = kNoStatement;  // else the nearest one above
  uint32_t carried_ = 0;              // the line up to which the lines below it are carried out
  ModeState state_;
  std::vector<ModeThere> modes_ = no_modes();  // what those lines have set
};

std::optional<std::vector<ModeThere>> ModeMap::before(uint32_t line) const {
  Walk walk(*this);
  if (!walk.go(line)) return std::nullopt;
  std::vector<ModeThere> modes;
  for (size_t i = 0; i < kModes; ++i) modes.push_back(walk.there(static_cast<Mode>(i)));
  return modes;
}

std::vector<ModeStep> ModeMap::steps(std::span<const uint32_t> lines) const {
  std::vector<ModeStep> steps;
  Walk walk(*this);
  std::optional<ModeState> last;
  bool reached = true;
  for (const uint32_t line : lines) {
    const bool gets_there = walk.go(line);
    if (!gets_there) {
      if (reached) steps.push_back({line, false, {}});
      reached = false;
      continue;
    }
    ModeStep step{line, true, {}};
    const ModeSets& now = walk.state().now;
    for (size_t i = 0; i < kModes; ++i) {
      const auto mode = static_cast<Mode>(i);
      if (!last || last->now[mode] != now[mode] || last->now.is_open(mode) != now.is_open(mode))
        step.changed.push_back(walk.there(mode));
    }
    if (!step.changed.empty() || !reached) steps.push_back(std::move(step));
    reached = true;
    last = walk.state();
  }
  return steps;
}

std::vector<ModeStep> ModeMap::changes() const {
  const Program& file = *linked_.files()[0].program;
  std::vector<ModeStep> steps;
  Walk walk(*this);
  bool reached = false;
  for (uint32_t line = 1; line <= file.syntax.lines; ++line) {
    const bool before = std::exchange(reached, walk.go(line));
    if (!reached && before) steps.push_back({line, false, {}});
    const std::optional<ModeState> behind = reached ? walk.behind(line) : std::nullopt;
    if (!behind) continue;
    const ModeSets& now = walk.state().now;
    ModeStep step{line, true, {}};
    for (size_t i = 0; i < kModes; ++i) {
      const auto mode = static_cast<Mode>(i);
      const bool open = behind->now.is_open(mode);
      if (now[mode] != behind->now[mode] || now.is_open(mode) != open)
        step.changed.push_back({mode, behind->now[mode], !open, {{&file, line}}});
    }
    if (!step.changed.empty()) steps.push_back(std::move(step));
  }
  return steps;
}

bool ModeMap::stops_at(uint32_t line) const { return collector_->stops().contains(line); }

std::optional<double> ModeMap::written(const ModeSetter& setter, char letter) const {
  if (setter.file == nullptr || setter.line == 0) return std::nullopt;
  const LineAlone alone(*setter.file, setter.line, analysis_.machine().machine_words());
  const WordLine* const words = alone.words();
  const uint8_t at = words == nullptr ? kNoWord : words->find(letter);
  return at == kNoWord || !(*words)[at].known ? std::nullopt : std::optional((*words)[at].value);
}

std::string ModeMap::code_written(const ModeSetter& setter, GGroup group) const {
  if (setter.file == nullptr || setter.line == 0) return {};
  const LineAlone alone(*setter.file, setter.line, analysis_.machine().machine_words());
  const GCode* const code = alone.words() == nullptr ? nullptr : alone.words()->code(group);
  return code == nullptr ? std::string() : g_name(code->tenths);
}

}  // namespace owlint::flow
