// Idioms that are about a line as a whole: its keyword, its label, its brackets.
#include <algorithm>

#include "rules/driver/idioms.h"

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"

namespace owlint::rules {
/// `if {#1 EQ 3}`, `X{#1+1}`.
bool has_braces(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t open = text.find_first_of("{}");
  // `#{depth}`: a name, not a calculation.
  if (open == std::string_view::npos || open < line.at || (open > 0 && text[open - 1] == '#')) return false;
  std::vector<Edit> edits;
  std::string right(text);
  for (size_t i = open; i < text.size(); ++i) {
    if (text[i] != '{' && text[i] != '}') continue;
    right[i] = text[i] == '{' ? '[' : ']';
    edits.push_back(line.put(i, i + 1, std::string(1, right[i])));
  }
  // Otherwise something else stops the line, too.
  if (line.rest()[0] != '{' && surely_refused(right)) return false;
  f.message = "`{ }` are not brackets in LinuxCNC";
  if (surely_refused(right)) {  // `X5 {why}`
    f.help = "write a comment in `( )`, and a calculation in `[ ]`";
    return true;
  }
  f.help = "write square brackets: `[ ]`";
  line.propose(f, f.help, std::move(edits), false);
  return true;
}

/// `o100 (why) if [...]`, `o100 if (why) [...]`.
bool has_comment_inside(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text();
  size_t open = std::string_view::npos;
  size_t next = line.at;
  if (line.kind() == StopKind::kTrailingText) {
    const bool value = line.statement.is(Keyword::kReturn) || line.statement.is(Keyword::kEndsub);
    const bool continues = line.statement.is(Keyword::kBare) ? keyword_of(line.rest()) != Keyword::kUnknown
                                                             : value && line.rest().starts_with("[");
    if (continues && line.at > 0 && text[line.at - 1] == ')') open = text.rfind('(', line.at);
  } else if (line.kind() == StopKind::kBracketMissing && line.at < text.size() && text[line.at] == '(') {
    const size_t close = text.find(')', line.at);
    if (close != std::string_view::npos && close + 1 < text.size() && text[close + 1] == '[') {
      open = line.at;
      next = close + 1;
    }
  }
  if (open == std::string_view::npos) return false;
  const Span comment = line.text.span(open, next);
  const uint64_t line_end = line.text.span(0, line.text.size()).end;
  f.message = "a comment in the middle of the O-word: LinuxCNC does not read what follows it";
  f.help = "write the comment at the end of the line, or on a line of its own";
  const std::string moved = " " +
      std::string(line.program.source->slice({comment.begin, line.text.span(open, text.find(')', open) + 1).end}));
  const bool whole = text.find_first_of("(;", next) == std::string_view::npos && !line.rest().starts_with("sub") &&
      !line.rest().starts_with("endsub");
  line.propose(f, "move the comment to the end of the line",
               {{{comment.begin, line.text.offset(next)}, line.apart(open) ? "" : " "}, {{line_end, line_end}, moved}},
               whole);
  return true;
}

namespace {

/// The label that `break`, `continue` or `return` needs where it stands. Empty if nothing there can be left.
std::string label_left(const RefusedLine& line, Keyword jump) {
  const Program& p = line.program;
  const StatementId sub = p.regions[p.region_of[line.id]].opener;
  if (jump == Keyword::kReturn)
    return sub != kNoStatement && p.at(sub).is(Keyword::kSub) ? p.label_at(sub) : std::string();
  BlockId block = p.open_above(p.region_of[line.id], line.id);
  while (block != kNoBlock && p.blocks[block].kind == Keyword::kIf) block = p.blocks[block].parent;
  return block == kNoBlock ? std::string() : p.label_text(p.blocks[block].label);
}

}  // namespace

/// `o101 if [#1 EQ 1] return`, `o101 else break`.
bool jumps_behind_keyword(const RefusedLine& line, Finding& f) {
  const Keyword jump = keyword_of(line.rest());
  const bool alone = line.rest() == spelling(jump) || (jump == Keyword::kReturn && line.rest().starts_with("return["));
  if (line.kind() != StopKind::kTrailingText || !alone ||
      (jump != Keyword::kReturn && jump != Keyword::kBreak && jump != Keyword::kContinue))
    return false;
  const std::string word(spelling(jump));
  const std::string label = label_left(line, jump);
  f.message = "`" + word + "` after `" + line.program.head(line.id) + "`: an O-word needs a line of its own";
  if (label.empty()) {
    f.help =
        "write it on the next line, with the label of the " + std::string(jump == Keyword::kReturn ? "sub" : "loop");
    return true;
  }
  const std::string written = label + " " + line.written(line.at, line.end);
  f.help = "write `" + written + "` on the next line";
  const Span rest{line.text.span(line.at - 1, line.at).end, line.text.span(line.at, line.end).end};
  line.propose(f, f.help,
               {{rest,
                 line_end(*line.program.source, line.statement) + indent_of(*line.program.source, line.statement) +
                     "  " + written}},
               false);
  return true;
}

/// `o1 else o1 if [#2]`: an `elseif`.
bool continues_with_if(const RefusedLine& line, Finding& f) {
  const std::string label = line.program.label_at(line.id);
  const std::string begin = small_letters(label) + "if[";
  std::string_view rest = line.rest();
  if (line.kind() != StopKind::kTrailingText || !line.has_keyword(Keyword::kElse) || !rest.starts_with(begin))
    return false;
  const std::string condition = line.written(line.at + begin.size() - 1, line.end);
  f.message = "a second O-word after `" + line.program.head(line.id) + "`: both are one keyword, `elseif`";
  f.help = "write `" + label + " elseif " + condition + "`";
  const Span words{line.statement.keyword_span().begin, line.text.span(line.at, line.end).end};
  line.propose(f, f.help, {{words, "elseif " + condition}}, false);
  return true;
}

/// `o100 do while [#1 LT 3]`.
bool tests_behind_do(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kTrailingText || !line.has_keyword(Keyword::kDo) || !line.rest().starts_with("while["))
    return false;
  const std::string label = line.program.label_at(line.id);
  const std::string test = label + " " + line.written(line.at, line.end);
  f.message = "LinuxCNC's `do` has its condition at the end of the loop";
  f.help = "write `" + test + "` … `" + label + " endwhile`, or `" + label + " do` … `" + test + "`";
  if (line.statement.label == kNoName) return true;
  const auto lines = line.program.by_label[line.statement.label];
  const bool ends = std::ranges::any_of(
      lines, [&](StatementId other) { return other > line.id && line.program.at(other).is(Keyword::kEndwhile); });
  if (!ends) return true;
  const uint64_t from = line.statement.keyword_span().begin;
  line.propose(f, "write `" + test + "`", {{{from, line.text.offset(line.at)}, ""}}, false);
  return true;
}

