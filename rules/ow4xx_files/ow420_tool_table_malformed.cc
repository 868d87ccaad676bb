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
    const bool carriage = word.empty() || word == "\r";
    Finding& f =
        out_.add(source_, carriage ? line.row.span : line.bad,
                 carriage ? "a blank at the end of the line, before the carriage return: LinuxCNC skips the line"
                          : "`" + std::string(word) + "` is no word of a tool table: LinuxCNC skips the line");
    if (count > 1) f.message += ", and " + std::to_string(count - 1) + " more like it";
    f.help = carriage      ? "remove the blank"
        : names_tool(line) ? "write words such as `T1 P1 D6 Z41.5`, separated by blanks, and comments behind `;`"
                           : "begin comments with `;`";
    f.interpreter = "File: " + std::string(name_of(source_->path())) + " Unrecognized line skipped:";
    if (!names_tool(line)) f.weight = Weight::kAside;
  }

  void check(const ToolLine& line) {
    const std::string tool = "tool " + std::to_string(line.row.number);
    if (line.hidden.end > 0) {
      Finding& f = out_.add(
          source_, line.hidden,
          "a tab separates no words: LinuxCNC does not read `" + std::string(source_->slice(line.hidden)) + "`");
      f.help = "write a blank instead of the tab";
      return;
    }
    if (line.no_place) {
      Finding& f =
          out_.add(source_, line.row.span,
                   random_ ? "there is no pocket " + std::to_string(line.row.pocket) + ": LinuxCNC skips " + tool
                           : "LinuxCNC reads 1000 tools and skips " + tool);
      f.help = random_ ? "pockets go from 0, the spindle, to 1000" : "remove tools that are not used";
      return;
    }
    if (!line.has_tool) {
      Finding& f = out_.add(source_, line.row.span, "a line without `T` is no tool");
      f.help = "write the number of the tool, as `T1`";
      return;
    }
    if (!line.has_pocket) {
      Finding& f =
          out_.add(source_, line.row.span,
                   tool + " has no `P`: LinuxCNC takes it for what is in the spindle, and loads it without length");
      f.help = "write its pocket, as `P1`";
      return;
    }
    check_twice(line, tool);
  }

  /// Of a fixed changer the first of a number counts, of a random one the last in a pocket.
  void check_twice(const ToolLine& line, const std::string& tool) {
    const int32_t number = random_ ? line.row.pocket : line.row.number;
    const auto [entry, added] = seen_.try_emplace(number, line.row);
    if (added) return;
    Finding& f = out_.add(source_, line.row.span,
                          random_ ? "pocket " + std::to_string(number) + " is there already: LinuxCNC forgets tool " +
                                  std::to_string(entry->second.number)
                                  : tool + " is there already, on line " + std::to_string(entry->second.line) +
                                  ": LinuxCNC uses that one");
    f.help = random_ ? "give each tool a pocket of its own" : "remove one of the two lines";
    f.related.push_back({entry->second.span, random_ ? "in the same pocket" : "the one that is used", nullptr});
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
words, a line without `T` or without `P`, a tool that is there twice.)",
            .why =
                R"(LinuxCNC skips a line with an unknown word, with a message on the console only, and the tool is not
found when a program asks for it. Only blanks separate words: behind a tab nothing is read, so that a
tool has no length. A line without `P` is about the spindle. Of two lines for one tool the first counts.)",
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
            .fix = R"(Write one tool in each line, `T1 P1 D6 Z41.5 ;comment`, with blanks between the words.)",
            .level_reason =
                "Warning: LinuxCNC starts without the tool or with another one. Info for text that was never "
                "meant as a tool.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow420
