#include "analyzer/syntax/plain_words.h"

#include <bit>
#include <charconv>
#include <cstring>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

/// Bytes that are looked at: letters have their index and 1, line feeds and comments are kOther, what is in a word is 0.
constexpr uint8_t kOther = UINT8_MAX;
constexpr std::array<uint8_t, 256> make_looks() {
  std::array<uint8_t, 256> looks{};
  for (char c = 'a'; c <= 'z'; ++c) {
    looks[static_cast<unsigned char>(c)] = looks[static_cast<unsigned char>(c - 'a' + 'A')] =
        static_cast<uint8_t>(letter_index(c) + 1);
  }
  for (const unsigned char c : {'\n', '(', ';'}) looks[c] = kOther;
  return looks;
}
constexpr auto kLooks = make_looks();

/// Behind the comment that begins at `at`, or at the line feed. A plain line has no `)` in a comment, and closes each.
const char* behind_comment(const char* at) {
  const char end = *at == '(' ? ')' : '\n';
  while (*at != end) ++at;
  return end == ')' ? at + 1 : at;
}

// Both numbers are exact, so their quotient is rounded once.
constexpr std::array kPowers = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

double any_number(const char* at) {
  const char* const from = at;
  uint64_t digits = 0;
  while (is_digit(*at)) digits = digits * 10 + static_cast<uint64_t>(*at++ - '0');
  const char* const point = at;
  size_t decimals = 0;
  if (*at == '.') {
    while (is_digit(*++at)) digits = digits * 10 + static_cast<uint64_t>(*at - '0');
    decimals = static_cast<size_t>(at - point - 1);
  }
  double value = 0;
  if (static_cast<size_t>(at - from) <= kPowers.size()) {
    value = static_cast<double>(digits) / kPowers[decimals];
  } else {
    std::from_chars(from, at, value, std::chars_format::fixed);
  }
  return value;
}

/// Up to eight digits, which lie in one number of the processor, a byte each.
class Eight {
 public:
  explicit Eight(const char* at) {
    std::memcpy(&digits_, at, sizeof(digits_));
    digits_ ^= kEach * '0';
    // The bytes that are no digits have their highest bit set.
    const uint64_t others = (digits_ | (digits_ + kEach * 0x76)) & kEach * 0x80;
    count_ = static_cast<unsigned>(std::countr_zero(others)) / 8;
  }
  unsigned count() const { return count_; }
  /// Pairs of digits become numbers below 100, these numbers below 10,000, and these the whole.
  uint64_t value() const {
    if (count_ == 0) return 0;
    constexpr uint64_t kPairs = 0x000000FF000000FF;
    uint64_t pairs = digits_ << (64 - 8 * count_);
    pairs = pairs * 10 + (pairs >> 8);
    return ((pairs & kPairs) * 0x000F424000000064 + (pairs >> 16 & kPairs) * 0x0000271000000001) >> 32;
  }

 private:
  static constexpr uint64_t kEach = 0x0101010101010101;
  uint64_t digits_ = 0;
  unsigned count_ = 0;
};

/// So many bytes are read at most.
constexpr std::ptrdiff_t kShortNumber = 20;

/// A number with at most seven digits before the point, and behind it; -1 for others.
double short_number(const char* at) {
  constexpr unsigned kMost = 7;
  const Eight whole(at);
  if (whole.count() > kMost) return -1;
  at += whole.count();
  if (*at != '.') return static_cast<double>(whole.value());
  const Eight part(at + 1);
  if (part.count() > kMost) return -1;
  const double power = kPowers[part.count()];
  return (static_cast<double>(whole.value()) * power + static_cast<double>(part.value())) / power;
}

/// The next byte from `at` on that is looked at: none of those of a word.
const char* next_look(const char* at, const char* end) {
  constexpr uint64_t kEach = 0x0101010101010101, kHigh = kEach * 0x80;
  while (end - at > 8) {
    uint64_t bytes = 0;
    std::memcpy(&bytes, at, sizeof(bytes));
    const auto equal = [&](char c) {  // the lowest of the bits that are set is right
      const uint64_t other = bytes ^ kEach * static_cast<uint64_t>(c);
      return (other - kEach) & ~other;
    };
    const uint64_t looks = (bytes << 1 | equal('\n') | equal('(') | equal(';')) & kHigh;
    if (looks != 0) return at + std::countr_zero(looks) / 8;
    at += sizeof(bytes);
  }
  while (kLooks[static_cast<unsigned char>(*at)] == 0) ++at;
  return at;
}

}  // namespace

double plain_number(const char* at, const char* end) {
  const bool negative = *at == '-';
  if (negative || *at == '+') ++at;
  const double value = end - at > kShortNumber ? short_number(at) : -1;
  const double number = value >= 0 ? value : any_number(at);
  return negative ? -number : number;
}

void PlainWords::convert(uint32_t which) {
  for_letters(letters & which, [this](size_t letter) { values[letter] = plain_number(texts[letter], end); });
}

size_t read_plain_words(std::string_view bytes, size_t from, PlainWords* words) {
  constexpr size_t kG = letter_index('g'), kN = letter_index('n');
  words->letters = 0;
  words->code = -1;
  words->end = bytes.data() + bytes.size();
  for (const char* at = bytes.data() + from;;) {
    const uint8_t look = kLooks[static_cast<unsigned char>(*at)];
    if (look == 0) {
      at = next_look(at + 1, words->end);
    } else if (look == kOther) {
      if (*at == '\n') return static_cast<size_t>(at - bytes.data()) + 1;
      at = behind_comment(at);
    } else {
      const size_t letter = look - 1U;
      do ++at;
      while (is_space_or_tab(*at));
      if (letter == kG) words->code = static_cast<int8_t>(plain_number(at, words->end));
      if (letter == kG || letter == kN) continue;
      words->letters |= 1U << letter;
      words->texts[letter] = at;
    }
  }
}

PlainMoves plain_moves(std::string_view bytes, size_t from, size_t to) {
  PlainMoves moves;
  PlainWords words;
  while (from < to) {
    from = read_plain_words(bytes, from, &words);
    for_letters(words.letters & PlainLine::kAxes,
                [&](size_t letter) { moves.add(letter, plain_number(words.texts[letter], words.end)); });
  }
  return moves;
}

void PlainReach::add(const PlainWords& line, const PlainMoves& moves, uint32_t number) {
  for (uint32_t axes = line.letters & kAxisLetters; axes != 0; axes &= axes - 1) {
    const auto i = static_cast<size_t>(std::countr_zero(axes));
    words[axis_of_letter(i)].add(line.values[i], number);
    sums[axis_of_letter(i)].add(moves.sum[i], number);
  }
  letters |= line.letters & kAxisLetters;
}

void PlainReach::add(const PlainReach& other, const std::array<double, kAxes>& before) {
  for (size_t axis = 0; axis < kAxes; ++axis) {
    words[axis].add(other.words[axis]);
    sums[axis].add(other.sums[axis], before[axis]);
  }
  letters |= other.letters;
}

PlainMoves last_plain_moves(std::string_view bytes, uint32_t axes, const LastLines& last) {
  PlainMoves moves;
  PlainWords words;
  for_letters(axes, [&](size_t letter) {
    read_plain_words(bytes, last[letter], &words);
    moves.add(letter, plain_number(words.texts[letter], words.end));
  });
  return moves;
}

}  // namespace owlint
