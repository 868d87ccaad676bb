// Words of other controllers and languages, and what LinuxCNC has in place of them.
#include <algorithm>
#include <array>
#include <optional>

#include "rules/driver/idioms.h"

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"

namespace owlint::rules {
namespace {

constexpr std::string_view kInsteadOfJumps =
    "to skip lines, write `o100 if [...]` and `o100 endif` with the opposite condition; to repeat lines, write `o100 "
    "while [...]` and `o100 endwhile`";

/// A keyword of other languages, and what to do in LinuxCNC.
struct OtherWord {
  std::string_view word;
  std::string_view instead;
};

constexpr std::array<OtherWord, 42> kOtherWords = {{
    {"gosub", "call a sub with `o<name> call`"},
    {"until", "close `do` with `while` and the opposite condition"},
    {"wend", "write `o100 endwhile`, with the label of the `while`"},
    {"endw", "write `o100 endwhile`, with the label of the `while`"},
    {"endfor", "count in a `while`, or use `repeat` and `endrepeat`"},
    {"endloop", "use `repeat` and `endrepeat`, or `while` and `endwhile`"},
    {"endproc", "end a sub with `o<name> endsub`"},
    {"enddef", "end a sub with `o<name> endsub`"},
    {"endfunction", "end a sub with `o<name> endsub`"},
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
    {"ret", "leave a sub with `return`, with the label of its `sub`: `o<name> return`"},
    {"rts", "leave a sub with `return`, with the label of its `sub`: `o<name> return`"},
    {"stop", "`M0` waits for the operator, `M2` ends the program"},
    {"pause", "`M0` waits for the operator, `G4 P1` waits for a second"},
    {"print", "write a comment: `(PRINT,text)`"},
    {"msg", "write a comment: `(MSG,text)`"},
    {"popen", "open a file of its own with a comment: `(LOGOPEN,points.txt)`"},
    {"dprnt", "write values to a file with a comment: `(LOG,X#1 Y#2)`, behind `(LOGOPEN,points.txt)`"},
    {"bprnt", "write values to a file with a comment: `(LOG,X#1 Y#2)`, behind `(LOGOPEN,points.txt)`"},
    {"pclos", "close the file with a comment: `(LOGCLOSE)`"},
    {"rem", "write a comment: `(text)` or `; text`"},
    {"proc", "define a sub with `o<name> sub` and `o<name> endsub`"},
    {"function", "define a sub with `o<name> sub` and `o<name> endsub`"},
    {"def", "name a value with `#<name> = 5`, define a sub with `o<name> sub`"},
    {"let", "assign with `#<name> = 5`"},
    {"var", "assign with `#<name> = 5`"},
    {"dim", "assign with `#<name> = 5`"},
    {"set", "assign with `#<name> = 5`"},
}};

std::string upper(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c; });
  return out;
}

/// A condition turned round, in its brackets, and the part of it that changed: `[#1 LT 3]` for `GE 3`.
struct Opposite {
  std::string condition;
  std::string was;
};

/// The opposite of a condition that is one comparison and nothing else.
std::optional<Opposite> opposite_of(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kOpposites = {
      {{"EQ", "NE"}, {"NE", "EQ"}, {"GT", "LE"}, {"LE", "GT"}, {"GE", "LT"}, {"LT", "GE"}}};
  text = text.substr(0, text.find_first_of("(;"));
  const size_t open = text.find_first_not_of(" \t");
  const size_t close = text.find_last_not_of(" \t\r");
  if (open == std::string_view::npos || text[open] != '[' || text[close] != ']') return std::nullopt;
  text = text.substr(open, close - open + 1);
  std::optional<Opposite> found;
  int depth = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<') i = std::min(text.find('>', i), text.size() - 1);
    depth += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
    const std::string word = upper(text.substr(i, 2));
    if (word == "OR" || (word == "AN" && upper(text.substr(i, 3)) == "AND")) return std::nullopt;
    const auto* pair = std::ranges::find(kOpposites, word, &std::pair<std::string_view, std::string_view>::first);
    if (pair == kOpposites.end()) continue;
    if (found || depth != 1) return std::nullopt;
    found = Opposite{std::string(text.substr(0, i)).append(pair->second).append(text.substr(i + 2)),
                     std::string(text.substr(i, text.size() - 1 - i))};
  }
  return found;
}

/// What ends the innermost open block with the line's label; empty if there is none, or a `do`.
std::string end_of_open(const RefusedLine& line) {
  const Program& p = line.program;
  if (line.statement.label == kNoName) return {};
  BlockId block = p.open_above(p.region_of[line.id], line.id);
  while (block != kNoBlock && p.blocks[block].label != line.statement.label) block = p.blocks[block].parent;
  if (block == kNoBlock || p.blocks[block].kind == Keyword::kDo) return {};
  return "end" + std::string(spelling(p.blocks[block].kind));
}

