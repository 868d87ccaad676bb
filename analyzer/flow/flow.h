// The flow room: a model of LinuxCNC's O-word state machine that follows every branch. It finds the lines at which the
// interpreter stops, on some run or on every run, the lines that no run reaches, and the branches that lead to a line.
// How it works is described in README.md; this header is what rules see, and verdicts/analyze.h makes it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "analyzer/program/program.h"
#include "analyzer/syntax/mode_run.h"
#include "analyzer/syntax/word_line.h"
#include "analyzer/text/reach.h"

namespace owlint {

/// A line in another file than the result's own.
struct Elsewhere {
  const Program* program = nullptr;  ///< null: there is none
  StatementId statement = kNoStatement;
};

/// The outcome of one condition on the way to a stop.
struct Decision {
  StatementId statement = kNoStatement;
  bool taken = false;                ///< the condition was true (a `repeat` had a pass left)
  const Program* program = nullptr;  ///< where, if in another file
};

/// The words of a kModeLine that it stops at; of a line with a computed number that its word may not have, that word among its
/// items.
struct FaultyWords {
  uint8_t word = kNoWord;   ///< index of the one that it is about; kNoWord: a motion that an earlier line has set
  uint8_t other = kNoWord;  ///< another one concerned, or kNoWord
  ModeMask decided_by = 0;  ///< the modes that decide it
  bool from_start = false;  ///< it stops from where a machine stands that was just started
  std::shared_ptr<const ArcNumbers> arc;  ///< if it is an arc that does not fit
};

/// The interpreter stops at `statement` on some run.
struct FlowStop {
  StatementId statement = kNoStatement;  ///< for ends of file: the line that causes it (see `kind`)
  StopKind kind = StopKind::kNone;
  Reach reach = Reach::kMaybe;
  bool unproven =
      false;  ///< depends on something that owlint cannot know: files elsewhere, how deep a recursion with an exit goes
  bool on_new_machine = false;         ///< it stops only on a machine that was just started
  std::vector<uint32_t> unset;         ///< then: numbers that nothing has set, so that they are 0
  StatementId end_of = kNoStatement;   ///< for ends of file: that end
  StatementId other = kNoStatement;    ///< the line that the message names (first definition, opener)
  StatementId call = kNoStatement;     ///< the call in which it happens, if in a sub
  Elsewhere other_elsewhere;           ///< instead of `other`, in another file
  Elsewhere call_elsewhere;            ///< instead of `call`, in another file
  const Program* file = nullptr;       ///< the file that was called and lacks the sub
  const LineError* further = nullptr;  ///< of what the rules add: a mistake behind the one with which the line stops
  std::string interpreter;             ///< the interpreter's message
  std::string detail;                  ///< a name that the message is about
  FaultyWords words;                   ///< if `statement` is a kModeLine, or `kind` kNumberOutOfRange
  const Program* set_in =
      nullptr;                 ///< the file in which one of the deciding modes was set last on the way here, if one was
  uint32_t set_line = 0;       ///< the line of that
  std::vector<Decision> path;  ///< the conditions that lead here; empty if every run stops here
};

/// Something that runs, but not as written.
enum class HazardKind : uint8_t {
  kStaleBreak,
  kStaleRepeatCount,
  kArgumentNotPassed,
  kEndlessLoop,
  kStaleContinue,
  kContinueMeetsBreak,
  kValueAtDefinition,
  kCrash,
  kLookupCrash,
  kHang,
  kWarned,
  kValueNotReturned,
  kValueCleared,
  kRepeatCount,
  kEndsInSub,
  kOtherHelper,  ///< a call runs `other`, a sub of another file, and not the one of its own file
  kOwnHelper,    ///< no finding: a call runs the sub of its own file, where other files have been followed, too
  kSubInCall,    ///< a `sub` line met in a call: its body runs in place, and its `endsub` ends the call
  /// The main program runs on into a Fanuc sub at `statement`, to the M99 at `other`; without `other`, such a sub does.
  kRunsIntoSub,
  kKeepsValues,        ///< no finding: the line gives each parameter the value that it has, as `#1 = [#1 + 0]` does
  kForeignEnd,         ///< an `endsub` with another sub's label ends a call
  kModeLeak,           ///< a call comes back in another mode, and its caller moves in it
  kModeDependsOnPath,  ///< a move in one mode or another, by the way to it
  kModeAssumed,        ///< a move in a mode that the program has not set
  kModeInactive,       ///< a mode is set, and set again before anything depends on it
  kLimitExceeded,      ///< a move that ends beyond a limit of the machine
};

struct Hazard {
  HazardKind kind{};
  StatementId statement = kNoStatement;  ///< where it begins (the `break`, the call, the loop)
  StatementId other = kNoStatement;      ///< where it shows
  uint32_t number = 0;                   ///< the parameter's number
  Reach reach = Reach::kMaybe;
  StopKind warned = StopKind::kNone;  ///< under FEATURE 0x20: the error that became a message
  std::string interpreter;
  Elsewhere other_elsewhere;  ///< instead of `other`, in another file
  std::string detail;         ///< the number of passes that a `repeat` is given
  // Of the last kinds:
  Mode mode{};
  uint8_t from = 0, to = 0;         ///< values of the mode
  const Program* set_in = nullptr;  ///< where it is set
  uint32_t set_line = 0;
  const Program* needed_in = nullptr;  ///< the move, or the second setting
  uint32_t needed_line = 0;
  bool not_always = false;                  ///< other runs execute these lines without a problem
  bool unproven = false;                    ///< seen only where paths were joined: it may be that no run does it
  std::shared_ptr<const LimitFault> limit;  ///< of kLimitExceeded
};

struct FlowStatistics {
  uint64_t steps = 0;     ///< states processed
  uint64_t merges = 0;    ///< states that were joined with loss of precision
  uint64_t recalled = 0;  ///< calls that were known before
};

namespace flow {
class KnownCalls;
class Reachability;
struct LearnedCall;
struct Structure;
}  // namespace flow

struct FlowResult {
  std::vector<FlowStop> stops;  ///< ordered by statement
  std::vector<Hazard> hazards;  ///< ordered by statement
  std::vector<bool> executed;   ///< by statement: some run executes it (and does not only skip it)
  bool ends = false;            ///< some run gets to a program end without an error
  FlowStatistics statistics;
  std::shared_ptr<flow::Reachability> reachability;         ///< of all files; remembers what reach() was asked
  StatementId first = 0;                                    ///< number of this file's first statement there
  std::shared_ptr<const flow::Structure> structure;         ///< of this file's own lines, if it was analysed alone
  std::shared_ptr<std::vector<flow::LearnedCall>> learned;  ///< calls for KnownCalls, if there are any

  /// Whether runs get to a statement and execute it: never, on some runs, on every run.
  Reach reach(StatementId statement) const;
};

/// How exactly runs are followed.
enum class Detail : uint8_t {
  kBySize,    ///< as exactly as the program's size allows
  kCoarse,    ///< as in a very large program; for tests
  kStepwise,  ///< the same line by line, without skipping stretches; kCoarse is tested against it
};

}  // namespace owlint
