// OW420 tool-table-malformed: lines of the tool table that LinuxCNC skips or takes for another tool.
// Depends on: how LinuxCNC reads the table (its own reader and `rs274 -t`, compared on random tables).
#include <map>

#include "analyzer/machine/tool_lines.h"
#include "rules/driver/ini_values.h"

namespace owlint::rules::ow420 {
namespace {

class Checker {
 public:
  Checker(const SetupInput& in, Reporter& out) : out_(out), source_(in.setup.tools_source) {
    const IniLine* key = find_line(in.setup.text, "EMCIO", "RANDOM_TOOLCHANGER");
    random_ = key != nullptr && ini_integer(in.setup.text.value(*key)).value_or(0) != 0;
  }

  void run() {
    const std::vector<ToolLine> lines =
        read_tool_lines(source_->bytes(), random_ ? ToolChanger::kRandom : ToolChanger::kFixed);
    const ToolLine* skipped = nullptr;  // the first
    size_t count = 0;
    for (const ToolLine& line : lines) {
      if (!line.skipped) {
        check(line);
        continue;
      }
      ++count;
      if (skipped == nullptr || (!names_tool(*skipped) && names_tool(line))) skipped = &line;
    }
    if (skipped != nullptr) add_skipped(*skipped, count);
  }

 private:
  /// Whether a skipped line was meant to be a tool: it has a T, or begins with a number as in tables of old.
  bool names_tool(const ToolLine& line) const {
    const std::string_view text = source_->slice(line.row.span);
    return line.has_tool || (!text.empty() && text[0] >= '0' && text[0] <= '9');
  }

  void add_skipped(const ToolLine& line, size_t count) {
    const std::string_view word = source_->slice(line.bad);
    if (says_why(line, word, count)) return;
    const bool carriage = word.empty() || word == "\r";
    Finding& f =
        out_.add(source_, carriage ? line.row.span : line.bad,
                 carriage ? "a space at the end of the line, before the carriage return: LinuxCNC skips the line"
                          : "`" + std::string(word) + "` does not belong in a tool table: LinuxCNC skips the line");
    if (count > 1) f.message += ", and " + std::to_string(count - 1) + " more like it";
    f.help = carriage      ? "remove the space"
        : names_tool(line) ? "write words such as `T1 P1 D6 Z41.5`, with spaces between them, and a comment after `;`"
                           : "begin comments with `;`";
    f.interpreter = "File: " + std::string(name_of(source_->path())) + " Unrecognized line skipped:";
    if (!names_tool(line)) f.weight = Weight::kAside;
  }

  /// A byte order mark, or `T 1 P 1`.
  bool says_why(const ToolLine& line, std::string_view word, size_t count) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    const std::string more = count > 1 ? ", and " + std::to_string(count - 1) + " more" : "";
    if (word.starts_with(kMark) && line.bad.begin == 0) {
      Finding& f = out_.add(source_, {0, kMark.size()},
                            "the file begins with a byte order mark: LinuxCNC skips its first line" + more);
      f.help = "remove the mark: save the file as UTF-8 without BOM";
      f.fixes.push_back({"remove the byte order mark", false, {{{0, kMark.size()}, ""}}});
      if (word == kMark) f.weight = Weight::kAside;  // before a comment
      return true;
    }
    const std::string_view text = source_->slice({line.bad.begin, line.row.span.end});
    const auto is_letter = [](char c) { return std::string_view("tTpPdDzZxX").find(c) != std::string_view::npos; };
    const size_t behind = text.find_first_not_of(' ', 1);
    if (word.size() != 1 || !is_letter(word[0]) || behind == std::string_view::npos || text[behind] < '0' ||
        text[behind] > '9')
      return false;
    const std::string number(text.substr(behind, std::min(text.find_first_of(" \t\r;", behind), text.size()) - behind));
    Finding& f = out_.add(source_, {line.bad.begin, line.bad.begin + behind + number.size()},
                          "a space after `" + std::string(word) + "`: LinuxCNC skips the line" + more);
    f.help = "write `" + std::string(word) + number + "`";
    return true;
  }

