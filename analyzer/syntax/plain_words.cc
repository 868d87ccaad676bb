#include "analyzer/syntax/plain_words.h"

#include <algorithm>
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

/// Up to seven digits, which lie in one number of the processor, a byte each.
class Digits {
 public:
  explicit Digits(const char* at) {
    std::memcpy(&digits_, at, sizeof(digits_));
    digits_ ^= kEach * '0';
    // The bytes that are no digits have their highest bit set.
    const uint64_t others = (digits_ | (digits_ + kEach * 0x76)) & kEach * 0x80;
    count_ = static_cast<unsigned>(std::countr_zero(others)) / 8;
  }
  /// 8 if there may be more.
  unsigned count() const { return count_; }
  /// The digits stand last, behind zeros.
  uint64_t last() const { return digits_ << 1 << (63 - 8 * count_); }
  /// The same, with others behind them: at most eight together.
  uint64_t last_before(const Digits& behind) const { return behind.last() | last() >> 8 * behind.count_; }

 private:
  static constexpr uint64_t kEach = 0x0101010101010101;
  uint64_t digits_ = 0;
  unsigned count_ = 0;
};

/// Pairs of digits become numbers below 100, these numbers below 10,000, and these the whole.
uint64_t value_of_digits(uint64_t digits) {
  constexpr uint64_t kPairs = 0x000000FF000000FF;
  const uint64_t pairs = digits * 10 + (digits >> 8);
  return ((pairs & kPairs) * 0x000F424000000064 + (pairs >> 16 & kPairs) * 0x0000271000000001) >> 32;
}

/// So many bytes are read at most.
constexpr std::ptrdiff_t kShortNumber = 20;

/// Reads a number with at most seven digits before the point, and behind it; false for others.
bool short_number(const char* at, double* number) {
  constexpr unsigned kMost = 7, kTogether = 8;
  const Digits whole(at);
  if (whole.count() > kMost) return false;
  at += whole.count();
  if (*at != '.') {
    *number = static_cast<double>(value_of_digits(whole.last()));
    return true;
  }
  const Digits part(at + 1);
  if (part.count() > kMost) return false;
  const double power = kPowers[part.count()];
  *number = whole.count() + part.count() <= kTogether
      ? static_cast<double>(value_of_digits(whole.last_before(part))) / power
      : (static_cast<double>(value_of_digits(whole.last())) * power +
         static_cast<double>(value_of_digits(part.last()))) /
          power;
  return true;
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

/// Takes in the word of a letter, which stands there. Returns its bit; none for G and N.
inline uint32_t take_word(size_t letter, const char* at, PlainWords* words) {
  constexpr size_t kG = letter_index('g'), kN = letter_index('n');
  do ++at;
  while (is_space_or_tab(*at));
  if (letter == kN) return 0;
  if (letter == kG) {  // of a plain line, 0 to 3, also as 00 to 03
    words->code = static_cast<int8_t>(at[is_digit(at[1]) ? 1 : 0] - '0');
    return 0;
  }
  words->texts[letter] = at;
  return 1U << letter;
}

}  // namespace

double plain_number(const char* at, const char* end) {
  // Both signs lie below the point and the digits, and a bit tells which it is: signs follow each other without an order, and a
  // branch would often be the wrong one.
  constexpr unsigned kMinusBit = 2;
  static_assert('+' < '.' && '-' < '.' && '.' < '0' && ('-' >> kMinusBit & 1) == 1 && ('+' >> kMinusBit & 1) == 0);
  const uint32_t sign = static_cast<uint32_t>(*at - '.') >> 31;
  const uint64_t minus = sign & static_cast<uint32_t>(*at) >> kMinusBit;
  at += sign;
  double number = 0;
  if (end - at <= kShortNumber || !short_number(at, &number)) number = any_number(at);
  return std::bit_cast<double>(std::bit_cast<uint64_t>(number) ^ minus << 63);
}

void PlainWords::convert(uint32_t which) {
  for_letters(letters & which, [this](size_t letter) { values[letter] = plain_number(texts[letter], end); });
}

size_t read_plain_words(std::string_view bytes, size_t from, PlainWords* words) {
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
      words->letters |= take_word(look - 1U, at++, words);
    }
  }
}

/// Finds what is looked at in the bytes from there on.
void PlainWordReader::look(std::string_view bytes, size_t from) {
  constexpr size_t kBlock = ByteClasses::kBlock;
  begin_ = from;
  block_ = 0;
  const size_t whole = std::min((bytes.size() - from) / kBlock, kBlocks);
  blocks_ = whole;
  by_->find_looks(bytes.data() + from, whole, looks_.data());
  if (whole < kBlocks) {
    std::array<char, kBlock> last{};
    std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(from + whole * kBlock), bytes.end(), last.begin());
    by_->find_looks(last.data(), 1, looks_.data() + blocks_++);
  }
  left_ = looks_[0];
}

/// Goes on from there.
void PlainWordReader::seek(std::string_view bytes, size_t from) {
  constexpr size_t kBlock = ByteClasses::kBlock;
  if (from < begin_ || from >= begin_ + blocks_ * kBlock) return look(bytes, from);
  block_ = (from - begin_) / kBlock;
  left_ = looks_[block_] & ~uint64_t{0} << (from - begin_) % kBlock;
}

size_t PlainWordReader::read(std::string_view bytes, size_t from, PlainWords* words) {
  constexpr size_t kBlock = ByteClasses::kBlock;
  const char* const text = bytes.data();
  if (from != next_) seek(bytes, from);
  uint32_t letters = 0;
  words->code = -1;
  words->end = text + bytes.size();
  uint64_t left = left_;
  for (;;) {
    if (left == 0) {
      if (++block_ == blocks_) look(bytes, begin_ + blocks_ * kBlock);
      left = looks_[block_];
      continue;
    }
    const size_t at = begin_ + block_ * kBlock + static_cast<size_t>(std::countr_zero(left));
    left &= left - 1;
    const uint8_t look = kLooks[static_cast<unsigned char>(text[at])];
    if (look == kOther) {
      if (text[at] == '\n') {
        left_ = left;
        words->letters = letters;
        return next_ = at + 1;
      }
      seek(bytes, static_cast<size_t>(behind_comment(text + at) - text));
      left = left_;
      continue;
    }
    letters |= take_word(look - 1U, text + at, words);
  }
}

PlainMoves plain_moves(std::string_view bytes, size_t from, size_t to, PlainWordReader* reader) {
  PlainMoves moves;
  PlainWords words;
  while (from < to) {
    from = reader->read(bytes, from, &words);
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
