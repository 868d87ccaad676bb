#include "analyzer/syntax/bulk.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "analyzer/syntax/line_text.h"
#include "analyzer/text/characters.h"

namespace owlint {
namespace {

static_assert(std::endian::native == std::endian::little, "windows of bits are read from any byte");

constexpr size_t kWindow = 56;  // bits from any place on that eight bytes have

/// The bits from `at` on; those above kWindow are anything.
uint64_t window(const ByteClasses::Bits& bits, size_t at) {
  uint64_t out;
  std::memcpy(&out, reinterpret_cast<const char*>(bits.data()) + at / 8, sizeof(out));
  return out >> at % 8;
}

/// The lowest so many bits.
constexpr uint64_t low_bits(size_t count) { return (uint64_t{1} << count) - 1; }

constexpr uint32_t kNumbered = letter_set("n");
constexpr uint32_t kGWord = letter_set("g");
constexpr uint32_t kNoPlainLetter = 1U << 31;
constexpr uint32_t kNeverZero = letter_set("fs");  // words that must not be small
constexpr uint32_t kLookedAt = kNumbered | kGWord | kNeverZero | kNoPlainLetter;

constexpr std::array<uint32_t, 256> make_line_words() {
  std::array<uint32_t, 256> words{};
  for (char c = 'a'; c <= 'z'; ++c) {
    const uint32_t bit = letter_set({&c, 1}) & (PlainLine::kLetters | kNumbered);
    words[static_cast<unsigned char>(c)] = words[static_cast<unsigned char>(c - 'a' + 'A')] =
        bit == 0 ? kNoPlainLetter : bit;
  }
  return words;
}
constexpr auto kLineWords = make_line_words();
uint32_t word_of(char c) { return kLineWords[static_cast<unsigned char>(c)]; }

/// What a line does is decided by this: its words, its code, and the motion in effect. Never 0.
uint32_t key_of(uint32_t words, uint8_t code, int8_t motion) {
  constexpr int kCodeShift = 26, kMotionShift = 29;
  const uint32_t by_code = (words & kGWord) != 0 ? code + 1U : 0U;
  return words | by_code << kCodeShift | static_cast<uint32_t>(motion + 2) << kMotionShift;
}
size_t place_of(uint32_t key) {
  constexpr uint32_t kSpread = 0x9E3779B1;
  return key * kSpread >> 28;
}

/// Bits of one kind, and those of the bytes behind such bytes.
class Follower {
 public:
  uint64_t operator()(uint64_t bits) {
    const uint64_t behind = bits << 1 | last_;
    last_ = bits >> 63;
    return behind;
  }
  explicit Follower(uint64_t last = 0) : last_(last) {}

