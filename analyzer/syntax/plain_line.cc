#include "analyzer/syntax/plain_line.h"

#include "analyzer/syntax/comment_command.h"
#include "analyzer/text/characters.h"

namespace owlint {
namespace {

constexpr uint32_t kXyzWords = letter_set("xyz");
constexpr uint32_t kRotaryWords = letter_set("abc");
constexpr uint32_t kCenterWords = letter_set("ijk");
constexpr uint32_t kRadius = letter_set("r");
constexpr uint32_t kArcWords = kCenterWords | kRadius;
constexpr uint32_t kXY = letter_set("xy");
constexpr uint32_t kFeed = letter_set("f");
constexpr uint32_t kSpeed = letter_set("s");
constexpr uint32_t kG = letter_set("g");

constexpr std::array<uint32_t, 256> make_letters() {
  std::array<uint32_t, 256> bits{};
  for (char c = 'a'; c <= 'z'; ++c) {
    const uint32_t bit = letter_set({&c, 1}) & PlainLine::kLetters;
    bits[static_cast<unsigned char>(c)] = bits[static_cast<unsigned char>(c - 'a' + 'A')] = bit;
  }
  return bits;
}
constexpr auto kLetterBits = make_letters();

/// Bytes of a comment that says something to people alone. A colon may belong to a directive of owlint.
constexpr std::array<bool, 256> make_prose() {
  std::array<bool, 256> prose{};
  for (char c = ' '; c <= '~'; ++c) prose[static_cast<unsigned char>(c)] = c != '(' && c != ')' && c != ':' && c != ';';
  prose['\t'] = true;
  return prose;
}
constexpr auto kProse = make_prose();
bool is_prose(char c) { return kProse[static_cast<unsigned char>(c)]; }

/// Three letters that follow each other, as a number.
uint32_t three(uint32_t words, uint32_t letters) { return (words & letters) / (letters & ~(letters - 1)); }

/// Reads the words. The bytes end in a line feed, so that no end has to be asked for.
class PlainReader {
 public:
  explicit PlainReader(const char* at) : at_(at) {}

  bool read() {
    skip_blanks();
    if (*at_ == 'N' || *at_ == 'n') {
      ++at_;
      skip_blanks();
      if (!is_digit(*at_)) return false;
      skip_digits();
      if (*at_ == '.') return false;
      if (!word_ends()) return false;
      numbered_ = true;
    }
    while (*at_ != '\n') {
      const uint32_t bit = plain_letter(*at_);
      if (bit == 0) {
        if (*at_ == ';') return last_comment();
        if (*at_ != '(') return line_ends();
        if (!comment()) return false;
        continue;
      }
      if ((words_ & bit) != 0) return false;
      words_ |= bit;
      ++at_;
      skip_blanks();
      if (bit == kG ? !code() : !number(bit)) return false;
      if (!word_ends()) return false;
    }
    return true;
  }

  const char* at() const { return at_; }
  PlainLine line() const {
    return {words_, code_,
            words_ != 0 || numbered_ ? PlainLine::kCode
                : commented_         ? PlainLine::kComment
                                     : PlainLine::kNothing};
  }

 private:
  void skip_blanks() {
    while (is_space_or_tab(*at_)) ++at_;
  }
  void skip_digits() {
    while (is_digit(*at_)) ++at_;
  }

  bool line_ends() {
    if (*at_ == '\r') ++at_;
    return *at_ == '\n';
  }

  /// G0 to G3, also as G00.
  bool code() {
    if (*at_ == '0' && is_digit(at_[1])) ++at_;
    code_ = static_cast<uint8_t>(*at_ - '0');
    ++at_;
    return code_ <= 3 && !is_digit(*at_) && *at_ != '.';
  }

  bool number(uint32_t letter) {
    if (*at_ == '-' || *at_ == '+') {
      if (*at_ == '-' && (letter & (kFeed | kSpeed)) != 0) return false;
      ++at_;
    }
    const char* const from = at_;
    skip_digits();
    size_t digits = static_cast<size_t>(at_ - from);
    if (*at_ == '.') {
      const char* const point = at_++;
      skip_digits();
      digits += static_cast<size_t>(at_ - point - 1);
    }
    return digits > 0 && ((letter & (kFeed | kSpeed)) == 0 || !is_small({from, static_cast<size_t>(at_ - from)}));
  }

  /// Perhaps 0, or rounded to 0 where it is restored.
  static bool is_small(std::string_view number) {
    const size_t first = number.find_first_not_of('0');
    return first == std::string_view::npos || number[first] == '.';
  }

