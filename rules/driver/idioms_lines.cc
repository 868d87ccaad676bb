// Idioms that are about a line as a whole: jumps, other loops, labels that are not there.
#include <algorithm>
#include <array>

#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

constexpr std::string_view kInsteadOfJumps =
    "to skip lines, write `o100 if [...]` and `o100 endif` with the opposite condition; to repeat lines, write `o100 "
    "while [...]` and `o100 endwhile`";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The keyword of the line, with or without a label; `while` for the WHILE of a Fanuc loop.
bool has_keyword(const RefusedLine& line, Keyword keyword) { return line.statement.keyword == keyword; }

/// A keyword of other languages, and what to do in LinuxCNC.
struct OtherWord {
  std::string_view word;
  std::string_view instead;
};

constexpr std::array<OtherWord, 34> kOtherWords = {{
    {"gosub", "call a sub with `o100 call`"},
    {"until", "close `do` with `while` and the opposite condition: `o100 while [#1 LT 10]` runs until #1 is 10"},
    {"wend", "write `o100 endwhile`, with the label of the `while`"},
    {"endw", "write `o100 endwhile`, with the label of the `while`"},
    {"endfor", "count in a `while`, or use `repeat` and `endrepeat`"},
    {"endloop", "use `repeat` and `endrepeat`, or `while` and `endwhile`"},
    {"endproc", "end a sub with `o<name> endsub`"},
    {"enddo", "close `do` with `while [...]`"},
    {"endcase", "use `if`, `elseif` and `endif`"},
    {"endswitch", "use `if`, `elseif` and `endif`"},
    {"endselect", "use `if`, `elseif` and `endif`"},
    {"for", "count in a `while`, or use `o100 repeat [5]` and `o100 endrepeat`"},
    {"next", "a loop ends with `endwhile` or `endrepeat`; to begin its next pass early, use `continue`"},
    {"loop", "use `repeat` and `endrepeat`, or `while` and `endwhile`"},
    {"foreach", "count in a `while`"},
    {"switch", "use `if`, `elseif` and `endif`"},
    {"select", "use `if`, `elseif` and `endif`"},
    {"case", "use `if`, `elseif` and `endif`"},
    {"default", "use `else`"},
    {"elif", "write `elseif`"},
    {"exit", "leave a loop with `break`, a sub with `return`, the program with `M2`"},
    {"quit", "leave a loop with `break`, a sub with `return`, the program with `M2`"},
    {"stop", "`M0` waits for the operator, `M2` ends the program"},
    {"pause", "`M0` waits for the operator, `G4 P1` waits for a second"},
    {"print", "write a comment: `(PRINT,text)`"},
    {"msg", "write a comment: `(MSG,text)`"},
    {"rem", "write a comment: `(text)` or `; text`"},
    {"proc", "define a sub with `o<name> sub` and `o<name> endsub`"},
    {"function", "define a sub with `o<name> sub` and `o<name> endsub`"},
    {"def", "name a value with `#<name> = 5`, define a sub with `o<name> sub`"},
    {"let", "assign with `#<name> = 5`"},
    {"var", "assign with `#<name> = 5`"},
    {"dim", "assign with `#<name> = 5`"},
    {"set", "assign with `#<name> = 5`"},
}};

/// The first letters of `text`.
std::string_view letters(std::string_view text) {
  return text.substr(0, std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), text.size()));
}

std::string upper(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c; });
  return out;
}

}  // namespace

/// `IF [#1 EQ 1] GOTO 20`, `GOTO 20`.
bool jumps(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t jump = text.find(
      "goto", line.kind() == StopKind::kLabelForgotten || line.kind() == StopKind::kBracketMissing ? 0 : line.at);
  if (jump == std::string_view::npos) return false;
  const bool right_there = jump == line.at || (jump == line.at + 1 && line.text[line.at] == ']');
  const bool of_keyword = line.kind() == StopKind::kLabelForgotten || line.kind() == StopKind::kBracketMissing;
  if (!right_there && !of_keyword) return false;
  f.message = "LinuxCNC has no `GOTO`: a program cannot jump to a line";
  f.help = kInsteadOfJumps;
  return true;
}

