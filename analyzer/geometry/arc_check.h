// Whether the numbers of G2 and G3 make an arc, and where its center is.
#pragma once

#include <array>

#include "analyzer/geometry/path_step.h"
#include "analyzer/geometry/plane_point.h"

namespace owlint {

struct ArcEntry {
  PlanePoint end;
  bool by_radius;     ///< the word `R`, else `center`
  double radius;      ///< the word, negative for more than half a turn
  PlanePoint center;  ///< where it is, not where from
  int turns;          ///< negative for G2
  double spread;      ///< by how much the radii may differ, in the units in effect
};

struct ArcUnits {
  bool inch;
  std::array<char, 2> axes;  ///< for messages: X and Y, or Z and X

  bool operator==(const ArcUnits&) const = default;
};

/// Puts the center into `arc`. False if the interpreter stops.
bool arc_check(PlanePoint start, const ArcUnits& units, ArcEntry& arc, PathStep& step);

}  // namespace owlint
