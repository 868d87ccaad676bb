// Lines that begin with M98 or M99: calls and returns in the style of Fanuc.
#include "analyzer/syntax/line_parser.h"

namespace owlint {

/// Whether the line's first word is M98 or M99. Measured: what is written there is worth 98 or 99, and then two characters
/// of it are passed over, so that `M098` is M98 and a stray `8`.
bool LineParser::fanuc_code(size_t at, Statement& s) {
  if (line_[at] != 'm') return false;
  ExpressionParser in(line_, out_.exprs, out_.names);
  in.cursor = at + 1;
  const ExprId code = in.value();
  const std::optional<long> number = code == kNoExpr ? std::nullopt : literal_integer(out_.exprs, code);
  if (number != 98 && number != 99) return false;
  s.kind = number == 98 ? LineKind::kM98 : LineKind::kM99;
  s.keyword_from = s.label_from = relative(at);
  s.keyword_to = s.label_to = static_cast<LineByte>(line_.span(at, at + kFanucCode).end - s.offset);
  return true;
}

/// Takes what stands from `at` on for the line's rest.
void LineParser::note_rest(size_t at, Statement& s) {
  bool comments = false;
  at = skip_comments(at, &comments);
  if (at >= line_.size()) return;
  const Span span = line_.span(at, line_.size());
  s.rest_from = static_cast<LineByte>(span.begin - s.offset);
  s.rest_to = static_cast<LineByte>(span.end - s.offset);
}

/// The P of M98: whom it calls. Whether that is a number at all is asked when all words have been read (measured).
void LineParser::m98_target(ExprId value, size_t from, size_t to, Statement& s) {
  target_ = value;
  target_from_ = from;
  target_to_ = to;
  s.label_from = relative(from);
  s.label_to = static_cast<LineByte>(line_.span(from, to).end - s.offset);
  s.label = kNoName;
  s.label_expr = kNoExpr;
  double number = 0;
  std::string name;
  if (!literal_value(out_.exprs, value, &number)) {
    s.label_expr = value;
  } else if (label_of_number(number, &name)) {
    s.label = out_.names.intern(name);
  }
}

/// A word of an M98 line that has been read: only P and L are used.
void LineParser::m98_word(char letter, ExprId value, size_t from, size_t to, Statement& s) {
  if (letter == 'p') return m98_target(value, from, to, s);
  if (letter != 'l') return m98_other(value, from, to, s);
  s.repeats = true;
  out_.values.insert(out_.values.begin() + s.first, value);
  ++s.value_count;
}

/// A word or an assignment of an M98 line that does nothing there.
void LineParser::m98_other(ExprId value, size_t from, size_t to, Statement& s) {
  const Span span = line_.span(from, to);
  if (s.rest_to == s.rest_from) s.rest_from = static_cast<LineByte>(span.begin - s.offset);
  s.rest_to = static_cast<LineByte>(span.end - s.offset);
  double number = 0;
  if (literal_value(out_.exprs, value, &number)) return;
  out_.values.push_back(value);
  ++s.value_count;
}

void LineParser::m98(ExpressionParser& in, Statement& s) {
  s.first = static_cast<uint32_t>(out_.values.size());
  letters_ = 0;
  target_ = kNoExpr;
  words_.begin_call();
  bool comments = false;
  for (;;) {
    in.cursor = skip_comments(in.cursor, &comments);
    if (in.cursor >= line_.size()) break;
    const size_t from = in.cursor;
    const char c = line_[from];
    if (c == '#') {
      const bool good = assignment(in, s);
      s.item_count = 0;
      if (!good) return;
      m98_other(out_.items.back().value, from, in.cursor, s);
      out_.items.pop_back();
    } else if (starts_word(c)) {
      if (!word(in, s)) return;
    } else {
      fail(s, c == 'o' ? StopKind::kWordBefore : StopKind::kBadCharacter, from, c == 'o' ? line_.size() : from + 1,
           bad_character(c));
      return;
    }
  }
  s.comment |= comments;
  double number = 0;
  std::string name;
  if (target_ == kNoExpr) {
    s.label_from = s.keyword_from;
    s.label_to = s.keyword_to;
    fail(s, StopKind::kM98NoTarget, 0, line_.size(), "Found 'm98' code with no P-word");
  } else if (literal_value(out_.exprs, target_, &number) && !label_of_number(number, &name)) {
    fail(s, StopKind::kM98Number, target_from_, target_to_, "Non integer value for integer");
  }
  has_words_of_call_ = !s.has_error();
}

void LineParser::m99(ExpressionParser& in, Statement& s) {
  note_rest(in.cursor + kFanucCode, s);
  letters_ = 0;
  words_.clear();
  if (!word(in, s) || !all_words(in, s) || s.has_error()) return;
  has_words_ = true;
  // With nothing else on the line, no mode takes the P.
  constexpr uint32_t kM = 1U << ('m' - 'a');
  constexpr uint32_t kP = 1U << ('p' - 'a');
  if ((letters_ & ~(kHasStop | kHasReturn)) == (kM | kP))
    fail(s, StopKind::kM99Jump, in.cursor, in.cursor,
         "P word with no G2 G3 G4 G10 G64 G5 G5.2 G76 G82 G86 G88 G89 or M50 M51 M52 M53 M62 M63 M64 M65 M66 M98 or "
         "user M code to use it");
}

}  // namespace owlint
