// The modes in effect before each line of a program, over all runs that get there, and where they were set: what a reader of the
// program asks.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analyzer/flow/engine/mode_setters.h"

namespace owlint::flow {

struct ModeThere {
  Mode mode{};
  ValueSet may = 0;                ///< its values
  bool known = false;              ///< false: it is whatever it was before
  std::vector<ModeSetter> set_on;  ///< by the runs that come here, as far as lines have set it
};

/// A line with modes that are others there than before.
struct ModeStep {
  uint32_t line = 0;
  bool reached = true;             ///< false: no run gets there, and `changed` is empty
  std::vector<ModeThere> changed;  ///< of the first line that a run gets to: all
};

class ModeMap {
 public:
  /// Analyses the program; `linked` must outlive it.
  ModeMap(const Linked& linked, const Profile& profile, const Limits& limits);
  ~ModeMap();

  /// Before a line of the program's own file (from 1) is carried out. Nothing if no run gets there.
  std::optional<std::vector<ModeThere>> before(uint32_t line) const;
  /// The same for many lines, which ascend, in one pass; lines without a change are left out.
  std::vector<ModeStep> steps(std::span<const uint32_t> lines) const;
  /// What each line changes by itself, in the order of the lines; of a call: what its sub does. Lines where nothing changes are
  /// left out. The first line that no run gets to is there too, if there is one behind a line that is reached.
  std::vector<ModeStep> changes() const;
  /// Whether a run stops at a line of the program's own file.
  bool stops_at(uint32_t line) const;
  /// The word of this letter on the line that has set a mode, if it is a plain number.
  std::optional<double> written(const ModeSetter& setter, char letter) const;
  /// The G code of a group on that line, `G43`; empty if it has none.
  std::string code_written(const ModeSetter& setter, GGroup group) const;

 private:
  class Collector;
  class Walk;
  struct Seen;

  bool loads_tool(const ModeSetter& setter) const;
  void carry_on(uint32_t first, uint32_t last, ModeState* state, std::vector<ModeThere>* modes) const;

  const Linked& linked_;
  Iteration analysis_;
  std::unique_ptr<Collector> collector_;
  std::unique_ptr<ModeSetters> setters_;
};

}  // namespace owlint::flow