 private:
  uint64_t last_;
};

/// Finds where a line is not as plain lines are: a letter, a sign perhaps, and digits with at most one point. The first byte is
/// the first of a line.
void find_bad(const ByteClasses& in, size_t blocks, ByteClasses::Bits& bad) {
  Follower letter, sign, digit, point, bare_point, carriage;
  Follower gap(1);
  uint64_t carry = 0;
  for (size_t i = 0; i < blocks; ++i) {
    const uint64_t digits = in.digits[i], points = in.points[i], signs = in.signs[i], letters = in.letters[i];
    const uint64_t gaps = in.blanks[i] | in.returns[i] | in.feeds[i];
    const uint64_t after_letter = letter(letters), after_point = point(points);
    const uint64_t bare = points & ~digit(digits);
    uint64_t out = ~(digits | points | signs | letters | gaps);
    out |= after_letter & ~(digits | points | signs);
    out |= (sign(signs) | bare_point(bare)) & ~(digits | points);
    out |= signs & ~after_letter;
    out |= (digits | points) & gap(gaps);
    out |= carriage(in.returns[i]) & ~in.feeds[i];  // it is the last of its line
    // A carry runs through the digits behind a point, to the byte behind them: that is no second point.
    uint64_t behind = digits + after_point;
    const uint64_t over = behind < digits ? 1 : 0;
    behind += carry;
    carry = over | (behind < carry ? 1 : 0);
    bad[i] = out | (behind & ~digits & points);
  }
}

}  // namespace

void LastLines::add(uint32_t axes, size_t line) {
  for (; axes != 0; axes &= axes - 1) {
    size_t& at = at_[place_of(static_cast<size_t>(std::countr_zero(axes)))];
    if (at == kNowhere || line > at) at = line;
  }
}

/// Sorts the bytes from a line start on.
void PlainLines::look(size_t from) {
  constexpr size_t kBlock = ByteClasses::kBlock;
  begin_ = from;
  end_ = std::min(from + kBlock * ByteClasses::kBlocks, bytes_.size());
  const size_t whole = (end_ - begin_) / kBlock, rest = (end_ - begin_) % kBlock;
  const char* const text = bytes_.data() + begin_;
  by_->classify(text, whole, 0, &classes_);
  if (rest != 0) {
    std::array<char, kBlock> last{};
    std::copy_n(text + whole * kBlock, rest, last.begin());
    by_->classify(last.data(), 1, whole, &classes_);
  }
  find_bad(classes_, whole + (rest != 0 ? 1 : 0), bad_);
}

/// The line feed at `from` or behind it, as far as the bytes are sorted; else `end_`.
size_t PlainLines::feed_behind(size_t from) const {
  for (size_t at = from; at < end_; at += kWindow) {
    const uint64_t feeds = window(classes_.feeds, at - begin_) & low_bits(kWindow);
    if (feeds != 0) return std::min(at + static_cast<size_t>(std::countr_zero(feeds)), end_);
  }
  return end_;
}

template <typename Do>
void PlainLines::for_letters(size_t from, size_t to, const Do& apply) const {
  for (; from < to; from += kWindow) {
    uint64_t letters = window(classes_.letters, from - begin_) & low_bits(std::min(to - from, kWindow));
    for (; letters != 0; letters &= letters - 1) apply(from + static_cast<size_t>(std::countr_zero(letters)));
  }
}

/// Whether F and S surely are not 0.
bool PlainLines::never_zero(size_t from, size_t feed) const {
  const char* const text = bytes_.data();
  bool never = true;
  for_letters(from, feed, [&](size_t at) {
    const bool asked = (word_of(text[at]) & kNeverZero) != 0;
    never = never && (!asked || (text[at + 1] >= '1' && text[at + 1] <= '9'));
  });
  return never;
}

/// Reads the line number, and the code of G that stands first or behind it, where `words` has them; and looks at F and S. False
/// if a closer look is needed.
bool PlainLines::read_codes(size_t from, size_t feed, uint32_t words, uint8_t* code) const {
  const char* at = bytes_.data() + from;
  if ((words & kNumbered) != 0) {
    if (word_of(*at) != kNumbered || !is_digit(at[1])) return false;
    do ++at;
    while (is_digit(*at));
    if (*at == '.') return false;
  }
  if ((words & kGWord) != 0) {
    while (is_space_or_tab(*at)) ++at;
    if (word_of(*at) != kGWord) return false;
    ++at;
    if (*at == '0' && is_digit(at[1])) ++at;
    *code = static_cast<uint8_t>(*at - '0');
    if (*code > 3 || is_digit(at[1]) || at[1] == '.') return false;
  }
  return (words & kNeverZero) == 0 || never_zero(from, feed);
}

/// Reads the line from `from` to the line feed. False if a closer look is needed.
bool PlainLines::read_by_bits(size_t from, size_t feed, PlainLine* line) const {
  const char* const text = bytes_.data();
  uint64_t bad = 0;
  for (size_t at = from; at <= feed; at += kWindow)
    bad |= window(bad_, at - begin_) & low_bits(std::min(feed + 1 - at, kWindow));
  if (bad != 0) return false;
  uint32_t words = 0, twice = 0;
  for_letters(from, feed, [&](size_t at) {
    const uint32_t word = word_of(text[at]);
    twice |= words & word;
    words |= word;
  });
  if (twice != 0 || (words & kNoPlainLetter) != 0) return false;
  uint8_t code = 0;
  if ((words & kLookedAt) != 0 && !read_codes(from, feed, words, &code)) return false;
  *line = {words & PlainLine::kLetters, code, words != 0 ? PlainLine::kCode : PlainLine::kNothing};
  return true;
}

/// Passes lines that are short and like others that were accepted: nearly all of a large program. The first line that is not
/// is left to pass().
void PlainLines::pass_alike(size_t to, Passed* out) {
  const size_t end = std::min(end_, to);
  size_t at = out->next;
  uint32_t lines = 0;
  int8_t motion = out->proven.code;
  while (at < end) {
    const size_t place = at - begin_;
    const uint64_t feeds = window(classes_.feeds, place) & low_bits(kWindow);
    const uint64_t line = feeds ^ (feeds - 1);  // all bits up to the line feed
    const size_t feed = at + static_cast<size_t>(std::countr_zero(feeds));
    if (feeds == 0 || feed >= end || (window(bad_, place) & line) != 0) break;
    const char* const text = bytes_.data() + at;
    uint32_t words = 0, twice = 0;
    for (uint64_t letters = window(classes_.letters, place) & line; letters != 0; letters &= letters - 1) {
      const uint32_t word = word_of(text[std::countr_zero(letters)]);
      twice |= words & word;
      words |= word;
    }
    uint8_t code = 0;
    if (((words & kLookedAt) | twice) != 0) {
      if (twice != 0 || (words & kNoPlainLetter) != 0 || !read_codes(at, feed, words, &code)) break;
    }
    const uint32_t key = key_of(words & PlainLine::kLetters, code, motion);
    Like& like = likes_[place_of(key)];
    if (like.key != key || words == 0) break;
    like.last = at;
    if ((words & kGWord) != 0) out->effect.motion = static_cast<Motion>(motion = static_cast<int8_t>(code));
    ++lines;
    at = feed + 1;
  }
  if (lines == 0) return;
  out->next = at;
  out->proven.code = motion;
  if (out->first_code == 0) out->first_code = out->lines + 1;
  out->lines += lines;
  out->last_code = out->lines;
  out->text = true;
}

void PlainLines::forget(Like& like, Passed* out) {
  if (like.key != 0) out->last.add(like.key & PlainLine::kAxes, like.last);
  like.key = 0;
}

/// Whether the line surely runs.
bool PlainLines::accept(const PlainLine& line, size_t at, Passed* out) {
  const uint32_t key = key_of(line.words(), line.code(), out->proven.code);
  Like& like = likes_[place_of(key)];
  if (like.key == key) {
    if (line.has_g()) {
      out->proven.code = static_cast<int8_t>(line.code());
      out->effect.motion = static_cast<Motion>(line.code());
    }
  } else {
    if ((line.words() & refused_) != 0 || !line.runs(out->lines + 1, &out->proven, &out->effect)) return false;
    forget(like, out);
    like.key = key;
    used_ |= 1U << place_of(key);
  }
  like.last = at;
  return true;
}

Passed PlainLines::pass(size_t from, size_t to, const Proven& proven) {
  Passed out;
  out.proven = proven;
  out.next = from;
  while (out.next < to) {
    PlainLine line;
    size_t at = out.next, feed = 0;
    bool read = false;
    if (by_ != nullptr) {
      if (at < begin_ || at >= end_) look(at);
      pass_alike(to, &out);
      at = out.next;
      if (at >= to) break;
      feed = at < end_ ? feed_behind(at) : end_;
      if (feed == end_ && at != begin_) {
        look(at);
        continue;
      }
      read = feed != end_ && read_by_bits(at, feed, &line);
    }
    if (!read) {
      const char* const end = read_plain_line(bytes_.data() + at, &line);
      if (end == nullptr) break;
      feed = static_cast<size_t>(end - bytes_.data());
    }
    if (feed - at > kLineLimit || !accept(line, at, &out)) break;
    ++out.lines;
    out.text = out.text || line.text() != PlainLine::kNothing;
    if (line.text() == PlainLine::kCode) {
      if (out.first_code == 0) out.first_code = out.lines;
      out.last_code = out.lines;
    }
    out.next = feed + 1;
  }
  for (; used_ != 0; used_ &= used_ - 1) forget(likes_[static_cast<size_t>(std::countr_zero(used_))], &out);
  return out;
}

Proven proven_after(std::string_view line, const Proven& before, const Proven& always, uint32_t refused) {
  // The line without its comments.
  std::array<char, kLineLimit + 2> code;
  size_t length = 0;
  for (size_t i = 0; i < line.size() && line[i] != ';'; ++i) {
    if (line[i] == '(') {
      i = line.find(')', i);
      if (i == std::string_view::npos) return always;
      continue;
    }
    if (length > kLineLimit) return always;
    code[length++] = line[i];
  }
  code[length] = '\n';
  PlainLine plain;
  if (read_plain_line(code.data(), &plain) == nullptr || (plain.words() & refused) != 0) return always;
  Proven out = before;
  plain.learn(&out);
  return out;
}

}  // namespace owlint
