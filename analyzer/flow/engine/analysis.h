// The analysis in progress: the waiting states, the states seen, the calls made, the results so far. Used by
// analysis.cc, which runs it, and results.cc, which makes the results.
#pragma once

#include <algorithm>
#include <deque>
#include <list>
#include <map>
#include <memory>
#include <memory_resource>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "analyzer/flow/engine/known_calls.h"
#include "analyzer/flow/engine/trace.h"
#include "analyzer/flow/interpreter/machine.h"

namespace owlint::flow {

inline constexpr uint32_t kNormalEnd = 0;

class Analysis final : public Listener {
 public:
  /// `limits` must outlive the analysis.
  Analysis(const Linked& linked, const Profile& profile, Detail detail, KnownCalls* known, const Limits& limits)
      : limits_(limits),
        linked_(linked),
        program_(linked.program()),
        passes_over_(detail != Detail::kStepwise),
        level_(detail != Detail::kBySize || program_.size() > limits.followed_statements ? limits.levels.size() - 1
                                                                                         : 0),
        machine_(linked, profile, limits, pool_),
        heads_(program_.size() + 1, UINT32_MAX),
        trace_(std::make_shared<Trace>(limits)) {
    result_.executed.resize(program_.size());
    remaps_ = profile.setup != nullptr && profile.setup->has_remaps;
    // Under FEATURE 0x20 any label may lead out of a sub.
    if (known != nullptr && !profile.warn_only()) memory_of_calls_.emplace(*known, CallKeys(linked, machine_));
  }

  FlowResult run();
  /// Names of called subs that were computed on the way.
  std::vector<std::string> computed_calls() const;
  std::shared_ptr<const Structure> structure() const { return std::make_shared<const Structure>(machine_.structure()); }

  void successor(State state) override;
  void stop(const State& at, StopKind kind, StatementId other, std::string message, std::string detail) override;
  void hazard(const State& at, HazardKind kind, uint32_t number, StopKind warned, std::string message,
              StatementId other) override;
  void end(const State& at) override {
    trace_->terminate(at.record, kNormalEnd);
    result_.ends = true;
  }
  void call(const State& at, State entry, Context callee, int repeats) override;
  void leave(const State& at) override;

 private:
  /// All states at one line in one mode (same call, same skip).
  struct Group {
    StatementId position;
    uint32_t number;
    uint32_t rank;  ///< how many groups at this place were there before
    ContextId context;
    FullLabel skip;
    NameId defining;
    bool seek;
    bool looped;
    uint8_t executed;  ///< while lines are skipped: the branch that was taken has assigned what the others have not
    uint32_t next;
    std::pmr::vector<std::pair<uint64_t, RecordId>> seen;
    std::unique_ptr<State> joined;
    std::pmr::vector<std::pair<RecordId, Branch>>
        parents;  ///< records whose states wait in `joined`, and their branches
    bool dirty;

    RecordId find(uint64_t hash) const {
      const auto found = std::ranges::find(seen, hash, &std::pair<uint64_t, RecordId>::first);
      return found == seen.end() ? kNoRecord : found->second;
    }
  };
  struct Caller {
    State state;
    int repeats;
  };
  /// A call whose outcome may be kept, see KnownCalls.
  struct Watch {
    std::string key;
    State entry;
    size_t level;
    uint64_t steps = 0;
    bool disturbed = false;  ///< its outcome cannot be kept
    std::vector<bool> lines;
  };
  struct Frame {
    explicit Frame(std::pmr::memory_resource* memory)
        : callers(memory), caller_hashes(memory), exits(memory), exit_hashes(memory) {}

    Context info;
    bool outside = false;            ///< called from outside the file: its return ends the run
    std::pmr::list<Caller> callers;  ///< a list: going through it while calls are added is safe
    std::pmr::unordered_set<uint64_t> caller_hashes;
    std::pmr::vector<State> exits;
    std::pmr::vector<uint64_t> exit_hashes;
    std::unique_ptr<State> joined_exit;
    std::unique_ptr<State> joined_entry;
    RecordId entry = kNoRecord;
    std::unique_ptr<Watch> watch;
    bool known = false;  ///< its exit comes from KnownCalls, and its lines are not analysed
  };
  struct Pending {
    StatementId position;
    uint64_t order;
    uint32_t state;
    bool operator<(const Pending& other) const {
      return position != other.position ? position > other.position : order > other.order;
    }
  };
  struct StopKey {
    StatementId statement;
    StopKind kind;
    std::string detail;
    uint32_t file;  // for stops without a statement
    auto operator<=>(const StopKey&) const = default;
  };
  struct StopInfo {
    uint32_t key;
    RecordId record;
    FlowStop stop;
  };

