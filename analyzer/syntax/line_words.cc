// Lines without an O-word: words and assignments, and what makes the interpreter refuse them.
#include <algorithm>
#include <utility>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/text/characters.h"

namespace owlint {
namespace {

/// Of an axis that the stand-alone interpreter does not have: refused before its value is read.
bool foreign_letter(char c) { return c == 'u' || c == 'v' || c == 'w'; }

bool begins_value(char c) {
  return is_digit(c) || (c != '\0' && std::string_view("+-.[#").find(c) != std::string_view::npos);
}

constexpr double kStopCodes[] = {0, 1, 2, 30, 60};

/// G70, G71, G71.1, G71.2, G72, G72.1, G72.2.
bool is_contour_code(double number) {
  const double tenths = number * 10;
  return number == 70 || (tenths >= 710 && tenths <= 712.5) || (tenths >= 720 && tenths <= 722.5);
}

std::string quoted_character(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= ' ' && byte <= 'z') return std::string(1, c);  // `{` and what follows is not printed as it is (measured)
  std::string octal = "\\000";
  octal[1] = static_cast<char>('0' + (byte >> 6));
  octal[2] = static_cast<char>('0' + ((byte >> 3) & 7));
  octal[3] = static_cast<char>('0' + (byte & 7));
  return octal;
}

}  // namespace

std::string LineParser::bad_character(char c) { return "Bad character '" + quoted_character(c) + "' used"; }

/// The length of a keyword at `at` in place of a word, followed by a bracket, a comment or nothing.
size_t LineParser::keyword_at(size_t at) const {
  const std::string_view rest = line_.text().substr(at);
  if (keyword_of(rest) == Keyword::kUnknown) return 0;
  for (const std::string_view keyword : kKeywordSpellings) {
    if (!rest.starts_with(keyword)) continue;
    const char next = line_[at + keyword.size()];
    if (next == '\0' || next == '[' || next == '(' || next == ';') return keyword.size();
  }
  return 0;
}

/// The end of the number or name at `at` that a keyword follows; 0 if there is none.
size_t LineParser::label_end(size_t at) const {
  size_t to = at;
  if (line_[at] == '<') {
    to = line_.text().find('>', at);
    if (to == std::string_view::npos) return 0;
    ++to;
  } else {
    while (is_digit(line_[to])) ++to;
  }
  return to == at || keyword_of(line_.text().substr(to)) == Keyword::kUnknown ? 0 : to;
}

/// A number or a name without its `o` before a keyword, or with a zero for it.
bool LineParser::label_without_o(size_t at, Statement& s) {
  const bool zero_and_name = line_[at] == '0' && line_[at + 1] == '<';
  const size_t to = label_end(zero_and_name ? at + 1 : at);
  if (to == 0) return false;
  const bool zero = zero_and_name || (line_[at] == '0' && to > at + 1);
  fail(s, zero ? StopKind::kZeroForO : StopKind::kLetterForgotten, at, to, bad_character(line_[at]));
  recover(at, s, zero);
  return true;
}

/// A keyword that begins the line, without a label; a line number may stand where the label belongs.
bool LineParser::label_forgotten(size_t at, Statement& s) {
  const size_t length = keyword_at(at);
  if (length == 0) return false;
  ExpressionParser first(line_, out_.exprs, out_.names);
  first.cursor = at + 1;
  if (first.value() != kNoExpr) return false;  // `I` and `FIX[1]`
  fail(s, StopKind::kLabelForgotten, at, at + length,
       foreign_letter(line_[at]) ? bad_character(line_[at]) : first.error().message);
  if (number_at_ != std::string_view::npos) {
    recover(number_at_, s);
  } else {
    s.keyword = keyword_of(line_.text().substr(at));
    s.label_from = s.label_to = s.keyword_from = relative(at);
    s.keyword_to = static_cast<LineByte>(line_.span(at, at + length).end - s.offset);
  }
  return true;
}

