#include "analyzer/machine/remap_line.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

constexpr size_t kMostOptions = 18;
constexpr int kMinGroup = 4;
constexpr int kMaxGroup = 10;

using Problem = RemapLine::Problem;

/// Up to a comment.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBlanks = " \t\r\n\v\f";
  for (size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;
       at = text.find_first_not_of(kBlanks, at)) {
    const std::string_view word = text.substr(at, text.find_first_of(kBlanks, at) - at);
    if (word.starts_with('#')) break;
    words.push_back(word);
    at += word.size();
  }
  return words;
}

/// The integer at the beginning; 0 for other text.
int integer_at(std::string_view text) {
  int value = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Whether a number follows the letter of a code. Measured: a sign is fine, so that `G-5` is accepted, and never called.
bool has_number(std::string_view code) {
  const size_t digit = code.find_first_not_of("+-", 1) == 2 ? 2 : 1;
  return digit < code.size() && is_digit(code[digit]);
}

class RemapReader {
 public:
  RemapReader(std::string_view value, uint32_t line) : value_(value), line_(line) {}

  RemapLine run() {
    const std::vector<std::string_view> words = words_of(value_);
    if (words.empty()) {
      fail(Problem::kOnlyComment, value_, "strstore(): NULL argument");
      return std::move(out_);
    }
    out_.code = words[0];
    for (size_t i = 1; i < words.size(); ++i) {
      if (i > kMostOptions) {
        out_.dropped = words.size() - 1 - kMostOptions;
        break;
      }
      read_option(words[i]);
    }
    if (out_.problem == Problem::kNone) check();
    return std::move(out_);
  }

 private:
  std::string place() const { return fmt::format("{}:REMAP = {}", line_, value_); }

  /// Only the first: what LinuxCNC prints first.
  void fail(Problem problem, std::string_view at, std::string message) {
    if (out_.problem != Problem::kNone) return;
    out_.problem = problem;
    out_.at = at;
    out_.message = std::move(message);
  }

  void read_option(std::string_view word) {
    const size_t equals = word.find('=');
    if (equals == std::string_view::npos)
      return fail(Problem::kNoEquals, word, fmt::format("option '{}' - missing '=<value>: {}", word, place()));
    const std::string name = small_letters(word.substr(0, equals));
    const std::string_view value = word.substr(equals + 1);
    if (value.empty())
      return fail(Problem::kNoValue, word, fmt::format("option '{}' - zero length value: {}", word, place()));
    // Measured: any beginning of a name will do.
    const auto is = [&](std::string_view option) { return option.starts_with(name); };
    if (is("modalgroup")) {
      out_.group = integer_at(value);
      group_word_ = word;
    } else if (is("argspec")) {
      out_.argspec = value;
      const size_t bad = small_letters(value).find_first_not_of("abcdefghijklmnpqrstuvwxyz>^@");
      if (bad != std::string_view::npos)
        fail(Problem::kArgspec, value.substr(bad, 1),
             fmt::format("argspec: illegal word '{}' - {}", value[bad], place()));
    } else if (is("prolog")) {
      out_.prolog = value;
    } else if (is("epilog")) {
      out_.epilog = value;
    } else if (is("ngc")) {
      out_.ngc = value;
      target_word_ = word;
    } else if (is("python")) {
      out_.python = value;
      target_word_ = word;
    } else {
      out_.unknown.push_back(word);
    }
    if (!out_.ngc.empty() && !out_.python.empty())
      fail(Problem::kTwoTargets, word, "can't remap to an ngc file and a Python function: -  " + place());
  }

  void check() {
    const std::string_view code = out_.code;
    const char letter = out_.letter();
    if (letter == 'T' || letter == 'S' || letter == 'F') {
      if (out_.ngc.empty() && out_.python.empty()) return no_target();
      if (code.size() > 1)
        return fail(Problem::kLetterOnly, code,
                    fmt::format("{}: {} remap - only single letter code allowed", line_, letter));
      if (out_.group)
        fail(Problem::kFixedGroup, group_word_,
             fmt::format("{}: {} remap - modal group setting ignored - fixed sequencing", line_, letter));
      return;
    }
    const bool bad_group = out_.group && *out_.group != -1 &&
        (letter == 'M' ? *out_.group < kMinGroup || *out_.group > kMaxGroup : letter == 'G' && *out_.group != 1);
    if (bad_group) {
      return fail(Problem::kGroup, group_word_,
                  letter == 'M'
                      ? fmt::format("error: code '{}' : invalid modalgroup=<int> given (currently valid: {}..{}) : {}",
                                    code, kMinGroup, kMaxGroup, place())
                      : fmt::format("error: code '{}' : invalid modalgroup=<int> given  : {}", code, place()));
    }
    if (out_.ngc.empty() && out_.python.empty()) return no_target();
    if (letter == 'M' && !has_number(code))
      fail(Problem::kNoNumber, code,
           fmt::format("parsing M-code: expecting integer like 'M420', got '{}' : {}", code, place()));
    if (letter == 'G' && !has_number(code))
      fail(Problem::kNoNumber, code, fmt::format("code '{}' : can't parse G-code : {}", code, place()));
  }

  void no_target() {
    fail(Problem::kNoTarget, out_.code,
         fmt::format("code '{}' - no remap function given, use either 'python=<function>' or 'ngc=<basename>' : {}",
                     out_.code, place()));
  }

  std::string_view value_;
  uint32_t line_;
  std::string_view group_word_, target_word_;
  RemapLine out_;
};

}  // namespace

char RemapLine::letter() const {
  return code.empty() ? '\0' : static_cast<char>(std::toupper(static_cast<unsigned char>(code[0])));
}

int RemapLine::m_number() const {
  if (letter() != 'M' || code.size() < 2 || !is_digit(code[1])) return -1;
  return integer_at(code.substr(1));
}

int RemapLine::g_number() const {
  if (letter() != 'G' || code.size() < 2 || !is_digit(code[1])) return -1;
  int whole = 0;
  const char* const stop = code.data() + code.size();
  const auto [end, wrong] = std::from_chars(code.data() + 1, stop, whole);
  if (wrong != std::errc{}) return -1;
  // Measured: what follows the point is added as it is, so that G88.12 is G89.2.
  int tenths = 0;
  if (end != stop && *end == '.') std::from_chars(end + 1, stop, tenths);
  constexpr int kMost = 100'000;
  return std::min(whole, kMost) * 10 + std::min(tenths, kMost);
}

RemapLine read_remap(std::string_view value, uint32_t line) { return RemapReader(value, line).run(); }

}  // namespace owlint