  /// A number with a comma: what is behind it does not count.
  void check_commas(const ToolLine& line) {
    const std::string_view text = source_->slice(line.row.span);
    const auto is_digit = [&](size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
    for (size_t at = text.find(','); at != std::string_view::npos; at = text.find(',', at + 1)) {
      if (at == 0 || !is_digit(at - 1) || !is_digit(at + 1)) continue;
      const size_t blank = text.find_last_of(' ', at);
      const size_t begin = blank == std::string_view::npos ? 0 : blank + 1;
      const size_t end = std::min(text.find_first_of(" \t\r;", at), text.size());
      const std::string word(text.substr(begin, end - begin)), read(text.substr(begin, at - begin));
      Finding& f = out_.add(source_, {line.row.span.begin + begin, line.row.span.begin + end},
                            "the comma ends the number: LinuxCNC reads `" + word + "` as `" + read + "`");
      f.help = "write a point: `" + read + "." + word.substr(read.size() + 1) + "`";
      f.fixes.push_back({"write a point", false, {{{line.row.span.begin + at, line.row.span.begin + at + 1}, "."}}});
      return;
    }
  }

  /// A number that ends before its word does: LinuxCNC reads as far as it can, and ignores the rest.
  bool check_numbers(const ToolLine& line) {
    const std::string_view text = source_->slice(line.row.span);
    for (size_t at = 0; at < text.size();) {
      const size_t end = std::min(text.find(' ', at), text.size());
      const std::string_view word = text.substr(at, end - at);
      if (check_number(word, line.row.span.begin + at)) return true;
      at = text.find_first_not_of(' ', end);
    }
    return false;
  }

  static bool is_figure(std::string_view text, size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
  }

  /// `T2 P2 Z20` for `T2P2Z20`.
  static std::string separated(std::string_view words) {
    std::string text;
    for (const char c : words) {
      const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
      if (letter && !text.empty()) text += ' ';
      text += c;
    }
    return text;
  }

  bool check_number(std::string_view word, uint64_t begin) {
    if (word.size() < 3) return false;
    const bool whole = std::string_view("tTpPqQ").find(word[0]) != std::string_view::npos;
    size_t end = word[1] == '-' || word[1] == '+' ? 2 : 1;
    const size_t first = end;
    while (is_figure(word, end)) ++end;
    if (!whole && end < word.size() && word[end] == '.') ++end;
    while (is_figure(word, end)) ++end;
    if (end == first || end >= word.size()) return false;
    const std::string read(word.substr(0, end)), rest(word.substr(end, word.find_first_of("\t\r", end) - end));
    if (rest.size() < 2) return false;
    const bool number =
        is_figure(rest, 1) || ((rest[1] == '.' || rest[1] == '-' || rest[1] == '+') && is_figure(rest, 2));
    if (!number) return false;
    const bool joined = std::string_view("tTpPdDxXyYzZaAbBcCuUvVwWiIjJqQ").find(rest[0]) != std::string_view::npos;
    const bool fraction = whole && rest[0] == '.' && rest.find_first_not_of('0', 1) != std::string::npos;
    const bool computed =
        rest[0] == '/' || rest[0] == '*' || rest[0] == '+' || rest[0] == '-' || (rest[0] == '.' && !whole);
    if (!joined && !fraction && !computed) return false;
    const std::string shown = read + rest;
    Finding& f = out_.add(source_, {begin, begin + shown.size()},
                          joined ? "no space in `" + shown + "`: LinuxCNC reads only `" + read + "`"
                                 : "`" + shown + "` is not one number: LinuxCNC reads `" + read + "`");
    f.help = joined ? "write `" + separated(shown) + "`"
        : whole     ? "write a whole number"
                    : "write one decimal number, such as `" + read.substr(0, 1) + "0.25`";
    if (joined)
      f.fixes.push_back({"put spaces between the words", false, {{{begin, begin + shown.size()}, separated(shown)}}});
    return true;
  }

  void check(const ToolLine& line) {
    check_commas(line);
    if (line.hidden.end == 0 && check_numbers(line)) return;
    const std::string tool = "tool " + std::to_string(line.row.number);
    if (line.hidden.end > 0) {
      Finding& f = out_.add(
          source_, line.hidden,
          "a tab does not separate words: LinuxCNC does not read `" + std::string(source_->slice(line.hidden)) + "`");
      f.help = "write a space instead of the tab";
      return;
    }
    if (line.no_place) {
      Finding& f =
          out_.add(source_, line.row.span,
                   random_ ? "there is no pocket " + std::to_string(line.row.pocket) + ": LinuxCNC skips " + tool
                           : "LinuxCNC reads only 1000 tools, and skips " + tool);
      f.help = random_ ? "write a pocket from 0 (the spindle) to 1000" : "remove tools that are not used";
      return;
    }
    if (!line.has_tool) {
      Finding& f = out_.add(source_, line.row.span, "a line without `T` defines no tool");
      f.help = "write the number of the tool, such as `T1`";
      return;
    }
    if (!line.has_pocket) {
      Finding& f = out_.add(
          source_, line.row.span,
          tool + " has no `P`: LinuxCNC takes it for the tool in the spindle, and loads it without its length");
      f.help = "write its pocket, such as `P1`";
      return;
    }
    check_twice(line, tool);
  }

  /// Of a fixed changer the first of a number counts, of a random one the last in a pocket.
  void check_twice(const ToolLine& line, const std::string& tool) {
    const int32_t number = random_ ? line.row.pocket : line.row.number;
    const auto [entry, added] = seen_.try_emplace(number, line.row);
    if (added) return;
    Finding& f = out_.add(
        source_, line.row.span,
        random_ ? "pocket " + std::to_string(number) + " is used twice: LinuxCNC forgets tool " +
                std::to_string(entry->second.number)
                : tool + " is already on line " + std::to_string(entry->second.line) + ": LinuxCNC uses that line");
    f.help = random_ ? "give each tool a pocket of its own" : "remove one of the two lines";
    f.related.push_back({entry->second.span, random_ ? "in the same pocket" : "LinuxCNC uses this line", nullptr});
    entry->second = random_ ? line.row : entry->second;
  }

  Reporter& out_;
  std::shared_ptr<const Source> source_;
  bool random_ = false;
  std::map<int32_t, ToolRow> seen_;
};

void check_setup(const SetupInput& in, Reporter& out) {
  if (in.setup.tools_source != nullptr) Checker(in, out).run();
}

}  // namespace

extern const Rule kRule{
    .code = "OW420",
    .name = "tool-table-malformed",
    .summary = "a line of the tool table that LinuxCNC skips or takes for another tool",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(In the file that `[EMCIO]TOOL_TABLE` names: a line with a word that LinuxCNC does not know, a tab between
words, no space between words, a space inside a word, a byte order mark, a number with a comma, a fraction, a line
without `T` or without `P`, two lines for one tool.)",
            .why =
                R"(LinuxCNC skips a line with an unknown word, and prints a message only on the console. A program that asks
for this tool does not find it. Only spaces separate words: LinuxCNC reads nothing after a tab, so the tool
may have no length. It reads a number as far as it can and ignores the rest of the word: `D1/4` is `D1`, and
`T3P3` is `T3`. LinuxCNC takes a line without `P` for the tool in the spindle. Of two lines for one tool,
it uses the first.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[EMCIO]
TOOL_TABLE = tool.tbl
; file: tool.tbl
T1 P1 D6 Z41.5
T2 P2 D8 Z40 #end mill
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[EMCIO]
TOOL_TABLE = tool.tbl
; file: tool.tbl
T1 P1 D6 Z41.5
T2 P2 D8 Z40 ;end mill
)",
            .fix = R"(Write one tool on each line, with spaces between the words: `T1 P1 D6 Z41.5 ;comment`.)",
            .level_reason =
                "Warning: LinuxCNC starts, without the tool or with another one. Info for text that was never "
                "meant as a tool.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow420
