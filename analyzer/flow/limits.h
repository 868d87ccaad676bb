// Every budget of the flow analysis. What lies beyond one is joined, assumed or left out on the safe side: a stop becomes
// `maybe`, a condition may go both ways, a finding about values is not made. The defaults are what owlint uses; tests pass
// small ones. README's section "Limits" names some of these figures (tests/unit/flow/limits_test.cc compares). Limits of
// LinuxCNC itself, such as the depth of calls, are not here but where the machine is modelled.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace owlint::flow {

struct Limits {
  // --- engine: how many states and calls are kept apart ---

  /// How exactly runs are followed until the analysis has taken `steps` steps, a step being one state at one line.
  struct Level {
    uint64_t steps;
    /// States that are kept apart in one partition (engine/partitions.h), and exits of one call; those beyond are joined.
    size_t states;
    size_t contexts;  ///< calls of one sub that are kept apart by their values
  };
  /// Small programs are followed almost path by path; the longer an analysis runs, the more states it joins, so that its
  /// time grows with the program and not with its paths. At the last level, which must have no end, constants are joined
  /// too, and stretches of harmless lines are one step.
  std::array<Level, 4> levels{{{2'500, 128, 256}, {10'000, 64, 32}, {25'000, 8, 4}, {UINT64_MAX, 1, 1}}};
  /// Factor on Level::states and Level::contexts, for states in which one of the sub's operations will fail.
  size_t times_for_failing = 2;
  /// Statements of a program that does not begin at the last level. In a larger one most lines would be analysed at that
  /// level anyway, and states that are separate by then would have to be carried through all of them.
  size_t followed_statements = 250'000;
  /// Operations of a sub that can fail, from its first line on: a state for which one of them will fail is kept apart
  /// longer. They are computed for many states.
  size_t fallible_operations = 16;
  /// M98 with an L up to this is called that many times; with more, or an unknown number, the line may run again.
  int counted_repeats = 8;
  /// Analyses of one program, each of which knows the files whose names the one before has computed.
  int rounds = 8;
  /// Checks for which a call is remembered that none of them makes. While a line is being written the program may stop
  /// early, and nothing after it is called meanwhile.
  uint64_t remembered_checks = 256;

  // --- interpreter: what a state holds ---

  /// Passes of a `repeat` that are counted, at most 15 (see Count). Bolt circles and step-downs have a few passes; where
  /// these are counted, the loop is left in one state and not in many.
  int counted_passes = 15;
  /// First lines that one label may have on joined paths. With more, only the first ones are kept: the message may then
  /// name another of these lines; whether it stops does not change. A constant, since every set has room for them.
  static constexpr size_t kDefiners = 4;
  /// Subs that a call with a computed label may mean. More say too little about each.
  size_t computed_candidates = 16;
  /// How deep calls with computed labels are followed within each other.
  int computed_depth = 4;
  /// Numbers of parameters that are tracked where some number is computed: a write to a computed one changes all of them.
  size_t tracked_numbers = 512;
  /// Rounds in which parameters come to matter because others depend on them. Few suffice; a limit only costs precision.
  int tracking_rounds = 8;
  /// Statements whose conditions are compared and remembered: the detailed analysis of a very large program does not get
  /// further.
  size_t remembered_statements = 100'000;
  /// Remembered conditions that read one parameter: each assignment to it forgets all of them.
  size_t conditions_of_one = 64;
  /// Numbers at which ranges begin and end. With more, a range that grows in each pass would come to rest too late.
  size_t thresholds = 64;
  /// Lines of a stretch of harmless ones. The analysis may come to use stretches in the middle of one.
  uint32_t stretch_lines = 256;
  /// Parameters and subs that a harmless sub may touch: more would make every call of it expensive.
  size_t stretch_accesses = 64;

  // --- the trace and the verdicts: questions about the finished analysis ---

  /// Records looked at to tell whether every run gets to a line, over all questions; then the answer is `maybe`.
  size_t reach_records = 16'000'000;
  /// Records of a trace in which the decisions on a path are told from those that do not matter.
  size_t path_records = 2'000'000;
  /// Decisions on a path that are looked at, and those that are shown: the last ones, as a longer list helps nobody.
  size_t path_decisions = 64;
  size_t shown_decisions = 8;
  /// Stops for which a path is worked out.
  size_t paths = 64;
  /// States at one line for which it is found where the trouble began: that walks back along the run.
  size_t origins = 4;
  /// Endless loops inside each other.
  int endless_nesting = 64;
  /// Callers of a sub that are asked whether a call would have gone on.
  size_t asked_callers = 16;

  // --- summaries: what subs do, worked out from their own lines ---

  /// Statements of a program whose data flow is worked out.
  size_t data_flow_statements = 50'000;
  /// Subs that a sub reaches by calls; one that reaches more is taken to change everything.
  size_t reached_subs = 256;
  /// Words of 64 bits for what is live at all lines of a sub.
  size_t liveness_words = size_t{1} << 22;
  /// Sweeps over a sub until nothing changes: one for each loop inside another.
  int liveness_sweeps = 64;
  /// Ranges of all lines of a sub together.
  size_t fixed_ranges = size_t{1} << 20;
  /// Sweeps over a sub's ranges, and those before ranges at the beginning of loops are widened.
  int fixed_sweeps = 64;
  int exact_sweeps = 3;
  /// Branches of an `if` among which an earlier one with the same condition is looked for.
  size_t compared_branches = 64;
};

}  // namespace owlint::flow