void LineParser::misplaced_character(size_t at, Statement& s) {
  const char c = line_[at];
  size_t to = at + 1;
  if (c == 'o') {
    while (to < line_.size() && line_[to] != '(' && line_[to] != ';') ++to;
    fail(s, StopKind::kWordBefore, at, to, bad_character('o'));
    return s.kind == LineKind::kM99 ? void() : recover(at, s);  // in a sub, M99 returns or is refused first
  }
  if ((is_digit(c) || c == '<') && label_without_o(at, s)) return;
  if (is_foreign(c)) to = at + foreign_run(line_.text(), at);
  fail(s, StopKind::kBadCharacter, at, to, bad_character(c));
  if (s.kind == LineKind::kM99) return;
  if (line_[to] == 'o') {
    recover(to, s);
  } else if (is_foreign(c) && label_end(to) != 0) {  // an O of another alphabet
    recover(to, s, false);
  }
}

/// A letter without a value. On such a line stands another language, mostly.
void LineParser::unreadable(const ReadError& error, size_t from, Statement& s) {
  if (is_foreign(line_[error.from])) return fail(s, StopKind::kWordUnreadable, error.from, error.to, error.message);
  size_t to = from + 1;
  while (is_small_letter(line_[to])) ++to;
  // `X`, and the first letter of `XY5`; three letters and more are text.
  const bool word = to == from + 1 || (to == from + 2 && begins_value(line_[to]));
  fail(s, word ? StopKind::kNumberMissing : StopKind::kWordUnreadable, from, std::max(to, error.to),
       foreign_letter(line_[from]) ? bad_character(line_[from]) : error.message);
}

bool LineParser::assignment(ExpressionParser& in, Statement& s) {
  const size_t from = in.cursor;
  ++in.cursor;  // '#'
  Item item{.from = relative(from)};
  const ExprId target = in.parameter();
  if (target == kNoExpr) {
    fail(s, in.error().kind, in.error().from, in.error().to, in.error().message);
    return false;
  }
  Expr& parameter = out_.exprs[target];
  parameter.target = true;
  item.target = parameter.left();
  item.target_name = parameter.name();
  if (line_[in.cursor] != '=') {
    fail(s, StopKind::kExpression, from, in.cursor, "Equal sign missing in parameter setting");
    return false;
  }
  ++in.cursor;
  item.value = in.value();
  if (item.value == kNoExpr) {
    fail(s, in.error().kind, in.error().from, in.error().to, in.error().message);
    return false;
  }
  item.to = static_cast<LineByte>(line_.span(from, in.cursor).end - s.offset);
  out_.items.push_back(item);
  ++s.item_count;
  if (s.kind != LineKind::kM98) item_begins_ = static_cast<ExprId>(out_.exprs.size());
  return true;
}

Span LineParser::span_of_word(uint8_t word) const {
  if (word >= words_.size()) return {};
  return {line_.begin() + words_[word].from, line_.begin() + words_[word].to};
}

/// A fault of the word at [from, to), which has been read.
void LineParser::fail(Statement& s, const Fault& fault, size_t from, size_t to) {
  if (s.has_error()) return;
  const bool of_call = s.kind == LineKind::kM98 && (line_[from] == 'p' || line_[from] == 'l');
  fail(s, of_call ? StopKind::kM98Words : fault.kind, from, to, fault.message);
  out_.errors[s.error].other = span_of_word(fault.other);
}

uint32_t LineParser::add_error(const Fault& fault, ModeMask decided_by) {
  Span span = span_of_word(fault.word);
  if (fault.word == kNoWord) span = {line_.offset(0), line_.span(0, line_.size()).end};
  out_.errors.push_back({fault.kind, span, fault.message, span_of_word(fault.other), kNoExpr, 0, 0, decided_by});
  return static_cast<uint32_t>(out_.errors.size() - 1);
}