/// `o1 do` … `o1 until [...]`: the `while` that ends it.
void closes_do(const RefusedLine& line, Finding& f) {
  const size_t from = line.at + line.first_word().size();
  const std::optional<Opposite> opposite = opposite_of(line.written(from, line.end));
  if (!opposite || line.statement.label == kNoName || !line.ends_do()) return;
  f.help = "write `" + line.program.label_at(line.id) + " while " + opposite->condition + "`, the opposite of `" +
      opposite->was + "`";
  line.propose(f, f.help, {line.put(line.at, line.end, "while " + opposite->condition)}, true);
}

}  // namespace

/// `IF [#1 EQ 1] GOTO 20`, `GOTO 20`.
bool jumps(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t jump = text.find(
      "goto", line.kind() == StopKind::kLabelForgotten || line.kind() == StopKind::kBracketMissing ? 0 : line.at);
  if (jump == std::string_view::npos) return false;
  const bool right_there = jump == line.at || (jump == line.at + 1 && line.text[line.at] == ']');
  const bool of_keyword = line.kind() == StopKind::kLabelForgotten || line.kind() == StopKind::kBracketMissing ||
      text.substr(line.at).starts_with("if");
  if (!right_there && !of_keyword) return false;
  f.message = "LinuxCNC has no `GOTO`: a program cannot jump to a line";
  f.help = with_free_label(line.in, std::string(kInsteadOfJumps));
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
      line.kind() == StopKind::kTrailingText && line.has_keyword(Keyword::kWhile) && (rest == "do" || numbered("do"));
  if (!begins && !ends && !behind) return false;
  if (behind) {
    f.message = "`" + upper(rest) + "` after the condition: LinuxCNC has a `while` without it";
    f.help = "remove it; the loop ends with `" + line.program.label_at(line.id) + " endwhile`";
    line.propose(f, "remove `" + upper(rest) + "`", {line.put(line.at, line.end, "")}, true);
    return true;
  }
  f.message = "other controllers write loops with `WHILE … DO1` and `END1`; LinuxCNC does not";
  f.help = "write `o100 endwhile`, with the label of the `while`";
  if (!ends) {
    const std::string label = free_label_for(line.in);
    f.help = "write `" + label + " while [...]`, without `DO" + std::string(rest.substr(rest.size() - 1)) + "`, and `" +
        label + " endwhile` in place of `END" + std::string(rest.substr(rest.size() - 1)) + "`";
  }
  return true;
}

namespace {

/// `o100 if [#1 EQ 2] G0 X1 ELSE G0 X2`.
bool says_else(const RefusedLine& line, Finding& f) {
  const size_t found = line.rest().find("else");
  if (line.kind() != StopKind::kTrailingText || !line.has_keyword(Keyword::kIf) || found == std::string_view::npos ||
      found == 0 || line.rest().starts_with("then") || surely_refused(line.written(line.at, line.at + found)))
    return false;
  const std::string label = line.program.label_at(line.id);
  f.message = "both branches are on the line of the `if`";
  f.help = "write `" + line.written(line.at, line.at + found) + "`, `" + label + " else` and `" +
      line.written(std::min(line.at + found + 4, line.end), line.end) + "` on lines of their own, before `" + label +
      " endif`";
  return true;
}

}  // namespace

/// `o100 if [#1 EQ 2] then`.
bool says_then(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const bool forgotten = text.substr(line.at).starts_with("if") &&
      (line.kind() == StopKind::kLabelForgotten || line.kind() == StopKind::kNumberMissing);
  if (says_else(line, f)) return true;
  const bool here = line.rest().starts_with("then") &&
      (line.kind() == StopKind::kTrailingText || line.kind() == StopKind::kWordUnreadable);
  const size_t bracket = text.find("]then", line.at);
  const size_t after = bracket != std::string_view::npos ? bracket + 1
      : line.kind() == StopKind::kNumberMissing          ? text.find("then", line.at)
                                                         : bracket;
  const size_t then = forgotten && after != std::string_view::npos ? after : here ? line.at : 0;
  if (then == 0 && !here) return false;
  const std::string_view behind = text.substr(std::min(then + 4, text.size()));
  f.message = "LinuxCNC has no `THEN`";
  if (forgotten || line.kind() == StopKind::kWordUnreadable) {
    const std::string label = free_label_for(line.in);
    f.help = "write `" + label + " if [...]` on a line, the lines for a true condition below it, and then `" + label +
        " endif`";
  } else if (behind.empty()) {
    f.help = "remove it";
    line.propose(f, "remove `then`", {line.put(line.at, line.end, "")}, true);
  } else {
    f.help =
        "remove it, and write the rest on a line of its own, before `" + line.program.label_at(line.id) + " endif`";
  }
  return true;
}

