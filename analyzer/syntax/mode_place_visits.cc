// Where a line moves, for those who watch (moves.h).
#include <iterator>

#include "analyzer/syntax/mode_place.h"

namespace owlint::places {
namespace {

Moves moves_of(const ModeLine& line, MoveKind kind, const Point& end, AxisSet axes) {
  Moves moves;
  moves.kind = kind;
  moves.place = line.place();
  moves.system = line.only(Mode::kSystem);
  moves.unit = unit_in_effect(line.now());
  moves.machine = line.code(GGroup::kNonModal) == code::kG53;
  moves.compensated = line.holds({kCompensationMoves}) != Answer::kNo;
  moves.axes = axes;
  moves.end_at(end, line.watch().line);
  return moves;
}

/// The words of an arc; nothing if one of them is not known.
std::optional<ArcWay> way_of(const ModeLine& line, const ArcAxes& axes, bool clockwise) {
  const std::optional<uint8_t> distance = line.only(Mode::kArcDistance);
  ArcWay arc{axes.first, axes.second, clockwise, 1, std::nullopt, {}, distance == modes::kG90_1};
  const auto read = [&](char letter, double* value) {
    if (!line.has(letter)) return true;
    if (line.value(letter) == nullptr) return false;
    *value = *line.value(letter);
    return true;
  };
  double turns = 1;
  double radius = 0;
  if (!read('p', &turns) || !read('r', &radius)) return std::nullopt;
  if (!read(axes.first_center, &arc.center.first) || !read(axes.second_center, &arc.center.second)) return std::nullopt;
  arc.turns = nearest_integer(turns);
  if (line.has('r')) {
    arc.radius = radius;
  } else if (!distance) {
    return std::nullopt;
  }
  return arc;
}

}  // namespace

AxisSet named_axes(const ModeLine& line) {
  AxisSet axes = 0;
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (line.has(kAxisOrder[i])) axes |= axis_set(i);
  }
  return line.words().has_polar_words() ? axes | axis_set(0) | axis_set(1) : axes;
}

AxisSet axes_of(const MachineWords& machine) {
  const uint32_t letters = machine.unsure ? letter_set("xyz") : machine.axes;
  AxisSet axes = 0;
  for (size_t i = 0; i < kAxisCount; ++i) {
    if ((letters & letter_set({&kAxisOrder[i], 1})) != 0) axes |= axis_set(i);
  }
  return axes;
}

void visit(const ModeLine& line, MoveKind kind, const Point& end, AxisSet axes) {
  if (line.watch().visitor != nullptr && line.place() != nullptr)
    line.watch().visitor->visit(moves_of(line, kind, end, axes));
}

void visit_arc(const ModeLine& line, Motion motion, const Point& end) {
  if (line.watch().visitor == nullptr || line.place() == nullptr) return;
  Moves moves = moves_of(line, MoveKind::kArc, end, named_axes(line));
  const std::optional<uint8_t> plane = line.only(Mode::kPlane);
  if (plane && *plane < std::size(kArcAxes)) {
    const ArcAxes& axes = kArcAxes[*plane];
    moves.axes |= axis_set(static_cast<size_t>(axes.first)) | axis_set(static_cast<size_t>(axes.second));
    moves.arc = way_of(line, axes, motion == Motion::kG2);
  }
  line.watch().visitor->visit(moves);
}

void lose_moves(const ModeLine& line, AxisSet axes) {
  if (line.watch().visitor != nullptr && axes != 0) line.watch().visitor->lose(line.watch().line, axes);
}

}  // namespace owlint::places