/// Whether the line goes on behind a fault of the word at [from, to): only where some machines know the word.
bool LineParser::passes(Statement& s, const Fault& fault, size_t from, size_t to) {
  if (fault.certain) {
    fail(s, fault, from, to);
    return false;
  }
  if (!std::exchange(unsure_, true)) {
    questions_.push_back(static_cast<uint32_t>(out_.errors.size()));
    out_.errors.push_back({fault.kind, line_.span(from, to), fault.message, {}, kNoExpr, 0, 0, 0});
  }
  return true;
}

/// Reads the value of the word at `from`; false where it has none.
bool LineParser::number_of(ExpressionParser& in, size_t from, ExprId* value, Statement& s) {
  const char first = line_[in.cursor];
  *value = in.value();
  if (*value != kNoExpr) return true;
  const ReadError& error = in.error();
  if (first == '[' || first == '#') {
    fail(s, StopKind::kExpression, error.from, error.to, error.message);
  } else if (begins_value(first)) {
    fail(s, StopKind::kNumberMalformed, from, std::max(error.to, from + 1), error.message);
  } else {
    unreadable(error, from, s);
  }
  return false;
}

bool LineParser::word(ExpressionParser& in, Statement& s) {
  const size_t from = in.cursor;
  const char letter = line_[from];
  const std::optional<Fault> letter_fault = words_.letter(letter);
  if (letter_fault && letter_fault->kind != StopKind::kWordUnknown) {
    const ExprId first = letter_fault->certain ? kNoExpr : value_of_[letter == 'q' ? 1 : 0];
    if (first == kNoExpr || s.kind == LineKind::kM98) {
      fail(s, *letter_fault, from, from + 1);
      if (s.has_error()) out_.errors[s.error].first_value = first;
      return false;
    }
    const auto read = static_cast<ExprId>(out_.exprs.size());
    questions_.push_back(static_cast<uint32_t>(out_.errors.size()));
    out_.errors.push_back({letter_fault->kind, line_.span(from, from + 1), letter_fault->message,
                           span_of_word(letter_fault->other), first, line_begins_, read, 0});
  }
  ++in.cursor;
  if (letter_fault && letter_fault->certain && begins_value(line_[in.cursor])) {
    fail(s, *letter_fault, from, from + 1);  // refused before its value is read
    return false;
  }
  ExprId value = kNoExpr;
  if (!number_of(in, from, &value, s)) return false;
  // The letter of an axis that is not there is refused before its value; but where that is no number it is a word of text.
  if (letter_fault && letter_fault->kind == StopKind::kWordUnknown && !passes(s, *letter_fault, from, in.cursor))
    return false;
  double number = 0;
  const bool known = literal_value(out_.exprs, value, &number);
  if (letter == 'g' && known) cuts_contour_ = cuts_contour_ || is_contour_code(number);
  if (letter == 'p') value_of_[0] = value;
  if (letter == 'q') {
    value_of_[1] = value;
    contour_sub_ = value;
    contour_from_ = from;
    contour_to_ = in.cursor;
  }
  if (is_small_letter(letter)) letters_ |= 1U << (letter - 'a');
  if (letter == 'm' && !m_code(value, from, in.cursor, s)) return false;
  const auto end = static_cast<LineByte>(line_.span(from, in.cursor).end - s.offset);
  if (const auto fault = words_.add({letter, known, number, relative(from), end});
      fault && !passes(s, *fault, from, in.cursor))
    return false;
  if (s.kind == LineKind::kM98) {
    m98_word(letter, value, from, in.cursor, s);
    return true;
  }
  if (!known) {
    Item item{.value = value, .from = relative(from), .letter = letter};
    item.to = end;
    out_.items.push_back(item);
    ++s.item_count;
  }
  item_begins_ = static_cast<ExprId>(out_.exprs.size());
  return true;
}

