// Words as they are read, one after the other; the checks of the complete line are in word_checks.cc.
#include "analyzer/syntax/word_line.h"

#include <algorithm>

namespace owlint {
namespace {

constexpr int kMCodesEnd = 200;  // what lies behind exists only if remapped
constexpr int kRemappedEnd = 1000;
constexpr size_t kMWords = 4;

}  // namespace

void WordLine::clear() {
  size_ = m_words_ = 0;
  fifth_m_ = kNoWord;
  unknown_code_ = remapped_m_ = call_ = false;
  lost_g_ = lost_user_ = lost_stop_ = kNoWord;
  remapped_letters_ = 0;
  code_ = Motion::kNone;
  letters_ = 0;
  codes_ = {};
  g_ = {};
  m_ = {};
}

void WordLine::begin_call() {
  clear();
  call_ = true;
  codes_ = set_of(*m_code(code::kM98));
}

uint8_t WordLine::find(char letter) const {
  return (letters_ & letter_set({&letter, 1})) == 0 ? kNoWord : at_[static_cast<size_t>(letter_index(letter))];
}

std::optional<Fault> WordLine::letter(char letter) const {
  const uint32_t bit = letter_set({&letter, 1});
  if ((bit & kAxisLetters) != 0 && (bit & machine_->axes) == 0)
    return Fault{StopKind::kWordUnknown, std::string("Bad character '") + letter + "' used", size_, kNoWord,
                 !machine_->unsure};
  if ((letters_ & bit) == 0) return std::nullopt;
  const WordRow* row = word_row(letter);
  if (row->repeated == WordRow::kRuns) return std::nullopt;
  const uint8_t before = find(letter);
  const Word& earlier = words_[before];
  const bool either_way = row->repeated == WordRow::kStops;
  if (!either_way && earlier.known && earlier.value <= -1) return std::nullopt;
  return Fault{StopKind::kWordRepeated, "Multiple " + std::string(row->name) + " words on one line", size_, before,
               either_way || earlier.known};
}

std::optional<Fault> WordLine::add(const Word& word) {
  if (size_ == kMaxWords) return std::nullopt;  // only of a line that is too long, which stops for that
  const uint8_t at = size_++;
  words_[at] = word;
  letters_ |= letter_set({&word.letter, 1});
  at_[static_cast<size_t>(letter_index(word.letter))] = at;
  if (word.letter == 'm' && ++m_words_ == kMWords + 1) fifth_m_ = at;
  if ((word.letter == 't' || word.letter == 's' || word.letter == 'f') && remapped(word.letter, 0) != nullptr)
    remapped_letters_ |= letter_set({&word.letter, 1});
  if (!word.known) {
    unknown_code_ |= word.letter == 'g' || word.letter == 'm';
    return std::nullopt;
  }
  int32_t whole = 0;
  if (auto fault = range(word, at, &whole)) return fault;
  if (word.letter == 'g') return add_g(whole, at);
  if (word.letter == 'm') return add_m(whole, at);
  return std::nullopt;
}

/// Whether a known value is one that the letter may have; an integer is converted.
std::optional<Fault> WordLine::range(const Word& word, uint8_t at, int32_t* whole) const {
  if (const char* message = refused_number(word.letter, word.value))
    return Fault{StopKind::kNumberOutOfRange, message, at, kNoWord, true};
  const NumberKind kind = word_row(word.letter)->number;
  if (kind == NumberKind::kInteger) word_integer(word.value, whole);
  if (kind == NumberKind::kTenths) g_tenths(word.value, whole);
  return std::nullopt;
}

const LostCode* WordLine::lost(char letter, int32_t number) const {
  const auto found = std::ranges::find_if(
      machine_->lost, [&](const LostCode& code) { return code.letter == letter && code.number == number; });
  return found == machine_->lost.end() ? nullptr : &*found;
}

const RemappedCode* WordLine::remapped(char letter, int32_t number) const {
  const auto found = std::ranges::find_if(
      machine_->remapped, [&](const RemappedCode& code) { return code.letter == letter && code.number == number; });
  return found == machine_->remapped.end() ? nullptr : &*found;
}

const RemappedCode* WordLine::remapped(const Word& word) const {
  if (word.letter != 'g' && word.letter != 'm') return remapped(word.letter, 0);
  int32_t number = 0;
  if (word.letter == 'g' ? !g_tenths(word.value, &number) : !word_integer(word.value, &number)) return nullptr;
  return remapped(word.letter, number);
}

std::vector<RemappedWord> WordLine::remapped_words() const {
  std::vector<RemappedWord> words;
  const auto take = [&](uint8_t word) {
    if (word == kNoWord) return;
    if (const RemappedCode* const code = remapped(words_[word])) words.push_back({code, word});
  };
  for (const char letter : {'f', 's', 't'}) {
    if (is_remapped(letter)) take(find(letter));
  }
  // Of a group whose word is remapped there is no code.
  const auto take_group = [&](MGroup group) {
    if (code(group) == nullptr) take(word_of(group));
  };
  for (const MGroup group : {MGroup::kInputsOutputs, MGroup::kToolChange, MGroup::kSpindle, MGroup::kCoolant,
                             MGroup::kOverrides, MGroup::kUser})
    take_group(group);
  if (moves_by_remap()) take(word_of(GGroup::kMotion));
  take_group(MGroup::kStop);
  return words;
}

std::optional<Fault> WordLine::add_g(int32_t tenths, uint8_t at) {
  const GCode* code = g_code(tenths, machine_->release);
  // A built-in code stays what it is when an INI remaps it.
  if (code == nullptr && remapped('g', tenths) == nullptr) {
    Place<GCode>& motion = g_[static_cast<size_t>(GGroup::kMotion)];
    if (machine_->unsure && motion.word == kNoWord) {
      motion.word = at;
      code_ = Motion::kRemapped;
    }
    return Fault{StopKind::kCodeUnknown, "Unknown g code used", at, kNoWord, !machine_->unsure};
  }
  const bool is_lost = lost('g', tenths) != nullptr;
  if (is_lost) code = nullptr;
  const GGroup group = code == nullptr ? GGroup::kMotion : code->group;
  Place<GCode>& place = g_[static_cast<size_t>(group)];
  if (place.word != kNoWord) {
    if (tenths == code::kG80) return std::nullopt;  // gives way to every other motion, without a word
    if (code == nullptr || code_ != Motion::kG80 || group != GGroup::kMotion)
      return Fault{StopKind::kCodesConflict, "Two g codes used from same modal group", at, place.word, true};
  }
  place = {code, at};
  if (is_lost) {
    lost_g_ = at;
  } else if (group == GGroup::kMotion) {
    code_ = code == nullptr ? Motion::kRemapped : code->motion;
  } else {
    codes_ = codes_ | set_of(*code);
  }
  return std::nullopt;
}

std::optional<Fault> WordLine::add_lost_m(const LostCode& lost, uint8_t at) {
  Place<MCode>& place = m_[static_cast<size_t>(lost.group)];
  if (place.word != kNoWord)
    return Fault{StopKind::kCodesConflict, "Two m codes used from same modal group", at, place.word, true};
  const MCode* const code = m_code(lost.number);
  // Measured: it still runs the program of the machine, but has no words any more.
  const bool runs = lost.group == MGroup::kUser && code != nullptr && code->group == MGroup::kUser;
  place = {runs ? code : nullptr, at};
  if (lost.group == MGroup::kUser && !runs) lost_user_ = at;
  if (lost.group == MGroup::kStop) lost_stop_ = at;
  return std::nullopt;
}

std::optional<Fault> WordLine::add_m(int32_t number, uint8_t at) {
  if (const LostCode* const code = lost('m', number)) return add_lost_m(*code, at);
  const RemappedCode* const machines = number < kRemappedEnd ? remapped('m', number) : nullptr;
  const MCode* code = m_code(number);
  if (machines == nullptr && (code == nullptr || code->group == MGroup::kCall)) {
    const bool beyond = number >= kMCodesEnd;
    const char* const message = beyond ? "M-code greater than 199: M" : "Unknown m code used: M";
    // A code that an INI may define passes all checks of the other words.
    const bool maybe = machine_->unsure && number < kRemappedEnd && (code == nullptr || code->group != MGroup::kCall);
    remapped_m_ = remapped_m_ || maybe;
    return Fault{StopKind::kCodeUnknown, message + std::to_string(number), at, kNoWord, !maybe};
  }
  Place<MCode>& place = m_[static_cast<size_t>(machines != nullptr ? machines->group : code->group)];
  if (place.word != kNoWord)
    return Fault{StopKind::kCodesConflict, "Two m codes used from same modal group", at, place.word, true};
  place = {machines != nullptr ? nullptr : code, at};
  if (machines != nullptr) {
    remapped_m_ = true;
  } else {
    codes_ = codes_ | set_of(*code);
  }
  return std::nullopt;
}

}  // namespace owlint
