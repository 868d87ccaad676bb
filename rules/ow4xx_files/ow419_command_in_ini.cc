// OW419 command-in-ini: a line of G-code in the INI that stops, hangs or crashes LinuxCNC.
// Depends on: which lines LinuxCNC and its displays run, and how (measured with LinuxCNC without a screen; displays: read).
#include <algorithm>
#include <cctype>

#include "rules/driver/ini_commands.h"
#include "rules/driver/ini_pages.h"
#include "rules/driver/machine_rules.h"

namespace owlint::rules::ow419 {
namespace {

constexpr size_t kMostCommands = 200;  // a machine has a few

class Checker {
 public:
  Checker(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text), runs_(in) {}

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
      if (line->continued) continue;
      check_command(*line, line->value, "halui runs it as an MDI command");
      check_rest(*line);
    }
    for (const IniLine* line : lines_of(text_, "MDI_COMMAND_LIST")) {
      if (line->kind == IniLine::Kind::kKey && text_.name(*line).starts_with("MDI_COMMAND") && !line->continued &&
          ++count <= kMostCommands)
        check_parts(*line);
    }
    for (const std::string_view section : {"MACROS", "TOUCHY", "DISPLAY"}) check_macros(section);
    check_ngcgui_pages(in_, out_);
  }

 private:
  /// `MACRO = name word word`: a button of gmoccapy, touchy or QtVCP that calls a sub.
  void check_macros(std::string_view section) {
    size_t count = 0;
    for (const IniLine* line : lines_of(text_, section)) {
      if (text_.name(*line) != "MACRO") continue;
      if (line->value.begin == line->value.end || ++count > kMostCommands) return;
      if (!line->continued) check_macro(section, *line);
    }
  }

  void check_macro(std::string_view section, const IniLine& line) {
    const std::string_view value = text_.value(line);
    const std::string name(value.substr(0, value.find_first_of(" \t")));
    const Span span{line.value.begin, line.value.begin + name.size()};
    const std::string called = small_letters(name);
    const auto found = in_.setup.search_path->find(called);
    const std::string listed = file_in(in_, "SUBROUTINE_PATH", name + ".ngc");
    const bool has_path = in_.setup.ini.find("RS274NGC", "SUBROUTINE_PATH") != nullptr;
    if (!has_all_folders(in_, "SUBROUTINE_PATH") || !has_all_folders(in_, "PROGRAM_PREFIX") ||
        in_.profile.may_be_python())
      return;
    if (section == "MACROS" && has_path && listed.empty()) {
      Finding& f =
          add(line, span,
              "gmoccapy leaves this macro out: there is no file `" + name + ".ngc` in a folder of `SUBROUTINE_PATH`");
      f.help = found
          ? "the file is " + found->path + ": write its name as it is, and let `SUBROUTINE_PATH` name its folder"
          : "put the file there, or correct the name";
      f.interpreter = "File " + name + ".ngc of the macro ['" + std::string(value) + "'] could not be found";
      return;
    }
    if (!found) {
      Finding& f = add(line, span,
                       "the macro calls `" + label_text(called) + "`, but there is no file `" + called +
                           ".ngc` on the machine's search path");
      f.help = listed.empty() ? "put the file into a folder of `SUBROUTINE_PATH`, or correct the name"
                              : "LinuxCNC looks for names in small letters: rename " + listed;
      f.interpreter = "File not open";
      return;
    }
    const std::shared_ptr<const Program> program = in_.library.load_called(found->path, in_.profile);
    if (program->find_sub(called) != kNoRegion) return check_macro_run(line, called, span);
    Finding& f =
        add(line, span, "the macro calls `" + label_text(called) + "`, but " + found->path + " has no such sub");
    f.help = "name the sub in the file like the file";
    f.interpreter = "EOF in file:" + found->path + " seeking o-word: o<" + called + "> from line: 0";
  }

  /// The sub is there: does it stop each time, and does it get what it reads?
  void check_macro_run(const IniLine& line, const std::string& sub, Span span) {
    const std::string_view value = text_.value(line);
    size_t values = 0;
    for (size_t at = value.find_first_of(" \t"); at < value.size(); at = value.find_first_of(" \t", at)) {
      at = value.find_first_not_of(" \t", at);
      ++values;
    }
    std::string call = "o<" + sub + "> call";
    for (size_t i = 0; i < values; ++i) call += " [#4998]";
    const auto stops = runs_.stops(call, RunsAt::kAny);
    if (!stops.empty()) {
      Finding& f = add(line, span, "the macro stops each time: " + words_of(stops[0]));
      f.help = stops[0].help;
      f.interpreter = stops[0].interpreter;
      f.related = stops[0].related;
      return;
    }
    for (const Finding& found : runs_.unpassed(sub, values)) {
      const size_t passes = found.message.find(" passes ");
      if (passes == std::string::npos) continue;
      Finding& f = add(line, line.value, "the macro" + found.message.substr(passes));
      f.help = "write a word for each behind the macro's name: the operator is asked for their values";
      f.related = found.related;
    }
  }

