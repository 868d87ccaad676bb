// A lathe contour made ready to be cut: with its corners, and in a direction in which it goes towards smaller Z, as a tool does
// that turns the outside of a part from the right.
#pragma once

#include <span>
#include <vector>

#include "analyzer/geometry/contour.h"
#include "analyzer/geometry/contour_segment.h"

namespace owlint {

class ContourShape {
 public:
  explicit ContourShape(std::span<const ContourElement> elements);

  /// Turns and mirrors it, makes its corners, and checks its direction.
  ContourOutcome prepare(const ContourWords& words);
  /// Moves it aside by the allowance.
  ContourOutcome shift(double distance);
  /// An upright line back to the height of the start, if it ends below that.
  void close();

  const std::vector<ContourSegment>& segments() const { return segments_; }
  /// Where a point of the shape is on the machine; the sense of arcs may be the other one.
  PlanePoint on_machine(Complex point) const;
  /// Rounding decides where some of it is.
  bool is_unsure() const { return unsure_; }
  bool is_mirrored() const { return mirrored_x_ != mirrored_z_; }

 private:
  void add(const ContourElement& element);
  void turn();
  void mirror();
  bool passes_without_first() const;
  void move_start();
  ContourOutcome make_corners();
  ContourOutcome make_corner(size_t at);
  ContourOutcome shift_step(double by);
  void close_gaps(const std::vector<Complex>& corners, bool outwards);
  ContourOutcome join_all();
  bool join(ContourSegment& a, ContourSegment& b);

  std::vector<ContourSegment> segments_;
  bool turned_ = false, mirrored_x_ = false, mirrored_z_ = false;
  bool unsure_ = false;
};

}  // namespace owlint
