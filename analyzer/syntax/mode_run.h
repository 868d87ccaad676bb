// What the interpreter does with a line of words in the modes that may be in effect: the checks of the complete line, then its
// words one after the other in the order in which they act. The line stops at the first that the modes refuse; what passes
// changes them. Positions are not followed: what an arc, a cycle or a compensated path stops with for its numbers is not
// here. Nor is what needs the tool in the spindle (G10 L0), or the program of a user code.
#pragma once

#include <vector>

#include "analyzer/syntax/modes.h"
#include "analyzer/syntax/word_line.h"

namespace owlint {

/// Something a line stops with, on some of the runs that get to it.
struct ModeFault {
  Fault fault;          ///< certain: on every run that gets here and has not stopped for an earlier fault of the line
  bool believed;        ///< if not certain: some run stops for it, so far as each mode alone decides
  ModeMask decided_by;  ///< the modes that decide whether it stops; 0 if the line alone does
};

class ModeRun {
 public:
  ModeRun(const MachineWords& machine, const WordLine& line) : machine_(machine), line_(line) {}

  /// Carries out the line. `*state` becomes that of the runs that go on behind it; the faults are appended in the order in which
  /// the interpreter would find them. False if no run goes on: then the last fault is certain.
  bool run(ModeState* state, std::vector<ModeFault>* faults) const {
    return check(state, faults) && act(state, faults);
  }
  /// Its two parts: the checks before the line does anything, even set parameters, and what it does.
  bool check(ModeState* state, std::vector<ModeFault>* faults) const;
  bool act(ModeState* state, std::vector<ModeFault>* faults) const;

 private:
  const MachineWords& machine_;
  const WordLine& line_;
};

/// The line computes with #5420 to #5428, which it may not do with compensation on; before ModeRun::run, and like it.
bool read_position(ModeState* state, std::vector<ModeFault>* faults);

/// A sub with M73 is left: restores what it has saved. As ModeRun::run.
bool restore_modes(const MachineWords& machine, ModeState* state, std::vector<ModeFault>* faults);

}  // namespace owlint
