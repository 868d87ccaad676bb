// Lines without an O-word: words, assignments, M98 and M99, and what makes the interpreter refuse them.
#include <algorithm>

#include "analyzer/syntax/line_parser.h"

namespace owlint {
namespace {

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string quoted_character(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte < 0x7F) return std::string(1, c);
  std::string octal = "\\000";
  octal[1] = static_cast<char>('0' + (byte >> 6));
  octal[2] = static_cast<char>('0' + ((byte >> 3) & 7));
  octal[3] = static_cast<char>('0' + (byte & 7));
  return octal;
}

}  // namespace

std::string LineParser::bad_character(char c) { return "Bad character '" + quoted_character(c) + "' used"; }

/// The length of the keyword that stands at `at` instead of a word, followed by a bracket, a comment or nothing.
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

bool LineParser::misplaced_character(size_t at, Statement& s) {
  const char c = line_[at];
  if (c == 'o') {
    size_t to = at + 1;
    while (to < line_.size() && line_[to] != '(' && line_[to] != ';') ++to;
    fail(s, StopKind::kWordBefore, at, to, bad_character('o'));
    recover(at, s);
    return true;
  }
  if (c == '0') {
    size_t to = at;
    while (is_digit(line_[to])) ++to;
    const std::string_view rest = line_.text().substr(to);
    if (keyword_of(rest) != Keyword::kUnknown) {
      fail(s, StopKind::kZeroForO, at, to, bad_character('0'));
      recover(at, s);
      return true;
    }
  }
  size_t to = at + 1;
  while (to < line_.size() && static_cast<unsigned char>(line_[to]) >= 0x80) ++to;  // a whole run of foreign bytes
  fail(s, StopKind::kBadCharacter, at, to, bad_character(c));
  recover(to, s);
  return true;
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
  return true;
}

bool LineParser::word(ExpressionParser& in, Statement& s) {
  const size_t from = in.cursor;
  const char letter = line_[from];
  ++in.cursor;
  const bool plain_number = is_digit(line_[in.cursor]) || line_[in.cursor] == '.' || line_[in.cursor] == '-' ||
                            line_[in.cursor] == '+';
  const ExprId value = in.value();
  if (value == kNoExpr) {
    // A word without its number is the business of a G-code checker; an expression is ours.
    const bool ours = line_[from + 1] == '[' || line_[from + 1] == '#';
    if (ours || plain_number) fail(s, StopKind::kExpression, in.error().from, in.error().to, in.error().message);
    return false;
  }
  double number = 0;
  if (letter == 'm' && literal_value(out_.exprs, value, &number) && (number == 2 || number == 30)) {
    s.kind = LineKind::kProgramEnd;
    s.keyword_from = relative(from);
    s.keyword_to = static_cast<LineByte>(line_.span(from, in.cursor).end - s.offset);
  }
  if (out_.exprs[value].op != Operator::kNumber) {
    Item item{.value = value, .from = relative(from)};
    item.to = static_cast<LineByte>(line_.span(from, in.cursor).end - s.offset);
    out_.items.push_back(item);
    ++s.item_count;
  }
  return true;
}

void LineParser::m98(ExpressionParser& in, Statement& s) {
  s.label_from = relative(in.cursor);
  s.first = static_cast<uint32_t>(out_.values.size());
  bool has_target = false;
  bool comments = false;
  for (;;) {
    in.cursor = skip_comments(in.cursor, &comments);
    const size_t from = in.cursor;
    const char letter = line_[from];
    if (!is_letter(letter)) break;
    ++in.cursor;
    const ExprId value = in.value();
    if (value == kNoExpr) {
      fail(s, in.error().kind, in.error().from, in.error().to, in.error().message);
      return;
    }
    if (letter == 'l') {
      out_.values.push_back(value);
      s.value_count = 1;
    }
    if (letter != 'p') continue;
    has_target = true;
    s.label_from = relative(from);
    s.label_to = static_cast<LineByte>(line_.span(from, in.cursor).end - s.offset);
    double number = 0;
    std::string name;
    if (!literal_value(out_.exprs, value, &number)) {
      s.label_expr = value;
    } else if (label_of_number(number, &name)) {
      s.label = out_.names.intern(name);
    } else {
      fail(s, StopKind::kM98Number, from, in.cursor, "Non integer value for integer");
      return;
    }
  }
  if (!has_target) {
    s.label_from = s.keyword_from;
    s.label_to = s.keyword_to;
    fail(s, StopKind::kM98NoTarget, 0, line_.size(), "Found 'm98' code with no P-word");
  }
}

bool LineParser::words(size_t at, Statement& s) {
  ExpressionParser in(line_, out_.exprs, out_.names);
  in.cursor = at;
  s.first = static_cast<uint32_t>(out_.items.size());
  bool comments = false;
  if (line_[at] == 'm') {  // M98 and M99 are calls only as the line's first word (measured)
    ExpressionParser first(line_, out_.exprs, out_.names);
    first.cursor = at + 1;
    const ExprId code = first.value();
    double number = 0;
    if (code != kNoExpr && literal_value(out_.exprs, code, &number) && (number == 98 || number == 99)) {
      s.kind = number == 98 ? LineKind::kM98 : LineKind::kM99;
      s.keyword_from = s.label_from = relative(at);
      s.keyword_to = s.label_to = static_cast<LineByte>(line_.span(at, first.cursor).end - s.offset);
      if (number == 98) m98(first, s);
      return true;
    }
  }
  if (const size_t keyword = keyword_at(at); keyword > 0) {
    ExpressionParser first(line_, out_.exprs, out_.names);
    first.cursor = at + 1;
    first.value();
    fail(s, StopKind::kLabelForgotten, at, at + keyword, first.error().message);
    return true;
  }
  for (;;) {
    in.cursor = skip_comments(in.cursor, &comments);
    if (in.cursor >= line_.size()) break;
    const char c = line_[in.cursor];
    if (c == '#') {
      if (!assignment(in, s)) return true;
    } else if ((is_letter(c) && c != 'o' && c != 'n') || c == '@' || c == '^' || c == '$') {
      if (!word(in, s)) break;
    } else {
      if (c == ']') {
        fail(s, StopKind::kExpression, in.cursor, in.cursor + 1, bad_character(c));
      } else {
        misplaced_character(in.cursor, s);
      }
      return true;
    }
  }
  s.comment |= comments;
  return s.kind != LineKind::kWords || s.item_count > 0 || s.error != UINT32_MAX;
}

}  // namespace owlint
