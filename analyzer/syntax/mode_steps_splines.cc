// Splines and NURBS: G5, G5.1, G5.2 with G5.3, and what 2.10 added to them.
#include <algorithm>
#include <bit>

#include "analyzer/syntax/mode_place.h"

namespace owlint::steps {
namespace {

constexpr StopKind kSplineWords = StopKind::kContourWords;
constexpr BadMode kHasPoints{Mode::kNurbs, all_but(modes::kNoPoints)};
constexpr MotionSet kQuadratic = set_of(Motion::kG5_1) | set_of(Motion::kG6_1);

bool spline_axes(ModeLine& line) {
  const bool newer = line.since(Release::k2_10);
  if (!newer &&
      line.stop_in({{Mode::kPlane, all_but(modes::kG17)}}, StopKind::kPlaneWrong, "Splines must be in the XY plane",
                   line.mover()))
    return true;
  for (const char axis : std::string_view(newer ? "abc" : "zabc")) {
    if (!line.has(axis)) continue;
    return line.stop(
        kSplineWords,
        newer ? "Splines may not have motion in A, B, or C" : "Splines may not have motion in Z, A, B, or C",
        line.at(axis), line.mover());
  }
  return false;
}

bool spline_words(ModeLine& line, Motion motion, Point* end) {
  const bool i = line.has('i'), j = line.has('j');
  if (contains(kQuadratic, motion)) {
    if (i && j) return places::end_point(line, end);
    return line.stop(kSplineWords,
                     line.since(Release::k2_10) ? "Must specify both I and J with G5.1 or G6.1"
                                                : "Must specify both I and J with G5.1",
                     line.mover());
  }
  if (i != j)
    return line.stop(kSplineWords, "Must specify both I and J, or neither", line.at(i ? 'i' : 'j'), line.mover());
  if (places::end_point(line, end)) return true;
  return (!line.has('p') || !line.has('q')) &&
      line.stop(kSplineWords, "Must specify both P and Q with G5", line.mover());
}

/// What a G5.2 with one axis of the pair, or neither, stops with in a plane.
struct PointPlane {
  modes::Plane plane;
  char first, second;
  const char* half;
  const char* late;  ///< P alone behind the first point
};
constexpr PointPlane kPointPlanes[] = {
    {modes::kG17, 'x', 'y', "You must specify both X and Y coordinates for Control Points",
     "Can specify P without X and Y only for the first control point"},
    {modes::kG18, 'x', 'z', "You must specify both X and Z coordinates for Control Points",
     "Can specify P without X and Z only for the first control point"},
    {modes::kG19, 'y', 'z', "You must specify both Y and Z coordinates for Control Points",
     "Can specify P without Y and Z only for the first control point"},
};

bool point_axes(ModeLine& line, const PointPlane& pair, BadMode plane) {
  const bool first = line.has(pair.first), second = line.has(pair.second);
  const uint8_t given = line.at(first ? pair.first : pair.second);
  if (first != second && line.stop_in({plane}, kSplineWords, pair.half, given, line.mover())) return true;
  const double* const p = line.value('p');
  return !first && !second && p != nullptr && *p > 0 &&
      line.stop_in({plane, kHasPoints}, kSplineWords, pair.late, line.at('p'), line.mover());
}

bool point_words(ModeLine& line) {
  if (line.since(Release::k2_10)) {
    for (const PointPlane& pair : kPointPlanes) {
      if (point_axes(line, pair, {Mode::kPlane, value_bit(pair.plane)})) return true;
    }
  } else if (point_axes(line, kPointPlanes[0], {Mode::kPlane, ~ValueSet{0}})) {
    return true;
  }
  const double* const p = line.value('p');
  const bool weightless = !line.has('p') || (p != nullptr && *p <= 0);
  return weightless &&
      line.stop_in({kHasPoints}, kSplineWords, "Must specify positive weight P for every Control Point",
                   line.has('p') ? line.at('p') : line.mover(), line.mover());
}

/// One more point than each of these numbers.
ValueSet one_more(ValueSet numbers) {
  constexpr ValueSet kMost = value_bit(modes::kMostPoints);
  return ((numbers & ~kMost) << 1) | (numbers & kMost);
}

void add_point(ModeLine& line) {
  const ValueSet first = value_bit(1);  // where the curve begins
  const Answer goes_on = line.holds({{Mode::kMotion, set_of(Motion::kG5_2)}});
  ValueSet points = line.now()[Mode::kNurbs];
  const bool begins = goes_on != Answer::kYes || (points & value_bit(modes::kNoPoints)) != 0;
  if (goes_on == Answer::kNo) points = 0;
  points &= all_but(modes::kNoPoints);
  if (begins) {
    const ValueSet least = value_bit(modes::kOrder3);
    line.now()[Mode::kNurbsOrder] = points == 0 ? least : line.now()[Mode::kNurbsOrder] | least;
    points |= first;
  }
  const bool moves = line.has('x') && line.has('y');
  places::add_point(line,
                    points == 0 || goes_on == Answer::kNo ? Answer::kYes
                        : begins                          ? Answer::kMaybe
                                                          : Answer::kNo,
                    moves);
  line.now()[Mode::kNurbs] = moves ? one_more(points) : points;
  line.now().assigned |= mask_of(Mode::kNurbs) | mask_of(Mode::kNurbsOrder);
}

void set_order(ModeLine& line) {
  const double* const l = line.value('l');
  int32_t order = 0;
  if (line.has('l') && l == nullptr) return line.set_open(Mode::kNurbsOrder);
  if (l == nullptr || !word_integer(*l, &order) || order <= modes::kLeastOrder) return;
  line.set(Mode::kNurbsOrder, static_cast<uint8_t>(std::min<int>(order - modes::kLeastOrder, modes::kMostOrder)));
}

/// A curve needs as many points as its order says.
bool too_few_points(ModeLine& line, uint8_t word) {
  const ValueSet orders = line.now()[Mode::kNurbsOrder];
  const int least = std::countr_zero(orders) + modes::kLeastOrder;
  const int most = static_cast<int>(std::bit_width(orders)) - 1 + modes::kLeastOrder;
  const BadMode too_few{Mode::kNurbs, value_bit(static_cast<uint8_t>(most)) - 1};
  if (line.holds({too_few}) == Answer::kNo) return false;
  const std::string message =
      "You must specify a number of control points at least equal to the order L = " + std::to_string(least);
  if (least == most) return line.stop_in({too_few}, kSplineWords, message, word);
  line.may_stop(kSplineWords, message, word, kNoWord, mask_of(Mode::kNurbs) | mask_of(Mode::kNurbsOrder));
  return false;
}

}  // namespace

bool spline(ModeLine& line, Motion motion) {
  if (line.refused_by_compensation("Cannot convert spline with cutter radius compensation", line.mover()) ||
      feed_of(line, motion) || spline_axes(line))
    return true;
  Point end;
  if (spline_words(line, motion, &end)) return true;
  line.set(Mode::kNurbs, modes::kNoPoints);
  places::lose_moves(line, places::named_axes(line));
  places::arrive(line, end);
  return false;
}

bool nurbs(ModeLine& line, Motion motion) {
  if (motion == Motion::kG6_2) return feed_of(line, motion);  // its words are not measured
  if (point_words(line) || feed_of(line, motion)) return true;
  add_point(line);
  set_order(line);
  return false;
}

/// Since 2.10 a curve does not go on behind a pause.
bool pause(ModeLine& line) {
  if (places::pause_path(line)) return true;
  if (line.code(MGroup::kStop) >= 0 && line.since(Release::k2_10)) line.set(Mode::kNurbs, modes::kNoPoints);
  return false;
}

bool end_nurbs(ModeLine& line) {
  const uint8_t word = line.at(GGroup::kNonModal);
  if (line.stop_in({{Mode::kMotion, ~set_of(Motion::kG5_2)}}, kSplineWords, "Cannot use G5.3 without G5.2 first", word))
    return true;
  if (too_few_points(line, word)) return true;
  places::lose_moves(line, axis_set(0) | axis_set(1));
  places::end_curve(line);
  line.set(Mode::kNurbs, modes::kNoPoints);
  return false;
}

}  // namespace owlint::steps
