// Where the moves of a program end: what is told to those who ask, one move after the other, or many plain lines at once. Limits
// of the machine and the extents of a program are found that way.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "analyzer/geometry/plane.h"
#include "analyzer/syntax/modes.h"
#include "analyzer/syntax/place.h"

namespace owlint {

enum class MoveKind : uint8_t {
  kRapid,
  kFeed,
  kArc,
  kProbe,
  kTap,  ///< G33.1
};

/// Millimetres in the unit in effect; NaN if it is not known which.
double unit_in_effect(const ModeSets& modes);

using AxisSet = uint32_t;  ///< by Axis
constexpr AxisSet axis_set(size_t axis) { return 1U << axis; }
inline constexpr AxisSet kAllAxes = (1U << kAxisCount) - 1;

/// The ends of moves along one axis, in the units and the coordinate system in effect.
struct Way {
  Coordinate least{}, greatest{};
  uint32_t least_line = 0, greatest_line = 0;  ///< where they are, from 1

  static Way to(Coordinate end, uint32_t line) { return {end, end, line, line}; }
  bool is_point() const { return least == greatest; }
};

/// What the words of an arc say beside its end.
struct ArcWay {
  Axis first, second;  ///< of its plane
  bool clockwise;
  int turns;
  std::optional<double> radius;  ///< as it is written, if it is; then there is no center
  Flat center;                   ///< as it is written
  bool absolute;                 ///< the center does not count from the start
};

/// Moves of one kind that end in the same offsets.
struct Moves {
  MoveKind kind = MoveKind::kRapid;
  const Place* place = nullptr;   ///< the offsets; its point is where the first move begins
  std::optional<uint8_t> system;  ///< G54 is 0; nothing if it is not known
  double unit = 1;                ///< of lengths, in millimetres; NaN if it is not known
  bool machine = false;           ///< G53: their words are coordinates of the machine
  bool compensated = false;       ///< the tool may end beside these points
  AxisSet axes = 0;               ///< axes that the lines name
  std::array<Way, kAxisCount> ways{};
  std::optional<ArcWay> arc = std::nullopt;  ///< of one arc whose words are known

  /// One move that ends there.
  void end_at(const Point& end, uint32_t line) {
    for (size_t i = 0; i < kAxisCount; ++i) ways[i] = Way::to(end[i], line);
  }
};

class MoveVisitor {
 public:
  virtual ~MoveVisitor() = default;
  /// Moves, in the order of the run. True if this has to see each of them by itself, and was told of several: then it is told of
  /// them again.
  virtual bool visit(const Moves& moves) = 0;
  /// A line moves these axes, and where to is not followed.
  virtual void lose(uint32_t line, AxisSet axes) = 0;
};

/// Who is told of the moves of one line.
struct MoveWatch {
  MoveVisitor* visitor = nullptr;  ///< null: nobody
  uint32_t line = 0;               ///< from 1
};

/// Where moves end along one axis, in coordinates and units of the machine.
struct MachineWay {
  enum class Trust : uint8_t {
    kNone,      ///< nothing is known
    kDistance,  ///< only how far apart such coordinates are, where `base` is the same
    kOffsets,   ///< they are right if no offset is in effect but those that the program sets
    kCertain,
  };

  Trust trust = Trust::kNone;
  double base = 0;  ///< what is the same for coordinates that count from the same point
  double tool = 0;  ///< the tool offset in them
  double least = 0, greatest = 0;
  uint32_t least_line = 0, greatest_line = 0;
};
/// `units_per_mm`: of the machine.
MachineWay machine_way(const Moves& moves, size_t axis, double units_per_mm);

}  // namespace owlint
