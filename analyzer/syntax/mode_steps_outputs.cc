// Inputs and outputs: M62 to M68. Numbers are rounded half to even.
#include <cmath>
#include <limits>

#include "analyzer/syntax/mode_line.h"

namespace owlint::steps {
namespace {

constexpr StopKind kOutputs = StopKind::kModeConflict;

/// Whether the index that E or P gives is known to be none.
bool is_no_index(const ModeLine& line, char letter) {
  if (line.lacks(letter)) return true;
  const double* const value = line.value(letter);
  if (value == nullptr) return false;
  const double index = std::nearbyint(*value);
  return index < 0 || index > std::numeric_limits<int32_t>::max();  // beyond it the interpreter's integer is negative
}

bool digital_output(ModeLine& line, int code, std::string_view refusal) {
  const uint8_t word = line.at(MGroup::kInputsOutputs);
  if (line.refused_by_compensation(refusal, word)) return true;
  return !line.has('p') && line.stop(kOutputs, "No valid P word with " + m_name(code), word);
}

bool analog_output(ModeLine& line, int code, std::string_view refusal) {
  const uint8_t word = line.at(MGroup::kInputsOutputs);
  if (line.refused_by_compensation(refusal, word)) return true;
  return is_no_index(line, 'e') && line.stop(kOutputs, "Invalid analog index with " + m_name(code), word, line.at('e'));
}

/// M66 with L above 0 waits, for Q seconds.
bool waiting(ModeLine& line, uint8_t word) {
  const double* const l = line.value('l');
  int32_t how = 0;
  if (l != nullptr) word_integer(*l, &how);
  if (how <= 0) return false;
  const double* const q = line.value('q');
  if (line.lacks('q') || (q != nullptr && *q <= 0))
    return line.stop(kOutputs, "Zero timeout with wait type != immediate return", line.has('q') ? line.at('q') : word,
                     line.at('l'));
  return line.has('e') &&
      line.stop(kOutputs, "Can't select analog input with wait type != immediate return", line.at('l'), line.at('e'));
}

bool input(ModeLine& line) {
  const uint8_t word = line.at(MGroup::kInputsOutputs);
  if (line.has('p') && line.has('e'))
    return line.stop(kOutputs, "Invalid to select both a digital and an analog input with M66", line.at('p'),
                     line.at('e'));
  if (waiting(line, word)) return true;
  const char chosen = line.has('e') ? 'e' : 'p';
  if (is_no_index(line, chosen))
    return line.stop(kOutputs, "Need to have either a valid P or a valid E word with M66", word, line.at(chosen));
  return line.refused_by_compensation(chosen == 'e'
                                          ? "Cannot wait for analog input with cutter radius compensation on"
                                          : "Cannot wait for digital input with cutter radius compensation on",
                                      word);
}

}  // namespace

bool inputs_outputs(ModeLine& line) {
  const int code = line.code(MGroup::kInputsOutputs);
  switch (code) {
    case code::kM62: return digital_output(line, code, "Cannot set motion output with cutter radius compensation on");
    case code::kM63:
      return digital_output(line, code, "Cannot set motion digital output with cutter radius compensation on");
    case code::kM64:
    case code::kM65:
      return digital_output(line, code, "Cannot set auxiliary digital output with cutter radius compensation on");
    case code::kM66: return input(line);
    case code::kM67:
      return analog_output(line, code, "Cannot set motion analog output with cutter radius compensation on");
    case code::kM68:
      return analog_output(line, code, "Cannot set auxiliary analog output with cutter radius compensation on");
    default: return false;
  }
}

}  // namespace owlint::steps