  Finding& add(const IniLine& line, Span span, std::string message) {
    return add_at(in_, out_, line, span, std::move(message));
  }

  void check_start(const IniLine& line) {
    const std::string code(text_.value(line));
    if (is_quoted(code)) {
      refuses(add_quotes(line, line.value, "LinuxCNC does not start with this start-up code"),
              std::string("Bad character '") + code[0] + "' used");
      return;
    }
    if (check_start_codes(line, bare_code(code), nullptr)) return;
    if (code.starts_with('%')) {
      Finding& f = add(line, line.value, "LinuxCNC does not start with this start-up code: `%` belongs into files");
      f.help = "remove the `%`";
      refuses(f, "Bad character '%' used");
      return;
    }
    for (const CommandStop& found : runs_.stops(code, RunsAt::kStart)) {
      Finding& f =
          add(line, inside(line, 0, found.span), "LinuxCNC does not start with this start-up code: " + words_of(found));
      f.help = code.find('#') == std::string::npos || found.in_sub
          ? found.help
          : "put the comment onto a line of its own; only `;` and `( )` are comments here";
      f.related = found.related;
      refuses(f, found.interpreter);
      return;
    }
    for (const CommandRuns::SubLine& in_sub : runs_.lines_in_subs(code)) {
      if (check_start_codes(line, in_sub.code, &in_sub.place)) return;
    }
  }

  static bool is_quoted(std::string_view code) {
    return code.size() > 2 && (code[0] == '"' || code[0] == '\'') && code.back() == code[0];
  }

  /// The value is taken as it is.
  Finding& add_quotes(const IniLine& line, Span span, const std::string& what) {
    const std::string_view code = text_.slice(line, span);
    Finding& f = add(line, span, what + ": the quotes are a part of it");
    f.help = "remove the quotes";
    const std::string plain(code.substr(1, code.size() - 2));
    f.fixes.push_back({"remove the quotes", false, {{span, plain}}});
    return f;
  }

  static std::string words_of(const CommandStop& stop) {
    return (stop.in_sub ? "a sub that it calls stops: " : "") + stop.message;
  }

  /// Codes that the start-up code, or a line of its subs, may not have. True if there is one.
  bool check_start_codes(const IniLine& line, std::string_view words, const Related* in_sub) {
    const auto has = [&](char letter, int number) { return has_code(words, letter, number); };
    const std::string start = in_sub != nullptr ? "a sub of the start-up code " : "the start-up code ";
    const auto found = [&](const std::string& what) -> Finding& {
      Finding& f = add(line, line.value, start + what);
      if (in_sub != nullptr) f.related.push_back(*in_sub);
      return f;
    };
    for (const int number : {6, 61, 66}) {
      if (!has('M', number)) continue;
      hang(found("changes the tool or waits for an input, `M" + std::to_string(number) +
                 "`: LinuxCNC waits for ever before it starts"));
      return true;
    }
    if (has('G', 38)) {
      hang(found("probes: LinuxCNC waits for ever before it starts"));
      return true;
    }
    if (has('M', 99) && in_sub == nullptr) {
      hang(found("has `M99`: LinuxCNC crashes when it starts"));
      return true;
    }
    for (const int number : {2, 30, 98}) {
      if (!has('M', number)) continue;
      Finding& f = found("has `M" + std::to_string(number) + "`: LinuxCNC does not start");
      f.help = "remove `M" + std::to_string(number) + "`: the line sets modes, such as `G21 G90`";
      refuses(f, "can't initialize interpreter");
      return true;
    }
    for (int number = 100; number <= 199; ++number) {
      if (!has('M', number)) continue;
      Finding& f = found("uses `M" + std::to_string(number) +
                         "`, which LinuxCNC does not know yet at that time: it does not start");
      f.help = "run it by a program or a button";
      refuses(f, "Unknown m code used: M" + std::to_string(number));
      return true;
    }
    return false;
  }

  static void hang(Finding& f) {
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
    if (is_quoted(code)) {
      add_quotes(line, line.value, "LinuxCNC runs this at each abort, and it stops each time");
      return;
    }
    const std::vector<CommandStop> found = runs_.stops(code + " [1]", RunsAt::kAny);
    const bool calls =
        small_letters(bare_code(code)).ends_with("call") || small_letters(bare_code(code)).ends_with(']');
    if (found.empty() && calls && code.find(';') == std::string::npos) return;
    Finding& f =
        add(line, line.value,
            "LinuxCNC runs this with the reason behind it, `" + code + " [1]`, and that stops with an error each time");
    f.help = "call a sub, as `O<on_abort> call`, with nothing behind it";
    if (found.empty()) return;
    f.interpreter = found[0].interpreter;
    f.related = found[0].related;
    if (!found[0].in_sub) return;
    f.message += "; " + words_of(found[0]);
    f.help = found[0].help;
  }