  const Limits::Level& level() const { return limits_.levels[level_]; }
  /// Whether constants are joined, too.
  bool coarse() const { return level_ + 1 == limits_.levels.size(); }
  void start();
  void push(State state);
  void arrive(State state);
  void execute(State state, Group& group, uint64_t hash);
  void execute_joined(uint32_t index);
  void mark_executed(const CalmStretch& stretch);
  void end_of_file(const State& state);
  void add_stop(RecordId record, FlowStop stop);
  void resume_one(const Caller& caller, const State& exit, Frame& frame);
  ContextId context_for(const Context& callee, const State& entry, bool* merged);
  void count_steps(uint64_t steps);
  void recall(ContextId context, const State& at, const State& entry);
  void disturb(ContextId context);
  void learn_calls();
  bool assigned_in_most_cases(const FlowStop& stop) const;
  bool followed(const std::vector<Decision>& path) const;
  void finish();
  void blame_calls();
  void not_found(ContextId context, const Caller& caller);
  StatementId call_of(ContextId context, StatementId at) const;
  bool recursion_comes_back(ContextId context) const;
  StopKind why_not_found(NameId sub, StatementId call) const;
  void endless_loops();
  bool conditional(StatementId id) const;
  bool leaves_work(ContextId context, StatementId call, int depth) const;
  void ends_in_subs();
  std::vector<uint32_t> passed_well() const;
  void idle_loops();
  /// Loops that other runs leave, but in which a run may go round for ever: nothing on the way round changes what decides.
  void stuck_loops();
  RegionId region_at(StatementId position) const;
  const std::vector<ExprId>& fragile_in(RegionId region);
  bool joins(const State& state, RegionId region, size_t there, size_t most);
  Group& group_at(const State& state);

  const Limits& limits_;
  const Linked& linked_;
  const Program& program_;
  bool passes_over_;
  size_t level_;
  PersistentMap::Pool pool_;
  Machine machine_;
  // Groups and frames are many and small, and are freed all at once.
  std::pmr::monotonic_buffer_resource memory_;
  std::vector<uint32_t> heads_;
  std::deque<Group> groups_;                            // a deque: growing moves nothing
  std::unordered_multimap<uint64_t, uint32_t> crowds_;  // groups by mode, at places where there are many
  std::unordered_map<RegionId, std::vector<ExprId>> fragile_;
  std::unordered_map<uint64_t, bool>
      failing_;  // by hash of region and parameters: the result of Evaluator::will_fail()
  std::unordered_map<ContextId, std::vector<const Group*>>
      seeking_;                                               // groups that look for a sub, by call; made at the end
  std::deque<Frame> frames_;                                  // a deque: references stay valid while calls are added
  using CallKind = std::tuple<NameId, int, bool, int, bool>;  ///< what a Context has
  std::pmr::map<std::pair<CallKind, uint64_t>, ContextId> contexts_{&memory_};
  std::pmr::map<CallKind, std::pair<size_t, ContextId>> context_counts_{&memory_};
  std::priority_queue<Pending> queue_;
  std::vector<State> waiting_;
  std::vector<uint32_t> free_;
  std::vector<uint32_t> dirty_;      // groups with a join to execute
  std::vector<bool> called_calmly_;  // by opener: the sub is called from a calm stretch, its lines are marked
  uint64_t order_ = 0;
  std::shared_ptr<Trace> trace_;
  std::map<StopKey, StopInfo> stops_;
  std::map<std::tuple<HazardKind, StatementId, StatementId, uint32_t>, Hazard> hazards_;
  std::vector<std::tuple<ContextId, uint32_t, StatementId>> not_passed_;
  std::unordered_set<RecordId> warned_;  // records with an error that FEATURE 0x20 turned into a message
  std::vector<std::pair<ContextId, StatementId>> deepest_;  // calls beyond the limit
  std::map<std::pair<HazardKind, StatementId>, size_t> origins_;
  uint32_t next_key_ = 1;
  bool remaps_ = false;        ///< the machine has codes that may assign anything
  std::vector<bool> stuck_;    ///< by record: see stuck_loops()
  bool may_go_round_ = false;  ///< one is
  struct Memory {
    Memory(KnownCalls& calls, CallKeys made) : known(calls), keys(std::move(made)) {}
    KnownCalls& known;
    CallKeys keys;
  };
  std::optional<Memory> memory_of_calls_;
  FlowResult result_;
};

/// Splits the result for a joined program into those of its files.
std::vector<FlowResult> by_file(const Linked& linked, FlowResult result);

}  // namespace owlint::flow
