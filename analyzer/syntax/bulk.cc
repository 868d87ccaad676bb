#include "analyzer/syntax/bulk.h"

#include <algorithm>
#include <array>

#include "analyzer/syntax/line_text.h"
#include "analyzer/text/characters.h"

namespace owlint {
namespace {

constexpr uint32_t kXyzWords = letter_set("xyz");
constexpr uint32_t kRotaryWords = letter_set("abc");
constexpr uint32_t kAxisWords = kXyzWords | kRotaryWords;
constexpr uint32_t kCenterWords = letter_set("ijk");
constexpr uint32_t kRadius = letter_set("r");
constexpr uint32_t kArcWords = kCenterWords | kRadius;
constexpr uint32_t kXY = letter_set("xy");
constexpr uint32_t kFeed = letter_set("f");
constexpr uint32_t kSpeed = letter_set("s");
constexpr uint32_t kG = letter_set("g");
constexpr uint32_t kMoves = kAxisWords | kArcWords | kG;
constexpr uint32_t kPlainWords = kMoves | kFeed | kSpeed;

/// By byte: the bit of a letter that a plain line may have, in capitals or not; 0 for all else.
constexpr std::array<uint32_t, 256> make_letters() {
  std::array<uint32_t, 256> bits{};
  for (char c = 'a'; c <= 'z'; ++c) {
    const uint32_t bit = letter_set({&c, 1}) & kPlainWords;
    bits[static_cast<unsigned char>(c)] = bits[static_cast<unsigned char>(c - 'a' + 'A')] = bit;
  }
  return bits;
}
constexpr auto kLetterBits = make_letters();

/// One line: its words as letters, and its motion. The bytes end in a line feed, so that no end has to be asked for.
class PlainLine {
 public:
  explicit PlainLine(const char* at, uint32_t refused = 0) : at_(at), refused_(refused) {}

  /// Reads to the line feed; false for a line that is not plain.
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
      const uint32_t bit = kLetterBits[static_cast<unsigned char>(*at_)];
      if (bit == 0) {
        if (*at_ != '\r') return false;
        ++at_;
        return *at_ == '\n';
      }
      if (((words_ | refused_) & bit) != 0) return false;
      words_ |= bit;
      ++at_;
      skip_blanks();
      if (bit == kG ? !code() : !number(bit)) return false;
      if (!word_ends()) return false;
    }
    return true;
  }

  /// Whether the line surely runs. Then what it does is added to `proven` and `effect`; `number`: of the line.
  bool runs(uint32_t number, Proven* proven, PlainEffect* effect) const {
    if ((words_ & kMoves) == 0) {  // nothing moves, and nothing uses S up; F has an effect of its own
      if ((words_ & kFeed) != 0) return false;
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

  /// The line has run, for all that is known: so will others like it.
  void learn(Proven* proven) const {
    if ((words_ & kMoves) == 0) return;
    if (uint8_t* const table = table_of(*proven)) table[has_feed() ? 1 : 0] |= static_cast<uint8_t>(1U << key(*proven));
    if (has_code()) proven->code = static_cast<int8_t>(code_);
    proven->rotary |= words_ & kRotaryWords;
  }

  bool has_code() const { return (words_ & kG) != 0; }
  bool blank() const { return words_ == 0 && !numbered_; }
  const char* end() const { return at_; }

 private:
  /// The keys that run: with F also those that run without it, unless the motion may be one that takes no F.
  uint32_t runs_with(const Proven& proven, const uint8_t* table) const {
    return table[has_feed() ? 1 : 0] | (code(proven) == Proven::kNoCode ? 0U : table[0]);
  }
  bool has_feed() const { return (words_ & kFeed) != 0; }
  int code(const Proven& proven) const { return has_code() ? code_ : proven.code; }

  /// The table of `Proven` that says whether the line runs, or null if none does.
  uint8_t* table_of(Proven& proven) const {
    const int code = this->code(proven);
    if (code == Proven::kNoCode) return (words_ & (kRotaryWords | kArcWords)) == 0 ? proven.alone : nullptr;
    if (code < 2) return (words_ & kArcWords) == 0 ? proven.straight : nullptr;
    // By its radius an arc needs an end in the plane: with both of these it has one in any.
    const bool radius = (words_ & kRadius) != 0;
    if (!radius && (words_ & kCenterWords) == 0) return nullptr;
    return radius && ((words_ & kCenterWords) != 0 || (words_ & kXY) != kXY) ? nullptr : proven.arcs;
  }
  /// The line's bit in that table.
  uint32_t key(const Proven& proven) const {
    const int code = this->code(proven);
    if (code == Proven::kNoCode) return three(words_, kXyzWords);
    return code < 2 ? static_cast<uint32_t>(code) : three(words_, kCenterWords);
  }
  /// Three letters that follow each other, as a number.
  static uint32_t three(uint32_t words, uint32_t letters) { return (words & letters) / (letters & ~(letters - 1)); }

  void take(uint32_t number, Proven* proven, PlainEffect* effect) const {
    if (has_code()) {
      proven->code = static_cast<int8_t>(code_);
      effect->motion = static_cast<Motion>(code_);
    }
    effect->axes |= words_ & kAxisWords;
    effect->feed |= has_feed();
    effect->speed |= (words_ & kSpeed) != 0;
    if ((words_ & kAxisWords) != 0) {
      effect->moves = true;
      effect->alone |= proven->code == Proven::kNoCode;
      if (effect->first_move == 0) effect->first_move = number;
    }
    // A full circle has no axis word.
    const bool arc = proven->code > 1 && (words_ & (kAxisWords | kArcWords)) != 0;
    if (arc && effect->first_arc == 0) effect->first_arc = number;
    effect->straight |= proven->code == 0 || proven->code == 1;
    effect->feeds |= proven->code > 0;
  }

  void skip_blanks() {
    while (is_space_or_tab(*at_)) ++at_;
  }
  void skip_digits() {
    while (is_digit(*at_)) ++at_;
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

  const char* at_;
  uint32_t refused_;
  uint32_t words_ = 0;
  uint8_t code_ = 0;
  bool numbered_ = false;
};

}  // namespace

Passed pass_plain_lines(std::string_view bytes, size_t from, const Proven& proven, uint32_t refused) {
  Passed out;
  out.proven = proven;
  out.next = from;
  const char* const begin = bytes.data();
  while (out.next < bytes.size()) {
    PlainLine line(begin + out.next, refused);
    if (!line.read() || !line.runs(out.lines + 1, &out.proven, &out.effect)) break;
    const auto length = static_cast<size_t>(line.end() - begin) - out.next;
    if (length > kLineLimit) break;
    ++out.lines;
    if (!line.blank()) {
      if (out.first_code == 0) out.first_code = out.lines;
      out.last_code = out.lines;
    }
    out.next += length + 1;
  }
  return out;
}

Proven proven_after(std::string_view line, const Proven& before) {
  // The line without its comments.
  std::array<char, kLineLimit + 2> code;
  size_t length = 0;
  for (size_t i = 0; i < line.size() && line[i] != ';'; ++i) {
    if (line[i] == '(') {
      i = line.find(')', i);
      if (i == std::string_view::npos) return {};
      continue;
    }
    if (length > kLineLimit) return {};
    code[length++] = line[i];
  }
  code[length] = '\n';
  PlainLine plain(code.data());
  if (!plain.read()) return {};
  Proven out = before;
  plain.learn(&out);
  return out;
}

}  // namespace owlint
