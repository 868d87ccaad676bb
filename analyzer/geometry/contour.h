// Lathe contours, G70 to G72.2: which moves the interpreter makes of the lines of a sub, and where it gives up. Pure arithmetic
// in the ZX plane; words, modes and what the moves themselves need are the caller's. Source: measured with rs274, see
// docs/interpreter.md.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "analyzer/geometry/plane_point.h"

namespace owlint {

/// A line of the sub that moves, or the corner behind one. `first` is Z, `second` is X, as a radius.
struct ContourElement {
  enum class Kind : uint8_t { kLine, kClockwise, kCounterclockwise, kFillet, kChamfer };
  Kind kind = Kind::kLine;
  bool by_radius = false;  ///< an arc: the word `R` is in `size`, else the center is known
  PlanePoint start{};      ///< both are at the corner if it is one
  PlanePoint end{};
  PlanePoint center{};  ///< where it is
  double size = 0;      ///< of a corner; or `R`
};

struct ContourWords {
  enum class Cut : uint8_t { kFinish, kPocketsAtOnce, kNoPockets, kPocketsAfterwards };
  Cut cut = Cut::kFinish;  ///< G70; G71 and G72; .1; .2
  bool facing = false;     ///< G72
  double d = 0, e = 0, i = 1, p = 1, r = 0.5;
};

struct ContourMove {
  enum class Kind : uint8_t { kRapid, kFeed, kClockwise, kCounterclockwise };
  Kind kind = Kind::kRapid;
  PlanePoint end{};
  PlanePoint center{};  ///< of an arc
};

class ContourMoves {
 public:
  virtual ~ContourMoves() = default;
  /// False if the interpreter stops there.
  virtual bool move(const ContourMove& move) = 0;
};

enum class ContourEnd : uint8_t {
  kDone,
  kStops,      ///< with a message
  kRefused,    ///< a move was
  kCrashes,    ///< the interpreter does
  kNeverEnds,  ///< nothing changes any more
  kTooLong,    ///< more moves than are followed
};

struct ContourOutcome {
  ContourEnd end = ContourEnd::kDone;
  const char* message = nullptr;  ///< the interpreter's
  bool unsure = false;            ///< rounding may lead elsewhere
};

/// Cuts along the elements of a sub, of which the first is no corner, from its start on.
ContourOutcome cut_contour(std::span<const ContourElement> elements, const ContourWords& words, ContourMoves& moves);

}  // namespace owlint
