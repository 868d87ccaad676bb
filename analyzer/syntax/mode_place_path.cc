// On a path with cutter compensation: whether the tool fits between the moves. Without its radius, or where a point of the
// path is
// not known, nothing is claimed until compensation is switched off.
#include <cmath>

#include "analyzer/syntax/mode_place.h"

namespace owlint::places {
namespace {

/// The plane of the path; it cannot change on the way but to one in which nothing moves.
struct PathPlane {
  Axis first, second;
  char first_center, second_center;
  std::array<char, 2> names;
};
constexpr PathPlane kXy{Axis::kX, Axis::kY, 'i', 'j', {'X', 'Y'}};
constexpr PathPlane kZx{Axis::kZ, Axis::kX, 'k', 'i', {'Z', 'X'}};

const PathPlane* plane_of(const ModeLine& line) {
  const std::optional<uint8_t> plane = line.only(Mode::kPlane);
  if (!plane || *plane > modes::kG18) return nullptr;
  return *plane == modes::kG17 ? &kXy : &kZx;
}

/// A point of the path, on a machine that was just started; nothing if it is not known.
std::optional<PlanePoint> point_of(Place& place, const Point& point, const PathPlane& plane) {
  const Coordinate first = point[plane.first], second = point[plane.second];
  if (first.is_unknown() || second.is_unknown()) return std::nullopt;
  if (!first.is_known() || !second.is_known()) place.path_from_start = true;
  return PlanePoint{first.value, second.value};
}

StopKind kind_of(const PathStep& step) {
  switch (step.fault) {
    case PathFault::kEntryTooShort: return StopKind::kCompensationEntry;
    case PathFault::kGouge: return StopKind::kCompensationGouge;
    case PathFault::kRadiiDiffer: return StopKind::kArcRadiiDiffer;
    case PathFault::kRadiusTooSmall: return StopKind::kArcRadiusTooSmall;
    case PathFault::kZeroRadius:
    case PathFault::kSamePoint: return StopKind::kArcWords;
    // Bugs by the interpreter's own word: of the entry, or of a corner.
    case PathFault::kBug:
      return step.message.starts_with("Bug in tool") ? StopKind::kCompensationEntry : StopKind::kCompensationGouge;
    case PathFault::kNone:
    case PathFault::kNotStraight: break;
  }
  return StopKind::kCompensation;
}

bool stops(ModeLine& line, PathStep step, uint8_t word, const std::optional<ArcNumbers>& arc = std::nullopt) {
  Place& place = *line.place();
  if (!step.stops()) return false;
  if (step.undecided) {
    // Rounding decides, and not every build rounds alike.
    const StopKind kind = kind_of(step);
    line.may_stop(kind, std::move(step.message), word, kNoWord, 0, true);
    line.faults()->back().by_place = true;
    place.lose_path();
    return false;
  }
  const StopKind kind = kind_of(step);
  return stop_by(line, place.path_from_start ? CheckOutcome::kFromStart : CheckOutcome::kStops, kind,
                 std::move(step.message), word, kNoWord, 0, arc);
}

/// What of the arc a finding tells.
ArcNumbers numbers_of(const ModeLine& line, const PathPlane& plane, PlanePoint from, const ArcEntry& arc) {
  ArcNumbers numbers{};
  numbers.first = kAxisOrder[static_cast<size_t>(plane.first)];
  numbers.second = kAxisOrder[static_cast<size_t>(plane.second)];
  numbers.first_center = plane.first_center;
  numbers.second_center = plane.second_center;
  numbers.start_known = true;
  numbers.inch = line.only(Mode::kUnits) == modes::kG20;
  numbers.diameter = line.only(Mode::kDiameter) == modes::kG7;
  numbers.incremental = line.only(Mode::kDistance) == modes::kG91;
  numbers.absolute_center = line.only(Mode::kArcDistance) == modes::kG90_1;
  numbers.clockwise = arc.turns < 0;
  numbers.tolerance = arc_tolerance(numbers.inch, arc.spread);
  numbers.start = {from.first, from.second};
  numbers.center = {arc.center.first, arc.center.second};
  numbers.end = {arc.end.first, arc.end.second};
  if (arc.by_radius) {
    numbers.radius = arc.radius;
    numbers.least_radius = arc_by_radius(numbers.start, numbers.end, arc.radius, numbers.tolerance).least_radius;
  } else {
    const CenterArc radii = arc_by_center(numbers.start, numbers.center, numbers.end, numbers.tolerance);
    numbers.start_radius = radii.start_radius;
    numbers.end_radius = radii.end_radius;
    numbers.allowed = radii.allowed;
  }
  return numbers;
}

/// Whether the moves of the line are on a path that is known. If it may be one, it is known no more.
bool is_on_path(ModeLine& line) {
  if (line.place() == nullptr) return false;
  const Answer moves = line.holds({kCompensationMoves});
  if (moves == Answer::kYes && line.place()->path.offsets() && line.holds({kCompensationOn}) == Answer::kYes)
    return true;
  if (moves != Answer::kNo) line.place()->lose_path();
  return false;
}

/// The turns of an arc, negative for G2; nothing if they are not known.
std::optional<int> turns_of(const ModeLine& line, Motion motion) {
  int turns = 1;
  if (line.has('p')) {
    const double* const p = line.value('p');
    if (p == nullptr) return std::nullopt;
    turns = static_cast<int>(std::nearbyint(*p));
  }
  return motion == Motion::kG2 ? -turns : turns;
}

/// The words of an arc; false if one is not known.
bool read_arc(const ModeLine& line, const PathPlane& plane, PlanePoint start, ArcEntry* arc) {
  if (arc->by_radius) {
    if (line.value('r') == nullptr) return false;
    arc->radius = *line.value('r');
    return true;
  }
  const std::optional<uint8_t> distance = line.only(Mode::kArcDistance);
  if (!distance) return false;
  const auto word = [&](char letter) -> std::optional<double> {
    if (!line.has(letter)) return 0;
    if (line.value(letter) == nullptr) return std::nullopt;
    return *line.value(letter);
  };
  const auto first = word(plane.first_center), second = word(plane.second_center);
  if (!first || !second) return false;
  arc->center = *distance == modes::kG90_1 ? PlanePoint{*first, *second}
                                           : PlanePoint{start.first + *first, start.second + *second};
  return true;
}

/// What waits cannot be sent in a plane of U, V and W. Of an arc it cannot be said what the interpreter does.
bool cannot_send(ModeLine& line, uint8_t word) {
  const std::optional<uint8_t> plane = line.only(Mode::kPlane);
  const QueuedMove* const waiting = line.place()->path.waiting();
  if (!plane || *plane < modes::kG17_1 || waiting == nullptr || waiting->arc) return false;
  const int number = *plane == modes::kG17_1 ? 4 : *plane == modes::kG19_1 ? 5 : 6;
  PathStep step;
  step.stop(PathFault::kNotStraight,
            waiting->rapid ? "BUG: Unsupported plane in cutter compensation"
                           : printed("BUG: Unsupported plane [%d] in cutter compensation", number));
  return stops(line, std::move(step), word);
}

}  // namespace

void begin_path(ModeLine& line, bool right, double radius, int orientation) {
  Place* const place = line.place();
  if (place == nullptr) return;
  place->lose_path();
  const PathPlane* const plane = plane_of(line);
  const std::optional<uint8_t> units = line.only(Mode::kUnits);
  if (plane == nullptr || !units || radius == 0) return;
  place->path_from_start = false;
  const std::optional<PlanePoint> at = point_of(*place, place->at, *plane);
  if (!at) return;
  place->path.start({right ? Side::kRight : Side::kLeft, radius, orientation}, {*units == modes::kG20, plane->names},
                    *at);
}

bool follow_path(ModeLine& line, Motion motion, const Point& end) {
  if (!is_on_path(line)) return false;
  Place& place = *line.place();
  const PathPlane* const plane = plane_of(line);
  const std::optional<PlanePoint> to = plane == nullptr ? std::nullopt : point_of(place, end, *plane);
  if (!to) {
    place.lose_path();
    return false;
  }
  const Mover mover = motion == Motion::kG0 ? Mover::kRapid : motion == Motion::kG1 ? Mover::kFeed : Mover::kThread;
  return stops(line, place.path.line(*to, mover), line.mover());
}

bool enters_nowhere(ModeLine& line) {
  constexpr BadMode kToCome{Mode::kEntry, value_bit(modes::kToCome)};
  const PathPlane* const plane = plane_of(line);
  if (plane == nullptr || line.words().has_polar_words() || line.holds({kCompensationOn, kToCome}) != Answer::kYes)
    return false;
  for (const Axis axis : {plane->first, plane->second}) {
    const std::optional<Coordinate> word = axis_word(line, static_cast<size_t>(axis));
    if (!word) continue;
    if (line.only(Mode::kDistance) != modes::kG91 || !word->is_known() || word->value != 0) return false;
  }
  if (line.holds({kCompensationMoves}) != Answer::kYes) return false;
  line.stop(StopKind::kCompensationEntry,
            "Length of cutter compensation entry move is not greater than the tool radius", line.mover(), kNoWord,
            mask_of(Mode::kCompensation) | mask_of(Mode::kRadius) | mask_of(Mode::kEntry));
  line.faults()->back().by_place = line.place() != nullptr;
  return true;
}

bool follow_path_by_arc(ModeLine& line, Motion motion, const Point& end) {
  if (!is_on_path(line)) return false;
  Place& place = *line.place();
  const PathPlane* const plane = plane_of(line);
  const std::optional<PlanePoint> to = plane == nullptr ? std::nullopt : point_of(place, end, *plane);
  const std::optional<int> turns = turns_of(line, motion);
  const bool inch = line.only(Mode::kUnits) == modes::kG20;
  ArcEntry arc{to.value_or(PlanePoint{}),
               line.has('r'),
               0,
               {},
               turns.value_or(1),
               inch ? line.machine().arc_tolerance_inch : line.machine().arc_tolerance_mm};
  const PlanePoint start = place.path.entered() ? place.path.programmed() : place.path.tool();
  if (!to || !turns || !read_arc(line, *plane, start, &arc)) {
    place.lose_path();
    return false;
  }
  const ArcNumbers numbers = numbers_of(line, *plane, start, arc);
  return stops(line, place.path.arc(arc), line.mover(), numbers);
}

bool pause_path(ModeLine& line) {
  if (line.code(MGroup::kStop) < 0 || !is_on_path(line)) return false;
  if (cannot_send(line, line.at(MGroup::kStop))) return true;
  return stops(line, line.place()->path.pause(), line.at(MGroup::kStop));
}

bool end_path(ModeLine& line) {
  if (line.place() == nullptr) return false;
  const bool known = is_on_path(line);
  const uint8_t word = line.at(GGroup::kCutterCompensation);
  if (known && (cannot_send(line, word) || stops(line, line.place()->path.off(), word))) return true;
  line.place()->lose_path();
  return false;
}

void wait_on_path(ModeLine& line) {
  // How often what waits is scaled when units change is not followed.
  if (line.place() != nullptr && line.place()->path.on()) line.place()->lose_path();
}

}  // namespace owlint::places
