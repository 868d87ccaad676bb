// OW419 command-in-ini: a line of G-code in the INI that stops, hangs or crashes LinuxCNC.
// Depends on: which lines LinuxCNC and its displays run, and how (measured with LinuxCNC without a screen; displays: read).
#include <algorithm>
#include <array>

#include "rules/driver/lint.h"
#include "rules/driver/machine_rules.h"

namespace owlint::rules::ow419 {
namespace {

constexpr size_t kMostCommands = 200;  // a machine has a few

/// Rules whose stops do not depend on what ran before the line.
constexpr std::array<std::string_view, 6> kOfReading{"OW701", "OW702", "OW703", "OW704", "OW705", "OW706"};

/// Without comments, in upper case, so that words can be looked for.
std::string bare(std::string_view code) {
  std::string out;
  bool inside = false;
  for (const char c : code) {
    if (c == ';' && !inside) break;
    inside = c == '(' || (inside && c != ')');
    if (!inside && c != ')' && c != ' ' && c != '\t')
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return out;
}

/// Whether a line without comments has a code, such as `M` and 6; `G38.2` counts as 38.
bool has_code(std::string_view line, char letter, int number) {
  for (size_t at = line.find(letter); at != std::string_view::npos; at = line.find(letter, at + 1)) {
    if (at > 0 && (std::isalpha(static_cast<unsigned char>(line[at - 1])) != 0 || line[at - 1] == '<')) continue;
    size_t end = at + 1;
    int value = 0;
    while (end < line.size() && line[end] >= '0' && line[end] <= '9' && value < 1000)
      value = value * 10 + (line[end++] - '0');
    if (end > at + 1 && value == number) return true;
  }
  return false;
}

class Checker {
 public:
  Checker(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text) {}

  void run() {
    const IniLine* start = find_line(text_, "RS274NGC", "RS274NGC_STARTUP_CODE");
    if (start == nullptr) start = find_line(text_, "EMC", "RS274NGC_STARTUP_CODE");
    if (start != nullptr && !start->continued) check_start(*start);
    const IniLine* abort = find_line(text_, "RS274NGC", "ON_ABORT_COMMAND");
    if (abort != nullptr && !abort->continued) check_abort(*abort);
    size_t count = 0;
    for (const IniLine* line : lines_of(text_, "HALUI")) {
      if (text_.name(*line) != "MDI_COMMAND") continue;
      if (line->value.begin == line->value.end || ++count > kMostCommands) break;
      if (!line->continued) check_command(*line, line->value, "halui runs it as an MDI command");
    }
    for (const IniLine* line : lines_of(text_, "MDI_COMMAND_LIST")) {
      if (line->kind == IniLine::Kind::kKey && text_.name(*line).starts_with("MDI_COMMAND") && !line->continued &&
          ++count <= kMostCommands)
        check_parts(*line);
    }
  }

 private:
  /// What owlint finds in the code as a program of its own.
  std::vector<Finding> findings_in(const std::string& code) const {
    const auto source = Source::own(joined_path(folder_of(in_.setup.path), "command in the INI"), code + "\nM2\n");
    Profile profile = in_.profile;
    profile.feature = 0;
    LintOptions options;
    FileReport report = lint(in_.library.load(source, profile), profile, options, in_.library).own;
    std::erase_if(report.findings, [&](const Finding& f) {
      return !f.stops || f.reach != Reach::kAlways || f.span.begin > code.size() || f.code == "OW208";
    });
    return std::move(report.findings);
  }

  Finding& add(const IniLine& line, Span span, std::string message) {
    return add_at(in_, out_, line, span, std::move(message));
  }

  void check_start(const IniLine& line) {
    const std::string code(text_.value(line));
    const std::string words = bare(code);
    const auto has = [&](char letter, int number) { return has_code(words, letter, number); };
    const std::string start = "the start-up code ";
    for (const int number : {6, 61, 66}) {
      if (has('M', number))
        return hang(line,
                    start + "changes the tool or waits for an input, `M" + std::to_string(number) +
                        "`: LinuxCNC waits for ever before it starts");
    }
    if (has('G', 38)) return hang(line, start + "probes: LinuxCNC waits for ever before it starts");
    if (has('M', 99)) return hang(line, start + "has `M99`: LinuxCNC crashes when it starts");
    for (const int number : {2, 30, 98}) {
      if (!has('M', number)) continue;
      Finding& f = add(line, line.value, start + "has `M" + std::to_string(number) + "`: LinuxCNC does not start");
      f.help = "remove `M" + std::to_string(number) + "`: the line sets modes, such as `G21 G90`";
      refuses(f, "can't initialize interpreter");
      return;
    }
    for (int number = 100; number <= 199; ++number) {
      if (!has('M', number)) continue;
      Finding& f = add(line, line.value,
                       start + "uses `M" + std::to_string(number) +
                           "`, which LinuxCNC does not know yet at that time: it does not start");
      f.help = "run it by a program or a button";
      refuses(f, "Unknown m code used: M" + std::to_string(number));
      return;
    }
    if (code.starts_with('%')) {
      Finding& f = add(line, line.value, "LinuxCNC does not start with this start-up code: `%` belongs into files");
      f.help = "remove the `%`";
      refuses(f, "Bad character '%' used");
      return;
    }
    for (const Finding& found : findings_in(code)) {
      Finding& f =
          add(line, inside(line, 0, found.span), "LinuxCNC does not start with this start-up code: " + found.message);
      f.help = code.find('#') == std::string::npos
          ? found.help
          : "put the comment onto a line of its own; only `;` and `( )` are comments here";
      refuses(f, found.interpreter);
      return;
    }
  }

  void hang(const IniLine& line, std::string message) {
    Finding& f = add(line, line.value, std::move(message));
    f.help = "let the line set modes only, such as `G21 G90`";
    f.never_ends = true;
    f.reach = Reach::kAlways;
  }

  /// A place in the code as a place in the INI.
  static Span inside(const IniLine& line, uint64_t from, Span span) {
    const uint64_t begin = line.value.begin + from;
    return {std::min(begin + span.begin, line.value.end), std::min(begin + span.end, line.value.end)};
  }

  /// LinuxCNC appends the reason to the text.
  void check_abort(const IniLine& line) {
    const std::string code(text_.value(line));
    const std::vector<Finding> found = findings_in(code + " [1]");
    const bool calls = small_letters(bare(code)).ends_with("call") || small_letters(bare(code)).ends_with(']');
    if (found.empty() && calls && code.find(';') == std::string::npos) return;
    Finding& f =
        add(line, line.value,
            "LinuxCNC runs this with the reason behind it, `" + code + " [1]`, and that stops with an error each time");
    f.help = "call a sub, as `O<on_abort> call`, with nothing behind it";
    if (!found.empty()) f.interpreter = found[0].interpreter;
  }

  void check_command(const IniLine& line, Span span, const char* who) {
    const std::string code(text_.slice(line, span));
    for (const Finding& found : findings_in(code)) {
      const bool reading =
          found.code.starts_with("OW3") || std::ranges::find(kOfReading, found.code) != kOfReading.end();
      if (!reading) continue;
      Finding& f = add(line, inside(line, span.begin - line.value.begin, found.span),
                       std::string(who) + ", and it stops each time: " + found.message);
      f.help = found.help;
      f.interpreter = found.interpreter;
      return;
    }
  }

  /// `G0 X0;G0 Y0,Zero`: lines, and a label.
  void check_parts(const IniLine& line) {
    const std::string_view value = text_.value(line);
    const std::string_view code = value.substr(0, value.find(','));
    for (size_t at = 0; at < code.size();) {
      const size_t end = std::min(code.find(';', at), code.size());
      if (code.find_first_not_of(" \t", at) < end)
        check_command(line, {line.value.begin + at, line.value.begin + end}, "a button runs it as an MDI command");
      at = end + 1;
    }
  }

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
};

void check_setup(const SetupInput& in, Reporter& out) { Checker(in, out).run(); }

}  // namespace

extern const Rule kRule{
    .code = "OW419",
    .name = "command-in-ini",
    .summary = "a line of G-code in the INI that stops, hangs or crashes LinuxCNC",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A mistake in the lines that LinuxCNC runs from the INI: `RS274NGC_STARTUP_CODE`, `ON_ABORT_COMMAND`,
`MDI_COMMAND` of `[HALUI]` and of `[MDI_COMMAND_LIST]`.)",
            .why =
                R"(The start-up code runs before LinuxCNC is up: any error in it ends the start, and so do `M2` and `M30`.
With `M6`, `M61`, `M66` or a probe it waits for ever. The other lines run as MDI commands when their time
comes, and stop with a message each time. `#` begins no comment there. To `ON_ABORT_COMMAND` LinuxCNC
appends the reason, as ` [1]`, so that only a call can be there.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
ON_ABORT_COMMAND = M5
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
ON_ABORT_COMMAND = O<on_abort> call
; file: on_abort.ngc
o<on_abort> sub
  M5
o<on_abort> endsub
)",
            .fix = R"(Correct the line. What needs more than one line goes into a sub that it calls.)",
            .level_reason = "Error for start-up code with which LinuxCNC does not start, hangs or crashes; warning for "
                            "lines that stop when they run.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow419
