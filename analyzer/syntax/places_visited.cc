// Lines up to the first from where runs may go elsewhere, for those who ask where moves end: whole stretches of plain lines at
// once, so that a large program costs no more than reading its numbers.
#include <bit>
#include <iterator>

#include "analyzer/syntax/mode_place.h"
#include "analyzer/syntax/places_in_effect.h"

namespace owlint {
namespace {

/// The only motion that may be in effect, or the first.
Motion motion_of(const ModeSets& modes) { return static_cast<Motion>(std::countr_zero(modes[Mode::kMotion])); }

MoveKind kind_of_motion(Motion motion) {
  if (motion == Motion::kG0) return MoveKind::kRapid;
  return motion == Motion::kG1 ? MoveKind::kFeed : MoveKind::kArc;
}

template <typename Do>
void for_axes(uint32_t letters, const Do& apply) {
  for_letters(letters & kAxisLetters, [&](size_t letter) { apply(letter, axis_of_letter(letter)); });
}

}  // namespace

Moves PlacesInEffect::moves_from_here(MoveKind kind) const {
  const ModeSets& now = assumed_.now;
  Moves moves;
  moves.kind = kind;
  moves.place = &place_;
  moves.system = static_cast<uint8_t>(std::countr_zero(now[Mode::kSystem]));
  moves.unit = unit_in_effect(now);
  moves.compensated = now[Mode::kRadius] != value_bit(modes::kNoRadius);
  moves.end_at(place_.at, 0);
  return moves;
}

bool PlacesInEffect::tell(const PlainReach& reach, MoveKind kind) {
  if (reach.letters == 0) return false;
  const bool incremental = assumed_.now[Mode::kDistance] == value_bit(modes::kG91);
  const bool diameter = assumed_.now[Mode::kDiameter] == value_bit(modes::kG7);
  Moves moves = moves_from_here(kind);
  for_axes(reach.letters, [&](size_t, size_t axis) {
    const Extremes& ends = incremental ? reach.sums[axis] : reach.words[axis];
    const double share = diameter && axis == 0 ? 0.5 : 1;
    const Coordinate from = incremental ? place_.at[axis] : Coordinate{};
    moves.axes |= axis_set(axis);
    moves.ways[axis] = {from + Coordinate::of(ends.least * share), from + Coordinate::of(ends.greatest * share),
                        ends.least_line, ends.greatest_line};
  });
  return visitor_->visit(moves);
}

/// Before the line has moved.
void PlacesInEffect::tell_line(const PlainWords& words, Motion motion, uint32_t line) {
  const bool arc = motion == Motion::kG2 || motion == Motion::kG3;
  if (arc ? words.letters == 0 : (words.letters & kAxisLetters) == 0) return;
  const bool incremental = assumed_.now[Mode::kDistance] == value_bit(modes::kG91);
  const bool diameter = assumed_.now[Mode::kDiameter] == value_bit(modes::kG7);
  Moves moves = moves_from_here(kind_of_motion(motion));
  for_axes(words.letters, [&](size_t letter, size_t axis) {
    const double word = diameter && axis == 0 ? words.values[letter] / 2 : words.values[letter];
    const Coordinate from = incremental ? place_.at[axis] : Coordinate{};
    moves.axes |= axis_set(axis);
    moves.ways[axis] = Way::to(from + Coordinate::of(word), line);
  });
  if (arc) add_arc(words, motion == Motion::kG2, line, &moves);
  visitor_->visit(moves);
}

/// The plane of an arc, and its words.
void PlacesInEffect::add_arc(const PlainWords& words, bool clockwise, uint32_t line, Moves* moves) const {
  const auto plane = static_cast<size_t>(std::countr_zero(assumed_.now[Mode::kPlane]));
  if (plane >= std::size(places::kArcAxes)) return;
  const places::ArcAxes& axes = places::kArcAxes[plane];
  const bool absolute = assumed_.now[Mode::kArcDistance] == value_bit(modes::kG90_1);
  ArcWay arc{axes.first, axes.second, clockwise, 1, std::nullopt, {}, absolute};
  if (words.has('r')) arc.radius = words['r'];
  if (words.has(axes.first_center)) arc.center.first = words[axes.first_center];
  if (words.has(axes.second_center)) arc.center.second = words[axes.second_center];
  for (const Axis of_plane : {axes.first, axes.second}) {
    const auto axis = static_cast<size_t>(of_plane);
    moves->axes |= axis_set(axis);
    moves->ways[axis].least_line = moves->ways[axis].greatest_line = line;
  }
  moves->arc = arc;
}

void PlacesInEffect::tell_each(std::string_view bytes, size_t from, size_t to, uint32_t line) {
  const Place start = place_;
  Motion motion = motion_of(assumed_.now);
  PlainWords words;
  for (; from < to; ++line) {
    from = reader_.read(bytes, from, &words);
    if (words.code >= 0) motion = static_cast<Motion>(words.code);
    words.convert(kAxisLetters);
    tell_line(words, motion, line);
    for_axes(words.letters, [&](size_t letter, size_t) { go(letter, words.values[letter], words.values[letter]); });
  }
  place_ = start;
}

/// Plain lines that are straight moves, without compensation.
void PlacesInEffect::walk(std::string_view bytes, size_t from, size_t to, uint32_t line, const ModeSets& before,
                          bool alone) {
  Motion motion = motion_of(assumed_.now);
  PlainMoves moves;
  PlainReaches reaches;
  PlainWords words;
  uint32_t number = line;
  for (size_t at = from; at < to; ++number) {
    at = reader_.read(bytes, at, &words);
    if (words.code >= 0) motion = static_cast<Motion>(words.code);
    if ((words.letters & kAxisLetters) == 0) continue;
    words.convert(kAxisLetters);
    for_axes(words.letters, [&](size_t letter, size_t) { moves.add(letter, words.values[letter]); });
    (motion == Motion::kG0 ? reaches.rapid : reaches.feed).add(words, moves, number);
  }
  if (!left_ && (tell(reaches.rapid, MoveKind::kRapid) || tell(reaches.feed, MoveKind::kFeed)))
    tell_each(bytes, from, to, line);
  for_axes(moves.letters, [&](size_t letter, size_t) { go(letter, moves.last[letter], moves.sum[letter]); });
  if (left_) note(moves, &reaches, before, alone);
}

}  // namespace owlint
