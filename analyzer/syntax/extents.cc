#include "analyzer/syntax/extents.h"

#include <cmath>

#include "analyzer/geometry/arc_box.h"

namespace owlint {
namespace {

Flat flat(const Point& point, const ArcWay& arc) { return {point[arc.first].value, point[arc.second].value}; }

}  // namespace

void Extent::add(double from, LineOfFile from_at, double to, LineOfFile to_at) {
  if (from < least) {
    least = from;
    least_at = from_at;
  }
  if (to > greatest) {
    greatest = to;
    greatest_at = to_at;
  }
}

void Extent::add(const Extent& other) {
  if (!other.empty()) add(other.least, other.least_at, other.greatest, other.greatest_at);
}

Extent Extents::Rates::both() const {
  Extent both = rapid;
  both.add(feed);
  return both;
}

void Extents::miss(UnknownExtent why, AxisSet axes, uint32_t line) {
  const LineOfFile here{file_, line};
  for (size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((axes & axis_set(axis)) == 0) continue;
    const auto [known, added] = unknown_.try_emplace({why, axis}, here);
    if (!added) known->second = std::min(known->second, here);
  }
}

void Extents::stop(LineOfFile at) { stops_at_ = stops_at_.line == 0 ? at : std::min(stops_at_, at); }

void Extents::add(Origin origin, size_t axis, bool rapid, const Way& way, double factor) {
  Rates& rates = origins_[origin][axis];
  (rapid ? rates.rapid : rates.feed)
      .add(way.least.value * factor, {file_, way.least_line}, way.greatest.value * factor, {file_, way.greatest_line});
}

/// Where the coordinate of the machine is certain.
void Extents::add_machine(const Moves& moves, size_t axis) {
  const MachineWay way = machine_way(moves, axis, is_length(axis) ? 1 / unit_ : 1);
  if (way.trust != MachineWay::Trust::kCertain) return;
  Rates& rates = origins_[{Origin::kMachine, false, false}][axis];
  (moves.kind == MoveKind::kRapid ? rates.rapid : rates.feed)
      .add(way.least, {file_, way.least_line}, way.greatest, {file_, way.greatest_line});
}

void Extents::add_arc(const Moves& moves, Origin origin, double factor) {
  const auto first = static_cast<size_t>(moves.arc ? moves.arc->first : Axis::kX);
  const auto second = static_cast<size_t>(moves.arc ? moves.arc->second : Axis::kY);
  const AxisSet plane = axis_set(first) | axis_set(second);
  const uint32_t line = moves.ways[first].least_line;
  if (!moves.arc) return miss(UnknownExtent::kArc, plane, line);
  const ArcWay& arc = *moves.arc;
  Point end;
  for (size_t i = 0; i < kAxisCount; ++i) end[i] = moves.ways[i].least;
  const Point& start = moves.place->at;
  for (const Coordinate& of_arc : {start[first], start[second], end[first], end[second]}) {
    if (of_arc.is_unknown()) return miss(UnknownExtent::kArc, plane, line);
    origin.from_start = origin.from_start || !of_arc.is_known();
  }
  const Flat from = flat(start, arc), to = flat(end, arc);
  Flat center = arc.center;
  if (arc.radius) {
    center = center_by_radius(from, to, *arc.radius, arc.clockwise);
  } else if (!arc.absolute) {
    center = {from.first + center.first, from.second + center.second};
  }
  const ArcBox box = arc_box(from, center, to, arc.clockwise, arc.turns);
  add(origin, first, false, {Coordinate::of(box.least.first), Coordinate::of(box.greatest.first), line, line}, factor);
  add(origin, second, false, {Coordinate::of(box.least.second), Coordinate::of(box.greatest.second), line, line},
      factor);
  // In a system that is turned, the arc reaches elsewhere along the machine's axes.
  const Coordinate& turn = moves.place->system.rotation;
  if (origin.from_start || !turn.is_known() || turn.value != 0) return;
  Moves between = moves;
  between.ways[first] = {Coordinate::of(box.least.first), Coordinate::of(box.greatest.first), line, line};
  between.ways[second] = {Coordinate::of(box.least.second), Coordinate::of(box.greatest.second), line, line};
  add_machine(between, first);
  add_machine(between, second);
}

bool Extents::visit(const Moves& moves) {
  if (unit_ == 0 && !std::isnan(moves.unit)) unit_ = moves.unit;
  const bool shifted = moves.place->has_offset.is_known() && moves.place->has_offset.value != 0;
  const Origin origin{moves.system.value_or(Origin::kSomeSystem), shifted, false};
  const double factor = moves.unit / unit();
  for (size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((moves.axes & axis_set(axis)) == 0) continue;
    const Way& way = moves.ways[axis];
    if (way.least.is_unknown() || way.greatest.is_unknown()) {
      miss(UnknownExtent::kPlace, axis_set(axis), way.least_line);
      continue;
    }
    if (is_length(axis) && std::isnan(factor)) {
      miss(UnknownExtent::kUnits, axis_set(axis), way.least_line);
      continue;
    }
    if (moves.compensated) miss(UnknownExtent::kBesides, axis_set(axis), way.least_line);
    add_machine(moves, axis);
    if (moves.machine) continue;
    Origin of_axis = origin;
    of_axis.from_start = !way.least.is_known() || !way.greatest.is_known();
    add(of_axis, axis, moves.kind == MoveKind::kRapid, way, is_length(axis) ? factor : 1);
  }
  if (moves.kind == MoveKind::kArc && !std::isnan(factor)) add_arc(moves, origin, factor);
  return false;
}

}  // namespace owlint