/// `WHILE [#1 LT 3] DO1` and `END1`.
bool loops_as_fanuc(const RefusedLine& line, Finding& f) {
  const std::string_view rest = line.rest();
  const auto numbered = [&](std::string_view word) {
    return rest.starts_with(word) && rest.size() == word.size() + 1 && is_digit(rest[word.size()]);
  };
  const bool begins = line.kind() == StopKind::kLabelForgotten && rest.starts_with("while") && rest.size() > 3 &&
      is_digit(rest.back()) && rest.substr(0, rest.size() - 1).ends_with("do");
  const bool ends = line.kind() == StopKind::kWordUnreadable && numbered("end");
  const bool behind =
      line.kind() == StopKind::kTrailingText && has_keyword(line, Keyword::kWhile) && (rest == "do" || numbered("do"));
  if (!begins && !ends && !behind) return false;
  if (behind) {
    f.message = "`" + upper(rest) + "` after the condition: LinuxCNC has a `while` without it";
    f.help = "remove it; the loop ends with `" + line.program.label_at(line.id) + " endwhile`";
    line.propose(f, "remove `" + upper(rest) + "`", {line.put(line.at, line.end, "")}, true);
    return true;
  }
  f.message = "`WHILE … DO1` and `END1` is a loop of other controllers; LinuxCNC does not have it";
  f.help = ends ? "write `o100 endwhile`, with the label of the `while`"
                : "write `o100 while [...]`, without `DO1`, and `o100 endwhile` in place of `END1`";
  return true;
}

/// `o100 if [#1 EQ 2] then`.
bool says_then(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const bool forgotten = line.kind() == StopKind::kLabelForgotten && text.substr(line.at).starts_with("if");
  const bool here = line.rest().starts_with("then") &&
      (line.kind() == StopKind::kTrailingText || line.kind() == StopKind::kWordUnreadable);
  const size_t then = forgotten ? text.find("]then", line.at) + 1 : here ? line.at : 0;
  if (then == 0 && !here) return false;
  const std::string_view behind = text.substr(std::min(then + 4, text.size()));
  f.message = "LinuxCNC has no `THEN`";
  if (forgotten || line.kind() == StopKind::kWordUnreadable) {
    f.help = "write `o100 if [...]` on a line, the lines for a true condition below it, and then `o100 endif`";
  } else if (behind.empty()) {
    f.help = "remove it";
    line.propose(f, "remove `then`", {line.put(line.at, line.end, "")}, true);
  } else {
    f.help =
        "remove it, and write the rest on a line of its own, before `" + line.program.label_at(line.id) + " endif`";
  }
  return true;
}