  void check_command(const IniLine& line, Span span, const char* who, bool missing_subs = false) {
    const std::string code(text_.slice(line, span));
    if (is_quoted(code)) {
      add_quotes(line, span, std::string(who) + ", and it stops each time");
      return;
    }
    std::vector<CommandStop> stops = runs_.stops(code, RunsAt::kAny, missing_subs);
    if (stops.empty()) stops = runs_.beyond_limits(code);
    for (const CommandStop& found : stops) {
      if (depends_on_others(found)) continue;
      Finding& f = add(line, inside(line, span.begin - line.value.begin, found.span),
                       std::string(who) + ", and it stops each time: " + words_of(found));
      f.help = found.help;
      f.interpreter = found.interpreter;
      f.related = found.related;
      return;
    }
  }

  /// Measured: halui runs the value as one line, in which `;` begins a comment.
  void check_rest(const IniLine& line) {
    const std::string_view value = text_.value(line);
    const size_t at = value.find(';');
    if (at == std::string_view::npos || at == 0 || value.substr(0, at).find('(') != std::string_view::npos) return;
    const std::string_view rest = value.substr(at + 1);
    if (!is_code(bare_code(rest))) return;
    const size_t last = value.find_last_not_of(" \t", at - 1);
    if (last == std::string_view::npos) return;
    Finding& f = add(line, {line.value.begin + at, line.value.end},
                     "`;` begins a comment: halui runs `" + std::string(value.substr(0, last + 1)) + "` only");
    f.help = "put the lines into a sub, and call it";
  }

  /// Whether a text without blanks is words of G-code and nothing else: a G or M code, then more.
  static bool is_code(std::string_view words) {
    if (words.starts_with("O<")) return words.find(">CALL") != std::string_view::npos;
    if (words.empty() || (words[0] != 'G' && words[0] != 'M')) return false;
    for (size_t at = 0; at < words.size();) {
      if (std::isalpha(static_cast<unsigned char>(words[at])) == 0) return false;
      const size_t end = std::min(words.find_first_not_of("+-.0123456789", at + 1), words.size());
      if (end == at + 1) return false;
      at = end;
    }
    return true;
  }

  /// Whether another line that operators run may have saved the modes that M72 restores, or set the name that is read.
  bool depends_on_others(const CommandStop& found) {
    if (found.in_sub) return false;
    if (found.code == "OW807")
      return others().find("M70") != std::string::npos || others().find("M73") != std::string::npos;
    if (found.code != "OW603") return false;
    // Named parameter #<foo> not defined
    const size_t from = found.interpreter.find('#'), to = found.interpreter.find('>');
    if (from >= to || to == std::string::npos) return false;
    const std::string name = bare_code(found.interpreter.substr(from, to + 1 - from));
    return others().find(name + "=") != std::string::npos;
  }

  /// All that operators run, without comments.
  const std::string& others() {
    if (!others_.empty()) return others_;
    for (const IniLine* line : lines_of(text_, "HALUI")) others_ += bare_code(text_.value(*line)) + "\n";
    for (const IniLine* line : lines_of(text_, "MDI_COMMAND_LIST"))
      for (const char c : text_.value(*line)) others_ += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return others_;
  }

  /// `G0 X0;G0 Y0,Zero`: lines, and a label.
  void check_parts(const IniLine& line) {
    const std::string_view value = text_.value(line);
    const std::string_view code = value.substr(0, value.find(','));
    for (size_t at = 0; at < code.size();) {
      const size_t end = std::min(code.find(';', at), code.size());
      if (code.find_first_not_of(" \t", at) < end)
        check_command(line, {line.value.begin + at, line.value.begin + end}, "a button runs it as an MDI command",
                      has_all_folders(in_, "SUBROUTINE_PATH") && has_all_folders(in_, "PROGRAM_PREFIX"));
      at = end + 1;
    }
  }

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
  const CommandRuns runs_;
  std::string others_;  // all that operators run, without comments
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
`MDI_COMMAND` of `[HALUI]` and of `[MDI_COMMAND_LIST]`. A `MACRO` of gmoccapy, touchy or QtVCP whose sub is
not found, or reads more than the macro asks for; a file of `NGCGUI_SUBFILE` that ngcgui refuses. Subs
that such a line calls are looked at, too.)",
            .why = R"(The start-up code runs before LinuxCNC is up: any error in it ends the start, and so do `M2` and
`M30`. With `M6`, `M61`, `M66` or a probe it waits for ever. The other lines run as MDI commands
when their time comes, and stop with a message each time. `#` begins no comment there. LinuxCNC
appends the reason to `ON_ABORT_COMMAND`, such as ` [1]`, so only a call works there.

The first word of a `MACRO` is the name of a sub. gmoccapy looks for the file as it is written,
LinuxCNC in small letters. ngcgui reads a file in its own way: the file must have one sub, named
like the file. Only comments may stand before it, and only comments and `M2` after it.)",
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
