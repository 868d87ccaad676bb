#include "analyzer/syntax/plain_words.h"

#include <bit>
#include <charconv>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

char small_letter(char c) { return static_cast<char>(c | 0x20); }

bool is_in_number(char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; }

}  // namespace

size_t read_plain_words(std::string_view bytes, size_t from, PlainWords* words) {
  words->letters = 0;
  words->code = -1;
  const char* at = bytes.data() + from;
  const char* const end = bytes.data() + bytes.size();
  for (; *at != '\n'; ++at) {
    const char letter = small_letter(*at);
    if (!is_small_letter(letter)) continue;
    ++at;
    while (is_space_or_tab(*at)) ++at;
    double value = 0;
    at = std::from_chars(*at == '+' ? at + 1 : at, end, value, std::chars_format::fixed).ptr - 1;
    if (letter == 'g') {
      words->code = static_cast<int8_t>(value);
    } else if (letter != 'n') {
      words->letters |= letter_set({&letter, 1});
      words->values[letter_index(letter)] = value;
    }
  }
  return static_cast<size_t>(at - bytes.data()) + 1;
}

void PlainMoves::add(const PlainWords& words) {
  for (uint32_t axes = words.letters & kAxisLetters; axes != 0; axes &= axes - 1) {
    const auto i = static_cast<size_t>(std::countr_zero(axes));
    letters |= 1U << i;
    last[i] = words.values[i];
    sum[i] += words.values[i];
  }
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

PlainMoves plain_moves(std::string_view bytes, size_t from, size_t to, uint32_t axes, bool sums) {
  PlainMoves moves;
  if (sums) {
    PlainWords words;
    while (from < to) {
      from = read_plain_words(bytes, from, &words);
      moves.add(words);
    }
    return moves;
  }
  // Letters stand before their numbers, and no number has one.
  for (size_t at = to; at-- > from && moves.letters != axes;) {
    const char letter = small_letter(bytes[at]);
    if (!is_small_letter(letter)) continue;
    const uint32_t bit = letter_set({&letter, 1});
    if ((bit & axes & ~moves.letters) == 0) continue;
    size_t number = at + 1;
    while (!is_in_number(bytes[number])) ++number;
    if (bytes[number] == '+') ++number;
    std::from_chars(bytes.data() + number, bytes.data() + bytes.size(), moves.last[letter_index(letter)],
                    std::chars_format::fixed);
    moves.letters |= bit;
  }
  return moves;
}

}  // namespace owlint
