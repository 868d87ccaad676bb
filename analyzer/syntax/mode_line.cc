#include "analyzer/syntax/mode_line.h"

#include <algorithm>
#include <cmath>

namespace owlint {

void ModeLine::save(modes::Saved by) {
  state().saved = now();
  set(Mode::kSaved, by);
}

const double* ModeLine::value(char letter) const {
  const uint8_t at = words_.find(letter);
  return at == kNoWord || !words_[at].known ? nullptr : &words_[at].value;
}

bool ModeLine::lacks(char letter) const {
  if (!has(letter)) return true;
  const double* const given = value(letter);
  return (letter == 'p' || letter == 'q') && given != nullptr && *given == -1;
}

int ModeLine::code(GGroup group) const {
  const GCode* const code = words_.code(group);
  return code == nullptr ? -1 : code->tenths;
}

int ModeLine::code(MGroup group) const {
  const MCode* const code = words_.code(group);
  return code == nullptr ? -1 : code->number;
}

bool ModeLine::names_no_spindle(int least) const {
  const double* const chosen = value('$');
  if (chosen == nullptr) return false;
  const double spindle = std::trunc(*chosen);
  return spindle < least || spindle >= machine_.spindles;
}

bool ModeLine::refuses_spindle(int least, std::string_view message, uint8_t word) {
  if (!names_no_spindle(least)) return false;
  const bool too_small = std::trunc(*value('$')) < least;
  if (!machine_.unsure || too_small) return stop(StopKind::kModeConflict, std::string(message), at('$'), word);
  may_stop(StopKind::kModeConflict, std::string(message), at('$'), word, 0, true);
  return false;
}

Answer ModeLine::is_for_spindle() const {
  if (!has('$')) return Answer::kYes;
  const double* const chosen = value('$');
  if (chosen == nullptr) return machine_.spindles > 1 || machine_.unsure ? Answer::kMaybe : Answer::kYes;
  const double spindle = std::trunc(*chosen);
  return spindle == 0 || spindle == -1 ? Answer::kYes : Answer::kNo;
}

bool ModeLine::choose_spindle(std::string_view message, uint8_t word) {
  if (refuses_spindle(0, message, word)) return true;
  if (is_for_spindle() == Answer::kYes) return false;
  set_open(Mode::kTurning);
  set_open(Mode::kSpeed);
  return false;
}

void ModeLine::set_spindle(Mode mode, uint8_t value) {
  const Answer own = is_for_spindle();
  if (own == Answer::kNo) return;
  // What is open may be that of another spindle, which is still the active one.
  const double* const chosen = this->value('$');
  const bool all = chosen != nullptr && std::trunc(*chosen) == -1;
  const bool active = machine_.spindles <= 1 || all || !now().is_open(mode);
  if (own == Answer::kYes && active) return set(mode, value);
  set_open(mode, now()[mode] | value_bit(value));
}

const Tool* ModeLine::tool(int number) const {
  if (!machine_.tools || number <= 0) return nullptr;
  const auto found = std::ranges::find(*machine_.tools, number, &Tool::number);
  return found == machine_.tools->end() ? nullptr : &*found;
}

bool ModeLine::lacks_tool(int number, uint8_t word, uint8_t other) {
  // Number 0 is the tool in the spindle, and no table has a number below it.
  if (number == 0 || (number > 0 && (!machine_.tools || tool(number) != nullptr))) return false;
  return stop(StopKind::kToolMissing, "Requested tool " + std::to_string(number) + " not found in the tool table", word,
              other);
}

const Tool* ModeLine::tool_in_spindle() const {
  return place_ == nullptr || place_->loaded_tool <= 0 ? nullptr : tool(place_->loaded_tool);
}

bool ModeLine::refused_by_compensation(std::string_view message, uint8_t word) {
  return stop_in({kCompensationOn}, StopKind::kCompensation, message, word);
}

}  // namespace owlint
