// Idioms of calls: labels and arguments that are not written as LinuxCNC reads them.
#include <algorithm>

#include "analyzer/syntax/look_alike.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"
#include "rules/driver/modes.h"

namespace owlint::rules {
namespace {

bool is_name_char(char c) { return (c >= 'a' && c <= 'z') || is_digit(c) || c == '_'; }

/// Where what begins at `from` ends: at a bracket that it has not opened, or at the line's end.
size_t bracket_end(const RefusedLine& line, size_t from) {
  for (int depth = 0; from < line.end; ++from) {
    if (line.text[from] == '[') ++depth;
    if (line.text[from] == ']' && --depth < 0) break;
  }
  return from;
}

/// The length of the quotation mark that a text begins with, whichever it is; 0 if there is none.
size_t quote_length(std::string_view text) {
  if (text.empty()) return 0;
  const Character c = character_at(text);
  const auto same = look_alike(c.code);
  const std::string_view plain = same ? same->plain : text.substr(0, c.length);
  return plain == "\"" || plain == "'" ? c.length : 0;
}

/// Where a label that begins at `from` ends, with or without its `o`: `o<drill>`, `<drill>`, `100`. Nothing if there is none.
size_t label_end(const RefusedLine& line, size_t from) {
  const std::string_view text = line.text.text().substr(0, line.end);
  if (text.substr(from).starts_with('o')) ++from;
  if (text.substr(from).starts_with('<')) return std::min(text.find('>', from), text.size() - 1) + 1;
  size_t to = from;
  while (to < text.size() && is_digit(text[to])) ++to;
  return to > from ? to : 0;
}

/// Where a name without `< >` ends that alone, or with arguments, stands behind a keyword. Nothing if it is other text.
size_t bare_name_end(const RefusedLine& line, size_t from) {
  const auto apart = [&](size_t at) { return line.text.offset(at) > line.text.offset(at - 1) + 1; };
  if (from >= line.end || !apart(from)) return 0;
  size_t to = from;
  while (to < line.end && is_name_char(line.text[to]) && (to == from || !apart(to))) ++to;
  return to > from && (to == line.end || line.text[to] == '[') ? to : 0;
}

}  // namespace

/// `o<drill> [5]`, `o<drill> = 5`.
bool calls_without_keyword(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kKeywordUnknown || line.at >= line.text.size()) return false;
  const std::string label = line.program.label_at(line.id);
  const char c = line.text[line.at];
  if (c == '[') {
    f.message = "`" + label + "` is followed by brackets, but not by a keyword";
    f.help = "write `" + label + " call " + line.written(line.at, line.end) + "` to call the sub";
    line.propose(f, "write `call`", {line.put(line.at, line.at, "call ")}, false);
    return true;
  }
  if (c != '=' || !line.statement.named) return false;
  f.message = "`" + label + "` is a label; a label has no value";
  f.help = "assign to a parameter: `#" + line.written(line.text.text().find('<'), line.at) + " = ...`";
  return true;
}

/// `M98 O7001`, `M98 <drill>`, `M98 P<drill>`.
bool calls_by_name(const RefusedLine& line, Finding& f) {
  if (line.statement.kind != LineKind::kM98 || line.at >= line.text.size()) return false;
  const std::string_view rest = line.rest();
  const bool number = rest.size() > 1 && rest[0] == 'o' && is_digit(rest[1]);
  const bool letter = rest.starts_with("p<") || rest.starts_with("o<");
  const bool name = (letter || rest[0] == '<') && !line.before().ends_with('#');
  if (!number && !name) return false;
  if (number) {
    const size_t digits = std::min(rest.find_first_not_of("0123456789", 1), rest.size());
    const bool call = rest.substr(digits) == "call";
    if (digits < rest.size() && !call) return false;
    if (line.before().find('p') != std::string_view::npos) {
      f.message = "a second call on the line of the `M98`";
      f.help = "write one call on a line";
      return true;
    }
    const std::string right = "P" + line.written(line.at + 1, line.at + digits);
    f.message = "`M98` needs the number of the sub after `P`";
    f.help = "write `M98 " + right + "`";
    line.propose(f, call ? f.help : "write `P`", {line.put(line.at, line.end, right)}, !call);
    return true;
  }
  const size_t open = line.at + (letter ? 1 : 0);
  const size_t close = std::min(line.text.text().find('>', open), line.text.size());
  const std::string_view label = line.text.text().substr(open + 1, close - open - 1);
  if (rest[0] == 'p' && !line.is_sub(label) && line.is_parameter(label)) return false;
  f.message = "`M98` cannot call a sub by its name";
  f.help = "call a sub with a name with `o<name> call`";
  if (label.empty() || close == line.text.size()) return true;
  const std::string right = "o<" + line.written(open + 1, close) + "> call";
  f.help = "write `" + right + "`";
  if (line.is_sub(label) && close + 1 == line.end)
    line.propose(f, f.help, {{{line.statement.keyword_span().begin, line.text.offset(close) + 1}, right}}, false);
  return true;
}

