// Tools: T, M6, M61, and the length offset G43 to G49.
#include <cmath>

#include "analyzer/syntax/mode_place.h"

namespace owlint::steps {
namespace {

constexpr const char* kNoOffsetChange = "Cannot change tool offset with cutter radius compensation on";
constexpr ValueSet kAnyOffset = value_bit(modes::kG49) | value_bit(modes::kOffsetOn);

/// The number of a word that has to be whole; false if it is not known.
bool number_of(const ModeLine& line, char letter, int* number) {
  const double* const value = line.value(letter);
  return value != nullptr && word_integer(*value, number);
}

/// A tool gives an offset, which may be 0; null: it is not known which one.
void take_offset_of(ModeLine& line, const Tool* tool) {
  if (tool != nullptr) {
    places::set_tool_offset(line, *tool);
  } else {
    places::set_unknown_tool_offset(line);
  }
  if (tool == nullptr) return line.set_open(Mode::kToolOffset, kAnyOffset);
  line.set(Mode::kToolOffset, tool->has_offset ? modes::kOffsetOn : modes::kG49);
}

/// G43: without H the tool in the spindle.
bool from_table(ModeLine& line) {
  int number = 0;
  if (number_of(line, 'h', &number) && line.lacks_tool(number, line.at('h'), line.at(GGroup::kToolLength))) return true;
  take_offset_of(line, line.has('h') && number != 0 ? line.tool(number) : line.tool_in_spindle());
  return false;
}

/// G43.1: the axes that are named get a new offset.
bool from_words(ModeLine& line) {
  bool sets = false;
  for (const char axis : std::string_view("xyzabcuvw")) {
    const double* const value = line.value(axis);
    sets = sets || (value != nullptr && *value != 0);
  }
  places::set_written_tool_offset(line);
  if (sets) {
    line.set(Mode::kToolOffset, modes::kOffsetOn);
  } else if (line.words().has_axis_words()) {
    line.set_open(Mode::kToolOffset, kAnyOffset);
  }
  return false;
}

/// G43.2: one more offset, of H or from the words. Before 2.10 the words made it look for tool -1.
bool further(ModeLine& line) {
  const uint8_t word = line.at(GGroup::kToolLength);
  const bool axes = line.words().has_axis_words();
  if (line.has('h') && axes)
    return line.stop(StopKind::kModeConflict, "G43.2: Can not have both H and axis words", line.at('h'), word);
  if (!line.has('h') && !axes)
    return line.stop(StopKind::kModeConflict, "G43.2: No axes specified and H word missing", word);
  constexpr int kNoTool = -1;
  int number = 0;
  if (axes && !line.since(Release::k2_10)) number = kNoTool;
  if (line.has('h')) number_of(line, 'h', &number);
  if (line.lacks_tool(number, line.has('h') ? line.at('h') : word)) return true;
  places::set_unknown_tool_offset(line);
  line.set_open(Mode::kToolOffset, kAnyOffset);
  return false;
}

/// M61: its Q is rounded half to even.
bool set_number(ModeLine& line) {
  line.set_open(Mode::kLoaded);
  if (line.place() != nullptr) line.place()->loaded_tool = Place::kUnknownTool;
  const uint8_t word = line.at(MGroup::kToolChange);
  const double* const q = line.value('q');
  if (line.has('q') && q == nullptr) return false;
  const double number = q == nullptr ? -1 : std::nearbyint(*q);
  if (number < 0)
    return line.stop(StopKind::kModeConflict, "Need non-negative Q-word to specify tool number with M61", word,
                     line.at('q'));
  return line.lacks_tool(nearest_integer(number), line.at('q'), word);
}

/// RETAIN_G43: while an offset is on, each line begins with G43 for the tool in the spindle, and G49 does nothing.
bool repeats_offset(ModeLine& line) {
  const BadMode on{Mode::kToolOffset, value_bit(modes::kOffsetOn)};
  if (line.stop_in({on, kCompensationOn}, StopKind::kCompensation, kNoOffsetChange,
                   line.at(GGroup::kCutterCompensation), line.at(GGroup::kToolLength)))
    return true;
  // Where the tool in the spindle is the prepared one, it does not matter which of the two counts.
  const Place* const place = line.place();
  const bool same = place != nullptr && place->chosen_tool == place->loaded_tool;
  take_offset_of(line, same ? line.tool_in_spindle() : nullptr);
  return false;
}

/// True if no run goes on.
bool change_offset(ModeLine& line, int code) {
  switch (code) {
    case code::kG43: return from_table(line);
    case code::kG43_1: return from_words(line);
    case code::kG43_2: return further(line);
    default:
      line.set(Mode::kToolOffset, modes::kG49);
      places::set_tool_offset(line, Point{});
      return false;
  }
}

}  // namespace

bool select_tool(ModeLine& line) {
  int number = 0;
  const bool known = number_of(line, 't', &number);
  if (line.place() != nullptr && line.has('t')) line.place()->chosen_tool = known ? number : Place::kUnknownTool;
  return known && line.lacks_tool(number, line.at('t'));
}

bool change_tool(ModeLine& line) {
  const int code = line.code(MGroup::kToolChange);
  if (code == code::kM61) return set_number(line);
  if (code != code::kM6) return false;
  if (line.refused_by_compensation("Cannot change tools with cutter radius compensation on",
                                   line.at(MGroup::kToolChange)))
    return true;
  line.set_open(Mode::kLoaded);
  if (line.place() != nullptr) line.place()->loaded_tool = line.place()->chosen_tool;
  if (!line.machine().change_keeps_spindle) line.set(Mode::kTurning, modes::kStopped);
  return false;
}

bool tool_length(ModeLine& line) {
  const bool retains = line.machine().retains_offset;
  const bool repeats = retains && line.now()[Mode::kToolOffset] != value_bit(modes::kG49);
  if (repeats && repeats_offset(line)) return true;
  const int code = line.code(GGroup::kToolLength);
  if (code < 0) return false;
  if (line.refused_by_compensation(kNoOffsetChange, line.at(GGroup::kToolLength))) return true;
  if (repeats && code == code::kG49) return false;
  if (change_offset(line, code)) return true;
  if (retains) places::set_unknown_tool_offset(line);
  return false;
}

}  // namespace owlint::steps
