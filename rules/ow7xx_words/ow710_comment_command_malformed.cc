// OW710 comment-command-malformed: a comment that is meant to do something, and does nothing or something else.
// Depends on (measured): the word comes first in the comment, in any case, and the comma right after it. Of several comments
// on a line only the last one acts; behind `;` and on the lines of O-words and M98 none does. PROBEOPEN and PROBECLOSE are in
// capitals. `%d`, `%f` and `%.3f` are formats, all else with `%` is shown as it is; so is `#[`. There are 5601 parameters.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analyzer/syntax/comment_command.h"
#include "analyzer/syntax/last_statement.h"
#include "rules/driver/words.h"

namespace owlint::rules::ow710 {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// A comment that begins with the word of a command.
struct Comment {
  const CommentCommand* command = nullptr;
  Span span;              ///< with its brackets
  Span word;              ///< the command's word
  std::string_view rest;  ///< behind it
  uint64_t rest_at = 0;

  bool has_comma() const { return rest.starts_with(','); }
  /// Whether it acts, if its place on the line lets it.
  bool acts(const Source& source) const {
    switch (command->form) {
      case CommentCommand::kBare: return true;
      case CommentCommand::kCapitals:
        return source.slice(word).find_first_of("abcdefghijklmnopqrstuvwxyz") == std::string_view::npos;
      default: return has_comma();
    }
  }
};

/// Whether a text shows a parameter: `#5`, `#<name>`.
bool has_parameter(std::string_view text) {
  for (size_t at = text.find('#'); at != std::string_view::npos && at + 1 < text.size(); at = text.find('#', at + 1)) {
    if (is_digit(text[at + 1]) || text[at + 1] == '<') return true;
  }
  return false;
}

class Checker {
 public:
  Checker(const Input& in, Reporter& out) : in_(in), out_(out), source_(*in.program.source), text_(source_.bytes()) {}

  void run() {
    for (const uint64_t begin : in_.program.syntax.command_lines)
      line(begin, std::min(text_.find('\n', begin), text_.size()));
    constexpr uint64_t kMost = 1'000'000;  // bytes: nobody writes more by hand
    const std::string_view head = text_.substr(0, kMost);
    for (size_t at = head.find('('); at != std::string_view::npos; at = head.find('(', at + 1)) misspelt(at);
  }

 private:
  void line(size_t begin, size_t end) {
    std::vector<Comment> found;
    size_t last = 0;  // where the last comment begins
    bool code = false;
    size_t at = begin;
    for (; at < end && text_[at] != ';'; ++at) {
      if (text_[at] != '(') {
        code = code || (!is_blank(text_[at]) && text_[at] != '\r');
        continue;
      }
      const size_t close = text_.substr(0, end).find(')', at);
      if (close == std::string_view::npos) return;  // OW308
      last = at;
      if (const Comment comment = comment_at(at, close); comment.command != nullptr) found.push_back(comment);
      at = close;
    }
    const StatementId above = last_statement(in_.program.syntax, end);
    const bool on_line = above != kNoStatement && in_.program.at(above).offset >= begin;
    id_ = on_line ? above : kNoStatement;
    if (on_line && in_.program.syntax.error(in_.program.at(above)) != nullptr) return;
    for (const Comment& comment : found) report(comment, comment.span.begin == last);
    // A line that begins with `;` is one that somebody has taken out.
    if (at < end && code) behind_semicolon(at, end);
  }

