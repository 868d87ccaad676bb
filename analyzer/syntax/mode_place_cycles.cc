// Canned cycles: their heights, and the holes of one line.
#include <algorithm>
#include <cmath>

#include "analyzer/geometry/plane.h"
#include "analyzer/syntax/mode_place.h"

namespace owlint::places {
namespace {

constexpr const char* kAtOrigin = "Incremental motion with polar coordinates is indeterminate when at the origin";
/// Holes that are followed; behind more of them the place is not known.
constexpr int32_t kMostHoles = 1000;

struct Hole {
  Axis along, first, second;
};
/// In the order of modes::Plane.
constexpr Hole kHoles[] = {{Axis::kZ, Axis::kX, Axis::kY}, {Axis::kY, Axis::kZ, Axis::kX},
                           {Axis::kX, Axis::kY, Axis::kZ}, {Axis::kW, Axis::kU, Axis::kV},
                           {Axis::kV, Axis::kW, Axis::kU}, {Axis::kU, Axis::kV, Axis::kW}};

size_t index(Axis axis) { return static_cast<size_t>(axis); }

AxisSet plane_axes(const Hole& hole) { return axis_set(index(hole.first)) | axis_set(index(hole.second)); }

/// Of a hole, in the coordinates in effect.
struct Heights {
  Coordinate r, bottom;
};
Heights heights_of(const Place& place, bool incremental) {
  if (!incremental) return {place.clearance, place.bottom};
  const Coordinate r = place.clearance + place.height;
  return {r, r + place.bottom};
}

/// Whether R lies below the bottom.
CheckOutcome is_below(Coordinate r, Coordinate bottom, size_t axis) {
  const double depth = here(bottom) - here(r);
  const double other = elsewhere(bottom, axis) - elsewhere(r, axis);
  return outcome_of(depth > 0, other > 0, agree(depth, other), r.is_unknown() || bottom.is_unknown());
}

/// The higher one of two, as it is on each machine.
Coordinate higher(Coordinate a, Coordinate b) {
  if (a.is_unknown() || b.is_unknown()) return Coordinate::unknown();
  return {std::max(a.value, b.value), std::max(a.other, b.other)};
}

/// A polar word that is 0 moves nothing here.
bool turns_at_origin(ModeLine& line, char letter, const Point& at) {
  const double* const word = line.value(letter);
  if (word == nullptr || *word == 0) return false;
  return stop_by(line, at_origin(at[Axis::kX], at[Axis::kY]), StopKind::kModeConflict, kAtOrigin, line.at(letter),
                 line.mover(), mask_of(Mode::kDistance));
}

void lose_plane(const Hole& hole, Point* at) { (*at)[hole.first] = (*at)[hole.second] = Coordinate::unknown(); }

/// From one hole to the next in G91.
bool advance(ModeLine& line, const Hole& hole, Point* at) {
  for (const Axis axis : {hole.first, hole.second}) {
    if (const auto word = axis_word(line, index(axis))) (*at)[axis] = (*at)[axis] + *word;
  }
  for (const char letter : {'@', '^'}) {
    if (!line.has(letter)) continue;
    if (turns_at_origin(line, letter, *at)) return true;
    const double* const by = line.value(letter);
    if (by == nullptr) {
      lose_plane(hole, at);
    } else if (*by != 0) {
      change_plane(at, [&](Flat from) { return letter == '@' ? further_out(from, *by) : further_around(from, *by); });
    }
  }
  return false;
}

/// To the holes of a line in G90: all are at one place.
void go(const ModeLine& line, const Hole& hole, Point* at) {
  for (const Axis axis : {hole.first, hole.second}) {
    if (const auto word = axis_word(line, index(axis))) (*at)[axis] = *word;
  }
  if (line.words().has_polar_words()) {
    const double* const radius = line.value('@');
    const double* const angle = line.value('^');
    if ((radius == nullptr && line.has('@')) || (angle == nullptr && line.has('^'))) return lose_plane(hole, at);
    change_plane(at, [&](Flat from) { return polar(from, radius, angle); });
  }
  // From hole to hole it adds 0, which makes a 0 of -0: messages show that.
  for (const Axis axis : {hole.first, hole.second}) (*at)[axis] = (*at)[axis] + Coordinate::of(0);
}

int32_t holes(const ModeLine& line) {
  const double* const l = line.value('l');
  int32_t number = 1;
  if (l != nullptr) word_integer(*l, &number);
  return l == nullptr && line.has('l') ? kMostHoles + 1 : number;
}

}  // namespace

std::optional<CheckOutcome> heights(ModeLine& line, modes::Plane plane) {
  const Hole& hole = kHoles[plane];
  Place& place = *line.place();
  if (!place.keeps_height) place.height = place.at[hole.along];
  place.keeps_height = true;
  if (const double* const r = line.value('r')) place.clearance = Coordinate::of(*r);
  if (line.has('r') && line.value('r') == nullptr) place.clearance = Coordinate::unknown();
  if (const auto bottom = axis_word(line, index(hole.along))) place.bottom = *bottom;
  const std::optional<uint8_t> distance = line.only(Mode::kDistance);
  if (!distance) return std::nullopt;
  const Heights heights = heights_of(place, *distance == modes::kG91);
  return is_below(heights.r, heights.bottom, index(hole.along));
}

bool first_hole(ModeLine& line, modes::Plane plane, Point* at) {
  const Hole& hole = kHoles[plane];
  *at = line.place()->at;
  const std::optional<uint8_t> distance = line.only(Mode::kDistance);
  if (!distance) {
    lose_plane(hole, at);
    return false;
  }
  if (*distance == modes::kG91) return advance(line, hole, at);
  go(line, hole, at);
  return false;
}

bool further_holes(ModeLine& line, modes::Plane plane, Point* at) {
  const Hole& hole = kHoles[plane];
  if (line.only(Mode::kDistance) != modes::kG91) return false;
  const int32_t number = holes(line);
  if (number > kMostHoles) lose_plane(hole, at);
  for (int32_t i = 1; i < std::min(number, kMostHoles); ++i) {
    if (advance(line, hole, at)) return true;
    visit(line, MoveKind::kRapid, *at, plane_axes(hole));
  }
  return false;
}

void visit_hole(const ModeLine& line, modes::Plane plane, const Point& at) {
  if (line.watch().visitor == nullptr) return;
  const Hole& hole = kHoles[plane];
  const std::optional<uint8_t> distance = line.only(Mode::kDistance);
  if (!distance) return lose_moves(line, kAllAxes);
  const Heights heights = heights_of(*line.place(), *distance == modes::kG91);
  Point end = at;
  end[hole.along] = heights.r;
  visit(line, MoveKind::kRapid, end, plane_axes(hole) | axis_set(index(hole.along)));
  end[hole.along] = heights.bottom;
  visit(line, MoveKind::kFeed, end, axis_set(index(hole.along)));
}

void lose_cycle(ModeLine& line) {
  Place* const place = line.place();
  if (place == nullptr) return;
  place->clearance = place->bottom = place->height = Coordinate::unknown();
  place->keeps_height = true;
  lose_moves(line);
  place->lose_point();
}

void leave_cycle(ModeLine& line, modes::Plane plane, const Point& at) {
  const Hole& hole = kHoles[plane];
  const Place& place = *line.place();
  const std::optional<uint8_t> distance = line.only(Mode::kDistance);
  const std::optional<uint8_t> retract = line.only(Mode::kRetract);
  Point end = at;
  Coordinate& along = end[hole.along];
  along = Coordinate::unknown();
  if (distance) {
    const Coordinate r = heights_of(place, *distance == modes::kG91).r;
    if (retract == modes::kG99) along = r;
    if (retract == modes::kG98) along = higher(place.height, r);
  }
  visit(line, MoveKind::kRapid, end, axis_set(index(hole.along)));
  arrive(line, end);
}

}  // namespace owlint::places
