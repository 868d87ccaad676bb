// Codes of group 0 that set offsets or go to stored positions: G10, G28, G30, G52, G92, and G92.1 to G92.3.
#include <cmath>

#include "analyzer/syntax/mode_place.h"

namespace owlint::steps {
namespace {

constexpr StopKind kConflict = StopKind::kModeConflict;
constexpr int kMostOrientation = 9;

/// G10 L2 and L20: P is cut to a whole number, and 0 means the active system.
bool set_system(ModeLine& line, bool l20) {
  const uint8_t word = line.at(GGroup::kNonModal);
  for (const char letter : {'i', 'j'}) {
    if (line.has(letter)) return line.stop(kConflict, "I J words not allowed with G10 L2", line.at(letter), word);
  }
  constexpr const char* kRefusal = "Cannot change the active coordinate system with cutter radius compensation on";
  const double* const p = line.value('p');
  if (p != nullptr) {
    const int number = static_cast<int>(*p);
    const ValueSet active = number == 0 ? all_values(Mode::kSystem) : value_bit(static_cast<uint8_t>(number - 1));
    if (line.stop_in({kCompensationOn, {Mode::kSystem, active}}, StopKind::kCompensation, kRefusal, word, line.at('p')))
      return true;
  } else if (line.holds({kCompensationOn}) != Answer::kNo) {
    line.may_stop(StopKind::kCompensation, kRefusal, word, line.at('p'), mask_of(Mode::kCompensation));
  }
  if (l20 && line.has('r')) return line.stop(kConflict, "R not allowed in G10 L20", line.at('r'), word);
  return places::set_system(line, l20);
}

/// G10 L1, L10 and L11: P is rounded.
bool set_tool(ModeLine& line) {
  if (line.place() != nullptr) line.place()->tools_changed = true;
  const uint8_t word = line.at(GGroup::kNonModal);
  const double* const p = line.value('p');
  if (p != nullptr && line.lacks_tool(nearest_integer(*p), line.at('p'), word)) return true;
  const bool changes =
      line.words().has_axis_words() || line.has('r') || line.has('q') || line.has('i') || line.has('j');
  if (!changes) return line.stop(kConflict, "G10 L1 without offsets has no effect", word);
  line.set_open(Mode::kLoaded);  // it may copy its diameter to the spindle
  const double* const q = line.value('q');
  if (q == nullptr || line.lacks('q')) return false;
  const double orientation = std::trunc(*q + 0.5);
  if (!(std::abs(*q - orientation) < kWholeSlack))
    return line.stop(kConflict, "Q number in G10 is not an integer", line.at('q'), word);
  return orientation > kMostOrientation && line.stop(kConflict, "Invalid tool orientation", line.at('q'), word);
}

bool g10(ModeLine& line) {
  const double* const l = line.value('l');
  int32_t what = 0;
  if (l == nullptr || !word_integer(*l, &what)) {
    places::lose_offsets(line);
    return false;
  }
  switch (what) {
    case 2: return set_system(line, false);
    case 20: return set_system(line, true);
    case 1:
    case 10:
    case 11: return set_tool(line);
    default: return false;  // L0 reads the table again; what it says of the tool in the spindle is not known
  }
}

}  // namespace

bool non_modal(ModeLine& line) {
  const uint8_t word = line.at(GGroup::kNonModal);
  switch (line.code(GGroup::kNonModal)) {
    case code::kG10: return g10(line);
    case code::kG28:
    case code::kG30:
      return line.refused_by_compensation("Cannot use g28 or g30 with cutter radius comp", word) ||
          places::go_home(line);
    case code::kG28_1:
    case code::kG30_1:
      if (line.refused_by_compensation("Cannot set reference point with cutter compensation in effect", word))
        return true;
      places::store_home(line);
      return false;
    case code::kG52:
    case code::kG92:
      if (line.refused_by_compensation("Cannot change axis offsets with cutter radius comp", word)) return true;
      line.set(Mode::kAxisOffsets, modes::kApplied);
      return places::set_axis_offsets(line, line.code(GGroup::kNonModal) == code::kG52);
    case code::kG5_3: return end_nurbs(line);
    default: return false;
  }
}

/// With compensation on they do nothing, without a word.
bool axis_offsets(ModeLine& line) {
  const int code = line.code(GGroup::kOffsets);
  if (code < 0) return false;
  const modes::AxisOffsets after = code == code::kG92_3 ? modes::kApplied : modes::kNotApplied;
  switch (line.holds({kCompensationOn})) {
    case Answer::kNo:
      line.set(Mode::kAxisOffsets, after);
      places::clear_axis_offsets(line, code);
      break;
    case Answer::kMaybe:
      line.set_open(Mode::kAxisOffsets, line.now()[Mode::kAxisOffsets] | value_bit(after));
      places::lose_offsets(line);
      break;
    case Answer::kYes: break;
  }
  return false;
}

}  // namespace owlint::steps
