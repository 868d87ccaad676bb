// Where a line goes, and what it stops with on the way.
#include <cmath>

#include "analyzer/geometry/plane.h"
#include "analyzer/syntax/mode_place.h"

namespace owlint::places {
namespace {

constexpr StopKind kPolar = StopKind::kModeConflict;

bool stops_at_origin(ModeLine& line, const Point& at, const char* message, char letter) {
  return stop_by(line, at_origin(at[Axis::kX], at[Axis::kY]), kPolar, message, line.at(letter), line.mover(),
                 mask_of(Mode::kDistance));
}

void lose_plane(Point* at) { (*at)[Axis::kX] = (*at)[Axis::kY] = Coordinate::unknown(); }

/// Polar words in G91: one after the other.
bool further_polar(ModeLine& line, Point* end) {
  if (const double* const by = line.value('@')) {
    if (stops_at_origin(line, *end, "Incremental motion with polar coordinates is indeterminate when at the origin",
                        '@'))
      return true;
    change_plane(end, [by](Flat at) { return further_out(at, *by); });
  }
  if (const double* const by = line.value('^')) {
    if (stops_at_origin(line, *end, "G91 motion with polar coordinates is indeterminate when at the origin", '^'))
      return true;
    change_plane(end, [by](Flat at) { return further_around(at, *by); });
  }
  return false;
}

bool polar_end(ModeLine& line, Point* end) {
  const double* const radius = line.value('@');
  const double* const angle = line.value('^');
  const std::optional<uint8_t> distance = line.only(Mode::kDistance);
  const bool known = (radius != nullptr) == line.has('@') && (angle != nullptr) == line.has('^') && distance;
  if (!known) {
    lose_plane(end);
    return false;
  }
  if (*distance == modes::kG91) return further_polar(line, end);
  if (angle == nullptr && stops_at_origin(line, *end, "Must specify angle in polar coordinate if at the origin", '@'))
    return true;
  change_plane(end, [&](Flat at) { return polar(at, radius, angle); });
  return false;
}

/// G53: words are coordinates of the machine. X and Y are turned there and back, even if the line names neither.
Point machine_end(const ModeLine& line) {
  const Place& place = *line.place();
  Point end = place.at;
  const auto x = axis_word(line, 0), y = axis_word(line, 1);
  Point turned = (place.at + place.offset).turned(place.system.rotation);
  if (x) turned[0] = *x - place.system.origin[0] - place.tool[0];
  if (y) turned[1] = *y - place.system.origin[1] - place.tool[1];
  turned = turned.turned(-place.system.rotation) - place.offset;
  end[0] = turned[0];
  end[1] = turned[1];
  for (size_t i = 2; i < kAxisCount; ++i) {
    const auto word = axis_word(line, i);
    if (!word) continue;
    end[i] = *word - place.system.origin[i] - place.offset[i];
    if (is_length(i)) end[i] = end[i] - place.tool[i];
  }
  return end;
}

Point plain_end(const ModeLine& line) {
  const std::optional<uint8_t> distance = line.only(Mode::kDistance);
  Point end = line.place()->at;
  for (size_t i = 0; i < kAxisCount; ++i) {
    const auto word = axis_word(line, i);
    if (!word) continue;
    end[i] = !distance ? Coordinate::unknown() : *distance == modes::kG91 ? end[i] + *word : *word;
  }
  return end;
}

/// Whether two coordinates differ, as far as is known.
CheckOutcome differ(Coordinate from, Coordinate to, size_t axis) {
  const double far = here(to) - here(from);
  const double farther = elsewhere(to, axis) - elsewhere(from, axis);
  return outcome_of(far != 0, farther != 0, agree(far, farther), from.is_unknown() || to.is_unknown());
}

/// The same of any of these axes.
CheckOutcome differ(const Point& from, const Point& to, size_t first) {
  CheckOutcome outcome = CheckOutcome::kPasses;
  for (size_t i = first; i < kAxisCount; ++i) outcome = std::max(outcome, differ(from[i], to[i], i));
  return outcome;
}

CheckOutcome same(Coordinate from, Coordinate to, size_t axis) {
  const double far = here(to) - here(from);
  const double farther = elsewhere(to, axis) - elsewhere(from, axis);
  return outcome_of(far == 0, farther == 0, agree(far, farther), from.is_unknown() || to.is_unknown());
}

/// The stored point that the code of the line goes to.
const Point& home_of(const ModeLine& line) {
  return line.code(GGroup::kNonModal) == code::kG28 ? line.place()->home : line.place()->home30;
}

}  // namespace

bool end_point(ModeLine& line, Point* end) {
  const bool g53 = line.code(GGroup::kNonModal) == code::kG53;
  const Positions are = g53 ? Positions::kAbsolute : Positions::kInG90;
  if (line.place() == nullptr) return goes_round(line, are, nullptr);
  *end = g53 ? machine_end(line) : plain_end(line);
  if (!g53 && line.words().has_polar_words() && polar_end(line, end)) return true;
  return goes_round(line, are, end);
}

void arrive(ModeLine& line, const Point& end) {
  Place* const place = line.place();
  if (place == nullptr) return;
  place->at = end;
  place->settle();
}

void lose_point(ModeLine& line) {
  if (line.place() != nullptr) line.place()->lose_point();
}

void go_towards(ModeLine& line, const Point& end) {
  Place* const place = line.place();
  if (place == nullptr) return;
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (end[i] != place->at[i]) place->at[i] = Coordinate::unknown();
  }
  // What is asked from the machine is turned back.
  constexpr Coordinate kNoRotation{};
  if (place->system.rotation != kNoRotation && (place->at[0].is_unknown() || place->at[1].is_unknown()))
    lose_plane(&place->at);
  place->settle();
}

