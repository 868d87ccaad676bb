// What a line does to the place, and what it stops with for its numbers: the part of its steps that needs to know where the
// machine stands. Without a place all of these do nothing.
#pragma once

#include <optional>
#include <string>

#include "analyzer/geometry/plane.h"
#include "analyzer/syntax/mode_line.h"

namespace owlint {

/// The outcome of a check whose numbers may depend on the place.
enum class CheckOutcome : uint8_t {
  kPasses,
  kUnsure,     ///< it depends on what is not known
  kFromStart,  ///< stops on a machine that was just started
  kStops,
};
/// True if no run goes on. `decided_by`: modes in which the same words would pass.
bool stop_by(ModeLine& line, CheckOutcome outcome, StopKind kind, std::string message, uint8_t word,
             uint8_t other = kNoWord, ModeMask decided_by = 0, std::optional<ArcNumbers> arc = std::nullopt);

/// The word of an axis in its units; nothing if the line has none.
std::optional<Coordinate> axis_word(const ModeLine& line, size_t axis);
/// From units of the machine to those in effect, and back.
Coordinate from_machine(const ModeLine& line, Coordinate value, size_t axis);
Coordinate to_machine(const ModeLine& line, Coordinate value, size_t axis);
Point from_machine(const ModeLine& line, const Point& point);

namespace places {

/// Of two machines. `agree`: the numbers of the check are the same on both.
CheckOutcome outcome_of(bool stops, bool other_stops, bool agree, bool unknown);
/// As far as rounding goes.
bool agree(double a, double b);
/// A coordinate in the two places where a check is made: where a machine that was just started would be, or somewhere, and
/// elsewhere.
double here(Coordinate coordinate);
double elsewhere(Coordinate coordinate, size_t axis);

/// The axes of the planes of arcs, and the letters of their centers; in the order of modes::Plane.
struct ArcAxes {
  Axis first, second;
  char first_center, second_center;
};
inline constexpr ArcAxes kArcAxes[] = {
    {Axis::kX, Axis::kY, 'i', 'j'}, {Axis::kZ, Axis::kX, 'k', 'i'}, {Axis::kY, Axis::kZ, 'j', 'k'}};

/// Whether the point is the origin, from where a polar word alone leads nowhere.
CheckOutcome at_origin(Coordinate x, Coordinate y);
/// Gives X and Y other numbers, in both places.
template <typename Change>
void change_plane(Point* at, Change change) {
  Coordinate &x = (*at)[Axis::kX], &y = (*at)[Axis::kY];
  const Flat changed = change(Flat{x.value, y.value});
  const Flat other = change(Flat{x.other, y.other});
  x = {changed.first, other.first};
  y = {changed.second, other.second};
}

/// The axes that the line names, also by polar words.
AxisSet named_axes(const ModeLine& line);
/// All axes of the machine; X, Y and Z where it is not known.
AxisSet axes_of(const MachineWords& machine);
/// Tells those who watch that the line moves to a point, by which it names these axes; or that it moves somewhere.
void visit(const ModeLine& line, MoveKind kind, const Point& end, AxisSet axes);
void lose_moves(const ModeLine& line, AxisSet axes = kAllAxes);
/// The same of an arc, which moves the axes of its plane in any case.
void visit_arc(const ModeLine& line, Motion motion, const Point& end);

/// Where the line goes; true if it stops for its polar words.
bool end_point(ModeLine& line, Point* end);
void arrive(ModeLine& line, const Point& end);
/// Rotary axes that index: true if the motion moves one that it may not move.
bool moves_indexing_axis(ModeLine& line, Motion motion);
bool names_indexing_axis(const ModeLine& line);
/// Whether words are positions in any case, or where G90 is in effect.
enum class Positions : uint8_t { kAbsolute, kInG90 };
/// Rotary axes that wrap: true if a word that is a position goes round more than once. `point`, which may be null, then does not
/// know the axis.
bool goes_round(ModeLine& line, Positions are, Point* point);
/// Somewhere.
void lose_point(ModeLine& line);
/// A probe: somewhere on the way there.
void go_towards(ModeLine& line, const Point& end);
/// G33.1 goes back, but for other axes than X, Y and Z.
void return_to_start(ModeLine& line, Point* end);
/// G28 and G30: from the end point on.
bool go_home(ModeLine& line);
/// G28.1 and G30.1.
void store_home(ModeLine& line);
/// An arc that ends there.
bool arc(ModeLine& line, Motion motion, const Point& end);
/// A compensated path: with a tool of this radius, in the units in effect, on this side; a move on it; its end. They tell
/// whether the tool does not fit.
void begin_path(ModeLine& line, bool right, double radius, int orientation);
bool follow_path(ModeLine& line, Motion motion, const Point& end);
/// The first straight move has no length in the plane, wherever the tool stands: no word of its axes, or only 0 in G91.
bool enters_nowhere(ModeLine& line);
bool follow_path_by_arc(ModeLine& line, Motion motion, const Point& end);
bool pause_path(ModeLine& line);
bool end_path(ModeLine& line);
/// Units change on the way.
void wait_on_path(ModeLine& line);
/// G38.2 and G38.4, G76.
bool starts_at_end(ModeLine& line, const Point& end);
bool moves_rotary_axes(ModeLine& line, const Point& end);

/// A lathe contour is cut, with compensation off; true if it does not come to its end.
bool cut_contour(ModeLine& line, Motion motion);

// Offsets.
void lose_offsets(ModeLine& line);
void change_units(ModeLine& line, Answer changes);
void convert_units(Place* place, bool to_inches);
void select_system(ModeLine& line, uint8_t system);
bool set_system(ModeLine& line, bool l20);
bool set_axis_offsets(ModeLine& line, bool g52);
void clear_axis_offsets(ModeLine& line, int code);
/// The offset of G43 and its kin becomes this one.
void set_tool_offset(ModeLine& line, const Point& offset);
/// G43 with a tool of the table.
void set_tool_offset(ModeLine& line, const Tool& tool);
/// G43.1: the axes that are named get a new one.
void set_written_tool_offset(ModeLine& line);
/// G43 with a tool of which nothing is known: a mill's offset lies along Z.
void set_unknown_tool_offset(ModeLine& line);

// NURBS: the list of points begins where the machine stands.
void add_point(ModeLine& line, Answer begins, bool moves);
void end_curve(ModeLine& line);

// Canned cycles.
/// The heights of a cycle in a plane: whether R lies below the bottom. Nothing if modes leave that open.
std::optional<CheckOutcome> heights(ModeLine& line, modes::Plane plane);
/// The first hole, and those behind it; true if it stops for its polar words.
bool first_hole(ModeLine& line, modes::Plane plane, Point* at);
bool further_holes(ModeLine& line, modes::Plane plane, Point* at);
/// Tells those who watch of the hole at a point.
void visit_hole(const ModeLine& line, modes::Plane plane, const Point& at);
void leave_cycle(ModeLine& line, modes::Plane plane, const Point& at);
/// Behind a cycle in a plane that is not known.
void lose_cycle(ModeLine& line);

}  // namespace places
}  // namespace owlint