/// Makes a line that was read without an error a call of its contour's sub. Q-1 counts as no Q (measured).
void LineParser::contour(Statement& s) {
  double number = 0;
  const bool literal = literal_value(out_.exprs, contour_sub_, &number);
  if (literal && number == -1) return;
  s.kind = LineKind::kContour;
  s.label_from = s.keyword_from = relative(contour_from_);
  s.label_to = s.keyword_to = static_cast<LineByte>(line_.span(contour_from_, contour_to_).end - s.offset);
  std::string name;
  if (literal && label_of_number(number, &name)) {
    s.label = out_.names.intern(name);
  } else {
    s.label_expr = contour_sub_;
  }
}

/// An M word on a line of words: the program end, M99, or M98, which only the first word can be. False where it is refused.
bool LineParser::m_code(ExprId value, size_t from, size_t to, Statement& s) {
  double number = 0;
  if (!literal_value(out_.exprs, value, &number)) return true;
  if (number == 98) {
    fail(s, StopKind::kM98Behind, from, to, "Unknown m code used: M98");
    return false;
  }
  // Of the codes that stop, a line has one; with M99 among them that is a matter of calls.
  if (number == 99 || std::ranges::find(kStopCodes, number) != std::end(kStopCodes)) {
    if ((letters_ & kHasStop) != 0 && (number == 99 || (letters_ & kHasReturn) != 0)) {
      fail(s, StopKind::kM99Jump, from, to, "Two m codes used from same modal group");
      return false;
    }
    letters_ |= kHasStop | (number == 99 ? kHasReturn : 0U);
  }
  const bool ends = (number == 2 || number == 30) && !words_.loses_m(static_cast<int32_t>(number));
  if (s.kind == LineKind::kM98) return true;  // it is not executed
  if (!ends && (number != 99 || s.kind != LineKind::kWords)) return true;
  s.kind = ends ? LineKind::kProgramEnd : LineKind::kM99Behind;
  s.keyword_from = relative(from);
  s.keyword_to = static_cast<LineByte>(line_.span(from, to).end - s.offset);
  if (!ends) note_rest(to, s);
  return true;
}

/// Words and assignments to the end of the line; false where the reading ended before, with an error or without.
bool LineParser::all_words(ExpressionParser& in, Statement& s) {
  bool comments = false;
  for (;;) {
    in.cursor = skip_comments(in.cursor, &comments);
    if (in.cursor >= line_.size()) break;
    const char c = line_[in.cursor];
    if (c == '#') {
      if (!assignment(in, s)) return false;
    } else if (starts_word(c)) {
      if (!word(in, s)) break;
    } else {
      if (c == ']') {
        fail(s, StopKind::kExpression, in.cursor, in.cursor + 1, bad_character(c));
      } else {
        misplaced_character(in.cursor, s);
      }
      return false;
    }
  }
  s.comment |= comments;
  return true;
}

bool LineParser::starts_word(char c) {
  return (is_small_letter(c) && c != 'o' && c != 'n') || c == '@' || c == '^' || c == '$';
}

bool LineParser::words(size_t at, Statement& s) {
  ExpressionParser in(line_, out_.exprs, out_.names, &out_.split_numbers);
  in.cursor = at;
  s.first = static_cast<uint32_t>(out_.items.size());
  if (fanuc_code(at, s)) {
    if (s.kind == LineKind::kM99) {
      m99(in, s);
    } else {
      in.cursor = at + kFanucCode;
      m98(in, s);
    }
    return true;
  }
  if (label_forgotten(at, s)) return true;
  letters_ = 0;
  contour_sub_ = kNoExpr;
  cuts_contour_ = false;
  words_.clear();
  has_words_ = all_words(in, s) && !s.has_error();
  if (cuts_contour_ && contour_sub_ != kNoExpr && s.kind == LineKind::kWords && !s.has_error()) contour(s);
  return s.kind != LineKind::kWords || s.item_count > 0 || s.has_error();
}

}  // namespace owlint
