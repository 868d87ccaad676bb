// How far an arc goes between its ends.
#pragma once

#include "analyzer/geometry/plane.h"

namespace owlint {

struct ArcBox {
  Flat least, greatest;
};

/// The center of an arc by its radius: with a positive one it is at most half a circle, with a negative one at least.
Flat center_by_radius(Flat start, Flat end, double radius, bool clockwise);

/// The box around an arc with its ends. Where they are one point it is a whole circle, and so it is with `turns` above 1.
ArcBox arc_box(Flat start, Flat center, Flat end, bool clockwise, int turns);

}  // namespace owlint