/// `o1 repeat` … `o1 until [...]`.
bool repeats_until(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBracketMissing || !line.has_keyword(Keyword::kRepeat) ||
      line.statement.label == kNoName)
    return false;
  const Program& p = line.program;
  const auto lines = p.by_label[line.statement.label];
  const auto until = std::ranges::find_if(lines, [&](StatementId id) {
    return id > line.id && p.at(id).is(Keyword::kUnknown) && upper(p.source->slice(p.at(id).keyword_span())) == "UNTIL";
  });
  if (until == lines.end()) return false;
  const std::string label = p.label_at(line.id);
  const Statement& end = p.at(*until);
  const std::string_view text = p.source->slice({end.keyword_span().end, end.end()});
  const std::optional<Opposite> opposite = opposite_of(text);
  f.message = "LinuxCNC has no `REPEAT` … `UNTIL`";
  f.help = "write `" + label + " do`, and in place of `until` on line " + std::to_string(end.line) + " `" + label +
      " while " +
      (opposite ? opposite->condition + "`, the opposite of `" + opposite->was + "`"
                : "[...]` with the opposite condition");
  return true;
}

/// `o100 fi`, `o100 done`: ends of blocks in a shell. LinuxCNC reads the `do` of the latter.
bool ends_as_shell(const RefusedLine& line, Finding& f) {
  const bool done = line.kind() == StopKind::kTrailingText && line.has_keyword(Keyword::kDo) && line.rest() == "ne";
  const bool known = line.kind() == StopKind::kKeywordUnknown && (line.rest() == "fi" || line.rest() == "od");
  if (!done && !known) return false;
  const Span word = done ? Span{line.statement.keyword_span().begin, line.text.span(line.at, line.end).end}
                         : line.text.span(line.at, line.end);
  f.message = done ? "LinuxCNC has no `DONE`, and reads it as `do`" : "LinuxCNC has no `" + upper(line.rest()) + "`";
  const std::string end = end_of_open(line);
  const std::string label = line.program.label_at(line.id);
  if (!end.empty()) {
    f.help = "write `" + label + " " + end + "`";
    line.propose(f, "write `" + end + "`", {{word, end}}, false);
  } else if (line.statement.label != kNoName && line.ends_do()) {
    f.help = "close the `do` with `" + label + " while [...]`";
  } else {
    f.help = line.rest() == "fi" ? "write `endif`, with the label of the `if`"
                                 : "write `endwhile` or `endrepeat`, with the label of the loop";
  }
  return true;
}

namespace {

/// `sub x y` of a program that has an `endsub` without a label, too: text would have none.
bool names_sub_with_words(const RefusedLine& line, Finding& f) {
  constexpr StatementId kMost = 2000;  // lines that are looked through
  const std::string_view rest = line.rest();
  if (line.kind() != StopKind::kWordUnreadable || line.at != 0 || !rest.starts_with("sub") || !line.apart(3))
    return false;
  const auto& statements = line.program.syntax.statements;
  const auto last = std::min<size_t>(statements.size(), line.id + size_t{kMost});
  const bool ends = std::any_of(
      statements.begin() + line.id, statements.begin() + static_cast<std::ptrdiff_t>(last), [&](const Statement& s) {
        const LineError* const error = line.program.syntax.error(s);
        return error != nullptr && error->kind == StopKind::kLabelForgotten && s.keyword == Keyword::kEndsub;
      });
  if (!ends) return false;
  f.message = "the `o…` label is missing before `sub`, and its arguments have no names here";
  f.help = "write `o<name> sub`: the arguments of the call are `#1`, `#2` and so on in the sub";
  return true;
}

}  // namespace

