// The abstract O-word state machine: `AbstractMachine::step` executes one line in a state, which after paths were
// joined holds sets of values. The transitions follow the measured table in docs/interpreter.md; if a set has several
// members, a step has several successors.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "analyzer/flow/domain/state.h"
#include "analyzer/flow/facts/structured.h"
#include "analyzer/flow/flow.h"
#include "analyzer/flow/interpreter/calm.h"
#include "analyzer/flow/interpreter/dependence.h"
#include "analyzer/flow/interpreter/evaluator.h"
#include "analyzer/flow/interpreter/mode_access.h"
#include "analyzer/flow/interpreter/mode_watch.h"
#include "analyzer/flow/interpreter/place_watch.h"
#include "analyzer/flow/interpreter/refinement.h"
#include "analyzer/flow/interpreter/remapped_codes.h"
#include "analyzer/flow/limits.h"
#include "analyzer/flow/summaries/effects.h"
#include "analyzer/machine/profile.h"
#include "analyzer/program/linker.h"
#include "analyzer/program/machine_words.h"

namespace owlint::flow {

inline constexpr NameId kGlobalScope = UINT32_MAX - 1;  ///< of `sub`, `endsub`, `call`, `return`, bare `O`, M98

/// A call in progress, one for all calls that begin in the same state: the part of a Frame (engine/calls.h) that the machine
/// sees.
struct Context {
  NameId sub = kNoName;
  int depth = 0;
  bool fanuc = false;     ///< made by M98
  int passed = 0;         ///< number of arguments of the call that made it
  uint8_t remaps = 0;     ///< calls by remapped codes that it is within
  uint16_t built_in = 0;  ///< codes that the INI remaps, but not within the subs that they run: see RemappedCodes
  bool contour =
      false;  ///< within a G70, G71 or G72: lines are read for the contour, M2, M30 and `(abort, …)` do nothing (measured)
  bool remap = false;  ///< made by a remapped code: M99 ends the sub as `endsub` does (measured)
};

/// The interpreter stops.
struct StopReport {
  StopKind kind = StopKind::kNone;
  StatementId other = kNoStatement;  ///< the line that the message names
  std::string message;               ///< the interpreter's
  std::string detail;                ///< a name that the message is about
  FaultyWords words;                 ///< if it stops at words in the modes that are in effect, or at a computed number
};

/// Something runs, but not as written.
struct HazardReport {
  HazardKind kind{};
  StatementId other = kNoStatement;  ///< another line that it is about
  uint32_t number = 0;               ///< of an argument
  StopKind error = StopKind::kNone;  ///< the error that became a message, or shows later
  std::string message;               ///< the interpreter's
  std::string detail;                ///< passes of a `repeat`

  static HazardReport of(HazardKind kind, StatementId other = kNoStatement) {
    HazardReport out;
    out.kind = kind;
    out.other = other;
    return out;
  }
  static HazardReport of_argument(HazardKind kind, uint32_t number) {
    HazardReport out = of(kind);
    out.number = number;
    return out;
  }
  static HazardReport of_error(HazardKind kind, StopKind error, std::string message) {
    HazardReport out = of(kind);
    out.error = error;
    out.message = std::move(message);
    return out;
  }
  static HazardReport of_passes(HazardKind kind, std::string passes) {
    HazardReport out = of(kind);
    out.detail = std::move(passes);
    return out;
  }
};

/// What a step reports: where the run goes on, and what happens on the way.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void successor(State state) = 0;
  virtual void stop(const State& at, StopReport report) = 0;
  virtual void hazard(const State& at, HazardReport report) = 0;
  virtual void end(const State& at) = 0;                                             ///< the program ends
  virtual void call(const State& at, State entry, Context callee, int repeats) = 0;  ///< repeats: -1 unknown
  virtual void leave(const State& at) = 0;  ///< `return`, `endsub`, M99 in a call
};

class AbstractMachine {
 public:
  /// All must outlive it. `modes`: those that are followed even if they decide nothing.
  AbstractMachine(const Linked& linked, const Profile& profile, const Limits& limits, PersistentMap::Pool& pool,
                  ModeMask modes = 0);

  /// Executes or skips the line at `state.position`.
  void step(State state, const Context& context, Listener& out);

  /// From now on constants are joined, and if `passes_over`, stretches of lines in which nothing can go wrong are one
  /// step: for very large programs.
  void set_coarse(bool passes_over);
  /// Skips such a stretch. If there is none, returns null and does nothing.
  const CalmStretch* pass_over(State& state, const Context& context);
  /// The first lines of the subs that a stretch defines, and that it calls.
  std::span<const StatementId> defined_in(const CalmStretch& stretch) const { return calm_->defined(stretch); }
  std::span<const StatementId> called_in(const CalmStretch& stretch) const { return calm_->called(stretch); }

  /// A state that skips lines goes on to the next one at which it has something to do.
  State skip_ahead(State state) const;

  /// The table's entry for a label; structured blocks have none.
  uint32_t entry(const State& state, FullLabel label) const;

