// Offsets, and what they do to the numbers of the point where the machine stands: it stays there.
#include "analyzer/geometry/arc.h"
#include "analyzer/syntax/mode_place.h"

namespace owlint::places {
namespace {

void scale(Point* point, double by) {
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (is_length(i)) (*point)[i] = (*point)[i] * by;
  }
}

/// Scaled or not: only 0 stays what it is.
void scale_maybe(Point* point) {
  for (size_t i = 0; i < kAxisCount; ++i) {
    Coordinate& at = (*point)[i];
    if (is_length(i) && at.value != 0) at = Coordinate::unknown();
  }
}

/// A system as its parameters say, in the units in effect.
CoordinateSystem stored(const ModeLine& line, size_t system) {
  const CoordinateSystem& parameters = line.place()->systems[system];
  return {from_machine(line, parameters.origin), parameters.rotation};
}

/// The stored offset of G92, where it is in effect.
Point stored_offset(const ModeLine& line) {
  const Place& place = *line.place();
  Point offset = from_machine(line, place.stored_offset);
  for (Coordinate& axis : offset.axes) {
    if (place.has_offset.value != 1) axis.value *= place.has_offset.value;
    if (place.has_offset.value == 0) axis.value = 0;
    if (place.has_offset.other == 0) axis.other = 0;
  }
  return offset;
}

/// The current point as another system shows it.
Point seen_from(const ModeLine& line, const CoordinateSystem& system) {
  const Place& place = *line.place();
  const Point at = (place.at + place.offset).turned(place.system.rotation) + place.system.origin - system.origin;
  return at.turned(-system.rotation) - stored_offset(line);
}

void arrive_in(ModeLine& line, const CoordinateSystem& system, const Point& at) {
  line.place()->system = system;
  arrive(line, at);
}

/// The origin and the rotation that G10 L2 writes.
void write_words(ModeLine& line, CoordinateSystem* parameters) {
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (const auto word = axis_word(line, i)) parameters->origin[i] = to_machine(line, *word, i);
  }
  if (!line.has('r')) return;
  const double* const r = line.value('r');
  parameters->rotation = r == nullptr ? Coordinate::unknown() : Coordinate::of(*r);
}

/// Those of L20: the current point becomes what the words say. True if it stops for one of them.
bool write_wishes(ModeLine& line, const CoordinateSystem& as_stored, CoordinateSystem* parameters,
                  CoordinateSystem* now) {
  const Point at = seen_from(line, as_stored);
  Point wished = at;
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (const auto word = axis_word(line, i)) wished[i] = *word;
  }
  if (goes_round(line, Positions::kAbsolute, &wished)) return true;
  const Point turned = at.turned(as_stored.rotation) + as_stored.origin - wished.turned(as_stored.rotation);
  const bool in_plane = line.has('x') || line.has('y');
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (i < 2 ? !in_plane : !line.has(kAxisOrder[i])) continue;
    now->origin[i] = i < 2 ? turned[i] : at[i] + as_stored.origin[i] - wished[i];
    parameters->origin[i] = to_machine(line, now->origin[i], i);
  }
  return false;
}

/// G10 of one system; true if it stops for one of the words.
bool write_system(ModeLine& line, size_t number, bool l20, Answer active) {
  Place& place = *line.place();
  CoordinateSystem now = stored(line, number);
  if (l20) {
    if (write_wishes(line, now, &place.systems[number], &now)) return true;
  } else {
    write_words(line, &place.systems[number]);
    now = stored(line, number);
    for (size_t i = 0; i < kAxisCount; ++i) {
      if (const auto word = axis_word(line, i)) now.origin[i] = *word;
    }
  }
  if (active == Answer::kMaybe) place.lose_offsets();
  if (active != Answer::kYes) return false;
  const Point at = place.at.turned(place.system.rotation) + place.system.origin - now.origin;
  arrive_in(line, now, at.turned(-now.rotation));
  return false;
}

}  // namespace

void lose_offsets(ModeLine& line) {
  if (line.place() != nullptr) line.place()->lose_offsets();
}

void convert_units(Place* place, bool to_inches) {
  for (Point* const point : {&place->at, &place->system.origin, &place->offset, &place->tool})
    scale(point, to_inches ? 1 / kMillimetresInInch : kMillimetresInInch);
  place->settle();
}