/// `o100 if [#1 EQ 2] AND [#3 LT 4]`: one bracket must be around it all.
bool has_two_brackets(const RefusedLine& line, Finding& f) {
  constexpr std::string_view kOperators[] = {"and", "or", "xor", "eq", "ne", "gt", "ge",
                                             "lt",  "le", "mod", "+",  "-",  "*",  "/"};
  const std::string_view rest = line.rest();
  const bool takes_one = has_keyword(line, Keyword::kIf) || has_keyword(line, Keyword::kElseif) ||
      has_keyword(line, Keyword::kWhile) || has_keyword(line, Keyword::kRepeat) ||
      has_keyword(line, Keyword::kReturn) || has_keyword(line, Keyword::kEndsub);
  if (line.kind() != StopKind::kTrailingText || !line.statement.has_bracket || !takes_one) return false;
  if (rest.starts_with("[")) {
    f.message = "`" + line.keyword_text() + "` takes one pair of brackets, but here is a second one";
    f.help = "write one pair around everything, and join the parts: `[[...] AND [...]]`";
    return true;
  }
  if (std::ranges::none_of(kOperators, [&](std::string_view word) { return rest.starts_with(word); })) return false;
  const size_t open = line.text.text().find('[', line.text.text().find(line.keyword_text()));
  const std::string all = line.written(open, line.end);
  f.message = "the condition ends before `" +
      std::string(line.written(line.at, line.at + letters(rest).size() + (letters(rest).empty() ? 1 : 0))) +
      "`: one pair of brackets must enclose all of it";
  f.help = "write `" + line.keyword_text() + " [" + all + "]`";
  line.propose(f, "write brackets around everything", {line.put(open, open, "["), line.put(line.end, line.end, "]")},
               true);
  // At the end of the text, not of the spaces after it.
  const uint64_t behind = line.text.span(line.at, line.end).end;
  f.fixes[0].edits[1].span = {behind, behind};
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
  f.message = "a comment inside the O-word: LinuxCNC does not read the rest of the O-word";
  f.help = "write the comment at the end of the line, or on a line of its own";
  const std::string moved = " " +
      std::string(line.program.source->slice({comment.begin, line.text.span(open, text.find(')', open) + 1).end}));
  const bool whole = text.find_first_of("(;", next) == std::string_view::npos && !line.rest().starts_with("sub") &&
      !line.rest().starts_with("endsub");
  line.propose(f, "move the comment to the end of the line",
               {{{comment.begin, line.text.offset(next)}, ""}, {{line_end, line_end}, moved}}, whole);
  return true;
}

namespace {

/// Whether the innermost open block with the line's label is a `do`.
bool ends_do(const RefusedLine& line) {
  const Program& p = line.program;
  BlockId block = p.open_above(p.region_of[line.id], line.id);
  while (block != kNoBlock && p.blocks[block].label != line.statement.label) block = p.blocks[block].parent;
  return block != kNoBlock && p.blocks[block].kind == Keyword::kDo;
}

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

/// `o1 repeat` … `o1 until [...]`.
bool repeats_until(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBracketMissing || !has_keyword(line, Keyword::kRepeat) ||
      line.statement.label == kNoName)
    return false;
  const Program& p = line.program;
  const auto lines = p.by_label[line.statement.label];
  const auto until = std::ranges::find_if(lines, [&](StatementId id) {
    return id > line.id && p.at(id).is(Keyword::kUnknown) && upper(p.source->slice(p.at(id).keyword_span())) == "UNTIL";
  });
  if (until == lines.end()) return false;
  const std::string label = p.label_at(line.id);
  f.message = "LinuxCNC has no `REPEAT` … `UNTIL`";
  f.help = "write `" + label + " do`, and in place of `until` on line " + std::to_string(p.at(*until).line) + " `" +
      label + " while [...]` with the opposite condition";
  return true;
}

/// `sub [x]`, `else [#1 EQ 1]`, `endif [..]`, `do [..]`.
bool brackets_behind_keyword(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kTrailingText || !line.rest().starts_with("[") || line.statement.has_bracket == false)
    return false;
  const std::string text = line.written(line.at, line.end);
  const std::string label = line.program.label_at(line.id);
  f.message = "`" + line.keyword_text() + "` takes no value in brackets";
  if (has_keyword(line, Keyword::kSub)) {
    f.message += ": the arguments of the call are #1, #2 and so on in the sub";
    f.help = "remove `" + text + "`; pass values with `" + label + " call [...]`";
    line.propose(f, "remove `" + text + "`", {line.put(line.at, line.end, "")}, false);
  } else if (has_keyword(line, Keyword::kElse)) {
    f.help = "write `" + label + " elseif " + text + "`";
    line.propose(f, "write `elseif`", {{line.statement.keyword_span(), "elseif"}}, false);
  } else if (has_keyword(line, Keyword::kDo)) {
    f.help = "write the condition at the end of the loop: `" + label + " while " + text + "`";
  } else if (has_keyword(line, Keyword::kEndwhile) && ends_do(line)) {
    f.help = "close the `do` with `" + label + " while " + text + "`";
    line.propose(f, "write `while`", {{line.statement.keyword_span(), "while"}}, false);
  } else if (has_keyword(line, Keyword::kEndwhile)) {
    f.help = "write the condition at the beginning of the loop: `" + label + " while " + text + "`";
  } else {
    f.help = "remove `" + text + "`";
    if (has_keyword(line, Keyword::kBreak) || has_keyword(line, Keyword::kContinue))
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
  line.propose(f, "write the letter `o`", {line.put(line.at, line.at, "o")}, !bounds_sub(line.statement));
  return true;
}

