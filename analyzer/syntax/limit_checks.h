// Moves held against the limits of the machine's axes, `[AXIS_X]MIN_LIMIT` and its kin. LinuxCNC looks at the end of each move
// when motion gets it, and stops the program (measured with LinuxCNC; the interpreter alone knows no limits).
#pragma once

#include <vector>

#include "analyzer/syntax/codes.h"
#include "analyzer/syntax/moves.h"

namespace owlint {

/// A move that ends beyond a limit, in units of the machine.
struct LimitFault {
  /// What has to be so that the program stops.
  enum class Needs : uint8_t {
    kNothing,
    kNoOffsets,   ///< no offset is in effect but those that the program sets
    kNoRotation,  ///< the coordinate system is not turned
  };

  uint32_t line = 0;  ///< from 1
  uint8_t axis = 0;
  bool greatest = false;  ///< the limit
  MoveKind kind = MoveKind::kRapid;
  bool machine = false;  ///< the line has G53
  Needs needs = Needs::kNothing;
  double position = 0;  ///< where the move ends; of a distance how long it is
  double limit = 0;     ///< of a distance all that the axis has
  double at_limit = 0;  ///< what the program calls the limit, in its units and coordinates; not of a distance
  double unit = 1;      ///< of the program, in units of the machine
  double furthest = 0;  ///< where the move of all ends that goes furthest beyond
  uint32_t furthest_line = 0;
  uint32_t from_line = 0;  ///< not 0: the moves from this line on go further than the axis can, wherever its zero is

  bool is_distance() const { return from_line != 0; }
};

/// What to say if moves end beyond the greatest or the least coordinate of an axis; of several moves of the furthest.
std::optional<LimitFault> beyond_limit(const MachineWords& machine, const Moves& moves, size_t axis,
                                       const MachineWay& way, bool greatest);

class LimitChecks final : public MoveVisitor {
 public:
  explicit LimitChecks(const MachineWords& machine) : machine_(machine) {}

  bool visit(const Moves& moves) override;
  void lose(uint32_t, AxisSet) override {}
  /// The first move beyond each limit.
  const std::vector<LimitFault>& faults() const { return faults_; }

 private:
  /// Coordinates along one axis that count from the same point.
  struct Range {
    size_t axis;
    double base;
    double least, greatest;
    double least_tool, greatest_tool;
    uint32_t least_line, greatest_line;
  };

  bool is_known(const LimitFault& fault) const;
  bool is_new(const Moves& moves, size_t axis, const MachineWay& way) const;
  std::optional<LimitFault> too_long(const Moves& moves, const Range& range) const;
  Range widened(size_t axis, const MachineWay& way) const;
  void take(const Moves& moves, size_t axis, const MachineWay& way);
  void add(const LimitFault& fault);

  const MachineWords& machine_;
  std::vector<LimitFault> faults_;
  std::vector<Range> ranges_;
};

}  // namespace owlint