  /// `(EBUG,`, `(MSG;`: the word of a command with a slip, which no English text has before a comma.
  void misspelt(size_t open) {
    constexpr size_t kLongest = 12;
    size_t from = open + 1;
    while (from < text_.size() && is_blank(text_[from])) ++from;
    size_t to = from;
    while (to < text_.size() && to - from <= kLongest && is_letter(text_[to])) ++to;
    if (to >= text_.size() || (text_[to] != ',' && text_[to] != ';') || to - from < 2) return;
    const std::string_view written = text_.substr(from, to - from);
    const bool capitals = written.find_first_of("abcdefghijklmnopqrstuvwxyz") == std::string_view::npos;
    const size_t close = std::min(text_.find_first_of(")\n", to), text_.size());
    if (close == text_.size() || text_[close] != ')') return;
    const bool shows = has_parameter(text_.substr(to, close - to));
    const CommentCommand* const known = comment_command(written);
    std::string meant;
    if (known != nullptr && text_[to] == ';') {
      // `(log; text)` may be English.
      if (known->form == CommentCommand::kBare || (!capitals && !shows)) return;
      meant = known->word;
    } else if (known == nullptr) {
      meant = command_meant(small_letters(written));
      if (meant.empty()) return;
    } else {
      return;
    }
    const size_t line_feed = text_.rfind('\n', open);
    const size_t begin = line_feed == std::string_view::npos ? 0 : line_feed + 1;
    if (in_comment(begin, open) || begin >= source_.line(in_.program.syntax.last_code).end) return;
    const StatementId above = last_statement(in_.program.syntax, open);
    id_ = above != kNoStatement && in_.program.at(above).offset >= begin ? above : kNoStatement;
    if (id_ != kNoStatement && in_.program.syntax.error(in_.program.at(id_)) != nullptr) return;
    for (char& c : meant) c = capital(c)[0];
    const std::string right = "(" + meant + ",";
    Finding& f =
        add({from, to + 1}, fmt::format("`({}{}` is an ordinary comment, which does nothing", written, text_[to]),
            fmt::format("did you mean `{}`?", right));
    f.fixes.push_back({fmt::format("write `{}`", right), false, {{{from, to + 1}, meant + ","}}});
  }

  /// Whether a place on a line is within a comment that began before it.
  bool in_comment(size_t begin, size_t place) const {
    for (size_t at = begin; at < place; ++at) {
      if (text_[at] == ';') return true;
      if (text_[at] != '(') continue;
      at = text_.find(')', at);
      if (at > place) return true;
    }
    return false;
  }

  /// The command that a word is one slip away from; empty if it is a word of its own, or of none.
  static std::string command_meant(const std::string& word) {
    constexpr size_t kShort = 3;
    constexpr std::string_view kEnglish[] = {"point",  "pint",  "prints", "sprint", "about",  "aborts",
                                             "debugs", "abbot", "lo",     "og",     "paint",  "debut",
                                             "lg",     "mg",    "ms",     "printf", "printer"};
    if (std::ranges::find(kEnglish, word) != std::end(kEnglish)) return {};
    std::vector<std::string> commands;
    for (const CommentCommand& command : kCommentCommands) {
      if (command.word.size() > kShort) commands.emplace_back(command.word);
    }
    if (word.size() > kShort) {
      std::string near = nearest(word, commands, 1);
      // `(xDEBUG,` is switched off by hand.
      if (!near.empty()) return word.size() > near.size() && word.ends_with(near) ? std::string() : near;
    }
    // Of a short word, only swapped, doubled and first letters: `lot`, `leg` and `mug` are words.
    constexpr std::string_view kMessage[] = {"sg", "mgs", "smg", "msgg", "mssg", "mmsg", "mesg"};
    constexpr std::string_view kLog[] = {"lgo", "olg", "logg", "llog", "loog"};
    if (std::ranges::find(kMessage, word) != std::end(kMessage)) return "msg";
    return std::ranges::find(kLog, word) != std::end(kLog) ? "log" : "";
  }

  Comment comment_at(size_t open, size_t close) const {
    size_t from = open + 1;
    while (from < close && is_blank(text_[from])) ++from;
    size_t to = from;
    while (to < close && is_letter(text_[to])) ++to;
    const CommentCommand* const command = comment_command(text_.substr(from, to - from));
    if (command == nullptr) return {};
    return {command, {open, close + 1}, {from, to}, text_.substr(to, close - to), to};
  }

  Finding& add(Span span, std::string message, std::string help) {
    Finding& f = out_.add(span, std::move(message));
    f.help = std::move(help);
    f.group = "comment: " + f.help;  // what an author writes once, he writes often
    f.habit_severity = Severity::kInfo;
    if (id_ != kNoStatement) f.reach = in_.flow.reach(id_);
    return f;
  }

  std::string written(const Comment& comment) const { return std::string(source_.slice(comment.word)); }