/// `endif`, `N100 sub`: a keyword without its label.
bool lacks_label(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kLabelForgotten) return false;
  const Program& p = line.program;
  const std::string word = line.keyword_text();
  if (line.statement.kind == LineKind::kOWord) {  // the line number was read in place of the label
    const size_t number = line.text.text().find('n');
    f.message =
        "the `o…` label is missing before `" + word + "`: `" + line.written(number, line.at) + "` is a line number";
    f.help = "write `" + p.head(line.id) + "`";
    line.propose(f, "write `o` instead of `N`", {line.put(number, number + 1, "o")}, !bounds_sub(line.statement));
    return true;
  }
  f.message = "the `o…` label is missing before `" + word + "`";
  f.help = "write the label first: `o100 " + word + "`";
  const BlockId block = p.block_of[line.id];
  const Region& region = p.regions[p.region_of[line.id]];
  const bool of_sub = has_keyword(line, Keyword::kEndsub) || has_keyword(line, Keyword::kReturn);
  const StatementId opener = block != kNoBlock ? p.blocks[block].opener : of_sub ? region.opener : kNoStatement;
  if (opener == kNoStatement) {
    if (has_keyword(line, Keyword::kSub) || has_keyword(line, Keyword::kCall))
      f.help = "write the label first: `o<name> " + word + "`";
    return true;
  }
  const std::string label = p.label_at(opener);
  f.help =
      "write `" + label + " " + word + "`, for `" + p.head(opener) + "` on line " + std::to_string(p.at(opener).line);
  relate(f, p, opener, "`" + p.head(opener) + "` begins here");
  const bool ends = block != kNoBlock && p.blocks[block].mistaken_end == line.id;
  line.propose(f, "write the label `" + label + "`", {line.put(line.at, line.at, label + " ")}, ends);
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
    f.help = "remove it; a block ends with its own keyword, such as `o100 endif`";
  } else {
    return false;
  }
  return true;
}

/// A keyword of another language, after a label or alone.
bool is_other_word(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kWordUnreadable && line.kind() != StopKind::kKeywordUnknown &&
      line.kind() != StopKind::kTrailingText)
    return false;
  const std::string_view word = letters(line.rest());
  const auto* other = std::ranges::find(kOtherWords, word, &OtherWord::word);
  if (other != kOtherWords.end()) {
    f.message = "LinuxCNC has no `" + upper(word) + "`";
    f.help = other->instead;
    return true;
  }
  if (word == "end" || word == "endprogram") {
    f.message = "`" + upper(word) + "` does not say what ends";
    f.help = "write `endif`, `endwhile`, `endrepeat` or `endsub` with its label, or `M2` at the end of the program";
    return true;
  }
  // A LinuxCNC keyword that is not followed by brackets.
  const Keyword keyword = keyword_of(line.rest());
  if (line.kind() != StopKind::kWordUnreadable || keyword == Keyword::kUnknown ||
      letters(line.rest()) != spelling(keyword))
    return false;
  f.message = "the `o…` label is missing before `" + std::string(spelling(keyword)) + "`";
  f.help = keyword == Keyword::kCall || keyword == Keyword::kSub
      ? "write the label first: `o<name> " + std::string(spelling(keyword)) + "`"
      : "write the label first, and the condition or values in square brackets: `o100 " +
          std::string(spelling(keyword)) + " [...]`";
  return true;
}

}  // namespace owlint::rules
