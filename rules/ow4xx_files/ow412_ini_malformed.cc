// OW412 ini-malformed: a line of the INI that LinuxCNC does not read as it looks.
// Depends on: what LinuxCNC takes for a section, a key, a continuation and a line (measured with `inivar` and with the check
// before the start).
#include <algorithm>
#include <map>

#include "analyzer/machine/ini_keys.h"
#include "rules/driver/ini_form.h"
#include "rules/driver/machine_rules.h"
#include "rules/driver/start_refusals.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow412 {
namespace {

using Kind = IniLine::Kind;

constexpr size_t kManyLines = 10'000;  // no machine has so many: then not all is said
constexpr size_t kMostFindings = 200;  // likewise

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string code(std::string_view text) { return as_code(text); }

class Checker {
 public:
  Checker(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text), strict_(reads_strictly(in)) {
    for (const BlamedRefusal& blamed : start_refusals(in)) {
      const IniLine* cause = blamed.misspelt ? nullptr : blamed.cause;
      if (blamed.refusal.kind == StartRefusal::Kind::kBeforeSection && cause == nullptr) cause = blamed.refusal.line;
      if (cause != nullptr) refused_.try_emplace(cause, blamed.refusal.message);
    }
  }

  void run() {
    if (check_hidden_ini(in_, out_)) return;
    check_marks();
    for (size_t i = 0; i < text_.lines().size() && found_ < kMostFindings; ++i) check(i);
    check_end();
  }

 private:
  Finding& add(const IniLine& line, Span span, std::string message) {
    ++found_;
    return add_at(in_, out_, line, span, std::move(message));
  }

  /// Whether the start is refused because of the line; then says so.
  bool refuse(const IniLine& line, Finding& finding) const {
    const auto refused = refused_.find(&line);
    if (refused == refused_.end()) return false;
    refuses(finding, refused->second);
    return true;
  }

  /// Of the bytes, before any line is one.
  void check_marks() {
    for (const auto& source : text_.sources()) {
      const std::string_view bytes = source->bytes();
      const IniLine* first = text_.lines().empty() ? nullptr : &text_.lines()[0];
      if (bytes.starts_with(kByteOrderMark) && first != nullptr && text_.source(*first) == source) {
        const std::string_view line = text_.text(*first);
        const bool section = line.substr(kByteOrderMark.size()).starts_with('[');
        if (section || refused_.contains(first)) {
          Finding& f = add(
              *first, {0, kByteOrderMark.size()},
              section
                  ? "the file begins with a byte order mark, so LinuxCNC does not find the section in "
                    "its first line"
                  : "the file begins with a byte order mark, so LinuxCNC does not take its first line for a comment");
          f.help = "remove the mark: save the file as UTF-8 without BOM";
          f.fixes.push_back({"remove the byte order mark", true, {{{0, kByteOrderMark.size()}, ""}}});
          if (!refuse(*first, f) && line.substr(kByteOrderMark.size()).starts_with("[EMC]") && !strict_)
            refuses(f,
                    "INI file [EMC]VERSION indicates update is needed, but the update GUI can't run without an X "
                    "display");
          marked_ = first;
        }
      }
      check_bytes(in_, out_, source);
    }
  }

  void check(size_t index) {
    const IniLine& line = text_.lines()[index];
    if (&line == marked_) return;
    check_continuation(index);
    if (line.continuation) return;
    switch (line.kind) {
      case Kind::kComment: check_comment(line); break;
      case Kind::kOpenSection: check_open_section(line); break;
      case Kind::kSection: check_section(line); break;
      case Kind::kKey: check_key(line); break;
      case Kind::kText: check_text(line); break;
    }
  }

  void check_comment(const IniLine& line) {
    const std::string_view text = text_.text(line);
    if (refused_.contains(&line)) {
      Finding& f =
          add(line, line.span,
              "LinuxCNC's check before the start reads this comment as a key: it begins with `;`, has a `=`, and "
              "comes before the first section");
      f.help = "begin the comment with `#`";
      f.fixes.push_back({"write `#`", true, {{{line.span.begin, line.span.begin + 1}, "#"}}});
      refuse(line, f);
    }
    const std::string_view name = ini_include(text);
    if (name.empty() && !strict_) return check_near_include(in_, out_, line);
    if (name.empty() || strict_) return;
    const bool indented = text_.source(line)->position(line.span.begin).column > 1;
    if (line.source == 0 && !indented) return check_include(in_, out_, line);
    Finding& f =
        add(line, line.span,
            line.source == 0 ? "a space before `#INCLUDE`: LinuxCNC takes the line for a comment"
                             : "`#INCLUDE` in a file that is itself included: LinuxCNC takes the line for a comment");
    f.help = line.source == 0 ? "begin the line with `#INCLUDE`" : "include the file in the machine's INI";
  }

