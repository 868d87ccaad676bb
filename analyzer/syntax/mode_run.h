// What the interpreter does with a line of words in the modes that may be in effect: the checks of the complete line, then its
// words one after the other in the order in which they act. The line stops at the first that the modes refuse; what passes
// changes them. Positions are followed if the caller has a Place: then what an arc or a cycle stops with for its numbers is
// here, too; and what a lathe contour stops with, if the caller also has the lines of its sub. What needs the tool in the
// spindle (G10 L0) is not, or the program of a user code.
#pragma once

#include <optional>
#include <vector>

#include "analyzer/geometry/arc.h"
#include "analyzer/syntax/contour_sub.h"
#include "analyzer/syntax/modes.h"
#include "analyzer/syntax/moves.h"
#include "analyzer/syntax/place.h"
#include "analyzer/syntax/word_line.h"

namespace owlint {

/// An arc that does not pass, in the units in effect.
struct ArcNumbers {
  char first, second;                ///< the axes of its plane, small
  char first_center, second_center;  ///< the letters of its center
  bool start_known;                  ///< else `start`, `center` and `end` may lie elsewhere, together
  bool inch;                         ///< G20
  bool diameter;                     ///< X is one
  bool incremental;                  ///< G91
  bool absolute_center;              ///< G90.1
  bool clockwise;                    ///< G2
  ArcTolerance tolerance;
  Flat start, center, end;
  double start_radius, end_radius;
  double allowed;       ///< how much the two may differ
  double radius;        ///< as it is written, if it is: then there is no center
  double least_radius;  ///< that would reach the end
};

/// Something a line stops with, on some of the runs that get to it.
struct ModeFault {
  Fault fault;          ///< certain: on every run that gets here and has not stopped for an earlier fault of the line
  bool believed;        ///< if not certain: some run stops for it, so far as each mode alone decides
  ModeMask decided_by;  ///< the modes that decide whether it stops; 0 if the line and the place alone do
  /// The place decides: if it is not certain, some places stop.
  bool by_place = false;
  /// Certain on a machine that was just started, and stands where it began, without offsets.
  bool from_start = false;
  std::optional<ArcNumbers> arc = std::nullopt;
  /// Found behind a code from M100 to M199, which stops the line first if the machine does not have it.
  bool behind_user_code = false;
};

/// A part of a line, between those of its codes that are remapped: the steps behind one, up to the other with it. Null: from the
/// line's beginning, and to its end.
struct LinePart {
  const RemappedCode* behind = nullptr;
  const RemappedCode* until = nullptr;
  /// The motion that the line was read with: its axis words keep it, whatever the subs of its codes leave. Empty: that in effect.
  MotionSet motion = 0;
  bool motion_open = false;
};

class ModeRun {
 public:
  ModeRun(const MachineWords& machine, const WordLine& line) : machine_(machine), line_(line) {}

  /// Carries out the line. `*state` becomes that of the runs that go on behind it; the faults are appended in the order in which
  /// the interpreter would find them. False if no run goes on: then the last fault is certain. `*place`, if there is one, becomes
  /// that behind the line, too; then `watch` is told where the line goes.
  bool run(ModeState* state, std::vector<ModeFault>* faults, Place* place = nullptr, MoveWatch watch = {}) const {
    return check(state, faults) && act(state, faults, place, watch);
  }
  /// Its two parts: the checks before the line does anything, even set parameters, and what it does.
  bool check(ModeState* state, std::vector<ModeFault>* faults) const;
  bool act(ModeState* state, std::vector<ModeFault>* faults, Place* place = nullptr, MoveWatch watch = {},
           const ContourSub* contour = nullptr) const;
  /// Whether M72 restores something, so that what would act behind it is lost; nothing if that is not known.
  std::optional<bool> loses_rest(const ModeState& before) const;
  /// Like act(), a part of a line with remapped codes, which themselves do nothing here.
  bool act_part(const LinePart& part, ModeState* state, std::vector<ModeFault>* faults, Place* place = nullptr,
                MoveWatch watch = {}) const;

 private:
  const MachineWords& machine_;
  const WordLine& line_;
};

/// The line computes with #5420 to #5428, which it may not do with compensation on; before ModeRun::run, and like it.
bool read_position(ModeState* state, std::vector<ModeFault>* faults);

/// A sub with M73 is left: restores what it has saved. As ModeRun::run.
bool restore_modes(const MachineWords& machine, ModeState* state, std::vector<ModeFault>* faults,
                   Place* place = nullptr);

}  // namespace owlint