void return_to_start(ModeLine& line, Point* end) {
  if (line.place() == nullptr) return;
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) (*end)[axis] = line.place()->at[axis];
}

bool go_home(ModeLine& line) {
  const Place* const place = line.place();
  if (place == nullptr) return goes_round(line, Positions::kInG90, nullptr);
  Point end;
  if (end_point(line, &end)) return true;
  if (line.words().has_axis_words()) visit(line, MoveKind::kRapid, end, named_axes(line));
  const Point stored = from_machine(line, home_of(line));
  const Point home = (stored - place->system.origin - place->tool).turned(-place->system.rotation) - place->offset;
  const bool all = !line.words().has_axis_words();
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (!all && !line.has(kAxisOrder[i])) continue;
    end[i] = i < 2 ? home[i] : stored[i] - place->system.origin[i] - place->offset[i] - place->tool[i];
  }
  // A point that the program has not stored itself is another one on each machine.
  Point told = end;
  for (Coordinate& axis : told.axes) {
    if (!axis.is_known()) axis = Coordinate::unknown();
  }
  visit(line, MoveKind::kRapid, told, all ? axes_of(line.machine()) : named_axes(line));
  arrive(line, end);
  return false;
}

void store_home(ModeLine& line) {
  Place* const place = line.place();
  if (place == nullptr) return;
  const Point at = (place->at + place->offset).turned(place->system.rotation) + place->system.origin + place->tool;
  Point& home = line.code(GGroup::kNonModal) == code::kG28_1 ? place->home : place->home30;
  for (size_t i = 0; i < kAxisCount; ++i) home[i] = to_machine(line, at[i], i);
}

bool starts_at_end(ModeLine& line, const Point& end) {
  if (line.place() == nullptr) return false;
  CheckOutcome outcome = CheckOutcome::kStops;
  for (size_t i = 0; i < kAxisCount; ++i) outcome = std::min(outcome, same(line.place()->at[i], end[i], i));
  return stop_by(line, outcome, StopKind::kModeConflict, "Start point too close to probe point", line.mover());
}

bool moves_rotary_axes(ModeLine& line, const Point& end) {
  if (line.place() == nullptr) return false;
  constexpr auto kFirst = static_cast<size_t>(Axis::kA);
  const CheckOutcome outcome = differ(line.place()->at, end, kFirst);
  uint8_t word = kNoWord;
  for (size_t i = kFirst; i < kAxisCount && word == kNoWord; ++i) word = line.at(kAxisOrder[i]);
  return stop_by(line, outcome, StopKind::kContourWords, "Cannot move rotary axes with G76", word, line.mover());
}

void add_point(ModeLine& line, Answer begins, bool moves) {
  Place* const place = line.place();
  if (place == nullptr) return;
  if (begins == Answer::kYes) {
    place->curve_x = place->at[Axis::kX];
    place->curve_y = place->at[Axis::kY];
  }
  if (begins == Answer::kMaybe) place->curve_x = place->curve_y = Coordinate::unknown();
  if (!moves) return;
  const Point end = plain_end(line);
  place->curve_x = end[Axis::kX];
  place->curve_y = end[Axis::kY];
}

void end_curve(ModeLine& line) {
  Place* const place = line.place();
  if (place == nullptr) return;
  place->at[Axis::kX] = place->curve_x;
  place->at[Axis::kY] = place->curve_y;
  // Since 2.10 a curve may lie in another plane.
  if (line.since(Release::k2_10) && line.only(Mode::kPlane) != modes::kG17) place->at = Point::unknown();
  place->settle();
}

}  // namespace owlint::places
