// OW416 remap-malformed: a REMAP line with which the interpreter does not start.
// Depends on: the interpreter reads all REMAP lines when it starts, and refuses to start for one bad one (measured).
#include "rules/driver/remap_rules.h"

namespace owlint::rules::ow416 {
namespace {

using Problem = RemapLine::Problem;

std::string quoted(std::string_view text) { return "`" + std::string(text) + "`"; }

void word(const RemapLine& remap, Finding& f) {
  const std::string at = quoted(remap.at);
  const char letter = remap.letter();
  switch (remap.problem) {
    case Problem::kOnlyComment:
      f.message = "`REMAP` with a comment only: the interpreter crashes when it starts";
      f.help = "begin the line with `#`";
      f.never_ends = true;
      break;
    case Problem::kNoEquals:
      f.message = remap.at.starts_with(';') ? "`;` begins no comment in a `REMAP` line: LinuxCNC does not start with it"
                                            : at + " is no option of `REMAP`: LinuxCNC does not start with this line";
      f.help = remap.at.starts_with(';') ? "begin the comment with `#`"
                                         : "write `option=value` without blanks around the `=`";
      break;
    case Problem::kNoValue:
      f.message = at + " has no value: LinuxCNC does not start with this line";
      f.help = "write the value behind the `=`, without a blank between them";
      break;
    case Problem::kGroup:
      f.message = quoted(remap.code) + " cannot be in modal group " + std::to_string(remap.group.value_or(0)) +
          ": LinuxCNC does not start with this line";
      f.help = letter == 'M' ? "M codes are in a group from 4 to 10: write `modalgroup=10` for a code of your own"
                             : "G codes are in group 1: write `modalgroup=1`";
      break;
    case Problem::kArgspec:
      f.message = at + " is no word for `argspec`: LinuxCNC does not start with this line";
      f.help = "`argspec` takes letters other than O, and `>`, `^`, `@`";
      break;
    case Problem::kTwoTargets:
      f.message = "`ngc` and `python` in one line: LinuxCNC does not start with it";
      f.help = "keep one of them";
      break;
    case Problem::kNoTarget:
      f.message = quoted(remap.code) + " is remapped to nothing: LinuxCNC does not start with this line";
      f.help = "add `ngc=` with the name of a file, or `python=` with that of a function";
      break;
    case Problem::kNoNumber:
      f.message = at + " has no number: LinuxCNC does not start with this line";
      f.help = letter == 'M' ? "write a code such as `M400`" : "write a code such as `G88.1`";
      break;
    case Problem::kLetterOnly:
      f.message = quoted(std::string(1, letter)) + " is remapped as a whole, " + at +
          " cannot be: LinuxCNC does not start with this line";
      f.help = "write `" + std::string(1, letter) + "`";
      break;
    case Problem::kFixedGroup:
      f.message = quoted(std::string(1, letter)) + " takes no modal group: LinuxCNC does not start with this line";
      f.help = "remove " + at;
      break;
    case Problem::kNone: break;
  }
}

void check_setup(const SetupInput& in, Reporter& out) {
  const IniText& text = in.setup.text;
  for (const Remap& remap : remaps_of(text)) {
    const std::string place = std::to_string(remap.line->number) + ":REMAP = " + std::string(text.value(*remap.line));
    if (remap.read.problem != Problem::kNone) {
      Finding& f = add_at(in, out, *remap.line, span_in(text, *remap.line, remap.read.at), "");
      refuses(f, remap.read.message);
      word(remap.read, f);
      f.stops = !f.never_ends;
    } else if (remap.earlier != nullptr) {
      Finding& f = add_at(in, out, *remap.line, span_in(text, *remap.line, remap.read.code),
                          quoted(remap.read.code) + " is remapped already, on line " +
                              std::to_string(remap.earlier->number) + ": LinuxCNC does not start with both");
      f.help = "keep one of the two lines";
      f.related.push_back({remap.earlier->span, "remapped here",
                           remap.earlier->source == remap.line->source ? nullptr : text.source(*remap.earlier)});
      refuses(f, "code '" + std::string(remap.read.code) + "' already remapped : " + place);
    }
    for (const std::string_view unknown : remap.read.unknown) {
      Finding& f =
          add_at(in, out, *remap.line, span_in(text, *remap.line, unknown),
                 "`REMAP` has no option " + quoted(unknown) + ": LinuxCNC says so on the console and ignores it");
      f.help = "the options are `modalgroup`, `argspec`, `ngc`, `python`, `prolog` and `epilog`";
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW416",
    .name = "remap-malformed",
    .summary = "a REMAP line with which LinuxCNC does not start",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A `REMAP` line that the interpreter refuses: an option without `=` or without a value, a modal group
that the code cannot be in, a letter that `argspec` does not take, no `ngc=` and no `python=` or both, a
code that is remapped twice. A file of `ngc=` that is nowhere is OW208's.)",
            .why = R"(The interpreter reads all `REMAP` lines when LinuxCNC starts. For one that it refuses it prints a
message on the console and gives up: LinuxCNC comes up without an interpreter, `can't initialize
interpreter`.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
REMAP = M400 modalgroup=3 ngc=greet
; file: greet.ngc
o<greet> sub
  G4 P0
o<greet> endsub
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
REMAP = M400 modalgroup=10 ngc=greet
; file: greet.ngc
o<greet> sub
  G4 P0
o<greet> endsub
)",
            .fix =
                R"(Write `REMAP = M400 modalgroup=10 argspec=P ngc=name`: options without blanks around the `=`, M codes in a
group from 4 to 10, G codes in group 1, T, S and F without a group. A comment begins with `#`, not with `;`.)",
            .level_reason = "Error: LinuxCNC does not start. Warning for an unknown option, which it ignores.",
            .interpreter =
                "error: code 'M400' : invalid modalgroup=<int> given (currently valid: 4..10) : 2:REMAP = M400 "
                "modalgroup=3 ngc=greet",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow416