  /// Blanks behind a word; not inside it, where they would vanish.
  bool word_ends() {
    if (!is_space_or_tab(*at_)) return true;
    skip_blanks();
    return !is_digit(*at_) && *at_ != '.';
  }

  bool begins_with_owlint() const {
    const char* at = at_;
    for (const char c : kOwlint) {
      if (*at++ != c) return false;
    }
    return true;
  }

  /// The text of a comment; false if it is a command, or may be meant for owlint.
  bool prose() {
    commented_ = true;
    const char* const from = at_ + 1;
    do {
      ++at_;
      skip_blanks();
      if (begins_with_owlint()) return false;
      while (is_prose(*at_)) ++at_;
    } while (*at_ == ';');
    return comment_command({from, at_}) == nullptr;
  }

  bool comment() {
    if (!prose() || *at_ != ')') return false;
    ++at_;
    skip_blanks();
    return !is_digit(*at_) && *at_ != '.';
  }

  /// The rest of the line.
  bool last_comment() { return prose() && line_ends(); }

  const char* at_;
  uint32_t words_ = 0;
  uint8_t code_ = 0;
  bool numbered_ = false;
  bool commented_ = false;
};

}  // namespace

uint32_t plain_letter(char c) { return kLetterBits[static_cast<unsigned char>(c)]; }

const char* read_plain_line(const char* at, PlainLine* line) {
  PlainReader reader(at);
  if (!reader.read()) return nullptr;
  *line = reader.line();
  return reader.at();
}

bool PlainLine::runs(uint32_t number, Proven* proven, PlainEffect* effect) const {
  if ((words_ & kMoveLetters) == 0) {  // nothing moves, and nothing uses S up; F has an effect of its own
    if (has_feed()) return false;
    effect->speed |= (words_ & kSpeed) != 0;
    return true;
  }
  const uint8_t* const table = table_of(*proven);
  if (table == nullptr || (words_ & kRotaryWords & ~proven->rotary) != 0 ||
      (runs_with(*proven, table) >> key(*proven) & 1) == 0)
    return false;
  take(number, proven, effect);
  return true;
}

void PlainLine::learn(Proven* proven) const {
  if ((words_ & kMoveLetters) == 0) return;
  if (uint8_t* const table = table_of(*proven)) table[has_feed() ? 1 : 0] |= static_cast<uint8_t>(1U << key(*proven));
  if (has_g()) proven->code = static_cast<int8_t>(code_);
  proven->rotary |= words_ & kRotaryWords;
}

/// The keys that run: with F also those that run without it, unless the motion may be one that takes no F.
uint32_t PlainLine::runs_with(const Proven& proven, const uint8_t* table) const {
  return table[has_feed() ? 1 : 0] | (motion(proven) == Proven::kNoCode ? 0U : table[0]);
}

/// The table of `Proven` that says whether the line runs, or null if none does.
uint8_t* PlainLine::table_of(Proven& proven) const {
  const int code = motion(proven);
  if (code == Proven::kNoCode) return (words_ & (kRotaryWords | kArcWords)) == 0 ? proven.alone : nullptr;
  if (code < 2) return (words_ & kArcWords) == 0 ? proven.straight : nullptr;
  // By its radius an arc needs an end in the plane: with both of these it has one in any.
  const bool radius = (words_ & kRadius) != 0;
  if (!radius && (words_ & kCenterWords) == 0) return nullptr;
  return radius && ((words_ & kCenterWords) != 0 || (words_ & kXY) != kXY) ? nullptr : proven.arcs;
}

/// The line's bit in that table.
uint32_t PlainLine::key(const Proven& proven) const {
  const int code = motion(proven);
  if (code == Proven::kNoCode) return three(words_, kXyzWords);
  return code < 2 ? static_cast<uint32_t>(code) : three(words_, kCenterWords);
}

void PlainLine::take(uint32_t number, Proven* proven, PlainEffect* effect) const {
  if (has_g()) {
    proven->code = static_cast<int8_t>(code_);
    effect->motion = static_cast<Motion>(code_);
  }
  effect->axes |= words_ & PlainLine::kAxes;
  effect->feed |= has_feed();
  effect->speed |= (words_ & kSpeed) != 0;
  if ((words_ & PlainLine::kAxes) != 0) {
    effect->moves = true;
    effect->alone |= proven->code == Proven::kNoCode;
    if (effect->first_move == 0) effect->first_move = number;
  }
  // A full circle has no axis word.
  const bool arc = proven->code > 1 && (words_ & (PlainLine::kAxes | kArcWords)) != 0;
  if (arc && effect->first_arc == 0) effect->first_arc = number;
  effect->straight |= proven->code == 0 || proven->code == 1;
  effect->feeds |= proven->code > 0;
}

}  // namespace owlint