/// A keyword of another language, after a label or alone.
bool is_other_word(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kWordUnreadable && line.kind() != StopKind::kKeywordUnknown &&
      line.kind() != StopKind::kTrailingText && line.kind() != StopKind::kNumberMissing &&
      (line.kind() != StopKind::kLineNumber || line.first_word() != "next"))
    return false;
  const bool loop = line.rest().starts_with("loopuntil[");
  std::string_view word = line.first_word().substr(loop ? 4 : 0);
  const auto* other = std::ranges::find(kOtherWords, word, &OtherWord::word);
  if (other == kOtherWords.end() && line.rest().find('=') != std::string_view::npos) {  // `FOR I=1 TO 5`, `LET X=5`
    size_t to = 0;
    while (to < word.size() && (to == 0 || !line.apart(line.at + to))) ++to;
    word = word.substr(0, to);
    other = std::ranges::find(kOtherWords, word, &OtherWord::word);
  }
  if (other != kOtherWords.end()) {
    f.message = "LinuxCNC has no `" + upper(word) + "`";
    f.help = with_free_label(line.in, std::string(other->instead));
    if (word == "until") closes_do(line, f);
    if (word == "loop" && line.statement.label != kNoName && line.ends_do())
      f.help = "close the `do` with `" + line.program.label_at(line.id) + " while [...]`";
    return true;
  }
  if (word == "end" || word == "endprogram") {
    f.message = "`" + upper(word) + "` does not say what ends";
    f.help = "write `endif`, `endwhile`, `endrepeat` or `endsub` with its label, or `M2` at the end of the program";
    const std::string end = end_of_open(line);
    if (line.kind() == StopKind::kKeywordUnknown && line.rest() == "end" && !end.empty()) {
      f.help = "write `" + line.program.label_at(line.id) + " " + end + "`";
      line.propose(f, "write `" + end + "`", {line.put(line.at, line.end, end)}, false);
    }
    if (end.empty() && line.statement.label != kNoName && line.ends_do())
      f.help = "write `" + line.program.label_at(line.id) + " while [...]`: a `do` ends with it";
    return true;
  }
  if (names_sub_with_words(line, f)) return true;
  // A LinuxCNC keyword that is not followed by brackets.
  const Keyword keyword = keyword_of(line.rest());
  if ((line.kind() != StopKind::kWordUnreadable && line.kind() != StopKind::kNumberMissing) ||
      keyword == Keyword::kUnknown || line.first_word() != spelling(keyword))
    return false;
  const std::string text(spelling(keyword));
  const bool takes_value = keyword == Keyword::kIf || keyword == Keyword::kElseif || keyword == Keyword::kWhile ||
      keyword == Keyword::kRepeat;
  f.message = "the `o…` label is missing before `" + text + "`";
  f.help = with_free_label(line.in, "write the label first: `o100 " + text + "`");
  if (keyword == Keyword::kCall || keyword == Keyword::kSub) f.help = "write the label first: `o<name> " + text + "`";
  if (takes_value)
    f.help = "write the label first, and the condition or values in square brackets: `" + free_label_for(line.in) +
        " " + text + " [...]`";
  return true;
}

/// `O100 G0 X1`: words on the line of the program's number.
bool has_words_behind_label(const RefusedLine& line, Finding& f) {
  constexpr std::string_view kLetters = "abcdefghijklmnpqrstuvwxyz#", kValue = "#[0123456789.+-<";
  const std::string_view rest = line.rest();
  if (line.kind() != StopKind::kKeywordUnknown || rest.size() < 2 ||
      line.statement.keyword_to == line.statement.label_to || kLetters.find(rest[0]) == std::string_view::npos ||
      kValue.find(rest[1]) == std::string_view::npos)
    return false;
  const std::string words = line.written(line.at, line.end);
  if (surely_refused(words)) return false;
  f.message = "`" + words + "` after `" + line.program.label_at(line.id) + "`: words need a line of their own";
  f.help = "write `" + words + "` on the next line";
  const Span rest_of_line{line.text.span(line.at - 1, line.at).end, line.text.offset(line.at)};
  line.propose(f, f.help,
               {{rest_of_line,
                 line_end(*line.program.source, line.statement) + indent_of(*line.program.source, line.statement)}},
               false);
  return true;
}

/// `o100 iff [1]`, `o100 whilee [#1 LT 3]`.
bool misspells_keyword(const RefusedLine& line, Finding& f) {
  const std::string_view letters = line.first_word();
  if (line.kind() != StopKind::kBracketMissing || letters.empty() || line.apart(line.at) ||
      !line.rest().substr(letters.size()).starts_with('['))
    return false;
  const std::string word = line.keyword_text() + std::string(letters);
  const std::string near = nearest(word, {kKeywordSpellings.begin(), kKeywordSpellings.end()});
  if (near.empty()) return false;
  const uint64_t begin = line.statement.keyword_span().begin;
  f.message = "`" + word + "` is not an O-word keyword";
  f.help = "write `" + near + "`";
  line.propose(f, f.help, {{{begin, line.text.span(line.at, line.at + letters.size()).end}, near}}, false);
  return true;
}

}  // namespace owlint::rules