/// `G71 Q<profile>`.
bool names_contour(const RefusedLine& line, Finding& f) {
  const std::vector<WrittenWord> words = words_of(*line.program.source, line.statement.whole());
  if (!line.rest().starts_with("q<") || find_word(words, "G70 G71 G71.1 G71.2 G72 G72.1 G72.2") == nullptr)
    return false;
  const size_t close = line.text.text().find('>', line.at);
  if (close == std::string_view::npos) return false;
  const std::string_view label = line.text.text().substr(line.at + 2, close - line.at - 2);
  if (!line.is_sub(label) && line.is_parameter(label)) return false;
  f.message = "`Q` takes the number of a sub, not its name";
  const std::string number = with_free_label(line.in, "o100 ");
  f.help = "give the sub a number, such as `" + number + "sub` … `" + number + "endsub`, and write `Q" +
      number.substr(1, number.size() - 2) + "`";
  return true;
}

/// `o<slot> call [length=5]`.
bool names_arguments(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  if (line.kind() != StopKind::kExpression || !line.has_keyword(Keyword::kCall) || !line.before().ends_with('['))
    return false;
  size_t equal = line.at;
  while (equal < text.size() && is_name_char(text[equal])) ++equal;
  if (equal == line.at || equal >= text.size() || text[equal] != '=') return false;
  f.message = "a call passes its values in order, without names";
  f.help =
      "write `[" + line.written(equal + 1, bracket_end(line, equal + 1)) + "]`: the sub reads the first one as `#1`";
  return true;
}

/// `#1 = o<f> call`, `#1 = call o<f>`, `X[o<f> call [1]]`.
bool calls_in_value(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression && line.kind() != StopKind::kWordUnreadable) return false;
  size_t from = line.at;
  if (line.kind() == StopKind::kWordUnreadable) ++from;
  const std::string_view text = line.text.text();
  constexpr std::string_view kCall = "call";
  const size_t label = text.substr(from).starts_with(kCall) ? from + kCall.size() : from;
  if (label + 1 >= line.end || text[label] != 'o' || (text[label + 1] != '<' && !is_digit(text[label + 1])))
    return false;
  size_t behind = label_end(line, label);
  if (behind == 0) return false;
  std::string call = line.written(label, behind) + " call";
  if (label == from && text.substr(behind).starts_with(kCall)) behind += kCall.size();
  while (behind < line.end && text[behind] == '[') {
    const size_t close = bracket_end(line, behind + 1);
    if (close == line.end) break;
    call += " " + line.written(behind, close + 1);
    behind = close + 1;
  }
  f.message = "a call cannot be used as a value";
  f.help = "call the sub on a line of its own: `" + call + "`; its result is then in `#<_value>`";
  const bool alone = text.substr(behind, line.end - behind).find(kCall) == std::string_view::npos;
  if (!alone || line.statement.block_delete || line.statement.kind == LineKind::kOWord || text[0] == 'n') return true;
  const std::string begin = indent_of(*line.program.source, line.statement);
  line.propose(f, "call first, then read `#<_value>`",
               {line.put(0, 0, call + line_end(*line.program.source, line.statement) + begin),
                line.put(from, behind, "#<_value>")},
               false);
  return true;
}

/// `#1 = M98 P100`.
bool calls_m98_in_value(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || !line.rest().starts_with("m98p") || line.at == 0) return false;
  const size_t digits = std::min(line.rest().find_first_not_of("0123456789", 4), line.rest().size());
  const std::string number = line.written(line.at + 4, line.at + digits);
  f.message = "a call cannot be used as a value, and `M98` returns none";
  f.help = "call the sub on a line of its own, `o" + (number.empty() ? "100" : number) +
      " call`, and end it with `endsub [...]`: its result is then in `#<_value>`";
  return true;
}