  void check_open_section(const IniLine& line) {
    if (strict_) return;
    open_ = true;
    const std::string_view name = text_.name(line);
    Finding& f = add(line, line.span,
                     "`]` is missing after " + code(text_.text(line)) +
                         ": LinuxCNC ends the section above here, and does not find the keys below");
    f.help = "write `[" + std::string(name.substr(0, name.find_first_of(" \t#;"))) + "]`";
    refuse(line, f);
  }

  void check_section(const IniLine& line) {
    if (strict_) return;
    const std::string_view name = text_.name(line);
    const std::string_view behind = text_.value(line);
    const bool comment = behind.starts_with('#') || behind.starts_with(';');
    if (name.empty() || name.front() == ' ' || name.back() == ' ' || name.front() == '\t' || name.back() == '\t') {
      Finding& f = add(line, line.name, "spaces inside the brackets: LinuxCNC finds no section " + code(name));
      const size_t first = std::min(name.find_first_not_of(" \t"), name.size());
      const std::string plain(name.substr(first, name.find_last_not_of(" \t") + 1 - first));
      f.help = "write `[" + plain + "]`";
      f.fixes.push_back({"remove the spaces", false, {{line.name, plain}}});
      refuse(line, f);
    } else if (!behind.empty() &&
               (refused_.contains(&line) || (!comment && behind.find('=') != std::string_view::npos))) {
      const bool refused = refused_.contains(&line);
      Finding& f = add(line, line.value,
                       refused ? "text after `[" + std::string(name) +
                               "]`: LinuxCNC's check before the start does not take the line for a section"
                               : "text after `[" + std::string(name) + "]`: LinuxCNC ignores the rest of the line");
      f.help = comment ? "put the comment on a line of its own" : "put it on a line of its own";
      f.fixes.push_back(own_line(line, comment));
      refuse(line, f);
    } else if (!behind.empty()) {
      Finding& f = add(line, line.value,
                       "text after `[" + std::string(name) +
                           "]`: LinuxCNC reads the section, but its check before the start does not");
      f.help = "put it on a line of its own";
      f.fixes.push_back(own_line(line, comment));
      f.weight = Weight::kRemark;
    }
  }

  /// Puts what follows `]` above the line, if it is a comment, else below.
  Fix own_line(const IniLine& line, bool comment) const {
    const Source& source = *text_.source(line);
    const std::string end = source.slice(source.line(line.number)).ends_with('\r') ? "\r\n" : "\n";
    const uint64_t close = line.name.end + 1;
    const std::string behind(text_.value(line));
    if (!comment) return {"put it on a line of its own", false, {{{close, line.value.end}, end + behind}}};
    const std::string section(source.slice({line.span.begin, close}));
    return {
        "put the comment on a line of its own", true, {{{line.span.begin, line.value.end}, behind + end + section}}};
  }

  void check_key(const IniLine& line) {
    const std::string_view value = text_.value(line);
    if (line.section < 0 && !strict_) {
      if (open_) return;  // the section was meant to be open
      Finding& f = add(line, line.span, "a key before the first section: LinuxCNC does not find it");
      f.help = "move it below the `[SECTION]` that it belongs to, or make it a comment with `#`";
      if (refuse(line, f)) f.message += ", and its check before the start fails";
      return;
    }
    const Source& source = *text_.source(line);
    const Span whole = source.line(line.number);
    if (!strict_ && whole.end - whole.begin > kLongestIniLine && line.value.end > whole.begin + kLongestIniLine) {
      const uint64_t cut = whole.begin + kLongestIniLine;
      Finding& f = add(line, {cut, line.value.end},
                       "the line is longer than 255 bytes: LinuxCNC cuts it here, and reads the rest as another line");
      f.help = "shorten it, or split it into two lines with `\\` at the end of the first";
    }
    if (value.ends_with('\\') && !line.continued) {
      const bool carriage = source.slice(whole).ends_with('\r');
      Finding& f = add(line, {line.value.end - 1, whole.end},
                       carriage ? "a carriage return after `\\`: LinuxCNC does not join the next line"
                                : "a space after `\\`: LinuxCNC does not join the next line");
      f.help = "make `\\` the last character of the line";
    }
  }

  /// Whether the key is there once more: LinuxCNC stops looking at a key with a blank behind it.
  bool hides_another(const IniLine& line) const {
    if (line.name.end == line.span.end || text_.lines().size() > kManyLines) return false;
    return std::ranges::any_of(lines_of(text_, text_.section_of(line)), [&](const IniLine* other) {
      return other > &line && other->kind == Kind::kKey && text_.name(*other) == text_.name(line);
    });
  }

  /// `KINS]`
  void check_unopened_section(const IniLine& line) {
    const std::string_view text = text_.text(line);
    const std::string above(text_.section_of(line));
    open_ = true;
    Finding& f = add(line, line.span,
                     "`[` is missing before " + code(text) + ": LinuxCNC takes the keys below for keys of " +
                         (above.empty() ? "no section" : "`[" + above + "]`"));
    f.help = "write `[" + std::string(text) + "`";
    f.fixes.push_back({f.help, false, {{{line.span.begin, line.span.begin}, "["}}});
    refuse(line, f);
  }