void change_units(ModeLine& line, Answer changes) {
  Place* const place = line.place();
  if (place == nullptr || changes == Answer::kNo) return;
  wait_on_path(line);
  if (changes == Answer::kYes) return convert_units(place, line.code(GGroup::kUnits) == code::kG20);
  for (Point* const point : {&place->at, &place->system.origin, &place->offset, &place->tool}) scale_maybe(point);
  place->settle();
}

void select_system(ModeLine& line, uint8_t system) {
  Place* const place = line.place();
  if (place == nullptr) return;
  const std::optional<uint8_t> before = line.only(Mode::kSystem);
  if (before == system) return;
  const CoordinateSystem after = stored(line, system);
  arrive_in(line, after, before ? seen_from(line, after) : Point::unknown());
}

bool set_system(ModeLine& line, bool l20) {
  Place* const place = line.place();
  if (place == nullptr) return l20 && goes_round(line, Positions::kAbsolute, nullptr);
  const double* const p = line.value('p');
  const std::optional<uint8_t> active = line.only(Mode::kSystem);
  const int number = p == nullptr ? 0 : static_cast<int>(*p);
  if (p == nullptr || (number == 0 && !active)) {
    place->lose_parameters();
    place->lose_offsets();
    return false;
  }
  const auto index = static_cast<size_t>(number == 0 ? *active : number - 1);
  const bool may = (line.now()[Mode::kSystem] & value_bit(static_cast<uint8_t>(index))) != 0;
  return write_system(line, index, l20, !may ? Answer::kNo : active ? Answer::kYes : Answer::kMaybe);
}

bool set_axis_offsets(ModeLine& line, bool g52) {
  Place* const place = line.place();
  if (place == nullptr) return goes_round(line, Positions::kAbsolute, nullptr);
  Point at = place->at;
  for (size_t i = 0; i < kAxisCount; ++i) {
    const auto word = axis_word(line, i);
    if (!word) continue;
    if (g52) {
      at[i] = at[i] + place->offset[i] - *word;
      place->offset[i] = *word;
    } else {
      place->offset[i] = at[i] + place->offset[i] - *word;
      at[i] = *word;
    }
  }
  if (goes_round(line, Positions::kAbsolute, &at)) return true;
  for (size_t i = 0; i < kAxisCount; ++i) place->stored_offset[i] = to_machine(line, place->offset[i], i);
  place->has_offset = Coordinate::of(1);
  arrive(line, at);
  return false;
}

void clear_axis_offsets(ModeLine& line, int code) {
  Place* const place = line.place();
  if (place == nullptr) return;
  const Point at = place->at + place->offset;
  if (code == code::kG92_3) {
    place->offset = from_machine(line, place->stored_offset);
    place->has_offset = Coordinate::of(1);
    return arrive(line, at - place->offset);
  }
  if (code == code::kG92_1) place->stored_offset = {};
  place->offset = {};
  place->has_offset = {};
  arrive(line, at);
}

void set_tool_offset(ModeLine& line, const Point& offset) {
  Place* const place = line.place();
  if (place == nullptr) return;
  const Point by = (place->tool - offset).turned(-place->system.rotation);
  place->tool = offset;
  arrive(line, place->at + by);
}

void set_tool_offset(ModeLine& line, const Tool& tool) {
  if (line.place() == nullptr) return;
  if (line.place()->tools_changed) return set_unknown_tool_offset(line);
  Point offset;
  for (size_t i = 0; i < kAxisCount; ++i) offset[i] = from_machine(line, Coordinate::of(tool.offset[i]), i);
  set_tool_offset(line, offset);
}

void set_written_tool_offset(ModeLine& line) {
  if (line.place() == nullptr) return;
  Point offset = line.place()->tool;
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (const auto word = axis_word(line, i)) offset[i] = *word;
  }
  set_tool_offset(line, offset);
}

void set_unknown_tool_offset(ModeLine& line) {
  if (line.place() == nullptr) return;
  Point offset;
  for (size_t i = 0; i < kAxisCount; ++i) {
    constexpr double kFirst = 7.3217;
    constexpr double kStep = 3.1191;
    offset[i].other = kFirst + kStep * static_cast<double>(i);
  }
  offset[Axis::kZ] = Coordinate::unknown();
  set_tool_offset(line, offset);
}

}  // namespace owlint::places
