// The flow room: LinuxCNC's O-word state machine over all branch outcomes at once. Answers which lines stop the
// interpreter, on some run or on every run, which lines no run reaches, and by which branches one gets there.
// The machine itself is described in machine.h; this header is what rules see.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "analyzer/machine/profile.h"
#include "analyzer/program/linker.h"
#include "analyzer/text/reach.h"

namespace owlint {

/// A line of another file than the one that a result is about.
struct Elsewhere {
  const Program* program = nullptr;  ///< null: there is none
  StatementId statement = kNoStatement;
};

/// One branch outcome on the way to a stop.
struct Decision {
  StatementId statement = kNoStatement;
  bool taken = false;  ///< the condition was true (a `repeat` had a pass left)
  const Program* program = nullptr;  ///< where, if in another file
};

/// The interpreter stops at `statement` on some run.
struct FlowStop {
  StatementId statement = kNoStatement;  ///< for ends of file: the line that is to blame (see `kind`)
  StopKind kind = StopKind::kNone;
  Reach reach = Reach::kMaybe;
  bool unproven = false;  ///< depends on what owlint cannot know: files elsewhere, how deep a guarded recursion goes
  StatementId end_of = kNoStatement;     ///< for ends of file: the place of that end
  StatementId other = kNoStatement;   ///< the line that the message speaks of (first definition, opener)
  StatementId call = kNoStatement;    ///< the call in which it happens, if in a sub
  Elsewhere other_elsewhere;          ///< instead of `other`, in another file
  Elsewhere call_elsewhere;           ///< instead of `call`, in another file
  const Program* file = nullptr;      ///< the file that was called and lacks the sub
  std::string interpreter;            ///< the interpreter's message
  std::string detail;                 ///< a name that the message is about
  std::vector<Decision> path;         ///< branch outcomes without which it does not happen; empty when always
};

/// Something that runs, but not as written.
enum class HazardKind : uint8_t {
  kStaleBreak, kStaleRepeatCount, kArgumentNotPassed, kEndlessLoop, kStaleContinue, kContinueMeetsBreak,
  kValueAtDefinition, kNestedDo, kCrash, kLookupCrash, kHang, kWarned, kValueNotReturned, kValueCleared, kRepeatCount,
};

struct Hazard {
  HazardKind kind{};
  StatementId statement = kNoStatement;  ///< where it begins (the `break`, the call, the loop)
  StatementId other = kNoStatement;      ///< where it shows
  uint32_t number = 0;                   ///< the parameter's number
  Reach reach = Reach::kMaybe;
  StopKind warned = StopKind::kNone;     ///< under FEATURE 0x20: the error that became a message
  std::string interpreter;
  Elsewhere other_elsewhere;             ///< instead of `other`, in another file
  std::string detail;                    ///< the number of passes that a `repeat` is given
  bool not_always = false;               ///< other runs get through the same lines well
};

struct FlowStatistics {
  uint64_t steps = 0;   ///< states processed
  uint64_t merges = 0;  ///< states that were joined with loss of precision
  uint64_t recalled = 0;  ///< calls that were known before
};

namespace flow {
class KnownCalls;
class Trace;
struct LearnedCall;
struct Structure;
}

struct FlowResult {
  std::vector<FlowStop> stops;    ///< ordered by statement
  std::vector<Hazard> hazards;    ///< ordered by statement
  std::vector<bool> executed;     ///< by statement: some run executes it (does not merely pass it over)
  bool ends = false;              ///< some run comes to a program end without an error
  FlowStatistics statistics;
  std::shared_ptr<const flow::Trace> trace;
  StatementId first = 0;          ///< number of this file's first statement in the trace
  std::shared_ptr<const flow::Structure> structure;  ///< of this file's own lines, if it was analysed alone
  std::shared_ptr<std::vector<flow::LearnedCall>> learned;  ///< calls for KnownCalls, if there are any

  /// Whether runs get to a statement and execute it: never, on some runs, on every run.
  Reach reach(StatementId statement) const;
};

/// How closely runs are followed.
enum class Detail : uint8_t {
  kBySize,    ///< what a program's size allows
  kCoarse,    ///< as in a very large program; for tests
  kStepwise,  ///< the same line by line, passing over nothing; what kCoarse is tested against
};

/// Runs the machine through all files of `linked`, which grows by files whose names only the run knows. One result
/// for each file, in the order of `linked.files()`; statement numbers in it are those of the file's own program.
/// `known`: calls that earlier analyses have found; see remember() for what becomes of this one's.
std::vector<FlowResult> analyze_flow(Linked& linked, const Profile& profile, Detail detail = Detail::kBySize, flow::KnownCalls* known = nullptr);

/// To be called when all questions about a result of analyze_flow() with `known` have been asked: keeps its calls for the
/// next analysis. False if something was asked about lines that were not gone through: then what was answered is void,
/// nothing is known any more, and the analysis must be made again.
bool remember(const FlowResult& result, flow::KnownCalls& known);

}  // namespace owlint