  void check_text(const IniLine& line) {
    if (!strict_ && is_unopened_section(text_, line)) return check_unopened_section(line);
    if (strict_ || line.section < 0) return;
    Finding& f = add(line, line.span,
                     "LinuxCNC ignores " + code(text_.text(line)) + ": a line without `=` sets nothing" +
                         (hides_another(line) ? ", and hides the same key below" : ""));
    f.help = "write `KEY = value`, or begin the line with `#` if it is a comment";
    if (!is_known_section(text_.section_of(line))) f.weight = Weight::kRemark;
    refuse(line, f);
  }

  /// What a `\` at the end of a line makes of the next one.
  void check_continuation(size_t index) {
    const std::vector<IniLine>& lines = text_.lines();
    const IniLine& line = lines[index];
    if (!line.continued) continued_ = 0;
    if (!line.continued || strict_) return;
    if (++continued_ == kMostContinued + 1) {
      Finding& f = add(line, {line.span.end - 1, line.span.end},
                       "more than 20 lines are joined with `\\`: LinuxCNC gives up, and finds no key from here on");
      f.help = "make the value shorter";
      f.interpreter = "Too many backslash line extends (limit=20)";
    }
    if (index + 1 == lines.size()) {
      Finding& f = add(line, {line.span.end - 1, line.span.end},
                       "`\\` at the end of the last line: LinuxCNC looks for another line, and ignores this one");
      f.help = "remove the `\\`";
      return;
    }
    const IniLine& next = lines[index + 1];
    const bool lost = next.kind == Kind::kSection ||
        (next.kind == Kind::kKey &&
         (line.kind == Kind::kComment || find_ini_key(text_.section_of(next), text_.name(next)) != nullptr));
    if (!next.continuation || !lost) return;
    Finding& f =
        add(line, {line.span.end - 1, line.span.end},
            std::string(line.kind == Kind::kComment ? "`\\` at the end of a comment" : "`\\` at the end of the line") +
                ": LinuxCNC reads the next line, " + code(text_.text(next)) + ", as a part of this one");
    f.help = "remove the `\\`";
    f.related.push_back({next.span, "this line has no effect", nullptr});
    if (next.source != line.source) f.related.clear();
    refuse(line, f);
    f.fixes.push_back({"remove the `\\`", false, {{{line.span.end - 1, line.span.end}, ""}}});
  }

  void check_end() {
    const std::vector<IniLine>& lines = text_.lines();
    if (lines.empty()) return;
    const IniLine& last = lines.back();
    if (text_.cut_short()) {
      Finding& f = add(last, last.span, "owlint checks only the first 100000 lines of an INI");
      f.help = "check whether this is the INI of a machine, and whether it includes itself";
    }
    if (!strict_ && text_.sources().size() > 1 && last.source == 0 && !last.ended && last.kind == Kind::kKey) {
      Finding& f = add(last, last.span,
                       "the last line has no line end: in a file with `#INCLUDE`, LinuxCNC's start script drops it");
      f.help = "press Enter at the end of the line";
      f.fixes.push_back({"end the line", false, {{{last.span.end, last.span.end}, "\n"}}});
    }
  }

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
  bool strict_;
  std::map<const IniLine*, std::string> refused_;  // what LinuxCNC prints, by the line that is the cause
  const IniLine* marked_ = nullptr;                // the line with the byte order mark, if it was reported
  size_t continued_ = 0;
  size_t found_ = 0;
  bool open_ = false;  // a section above has no `]`
};

void check_setup(const SetupInput& in, Reporter& out) { Checker(in, out).run(); }

}  // namespace

extern const Rule kRule{
    .code = "OW412",
    .name = "ini-malformed",
    .summary = "a line of the INI that LinuxCNC reads as something else",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A line of the machine's INI that LinuxCNC reads differently from people: `[NAME` without `]`, spaces
inside the brackets, text after `]`, a line without `=`, a key before the first section, a line
longer than 255 bytes, a `\` that joins the next key or section to the line, a carriage return
inside a line or two of them at its end, a byte order mark, UTF-16, an `#INCLUDE` that LinuxCNC takes for
a comment, whose file is not there, or that would run a command.)",
            .why = R"(LinuxCNC gives no message about a line that it does not understand: it does not find the key, and
uses its default. LinuxCNC's check before the start reads the file differently. That check does not
see the section `[KINS] # my machine`, and it fails at a line with `=` before the first section:
`can't read "section": no such variable`.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[TRAJ]
COORDINATES = XYZ
[RS274NGC
RETAIN_G43 = 1
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[TRAJ]
COORDINATES = XYZ
[RS274NGC]
RETAIN_G43 = 1
)",
            .fix = R"(Write each section, key and comment on a line of its own: `[NAME]`, `KEY = value`, `# comment`.)",
            .level_reason =
                "Warning: LinuxCNC starts, without what the line was meant to set. Error if LinuxCNC does not start.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow412
