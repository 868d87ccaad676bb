#include "analyzer/syntax/known_line.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

#include "analyzer/syntax/line_parser.h"

namespace owlint {
namespace {

struct Code {
  char letter;
  int tenths;  ///< G5.1 is 51; of M codes, too
  int group;   ///< modal group: a line has one code of each
};

// Measured, each: these run whatever the machine's modes are. G1 with F, G10 with L2 or L20.
constexpr Code kSurelyRun[] =
    {
        {'g', 0, 1},     {'g', 10, 1},    {'g', 800, 1},                  // motion
        {'g', 40, 0},    {'g', 100, 0},   {'g', 280, 0},  {'g', 300, 0},  // G4 G10 G28 G30
        {'g', 200, 6},   {'g', 210, 6},   {'g', 900, 3},  {'g', 910, 3},   {'g', 901, 4},
        {'g', 911, 4},  // units, distances
        {'g', 400, 7},   {'g', 490, 8},   {'g', 940, 5},  {'g', 980, 10},  {'g', 990, 10},
        {'g', 540, 12},  {'g', 550, 12},  {'g', 560, 12}, {'g', 570, 12},  {'g', 580, 12},
        {'g', 590, 12},  {'g', 591, 12},  {'g', 592, 12}, {'g', 593, 12},  {'g', 610, 13},
        {'g', 611, 13},  {'g', 640, 13},  {'m', 0, 104},  {'m', 10, 104},  {'m', 20, 104},
        {'m', 300, 104}, {'m', 600, 104},                                                    // stop
        {'m', 30, 107},  {'m', 40, 107},  {'m', 50, 107},                                    // spindle
        {'m', 70, 108},  {'m', 80, 108},  {'m', 90, 108}, {'m', 480, 109}, {'m', 490, 109},  // coolant, overrides
};

/// Whether a comment does something that can stop the program: `(abort, …)` and Python.
bool acts(std::string_view comment) {
  comment.remove_prefix(std::min(comment.find_first_not_of("(; \t"), comment.size()));
  const auto begins = [&](std::string_view word) {
    return comment.size() >= word.size() && std::ranges::equal(comment.substr(0, word.size()), word, {}, [](char c) {
             return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
           });
  };
  return begins("abort") || begins("py");
}

/// The words of one line, and whether they go together.
class Words {
 public:
  explicit Words(const LineText& line) : line_(line), in_(line, pool_, names_) {}

  bool all_good() {
    if (line_[0] == 'n') {  // its digits have been read before
      in_.cursor = std::min(line_.text().find_first_not_of("0123456789.", 1), line_.size());
    }
    while (in_.cursor < line_.size()) {
      const char c = line_[in_.cursor];
      const bool good = c == '(' || c == ';' ? comment() : c == '#' ? assignment() : word(c);
      if (!good) return false;
    }
    return go_together();
  }

 private:
  bool comment() {
    const size_t from = in_.cursor;
    const size_t close = line_[from] == ';' ? line_.size() : line_.text().find(')', from) + 1;
    in_.cursor = close;
    return !acts(line_.text().substr(from, close - from));
  }

  bool assignment() {
    ++in_.cursor;
    if (in_.parameter() == kNoExpr || line_[in_.cursor] != '=') return false;
    ++in_.cursor;
    return in_.value() != kNoExpr;
  }

  bool word(char letter) {
    ++in_.cursor;
    const ExprId value = in_.value();
    if (value == kNoExpr) return false;
    if (std::string_view("xyzabc").find(letter) != std::string_view::npos) {
      has_axis_ = true;
      return once(letter);
    }
    double number = 0;
    if (pool_[value].op != Operator::kNumber || !literal_value(pool_, value, &number)) return false;
    if (letter == 'g' || letter == 'm') return code(letter, number);
    std::optional<double>* const word = letter == 'f' ? &feed_
        : letter == 's'                               ? &speed_
        : letter == 'p'                               ? &p_
        : letter == 'l'                               ? &l_
                                                      : nullptr;
    if (word == nullptr) return false;
    *word = number;
    return once(letter);
  }

  bool code(char letter, double number) {
    const double tenths = number * 10;
    if (tenths != std::floor(tenths) || tenths > 1000) return false;
    const Code* known = std::ranges::find_if(
        kSurelyRun, [&](const Code& c) { return c.letter == letter && c.tenths == static_cast<int>(tenths); });
    if (known == std::end(kSurelyRun) || !groups_.insert(known->group).second) return false;
    if (letter == 'm') return ++m_codes_ <= 4;
    codes_.insert(known->tenths);
    return true;
  }

  bool once(char letter) { return letters_.insert(letter).second; }
  bool has(int tenths) const { return codes_.contains(tenths); }

  bool go_together() const {
    const bool takes_axes = has(0) || has(10) || has(100) || has(280) || has(300);
    if (has_axis_ && !takes_axes) return false;
    if ((has(100) || has(280) || has(300)) && (has(0) || has(10) || has(800))) return false;
    if (has(10) && (!has_axis_ || !feed_ || *feed_ == 0)) return false;
    for (const auto& word : {feed_, speed_, p_}) {
      if (word && *word < 0) return false;
    }
    if (has(40) ? !p_ : has(100) ? !p_ || *p_ > 9 || *p_ != std::floor(*p_) : p_.has_value()) return false;
    return has(100) ? l_ == 2.0 || l_ == 20.0 : !l_.has_value();
  }

  const LineText& line_;
  ExprPool pool_;
  Names names_;
  ExpressionParser in_;
  std::unordered_set<int> groups_, codes_;
  std::unordered_set<char> letters_;
  int m_codes_ = 0;
  bool has_axis_ = false;
  std::optional<double> feed_, speed_, p_, l_;
};

/// Whether an O-word, M98 or M99 is whole, and no line that begins or ends a sub.
bool whole(const Statement& s) {
  if (s.has_error() || s.name_open || s.rest_to > s.rest_from) return false;
  if (s.kind == LineKind::kM98 || s.kind == LineKind::kM99) return true;
  return s.kind == LineKind::kOWord && !s.opens_sub() && !s.is(Keyword::kEndsub);
}

}  // namespace

bool surely_refused(std::string_view text) {
  if (text.size() > kLineLimit) return true;
  Syntax syntax;
  Statement s;
  LineParser(syntax).parse(text, 0, &s);
  return s.has_error();
}

bool surely_runs(std::string_view text) {
  if (text.size() > kLineLimit) return false;
  Syntax syntax;
  LineParser parser(syntax);
  Statement s;
  const bool kept = parser.parse(text, 0, &s);
  if (s.nul || s.inner_cr || s.block_delete) return false;
  if (kept && (s.kind == LineKind::kOWord || s.kind == LineKind::kM98 || s.kind == LineKind::kM99)) return whole(s);
  if (s.has_error() || s.kind == LineKind::kPercent) return false;
  LineText line;
  line.assign(text, 0);
  return Words(line).all_good();
}

}  // namespace owlint