/// `sub [x]`, `else [#1 EQ 1]`, `endif [..]`, `do [..]`.
bool brackets_behind_keyword(const RefusedLine& line, Finding& f) {
  const bool behind_comment = line.at > 0 && line.text[line.at - 1] == ')';
  if (line.kind() != StopKind::kTrailingText || !line.rest().starts_with("[") || line.has_keyword(Keyword::kBare) ||
      (!line.statement.has_bracket && !behind_comment))
    return false;
  const std::string text = line.written(line.at, line.end);
  const std::string label = line.program.label_at(line.id);
  const bool condition =
      line.has_keyword(Keyword::kElse) || line.has_keyword(Keyword::kDo) || line.has_keyword(Keyword::kEndwhile);
  f.message = "`" + line.keyword_text() + (condition ? "` takes no condition" : "` takes no value in brackets");
  if (line.has_keyword(Keyword::kSub)) {
    f.message += ": the arguments of the call are #1, #2 and so on in the sub";
    f.help = "remove `" + text + "`; pass values with `" + label + " call [...]`";
    line.propose(f, "remove `" + text + "`", {line.put(line.at, line.end, "")}, false);
  } else if (line.has_keyword(Keyword::kElse)) {
    f.help = "write `" + label + " elseif " + text + "`";
    if (!behind_comment) line.propose(f, "write `elseif`", {{line.statement.keyword_span(), "elseif"}}, false);
  } else if (line.has_keyword(Keyword::kDo)) {
    f.help = "write the condition at the end of the loop: `" + label + " while " + text + "`";
  } else if (line.has_keyword(Keyword::kEndwhile) && line.ends_do()) {
    f.help = "close the `do` with `" + label + " while " + text + "`";
    line.propose(f, "write `while`", {{line.statement.keyword_span(), "while"}}, false);
  } else if (line.has_keyword(Keyword::kEndwhile)) {
    f.help = "write the condition at the beginning of the loop: `" + label + " while " + text + "`";
  } else {
    f.help = "remove `" + text + "`";
    if (line.has_keyword(Keyword::kBreak) || line.has_keyword(Keyword::kContinue))
      f.help = "write an `if` with the condition around the line";
  }
  return true;
}

/// `o100 while (#1 LT 3)`.
bool rounds_brackets(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text();
  if (line.kind() != StopKind::kBracketMissing || line.at >= text.size() || text[line.at] != '(') return false;
  const size_t close = text.find(')', line.at);
  if (close == std::string_view::npos || close + 1 != text.size()) return false;
  f.message = "`" + line.keyword_text() + "` is followed by round brackets, and they are a comment";
  const std::string inside = line.written(line.at + 1, close);
  f.help = "write `" + line.keyword_text() + " [" + inside + "]`";
  line.propose(f, "write square brackets", {line.put(line.at, line.at + 1, "["), line.put(close, close + 1, "]")},
               false);
  return true;
}

