#include "analyzer/syntax/line_parser.h"

#include <algorithm>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/place_names.h"
#include "analyzer/text/characters.h"

namespace owlint {
namespace {

constexpr size_t kMaxArguments = 30;

}  // namespace

bool label_of_number(double value, std::string* name) {
  long number = 0;
  if (!to_integer(value, &number)) return false;
  *name = std::to_string(number);
  return true;
}

bool literal_value(const ExprPool& pool, ExprId id, double* value) {
  const Expr& expr = pool[id];
  if (expr.op == Operator::kNumber) {
    *value = expr.value();
    return true;
  }
  if (expr.left() == kNoExpr || expr.op == Operator::kParameter || expr.op == Operator::kExistsNumbered) return false;
  // Depth is bounded by the length of one line.
  double left = 0;
  double right = 0;
  if (!literal_value(pool, expr.left(), &left)) return false;
  if (expr.right() != kNoExpr && !literal_value(pool, expr.right(), &right)) return false;
  return apply(expr.op, left, right, value) == nullptr;
}

std::optional<long> literal_integer(const ExprPool& pool, ExprId id) {
  double value = 0;
  long whole = 0;
  return literal_value(pool, id, &value) && to_integer(value, &whole) ? std::optional(whole) : std::nullopt;
}

LineByte LineParser::relative(size_t at) const { return static_cast<LineByte>(line_.offset(at) - line_.begin()); }

void LineParser::fail(Statement& s, StopKind kind, size_t from, size_t to, std::string message) {
  if (s.has_error()) return;  // the first error on a line is the one that the interpreter reports
  if (is_foreign(line_[from])) to = from + foreign_run(line_.text(), from);
  s.error = static_cast<uint32_t>(out_.errors.size());
  out_.errors.push_back({kind,
                         line_.span(from, to),
                         std::move(message),
                         {},
                         kNoExpr,
                         item_begins_,
                         static_cast<ExprId>(out_.exprs.size()),
                         0});
}

bool LineParser::reads_place() const {
  for (ExprId id = line_begins_; id < out_.exprs.size(); ++id) {
    if (PlaceName::read_by(out_, out_.exprs[id])) return true;
  }
  return false;
}

size_t LineParser::skip_comments(size_t at, bool* any) const {
  while (line_[at] == '(') {
    const size_t close = line_.text().find(')', at);
    at = close == std::string_view::npos ? line_.size() : close + 1;
    *any = true;
  }
  if (line_[at] == ';') {
    *any = true;
    return line_.size();
  }
  return at;
}

bool LineParser::parse(std::string_view raw, uint64_t offset, Statement* statement) {
  Statement& s = *statement;
  s.offset = offset;
  s.length = static_cast<uint32_t>(raw.size());
  const StopKind comment = line_.assign(raw, offset);
  has_words_ = has_words_of_call_ = false;
  line_begins_ = static_cast<ExprId>(out_.exprs.size());
  questions_.clear();
  unsure_ = false;
  s.nul = line_.has_nul();
  s.inner_cr = line_.has_inner_cr();
  if (comment != StopKind::kNone) {
    s.error = static_cast<uint32_t>(out_.errors.size());
    out_.errors.push_back({comment,
                           line_.error(),
                           comment == StopKind::kCommentNested ? "Nested comment found" : "Unclosed comment found",
                           {},
                           kNoExpr,
                           0,
                           0,
                           0});
    return true;
  }
  item_begins_ = line_begins_;
  size_t at = 0;
  number_at_ = std::string_view::npos;
  if (line_.text() == "%") {
    s.kind = LineKind::kPercent;
    s.keyword_from = relative(0);
    s.keyword_to = static_cast<LineByte>(s.keyword_from + 1);
    return true;
  }
  if (line_[at] == '/') {
    s.block_delete = true;
    ++at;
  }
  if (line_[at] == 'n') {
    const size_t digits = at + 1;
    size_t end = digits;
    while (is_digit(line_[end])) ++end;
    const size_t point = end;
    if (line_[end] == '.') {
      ++end;
      while (is_digit(line_[end])) ++end;
    }
    if (point == digits || end == point + 1) {  // neither `N` nor `N10.`
      fail(s, StopKind::kLineNumber, at, std::max(end, at + 1), "Bad format unsigned integer");
      return true;
    }
    number_at_ = at;
    at = end;
    if (line_[at] == '/') {
      fail(s, StopKind::kBlockDelete, at, at + 1, bad_character('/'));
      if (line_[at + 1] == 'o') recover(at + 1, s);
      return true;
    }
  }
  if (line_[at] == 'o') {
    o_word(at, s);
    return true;
  }
  const bool keep = words(at, s) || s.nul || s.inner_cr;
  if (!keep) out_.exprs.erase(out_.exprs.begin() + line_begins_, out_.exprs.end());
  return keep;
}

/// `has_letter`: the cursor is at the `o`, or what stands in its place; else it has been forgotten.
void LineParser::label(ExpressionParser& in, Statement& s, bool has_letter) {
  const size_t from = in.cursor;
  if (has_letter) ++in.cursor;
  s.label_from = relative(from);
  if (line_[in.cursor] == '<') {
    s.named = true;
    size_t close = line_.text().find('>', in.cursor);
    s.name_open = close == std::string_view::npos;
    if (s.name_open) close = line_.size();
    s.label = out_.names.intern(line_.text().substr(in.cursor + 1, close - in.cursor - 1));
    in.cursor = s.name_open ? close : close + 1;
    s.label_to = static_cast<LineByte>(line_.span(from, in.cursor).end - s.offset);
    return;
  }
  uint32_t number = 0;
  if (in.plain_number(&number)) {
    s.label_to = static_cast<LineByte>(line_.span(from, in.cursor).end - s.offset);
    s.label = out_.names.intern_number(number);
    return;
  }
  const char first = line_[in.cursor];
  const ExprId expr = in.value();
  s.label_to = static_cast<LineByte>(line_.span(from, std::max(in.cursor, from + 1)).end - s.offset);
  if (expr == kNoExpr) {
    const ReadError& e = in.error();
    const bool digits = is_digit(first) || first == '.' || first == '-' || first == '+';
    const StopKind kind = is_small_letter(first) ? StopKind::kLabelWord
        : first == '[' || first == '#'           ? StopKind::kLabelExpression
        : digits                                 ? StopKind::kLabelNotInteger
                                                 : StopKind::kLabelMissing;
    fail(s, kind, kind == StopKind::kLabelExpression ? e.from : from, std::max(e.to, from + 1), e.message);
    return;
  }
  double value = 0;
  if (!literal_value(out_.exprs, expr, &value)) {
    s.label_expr = expr;
    return;
  }
  std::string name;
  if (!label_of_number(value, &name)) {
    fail(s, StopKind::kLabelNotInteger, from, in.cursor, "Non integer value for integer");
    return;
  }
  s.label = out_.names.intern(name);
}

void LineParser::arguments(ExpressionParser& in, Statement& s) {
  bool comments = false;
  for (;;) {
    in.cursor = skip_comments(in.cursor, &comments);
    if (line_[in.cursor] != '[') break;
    const size_t from = in.cursor;
    const ExprId argument = in.bracketed();
    if (argument == kNoExpr) {
      fail(s, in.error().kind, in.error().from, in.error().to, in.error().message);
      break;
    }
    if (s.value_count == kMaxArguments) {
      fail(s, StopKind::kTooManyArguments, from, in.cursor, "Too many subroutine parameters");
      break;
    }
    out_.values.push_back(argument);
    ++s.value_count;
  }
  s.comment |= comments;
}

void LineParser::o_word(size_t at, Statement& s, bool has_letter) {
  s.kind = LineKind::kOWord;
  s.first = static_cast<uint32_t>(out_.values.size());
  ExpressionParser in(line_, out_.exprs, out_.names, &out_.split_numbers);
  in.cursor = at;
  const size_t split_numbers = out_.split_numbers.size();
  const bool numbered = is_digit(line_[at + (has_letter ? 1 : 0)]);
  label(in, s, has_letter);
  if (numbered) out_.split_numbers.resize(split_numbers);  // `o 1 0 call`: in a label that is no matter of values
  if (s.has_error()) return;

  const std::string_view rest = line_.text().substr(in.cursor);
  s.keyword_from = s.keyword_to = relative(in.cursor);
  bool comments = false;
  if (rest.empty() || rest[0] == '(' || rest[0] == ';') {
    s.keyword = Keyword::kBare;
    s.keyword_from = s.keyword_to = s.label_to;
  } else {
    s.keyword = keyword_of(rest);
    if (s.keyword == Keyword::kUnknown) {
      size_t to = in.cursor;
      while (is_small_letter(line_[to]) || is_foreign(line_[to])) ++to;
      if (to == in.cursor) ++to;
      s.keyword_to = static_cast<LineByte>(line_.span(in.cursor, to).end - s.offset);
      fail(s, StopKind::kKeywordUnknown, in.cursor, to, "Unknown control command in o word");
      return;
    }
    const size_t from = in.cursor;
    in.cursor += spelling(s.keyword).size();
    s.keyword_to = static_cast<LineByte>(line_.span(from, in.cursor).end - s.offset);
  }

  s.has_bracket = line_[in.cursor] == '[';
  switch (s.keyword) {
    case Keyword::kCall: arguments(in, s); break;
    case Keyword::kIf:
    case Keyword::kElseif:
    case Keyword::kWhile:
    case Keyword::kRepeat:
      if (!s.has_bracket) {
        fail(s, StopKind::kBracketMissing, in.cursor, std::max(line_.size(), in.cursor),
             "Left bracket missing after '" + std::string(spelling(s.keyword)) + "'");
        return;
      }
      [[fallthrough]];
    case Keyword::kReturn:
    case Keyword::kEndsub:
      if (!s.has_bracket) break;
      if (const ExprId value = in.bracketed(); value != kNoExpr) {
        out_.values.push_back(value);
        s.value_count = 1;
      } else {
        fail(s, in.error().kind, in.error().from, in.error().to, in.error().message);
      }
      break;
    default: break;
  }
  if (s.has_error()) return;
  const size_t rest_at = skip_comments(in.cursor, &comments);
  s.comment |= comments;
  if (rest_at < line_.size()) {
    note_rest(rest_at, s);
    fail(s, StopKind::kTrailingText, rest_at, line_.size(), "Unexpected character after O-word");
  }
}

/// The line is an error, but its O-word is read anyway: then its block is not missed, and one
/// mistake stays one finding.
void LineParser::recover(size_t at, Statement& s, bool has_letter) {
  const size_t errors = out_.errors.size();
  const uint32_t error = s.error;
  s.error = kNoError;
  s.item_count = 0;
  out_.errors[error].read_from = line_begins_;
  o_word(at, s, has_letter);
  out_.errors.resize(errors);
  s.error = error;
  s.refused = true;
}

}  // namespace owlint
