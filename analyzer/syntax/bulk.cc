#include "analyzer/syntax/bulk.h"

#include <algorithm>
#include <array>

#include "analyzer/syntax/line_text.h"

namespace owlint {
namespace {

constexpr uint32_t kXyzWords = letter_set("xyz");
constexpr uint32_t kRotaryWords = letter_set("abc");
constexpr uint32_t kAxisWords = kXyzWords | kRotaryWords;
constexpr uint32_t kCenterWords = letter_set("ijk");
constexpr uint32_t kArcWords = kCenterWords | letter_set("r");
constexpr uint32_t kFeed = letter_set("f");
constexpr uint32_t kSpeed = letter_set("s");
constexpr uint32_t kG = letter_set("g");
constexpr uint32_t kPlainWords = kAxisWords | kArcWords | kFeed | kSpeed | kG;

/// Which words without a code are taken, by Taken.
constexpr std::array<uint32_t, 4> kTaken = {
    kSpeed,
    kSpeed | kXyzWords,
    kSpeed | kAxisWords | kFeed,
    kSpeed | kAxisWords | kFeed | kArcWords,
};

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

bool is_digit(char c) { return static_cast<unsigned char>(c - '0') <= 9; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// One line: its words as letters, and its motion. The bytes end in a line feed, so that no end has to be asked for.
class PlainLine {
 public:
  explicit PlainLine(const char* at) : at_(at) {}

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
      if ((words_ & bit) != 0) return false;
      words_ |= bit;
      ++at_;
      skip_blanks();
      if (bit == kG ? !code() : !number(bit)) return false;
      if (!word_ends()) return false;
    }
    return true;
  }

  /// Whether the words go together, and with the motion in effect, which they change.
  bool fits(Taken* taken) const {
    if (has_code()) {
      const bool arc = code_ >= 2;
      if ((words_ & kArcWords) != 0 && !arc) return false;
      *taken = arc ? Taken::kArcWords : Taken::kAxes;
      return true;
    }
    if ((words_ & (kAxisWords | kArcWords)) == 0) return true;      // nothing moves, and nothing uses F and S up
    if ((words_ & (kAxisWords | kCenterWords)) == 0) return false;  // a radius alone is no arc
    return (words_ & ~kTaken[static_cast<size_t>(*taken)]) == 0;
  }

  bool has_code() const { return (words_ & kG) != 0; }
  Motion motion() const { return static_cast<Motion>(code_); }
  bool blank() const { return words_ == 0 && !numbered_; }
  const char* end() const { return at_; }

 private:
  void skip_blanks() {
    while (is_blank(*at_)) ++at_;
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
    return digits > 0;
  }

  /// Blanks behind a word; not inside it, where they would vanish.
  bool word_ends() {
    if (!is_blank(*at_)) return true;
    skip_blanks();
    return !is_digit(*at_) && *at_ != '.';
  }

  const char* at_;
  uint32_t words_ = 0;
  uint8_t code_ = 0;
  bool numbered_ = false;
};

}  // namespace

Passed pass_plain_lines(std::string_view bytes, size_t from, Taken taken) {
  Passed out;
  out.taken = taken;
  out.next = from;
  const char* const begin = bytes.data();
  while (out.next < bytes.size()) {
    PlainLine line(begin + out.next);
    if (!line.read() || !line.fits(&out.taken)) break;
    const auto length = static_cast<size_t>(line.end() - begin) - out.next;
    if (length > kLineLimit) break;
    ++out.lines;
    if (line.has_code()) out.motion = line.motion();
    if (!line.blank()) {
      if (out.first_code == 0) out.first_code = out.lines;
      out.last_code = out.lines;
    }
    out.next += length + 1;
  }
  return out;
}

Taken taken_after(std::string_view line, Taken before) {
  uint32_t words = 0;
  bool code = false;
  bool others = false;
  for (size_t i = 0; i < line.size() && line[i] != ';'; ++i) {
    const char c = line[i];
    if (c == '(') i = std::min(line.find(')', i), line.size() - 1);
    if (c == '(' || is_blank(c) || c == '\r') continue;
    code = true;
    const uint32_t bit = kLetterBits[static_cast<unsigned char>(c)];
    words |= bit;
    others = others || (bit == 0 && !is_digit(c) && c != '.' && c != '-' && c != '+' && c != 'N' && c != 'n');
  }
  if (!code) return before;
  if (others || (words & kG) != 0) return Taken::kNothing;
  // Where axis words alone run, some motion is in effect: it may be a cycle, unless more was known before. With a K it may be a
  // thread, which wants one on every line.
  return (words & kAxisWords) == 0 || (words & kArcWords) != 0 ? before : std::max(before, Taken::kXyz);
}

}  // namespace owlint