  void report(const Comment& comment, bool last) {
    if (!comment.acts(source_)) return inactive(comment);
    const bool bare_word = comment.command->form == CommentCommand::kBare && !comment.has_comma();
    if (bare_word && comment.rest.find_first_not_of(" \t") != std::string_view::npos) return;  // prose: `(py chart)`
    if (id_ != kNoStatement && never_acts(in_.program.at(id_).kind)) {
      add(comment.span,
          fmt::format("this comment does nothing: comments do not act on the line of {}",
                      in_.program.at(id_).kind == LineKind::kOWord ? "an O-word" : "`M98`"),
          "write it on a line of its own");
    } else if (!last) {
      add(comment.span, "this comment does nothing: only the last comment of a line acts",
          "write it on a line of its own, or after the other comments");
    } else if (comment.command->form == CommentCommand::kShows) {
      shows(comment);
    } else if (comment.command->form == CommentCommand::kText) {
      verbatim(comment);
    }
  }

  static bool never_acts(LineKind kind) { return kind == LineKind::kOWord || kind == LineKind::kM98; }

  /// Its comma is missing, or not in its place.
  void inactive(const Comment& comment) {
    const std::string word = written(comment);
    const size_t behind = std::min(comment.rest.find_first_not_of(" \t"), comment.rest.size());
    if (behind == comment.rest.size()) return;
    if (comment.command->form == CommentCommand::kCapitals) {
      std::string capitals;
      for (const char c : comment.command->word) capitals += capital(c);
      Finding& f = add(comment.word, fmt::format("`{}` does nothing: LinuxCNC knows it in capital letters only", word),
                       fmt::format("write `{}`", capitals));
      f.fixes.push_back({f.help, false, {{comment.word, capitals}}});
      return;
    }
    const char next = comment.rest[behind];
    Edit edit{{comment.rest_at, comment.rest_at + behind}, ","};
    if (next == ',') {
      edit.text.clear();
      add(comment.word, fmt::format("a space before the comma: `({} ,` is an ordinary comment", word),
          fmt::format("write `({},`", word))
          .fixes.push_back({fmt::format("write `({},`", word), false, {std::move(edit)}});
      return;
    }
    const bool colon = next == ':' && behind == 0;
    const bool apart =
        behind > 0 && (is_letter(next) || is_digit(next) || next == '#' || next == '"' || is_foreign(next));
    if (!colon && !apart) return;
    // Words of English, too: only with a parameter they are surely meant.
    if (comment.command->form == CommentCommand::kShows && !has_parameter(comment.rest)) return;
    if (colon) edit.span.end = comment.rest_at + 1;
    edit.text = colon ? "," : ", ";
    Finding& f = add(comment.word, fmt::format("`({}` has no comma: this is an ordinary comment", word),
                     fmt::format("write `({},` and the text", word));
    f.fixes.push_back({fmt::format("write `({},`", word), false, {std::move(edit)}});
  }

  /// What a text with parameters in it does not do.
  void shows(const Comment& comment) {
    const std::string_view rest = comment.rest;
    for (size_t i = 1; i < rest.size(); ++i) {
      const uint64_t at = comment.rest_at + i;
      if (rest[i] == '%') {
        format(rest.substr(i), at);
      } else if (rest[i] == '#') {
        i += parameter(rest.substr(i), at);
      }
    }
  }

  /// `%5.2f` and the like.
  void format(std::string_view text, uint64_t at) {
    size_t to = std::min(text.find_first_not_of("0123456789.", 1), text.size());
    if (to == text.size() || !is_letter(text[to])) return;
    const std::string_view body = text.substr(1, to - 1);
    const char letter = text[to];
    const bool number = letter == 'd' || letter == 'f' || letter == 'i' || letter == 'g' || letter == 'e' ||
        letter == 's' || letter == 'u';
    const bool known = (letter == 'd' && body.empty()) || (letter == 'f' && body.empty()) ||
        (letter == 'f' && body.size() == 2 && body[0] == '.' && is_digit(body[1]));
    if (known || !number || (to + 1 < text.size() && is_letter(text[to + 1]))) return;
    ++to;
    add({at, at + to}, fmt::format("`{}` is not a format: LinuxCNC shows it as it is", text.substr(0, to)),
        "the formats are `%d`, `%f` and `%.0f` to `%.9f`, written before the parameter");
  }

