// The flow room: LinuxCNC's O-word state machine over all branch outcomes at once. Answers which lines stop the
// interpreter, on some run or on every run, which lines no run reaches, and by which branches one gets there.
// The machine itself is described in machine.h; this header is what rules see.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "analyzer/machine/profile.h"
#include "analyzer/program/program.h"
#include "analyzer/text/reach.h"

namespace owlint {

/// One branch outcome on the way to a stop.
struct Decision {
  StatementId statement = kNoStatement;
  bool taken = false;  ///< the condition was true (a `repeat` had a pass left)
};

/// The interpreter stops at `statement` on some run.
struct FlowStop {
  StatementId statement = kNoStatement;  ///< for ends of file: the line that is to blame (see `kind`)
  StopKind kind = StopKind::kNone;
  Reach reach = Reach::kMaybe;
  bool unproven = false;  ///< depends on what owlint cannot know: files elsewhere, how deep a guarded recursion goes
  StatementId other = kNoStatement;   ///< the line that the message speaks of (first definition, opener)
  StatementId call = kNoStatement;    ///< the call in which it happens, if in a sub
  std::string interpreter;            ///< the interpreter's message
  std::string detail;                 ///< a name that the message is about
  std::vector<Decision> path;         ///< branch outcomes without which it does not happen; empty when always
};

/// Something that runs, but not as written.
enum class HazardKind : uint8_t {
  kStaleBreak, kStaleRepeatCount, kArgumentNotPassed, kEndlessLoop, kStaleContinue, kContinueMeetsBreak,
  kValueAtDefinition, kNestedDo, kCrash, kHang, kWarned,
};

struct Hazard {
  HazardKind kind{};
  StatementId statement = kNoStatement;  ///< where it begins (the `break`, the call, the loop)
  StatementId other = kNoStatement;      ///< where it shows
  uint32_t number = 0;                   ///< the parameter's number
  Reach reach = Reach::kMaybe;
  StopKind warned = StopKind::kNone;     ///< under FEATURE 0x20: the error that became a message
  std::string interpreter;
};

struct FlowStatistics {
  uint64_t steps = 0;   ///< states processed
  uint64_t merges = 0;  ///< states that were joined with loss of precision
};

namespace flow {
class Trace;
}

struct FlowResult {
  std::vector<FlowStop> stops;    ///< ordered by statement
  std::vector<Hazard> hazards;    ///< ordered by statement
  std::vector<bool> executed;     ///< by statement: some run executes it (does not merely pass it over)
  bool ends = false;              ///< some run comes to a program end without an error
  FlowStatistics statistics;
  std::shared_ptr<const flow::Trace> trace;

  /// Whether runs get to a statement and execute it: never, on some runs, on every run.
  Reach reach(StatementId statement) const;
};

/// Runs the machine. `program` is not changed except that computed labels may add names.
FlowResult analyze_flow(Program& program, const Profile& profile);

}  // namespace owlint
