// Cutter radius compensation: where the tool is beside the programmed path, and which moves the interpreter refuses because
// the tool does not fit. Pure arithmetic in the axes of the plane; words, modes and the third axis are the caller's.
// Source: measured with rs274, see docs/interpreter.md.
#pragma once

#include "analyzer/geometry/arc_check.h"
#include "analyzer/geometry/move_queue.h"
#include "analyzer/geometry/path_step.h"
#include "analyzer/geometry/plane_point.h"

namespace owlint {

/// What moves in a straight line: G0, G1, or G33, G33.1 and G76.
enum class Mover : uint8_t { kRapid, kFeed, kThread };

/// Small, and copied where runs part. After a step that stops it means nothing any more.
class CompensatedPath {
 public:
  struct Tool {
    Side side;
    double radius;    ///< negative: the other side
    int orientation;  ///< of a lathe tool
  };

  /// G41, G42, G41.1, G42.1 with the tool at this point.
  void start(const Tool& tool, const ArcUnits& units, PlanePoint at);
  bool on() const { return on_; }
  /// Not with radius 0: then compensation is on, but moves are plain ones, and neither `line` nor `arc` is for them.
  bool offsets() const { return on_ && radius_ > 0; }
  /// Whether the entry move has been made.
  bool entered() const { return entered_; }

  [[nodiscard]] PathStep line(PlanePoint end, Mover mover);
  /// With the center from words, or `R`. `arc_forbidden` is asked before anything else of any arc, plain ones too.
  [[nodiscard]] PathStep arc(ArcEntry arc);
  /// M0, M1, M2, M30, M60.
  [[nodiscard]] PathStep pause();
  /// G40. If the path was entered, the current point becomes the programmed one: both are then in `tool`.
  [[nodiscard]] PathStep off();
  /// F, S, M3 and others that wait behind moves: so many of them. It matters where the units change.
  void append(int others) { queue_.append_others(others); }
  /// G20, G21, while compensation is on.
  void change_units(bool inch);

  /// The move that the interpreter sends next; null if none waits.
  const QueuedMove* waiting() const { return queue_.empty() ? nullptr : &queue_.front(); }

  PlanePoint programmed() const { return programmed_; }
  /// The interpreter's current point.
  PlanePoint tool() const { return tool_; }

  /// G40 has ended an entered path, and no straight move has begun since.
  bool arc_forbidden() const { return arc_forbidden_; }
  void straight_begins() { arc_forbidden_ = false; }

  bool operator==(const CompensatedPath&) const = default;

 private:
  bool enter_line(PlanePoint end, Mover mover, PathStep& step);
  bool enter_arc(ArcEntry& arc, PathStep& step);
  bool next_line(PlanePoint end, Mover mover, PathStep& step);
  bool next_arc(ArcEntry& arc, PathStep& step);
  /// What comes before is shortened where the moves meet inside the corner; else the corner is rounded.
  bool turn_into_line(PlanePoint end, double across, double ahead, double turn, Mover mover, PathStep& step);
  bool turn_into_arc(const ArcEntry& arc, double radius, double before, double outward, double turn, PathStep& step);
  bool shorten_arc_for_line(PlanePoint end, PathStep& step);
  bool shorten_line_for_arc(const ArcEntry& arc, double radius, double before, double turn, PathStep& step);
  bool shorten_arc_for_arc(const ArcEntry& arc, double radius, PathStep& step);
  void append_line(PlanePoint tool_end, PlanePoint direction, Mover mover);
  void append_arc(PlanePoint tool_end, PlanePoint center, int turns, Sweep swept);
  bool trim(PlanePoint at, PathStep& step) { return queue_.trim(at, units_.inch, step); }
  bool is_inside(int turns) const { return inside(side_, turns); }
  /// From a line's direction to the tool beside it.
  double quarter() const { return rounded(side_ == Side::kLeft ? kHalfPi : -kHalfPi); }

  MoveQueue queue_;
  PlanePoint programmed_{};
  PlanePoint tool_{};
  double radius_ = 0;
  ArcUnits units_{false, {'X', 'Y'}};
  int orientation_ = 0;
  Side side_ = Side::kLeft;
  bool on_ = false;
  bool entered_ = false;
  bool arc_forbidden_ = false;
};

}  // namespace owlint