  /// How many bytes of it need no second look.
  size_t parameter(std::string_view text, uint64_t at) {
    const char next = text.size() > 1 ? text[1] : '\0';
    if (next == '[') {
      add({at, at + 2}, "`#[` is shown as it is: comments do not compute",
          "compute it into a parameter on a line before");
    } else if (next == '<' && text.find('>') == std::string_view::npos) {
      add({at, at + text.size()}, "the name has no `>`: LinuxCNC shows something else in its place", "write `#<name>`");
    } else if (is_digit(next)) {
      const size_t to = std::min(text.find_first_not_of("0123456789", 1), text.size());
      constexpr size_t kDigits = 4;
      const bool over = to > kDigits + 1 || (to == kDigits + 1 && text.substr(1, kDigits) > "5601");
      if (over && next != '0')
        add({at, at + to},
            fmt::format("LinuxCNC shows `######` for `{}`: the last parameter is #5601", text.substr(0, to)),
            "write the number of a parameter");
      return to - 1;
    }
    return 0;
  }

  /// MSG shows its text as it is. `#3` may be the number of a tool there, a name is a parameter.
  void verbatim(const Comment& comment) {
    const size_t name = comment.rest.find("#<");
    if (name == std::string_view::npos) return;
    const size_t to = std::min(comment.rest.find('>', name), comment.rest.size() - 1) + 1;
    Finding& f = add({comment.rest_at + name, comment.rest_at + to},
                     fmt::format("`({},` shows `{}` as it is, not its value", written(comment),
                                 comment.rest.substr(name, to - name)),
                     "write `(DEBUG,` in place of it: that shows values");
    f.fixes.push_back({"write `(DEBUG,`", false, {{comment.word, "DEBUG"}}});
  }

  /// `G0 X1 ; (MSG, …)`.
  void behind_semicolon(size_t at, size_t end) {
    const size_t open = text_.find_first_not_of("; \t", at);
    // Right behind the `;` it was switched off by hand.
    if (open >= end || text_[open] != '(' || text_[open - 1] == ';') return;
    const size_t close = text_.substr(0, end).find(')', open);
    if (close == std::string_view::npos) return;
    const Comment comment = comment_at(open, close);
    if (comment.command == nullptr || !comment.has_comma()) return;
    Finding& f = add(comment.span, "this comment does nothing: it comes after `;`", "remove the `;`");
    f.weight = Weight::kAside;  // it may have been taken out on purpose
  }

  const Input& in_;
  Reporter& out_;
  const Source& source_;
  std::string_view text_;
  StatementId id_ = kNoStatement;  ///< on the line at hand
};

void check(const Input& in, Reporter& out) { Checker(in, out).run(); }

}  // namespace

extern const Rule kRule{
    .code = "OW710",
    .name = "comment-command-malformed",
    .summary = "a comment that is meant to act, such as MSG or PRINT, and does not",
    .group = Group::kWords,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A comment that looks like a command and is none: `(MSG text)` without the comma, `(ABORT ,text)` with a
blank before it, `(probeopen file)` in small letters. A command in a place where comments do not act: not
the last comment of its line, on the line of an O-word or of `M98`, after `;`. A format that LinuxCNC
does not know (`%5.2f`), a parameter above #5601, `#[...]` in a `(DEBUG,...)` or `(PRINT,...)`, or
`#<name>` in a `(MSG,...)`. A word that is one slip away from a command, before a comma, and a semicolon in
place of the comma: `(EBUG,text)`, `(MSG;text)`.

`DEBUG`, `PRINT`, `LOG` and `ABORT` are English words, too: without a comma they are reported only if a
parameter follows.)",
            .why = R"(There is no message. LinuxCNC does not show or log the text, or does not stop; or the text has
`%5.2f` or `######` in it. `(MSG,...)` shows `#<name>` as it is; `(DEBUG,...)` shows the value.

The word comes first, in small or capital letters, and the comma right after it. The formats `%d`, `%f`
and `%.3f` apply from their place to the end of the text.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
(MSG turn the part over)
M0
G1 Z-2 F80
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
(MSG, turn the part over)
M0
G1 Z-2 F80
G0 Z5
M2
)",
            .fix =
                R"(Write the comma right after the word, and the comment on a line of its own. If it is an ordinary comment,
begin it with another word.)",
            .level_reason = "Warning: the program runs, but not as its author thinks. Info for a command after `;`: "
                            "somebody may have turned it off on purpose.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow710
