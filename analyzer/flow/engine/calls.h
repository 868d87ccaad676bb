// The calls of a run: each in its contexts, with the callers that wait for it and the exits that come back to them. Calls that
// begin alike are one context, so that a sub is analysed once for all of them.
#pragma once

#include <deque>
#include <list>
#include <map>
#include <memory>
#include <memory_resource>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "analyzer/flow/engine/call_memo.h"
#include "analyzer/flow/engine/worklist.h"

namespace owlint::flow {

struct Caller {
  State state;  ///< at the call's line
  int repeats;  ///< calls that are left to make, with this one; kUnknownRepeats
};

/// A call in one context.
struct Frame {
  explicit Frame(std::pmr::memory_resource* memory)
      : callers(memory), caller_hashes(memory), joined_callers(memory), exits(memory), exit_hashes(memory) {}

  static constexpr size_t kNoExit = SIZE_MAX;

  Context info;
  bool outside = false;            ///< called from outside the file: its return ends the run
  std::pmr::list<Caller> callers;  ///< a list: returns that wait point into it
  std::pmr::unordered_set<uint64_t> caller_hashes;
  std::pmr::unordered_map<uint64_t, Caller*> joined_callers;  ///< by where they are: the last one whose state is joined
  std::pmr::vector<State> exits;
  std::pmr::vector<uint64_t> exit_hashes;
  size_t joined_exit = kNoExit;         ///< among the exits: the join of those that were not kept apart
  std::unique_ptr<State> joined_entry;  ///< the same of the entries, if the context is one of many calls
  bool known = false;                   ///< its exit comes from a CallMemo, and its lines are not analysed
};

class Calls {
 public:
  /// All must outlive it; `memo` may be null. Frames are many and small, and are freed with `memory`.
  Calls(AbstractMachine& machine, const Limits& limits, Precision& precision, Separation& separation,
        Worklist& worklist, Trace& trace, CallMemo* memo, std::pmr::memory_resource& memory)
      : machine_(machine),
        limits_(limits),
        precision_(precision),
        separation_(separation),
        worklist_(worklist),
        trace_(trace),
        memo_(memo),
        memory_(memory),
        contexts_(&memory),
        counts_(&memory) {}

  /// The main program, or for a file that holds a sub a call of that from outside. It must come first, and is context 0.
  void begin(const Context& info, bool outside);
  /// A call is made at `at` and begins with `entry`. `repeats`: how often it is made, or kUnknownRepeats.
  void call(const State& at, State entry, const Context& callee, int repeats);
  /// A call comes back: its callers go on. False for one from outside, which ends the run.
  bool leave(const State& at);

  const Frame& operator[](ContextId context) const { return frames_[context]; }
  size_t size() const { return frames_.size(); }
  /// Entries and exits that were joined with loss of precision.
  uint64_t joined_states() const { return joined_states_; }
  /// Calls whose outcome was known.
  uint64_t recalled() const { return recalled_; }

  /// The call that led to a line: into its file if it is in a called one, else into its sub. None where many calls of that
  /// have been joined: it may not be the first one's.
  StatementId call_of(const Linked& linked, ContextId context, StatementId at) const;
  /// Whether the calls that lead to `context` go through one sub twice, and that sub also returns: a recursion with an
  /// exit, of which nobody knows here how deep it goes.
  bool recursion_comes_back(ContextId context) const;

 private:
  using Kind = std::tuple<NameId, int, bool, int, bool, uint8_t, uint16_t, bool>;  ///< what a Context has
  /// An exit that is to come back to a caller.
  struct Return {
    const Caller* caller;
    ContextId callee;
    size_t exit;
  };

  ContextId context_for(const Context& callee, const State& entry, bool* joined);
  void enter(const State& at, State entry, const Context& callee, int repeats);
  Caller* add_caller(Frame& frame, const State& at, int repeats);
  bool holds(const State& all, const State& some);
  bool join_exit(Frame& frame, State exit);
  void recall(ContextId context, const State& at, const State& entry);
  void come_back();
  void resume(const Return& back);

  AbstractMachine& machine_;
  const Limits& limits_;
  Precision& precision_;
  Separation& separation_;
  Worklist& worklist_;
  Trace& trace_;
  CallMemo* memo_;
  std::pmr::memory_resource& memory_;
  std::deque<Frame> frames_;  // a deque: references stay valid while calls are added
  std::pmr::map<std::pair<Kind, uint64_t>, ContextId> contexts_;
  std::pmr::map<Kind, std::pair<size_t, ContextId>> counts_;  // contexts that are kept apart, and the one of all others
  std::deque<Return> returns_;                                // that wait
  uint64_t joined_states_ = 0;
  uint64_t recalled_ = 0;
};

}  // namespace owlint::flow