/// `call o<drill>`, `call <drill>`, `call 100`, `call drill [1]`.
bool has_label_behind(const RefusedLine& line, Finding& f) {
  const Keyword keyword = keyword_of(line.rest());
  if (line.kind() != StopKind::kWordUnreadable || keyword == Keyword::kUnknown) return false;
  const size_t from = line.at + spelling(keyword).size();
  const bool of_sub = keyword == Keyword::kCall || keyword == Keyword::kSub || keyword == Keyword::kEndsub;
  size_t to = label_end(line, from);
  const bool has_letter = to > 0 && line.text[from] == 'o';
  const bool bare = to == 0;
  if (bare) to = bare_name_end(line, from);
  // Behind other keywords a value is as likely.
  if (to == 0 || (!has_letter && !of_sub)) return false;
  const std::string word(spelling(keyword));
  const std::string label = has_letter ? line.written(from, to)
      : bare                           ? "o<" + line.written(from, to) + ">"
                                       : "o" + line.written(from, to);
  f.message = "the label must come before `" + word + "`";
  const std::string values = line.written(to, line.end);
  f.help = "write `" + label + " " + word + (values.empty() ? "" : " ") + values + "`";
  line.propose(f, f.help, {line.put(line.at, to, label + " " + word)},
               has_letter && keyword != Keyword::kSub && keyword != Keyword::kEndsub);
  return true;
}

/// `drill sub`, `odrill call`, `o hole sub`, `o(hole) sub`, `Q100 if`, `#<hole> call`.
bool labels_with_word(const RefusedLine& line, Finding& f) {
  if (line.statement.refused || line.kind() == StopKind::kKeywordUnknown || line.kind() == StopKind::kTrailingText ||
      line.kind() == StopKind::kLabelForgotten || line.kind() == StopKind::kLabelNotInteger)
    return false;
  const Meant meant = meant_by(line.program, line.id);
  if (meant.keyword == Keyword::kUnknown) return false;
  const Program& p = line.program;
  const std::string keyword(spelling(meant.keyword));
  const std::string words(p.source->slice(meant.words));
  const bool used = meant.label != kNoName &&
      std::ranges::any_of(p.by_label[meant.label], [&](StatementId id) { return id != line.id; });
  const std::string other = used ? std::string() : label_meant(line, meant.keyword);
  if (other.empty() && !meant.has_label) return false;
  const bool closed = meant.name.ends_with('>') && meant.name.find('<') == std::string::npos;  // `of> sub`
  const std::string label =
      !other.empty() ? other : label_text(closed ? meant.name.substr(0, meant.name.size() - 1) : meant.name);
  // What stands in place of the label.
  std::string written = words;
  const bool behind = small_letters(words).starts_with(keyword);
  if (behind) {
    f.message = "the label must come before `" + keyword + "`";
  } else {
    written.resize(words.size() - std::min(words.size(), keyword.size()));
    written.erase(std::min(written.find_last_not_of(" \t") + 1, written.size()));
    f.message = "the label `" + written + "` is not written as `" + label + "`";
    if (!other.empty()) f.message = "`" + written + "` is not the label `" + label + "`";
    if (!meant.has_label) f.message = "the O-word has no label before `" + keyword + "`";
  }
  f.help = "write `" + label + " " + keyword + "`";
  line.propose(f, f.help, {{meant.words, label + " " + keyword}}, false);
  return true;
}

/// `o"drill" call`, `#"depth" = 5`, with whatever quotation marks.
bool quotes_name(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.program.source->slice({line.error.span.begin, line.statement.end()});
  const size_t letter = line.text[line.at] == 'o' ? 1 : 0;
  const bool of_parameter = letter == 0 && line.before().ends_with('#');
  const size_t open = quote_length(text.substr(letter));
  if (open == 0 || (letter == 0 && !of_parameter)) return false;
  const size_t from = letter + open;
  size_t to = from;
  while (to < text.size() && quote_length(text.substr(to)) == 0) to += character_at(text.substr(to)).length;
  if (to == from || to == text.size()) return false;
  const std::string name(text.substr(from, to - from));
  const uint64_t begin = line.error.span.begin;
  f.message = of_parameter ? "the name of a parameter is in `< >`, not in quotes"
                           : "the name of a sub is in `< >`, not in quotes";
  std::string label = "<" + name + ">";
  const NameId id = line.program.syntax.names.find(small_letters(name));
  const bool used = id != kNoName && !line.program.by_label[id].empty();
  const std::string other = of_parameter || used ? "" : label_meant(line, meant_by(line.program, line.id).keyword);
  if (!other.empty()) label = other.substr(1);
  f.help = std::string("write `") + (of_parameter ? "#" : "o") + label + "`";
  line.propose(f, f.help, {{{begin + letter, begin + to + quote_length(text.substr(to))}, label}},
               !bounds_sub(line.statement) && other.empty());
  return true;
}

}  // namespace owlint::rules
