#include "analyzer/syntax/plain_words.h"

#include <bit>
#include <charconv>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

constexpr uint32_t kAxes = letter_set("xyzabc");

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

template <typename Do>
void for_bits(uint32_t bits, const Do& apply) {
  for (; bits != 0; bits &= bits - 1) apply(static_cast<size_t>(std::countr_zero(bits)));
}

}  // namespace

double plain_number(const char* at) {
  const bool negative = *at == '-';
  if (negative || *at == '+') ++at;
  const char* const from = at;
  uint64_t digits = 0;
  while (is_digit(*at)) digits = digits * 10 + static_cast<uint64_t>(*at++ - '0');
  const char* const point = at;
  size_t decimals = 0;
  if (*at == '.') {
    while (is_digit(*++at)) digits = digits * 10 + static_cast<uint64_t>(*at - '0');
    decimals = static_cast<size_t>(at - point - 1);
  }
  // Both numbers are exact, so their quotient is rounded once.
  constexpr std::array kPowers = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  double value = 0;
  if (static_cast<size_t>(at - from) <= kPowers.size()) {
    value = static_cast<double>(digits) / kPowers[decimals];
  } else {
    std::from_chars(from, at, value, std::chars_format::fixed);
  }
  return negative ? -value : value;
}

void PlainWords::convert(uint32_t which) {
  for_bits(letters & which, [this](size_t letter) { values[letter] = plain_number(texts[letter]); });
}

size_t read_plain_words(std::string_view bytes, size_t from, PlainWords* words) {
  constexpr size_t kG = letter_index('g'), kN = letter_index('n');
  words->letters = 0;
  words->code = -1;
  for (const char* at = bytes.data() + from;;) {
    const uint8_t look = kLooks[static_cast<unsigned char>(*at)];
    if (look == 0) {
      ++at;
    } else if (look == kOther) {
      if (*at == '\n') return static_cast<size_t>(at - bytes.data()) + 1;
      at = behind_comment(at);
    } else {
      const size_t letter = look - 1U;
      do ++at;
      while (is_space_or_tab(*at));
      if (letter == kG) words->code = static_cast<int8_t>(plain_number(at));
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
    for_bits(words.letters & kAxes, [&](size_t letter) { moves.add(letter, plain_number(words.texts[letter])); });
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
  for_bits(axes, [&](size_t letter) {
    read_plain_words(bytes, last[letter], &words);
    moves.add(letter, plain_number(words.texts[letter]));
  });
  return moves;
}

}  // namespace owlint
