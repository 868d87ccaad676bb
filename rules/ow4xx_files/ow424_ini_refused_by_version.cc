// OW424 ini-refused-by-version: what another LinuxCNC version refuses in this INI.
// Depends on: the INI reader of 2.10, and the version that an INI of 2.8 and 2.9 has (measured).
#include "analyzer/machine/ini_hidden.h"
#include "analyzer/machine/strict_ini.h"
#include "rules/driver/machine_rules.h"

namespace owlint::rules::ow424 {
namespace {

using Kind = StrictRefusal::Kind;

std::string code(std::string_view text) {
  constexpr size_t kShown = 40;
  return "`" + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "…`" : "`");
}

/// Those that 2.8 and 2.9 do not read as they look either: OW412 reports them for these versions, and a note the includes.
bool said_before(Kind kind) {
  return kind == Kind::kNoEquals || kind == Kind::kOpenSection || kind == Kind::kBeforeSection ||
      kind == Kind::kOpenEnd || kind == Kind::kNoInclude;
}

void word(const StrictRefusal& refusal, std::string_view text, Finding& f) {
  switch (refusal.kind) {
    case Kind::kNoEquals:
      f.message = code(text) + " has no `=`";
      f.help = "write `KEY = value`, or begin the line with `#` if it is a comment";
      break;
    case Kind::kBadKey:
      f.message = code(text) + " is not a valid key name";
      f.help = text.starts_with("//") ? "begin a comment with `#`: `//` begins none"
                                      : "use letters, digits and `_`, and begin with a letter";
      break;
    case Kind::kBadSection:
      f.message = code(text) + " is not a valid section name";
      f.help = "use letters, digits and `_`, and begin with a letter";
      break;
    case Kind::kOpenSection:
      f.message = "`]` is missing after " + code(text);
      f.help = "write `]` after the name";
      break;
    case Kind::kBeforeSection:
      f.message = "a line before the first section";
      f.help = "move it below the `[SECTION]` that it belongs to";
      break;
    case Kind::kNotUtf8:
      f.message = "a character that is not UTF-8";
      f.help = "save the file as UTF-8";
      break;
    case Kind::kBadEscape:
      f.message = code(text) + " is not followed by hexadecimal digits";
      f.help = "write `\\\\` to get one `\\`";
      break;
    case Kind::kOpenEnd:
      f.message = "`\\` at the end of the file";
      f.help = "remove it";
      break;
    case Kind::kNoInclude:
      f.message = "the file of " + code(text) + " cannot be read";
      f.help = "correct the name, or remove the line";
      break;
  }
  f.message += ": LinuxCNC 2.10 refuses the whole INI";
}

void check_strict(const SetupInput& in, Reporter& out) {
  const bool strict = reads_strictly(in);
  std::vector<StrictRefusal> refusals = strict_refusals(in.setup.text);
  if (!strict) std::erase_if(refusals, [](const StrictRefusal& r) { return said_before(r.kind); });
  const size_t count = refusals.size();
  if (!strict && count > 1) refusals.resize(1);
  for (const StrictRefusal& refusal : refusals) {
    Finding& f = add_at(in, out, *refusal.line, refusal.span, "");
    word(refusal, in.setup.text.slice(*refusal.line, refusal.span), f);
    if (strict) {
      refuses(f, refusal.message);
    } else {
      if (count > 1)
        f.message += ", for this and " + std::to_string(count - 1) + (count > 2 ? " more lines" : " more line");
      f.weight = in.profile.version_given ? Weight::kRemark : Weight::kAside;
    }
  }
}

/// An INI of 2.7 or older: later versions convert it before they start.
void check_age(const SetupInput& in, Reporter& out) {
  if (in.profile.version < Version::k2_8 || reads_strictly(in)) return;
  const IniText& text = in.setup.text;
  const Ini::Entry* version = in.setup.ini.find("EMC", "VERSION");
  const bool machine = in.setup.ini.has_section("EMC") && in.setup.ini.has_section("TRAJ");
  if (!machine || (version != nullptr && version_meant(version->value) == "1.1")) return;
  const std::vector<const IniLine*> lines = lines_of(text, "EMC");
  const IniLine* line = find_line(text, "EMC", "VERSION");
  if (line == nullptr) {
    for (const IniText::Section& section : text.sections()) {
      if (section.first && section.name == "EMC") line = &text.lines()[section.line];
    }
  }
  if (line == nullptr) return;
  Finding& f =
      add_at(in, out, *line,
             version == nullptr
                 ? "`[EMC]` has no `VERSION`: LinuxCNC 2.8 and 2.9 convert this INI before they start"
                 : "`VERSION = " + version->value + "`: LinuxCNC 2.8 and 2.9 convert this INI before they start");
  f.group = "INI of 2.7";  // a folder of old configurations has many
  f.help = "let LinuxCNC convert it, or run `update_ini` on a copy; if the machine has 2.7, leave it as it is";
  f.interpreter = "INI file [EMC]VERSION indicates update is needed, but the update GUI can't run without an X display";
  if (!in.profile.version_given) f.weight = Weight::kAside;
}

void check_setup(const SetupInput& in, Reporter& out) {
  if (how_hidden(in.setup.ini.source()->bytes()) != IniHidden::kNone) return;  // OW412
  check_strict(in, out);
  check_age(in, out);
}

}  // namespace

extern const Rule kRule{
    .code = "OW424",
    .name = "ini-refused-by-version",
    .summary = "a line or an INI that another LinuxCNC version refuses",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A line that LinuxCNC 2.10 cannot read: a line without `=`, a key or section name with characters other than
letters, digits and `_`, a `\U` in a value such as `C:\User`, text that is not UTF-8. Also an INI for 2.7 or
older, which later versions convert before they start.)",
            .why =
                R"(LinuxCNC 2.10 reads the whole INI when it starts, and refuses all of it because of one bad line. 2.8 and
2.9 ignore such lines. But they start only if the INI has `VERSION = 1.1` in `[EMC]`. Otherwise they offer to
convert it, or give up if there is no screen.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
RETAIN_G43 = 1
[MY-PANEL]
COLOUR = red
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
RETAIN_G43 = 1
[MY_PANEL]
COLOUR = red
)",
            .fix =
                R"(Correct the line before you update to 2.10. `--linuxcnc all` reports what any of the versions refuses.)",
            .level_reason = "Error with `--linuxcnc 2.10`. Info if no version is given.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow424
