// An arc that does not fit, as plain numbers with the words for them: what a rule knows of it, for a drawing of it
// (analyzer/report/arc_drawing.h).
#pragma once

#include <optional>
#include <string>

namespace owlint {

struct ArcSketch {
  /// In the plane of the arc, in the units in effect. Its first axis goes to the right, the second one up: then G2 is clockwise.
  struct Point {
    double right = 0, up = 0;
    std::string words;  ///< as reports have it: `X10 Y0`; from the start, if it is not known where that is
  };
  struct Circle {
    Point center;
    double radius = 0;
    std::string words;  ///< of the radius: `10 mm`
  };

  bool clockwise = false;
  Point start, end;
  std::optional<Point> center;              ///< as it is written; none where the radius is
  double start_radius = 0, end_radius = 0;  ///< how far it is from them; both are the radius where that is written
  std::string start_radius_words, end_radius_words;
  std::optional<Circle> nearest;  ///< the arc nearest to it that LinuxCNC takes
};

}  // namespace owlint
