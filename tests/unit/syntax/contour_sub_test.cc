// The sub of a lathe contour: the motion mode that it leaves.
#include "analyzer/syntax/contour_sub.h"

#include <catch2/catch.hpp>

namespace owlint {

TEST_CASE("a contour of which nothing is cut leaves the motion of its last code") {
  ContourSub sub;
  CHECK(sub.motion() == Motion::kG0);
  sub.words = {{'g', 1}, {'x', 10}, {'g', 3}, {'z', -5}, {'i', 2}, {'x', 12}};
  sub.ends = {2, 5, 6};
  CHECK(sub.motion() == Motion::kG3);
  sub.words.push_back({'g', 90});
  sub.ends.push_back(7);
  CHECK(sub.motion() == Motion::kG3);
}

}  // namespace owlint