/// `100 if [...]`, `<drill> call`.
bool lacks_letter(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kLetterForgotten) return false;
  const std::string label = line.program.label_at(line.id);
  f.message = "the letter `o` is missing before the label";
  f.help = "write `" + line.program.head(line.id) + "`";
  const NameId id = line.statement.label;
  const std::string other =
      id == kNoName || line.program.by_label[id].size() > 1 ? std::string() : label_meant(line, line.statement.keyword);
  if (!other.empty() && other != label) {
    f.message = "`" + line.written(line.at, line.at + label.size() - 1) + "` is not the label `" + other + "`";
    f.help = "write `" + other + " " + line.keyword_text() + "`";
    line.propose(f, f.help, {{line.statement.label_span(), other}}, false);
    return true;
  }
  line.propose(f, "write the letter `o`", {line.put(line.at, line.at, "o")}, !bounds_sub(line.statement));
  return true;
}

/// A title above the first `%`.
bool comes_before_percent(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kWordUnreadable && line.kind() != StopKind::kBadCharacter &&
      line.kind() != StopKind::kLabelForgotten)
    return false;
  const auto& statements = line.program.syntax.statements;
  const uint32_t plain = line.program.syntax.first_plain_line;
  if (plain != 0 && plain < line.statement.line) return false;
  // Up to the `%` there is only text.
  const auto is_text = [](const Statement& s) { return s.has_error() && s.kind != LineKind::kPercent; };
  const auto percent = std::ranges::find_if_not(statements, is_text);
  if (percent == statements.end() || percent->kind != LineKind::kPercent || percent->line < line.statement.line ||
      (percent != statements.begin() && (percent - 1)->plain_code_follows))
    return false;
  f.message = "text before the first `%`: LinuxCNC reads it as code";
  f.help = "remove it, or write it in a comment below the `%`, which must be the first line";
  return true;
}

/// `o100 if [1] // why`, `G0 X1 /* why */`, `o100 else # why`.
bool has_other_comment(const RefusedLine& line, Finding& f) {
  const bool trailing = line.kind() == StopKind::kTrailingText;
  if ((!trailing && line.kind() != StopKind::kBadCharacter) || line.at == 0) return false;
  constexpr std::string_view kMarks[] = {"//", "/*", "--", "-", "'", "#"};
  const std::string_view rest = line.rest();
  const auto* mark = std::ranges::find_if(kMarks, [&](std::string_view m) { return rest.starts_with(m); });
  if (mark == std::end(kMarks)) return false;
  const bool value =
      line.has_keyword(Keyword::kCall) || line.has_keyword(Keyword::kReturn) || line.has_keyword(Keyword::kEndsub);
  const char next = rest.size() > mark->size() ? rest[mark->size()] : ' ';
  if (*mark == "-" && std::ranges::any_of(kFunctionNames, [&](std::string_view name) {
        return rest.substr(1).starts_with(std::string(name) + "[");
      }))
    return false;
  // `else-if` and `do-while` are words.
  if (*mark == "-" && !line.apart(line.at) && is_small_letter(line.text[line.at - 1])) return false;
  if ((*mark == "#" || *mark == "--" || *mark == "-" || *mark == "'") && (!trailing || value || !is_small_letter(next)))
    return false;
  f.message = "`" + std::string(*mark) + "` does not begin a comment";
  f.help = "begin a comment with `;`, or write it in `( )`";
  if (*mark == "/*") return true;
  line.propose(f, "write `;`", {line.put(line.at, line.at + mark->size(), ";")},
               *mark != "-" || surely_refused(line.written(line.at + 1, line.end)));
  return true;
}

/// `// comment`, `% name`, `:1000`, quotes and braces.
bool has_odd_sign(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBadCharacter || line.at >= line.text.size()) return false;
  const size_t first = line.statement.block_delete ? 1 : 0;
  const char c = line.text[line.at];
  const std::string sign(1, c);
  if (c == '/' && line.at == first) {
    f.message = "`//` does not begin a comment: the first `/` is block delete";
    f.help = "begin a comment with `;`";
  } else if (c == '%') {
    f.message = "`%` must be alone on its line";
    f.help =
        line.at == 0 ? "write the text after it on a line of its own, in a comment" : "write it on a line of its own";
  } else if (c == ':' && line.at == first && is_digit(line.text[line.at + 1])) {
    f.message = "LinuxCNC does not know `:` before a program number";
    f.help = "write `O" + line.written(line.at + 1, line.end) + "`";
  } else if (line.at == first && (c == '!' || c == '\'' || c == '*' || c == '"' || c == '\\')) {
    f.message = "`" + sign + "` does not begin a comment";
    f.help = "begin a comment with `;`, or write it in `( )`";
  } else if (c == '"' || c == '\'') {
    f.message = "LinuxCNC has no text in quotes";
    f.help = "write text in a comment; a value is a number or a parameter";
  } else if (c == '{' || c == '}') {
    f.message = "`" + sign + "` has no meaning: blocks are between O-words, values in `[ ]`";
    f.help = with_free_label(line.in, "remove it; a block ends with its own keyword, such as `o100 endif`");
  } else {
    return false;
  }
  return true;
}

}  // namespace owlint::rules
