// The motion in effect (G0, G81, none …) as a value like that of a global parameter: it lives under a key of its own beside the
// numbered parameters, so calls, joins and remembered calls treat it as one of them. Kept only where a line asks for it.
#pragma once

#include <bit>

#include "analyzer/flow/domain/parameters.h"
#include "analyzer/flow/domain/ranges.h"
#include "analyzer/syntax/codes.h"

namespace owlint::flow {

inline constexpr uint32_t kMotionKey = kLastNumber + 1;

/// G80 and none are the lowest: the hull of motions that move has neither.
constexpr double motion_number(Motion motion) {
  return motion == Motion::kNone ? -2 : motion == Motion::kG80 ? -1 : static_cast<double>(motion);
}

/// Of a range that is a hull of motions, those that are surely in it: its two ends.
inline MotionSet motions_at_ends(const Range& range) {
  MotionSet out = 0;
  for (MotionSet rest = kAnyMotion; rest != 0; rest &= rest - 1) {
    const auto motion = static_cast<Motion>(std::countr_zero(rest));
    if (motion_number(motion) == range.low || motion_number(motion) == range.high) out |= set_of(motion);
  }
  return out;
}

}  // namespace owlint::flow