  /// The lattice of the machine's states.
  StateDomain& states() { return states_; }
  /// The state after a call: the callee's effects, with the caller's own parameters restored.
  /// `joined_calls`: the exit stands for the calls of several callers.
  State resume(const State& caller, const State& exit, const Context& callee, bool joined_calls);

  /// Whether a skipping state is at the line that it skips to.
  bool is_target(const State& state, const Context& context) const;

  /// Whether a sub that is not found may be in a file, a module or a calling program that owlint does not know.
  bool may_be_elsewhere(NameId sub) const;
  /// Whether the program or a file that it calls has a `sub` line with this label.
  bool opens_somewhere(NameId sub) const;
  /// Where LinuxCNC finds a called sub that the label table does not have.
  CallTarget target(NameId sub) const { return linked_.target(name(sub)); }

  /// Whether the machine's INI turns this Fanuc-style line off.
  bool refuses_fanuc(const Statement& s) const {
    return no_fanuc_ && ((s.is(Keyword::kBare) && !s.refused) || s.kind == LineKind::kM98);
  }

  /// Names, those of the program and those that were computed on the way.
  NameId intern(const std::string& text);
  const std::string& name(NameId id) const;
  /// Computed names of subs that were called.
  const std::unordered_set<NameId>& computed_calls() const { return computed_calls_; }

  FullLabel full_label(NameId scope, NameId label);
  /// A label as the interpreter writes it: `100`, or `100#110` for a block's label in sub 100.
  std::string full_text(FullLabel label) const;
  NameId label_of(FullLabel label) const { return labels_[label].second; }
  Definers& definers() { return definers_; }
  Version version() const { return profile_.version; }
  /// A line is left for the one behind it, by way of the lines without a statement.
  void leave_modes(State& state, StatementId line);
  /// From now on `watch` is told.
  void set_watch(ModeWatch* watch) { watch_ = watch; }
  void set_watch(PlaceWatch* watch) { place_watch_ = watch; }
  Evaluator& evaluator() { return evaluator_; }
  /// The modes in which a program begins.
  const ModeState& start() const { return start_; }
  ModeAccess& modes() { return modes_; }
  const MachineWords& machine_words() const { return machine_words_.words; }
  const RemappedCodes& remapped_codes() const { return remapped_codes_; }
  const ModeUses& mode_uses() const { return mode_uses_; }
  const Evaluator& evaluator() const { return evaluator_; }
  const TrackedParameters& tracked() const { return tracked_; }
  const Refinement& refinement() const { return refinement_; }
  Dependences dependences() const { return {program_.syntax, tracked_, remembered_, refinement_}; }
  const Structure& structure() const { return structure_; }
  NameId scope_of(FullLabel label) const { return labels_[label].first; }
  /// Everything else that a call depends on, besides lines and parameters, as a number.
  uint64_t circumstances() const {
    uint64_t out = static_cast<uint64_t>(profile_.version) << 2 | static_cast<uint64_t>(reads_break_) << 1 |
        static_cast<uint64_t>(evaluator_.distrusts_globals());
    out = mix(out, evaluator_.machine_values());
    for (const double number : values_.thresholds().numbers()) out = mix(out, std::bit_cast<uint64_t>(number));
    return out;
  }

 private:
  struct Step;  // one step in progress: step.h
  friend struct Step;

  void index();
  void go(State& state, StatementId line);
  StatementId next_stop(const State& state, StatementId from) const;

  const Linked& linked_;
  const Program& program_;
  const Profile& profile_;
  const Limits& limits_;
  PersistentMap::Pool& pool_;
  KnownValues values_;
  TrackedParameters tracked_;
  RememberedConditions remembered_;
  Evaluator evaluator_;
  Refinement refinement_;
  WordsOfMachine machine_words_;
  RemappedCodes remapped_codes_;
  ModeState start_;
  ModeUses mode_uses_;
  ModeAccess modes_;
  ModeWatch* watch_ = nullptr;
  PlaceWatch* place_watch_ = nullptr;
  Definers definers_;
  StateDomain states_;
  bool no_fanuc_;     // DISABLE_FANUC_STYLE_SUB
  bool reads_break_;  // only a `do` loop reads the flag that `break` sets
  Structure structure_;
  EffectsOfSubs effects_;
  std::optional<CalmStretches> calm_;                  // exists from set_coarse() on
  std::vector<std::pair<NameId, NameId>> labels_;      // FullLabel -> scope, label
  std::unordered_map<uint64_t, FullLabel> label_ids_;  // by scope and label, but for subs
  std::vector<FullLabel> sub_labels_;                  // by label
  // Positions at which a skip may be interrupted, each sorted.
  std::vector<StatementId> computed_, always_read_, unknown_keywords_, definitions_, percents_, file_ends_;
  std::vector<bool> returns_value_;                       // by label of a sub: some `return` or `endsub` has a value
  std::vector<std::pair<double, NameId>> numbered_subs_;  // sorted
  Names computed_names_;                                  // numbered after the program's own
  std::unordered_set<NameId> computed_calls_;
};

}  // namespace owlint::flow
