// OW701 word-unknown: text, a word of another language, or the letter of an axis that the machine lacks.
// Depends on: a word is a letter and a value; anything else on a line is an error when the line is executed. The letter of an
// axis that is not in [TRAJ]COORDINATES is a bad character; rs274 without an INI has X Y Z A B C.
#include <algorithm>

#include <fmt/format.h>

#include "rules/driver/idioms.h"
#include "rules/driver/modes.h"

namespace owlint::rules::ow701 {
namespace {

void text_outside_comment(const Input& in, const FlowStop& stop, const std::string& text, Finding& f) {
  f.message = "`" + text + "` is not a G-code word: a word is a letter and a number";
  f.help = "write text in a comment: `(text)`";
  explain_idiom(in, stop.statement, f);
}

/// Whether the line is in a block whose condition asks for the machine's INI or HAL, as a macro for several machines does; or in
/// one of a sub, whose callers choose the axis.
bool asks_for_machine(const Program& p, StatementId statement) {
  const bool in_sub = p.region_of[statement] != kMainRegion;
  for (BlockId id = p.open_above(p.region_of[statement], statement); id != kNoBlock; id = p.blocks[id].parent) {
    if (in_sub && p.blocks[id].kind == Keyword::kIf) return true;
    const std::string condition = small_letters(p.source->slice(p.at(p.blocks[id].opener).whole()));
    if (condition.find("#<_hal[") != std::string::npos || condition.find("#<_ini[") != std::string::npos ||
        condition.find("exists[") != std::string::npos)
      return true;
  }
  return false;
}

/// `G28 U0 W0`: on lathes of other controllers U and W are steps of X and Z. Foam cutters, which have these axes, have V and Y.
void tell_step(const Input& in, const FlowStop& stop, char letter, Finding& f) {
  const std::vector<WrittenWord> line = words_of(*in.program.source, in.program.at(stop.statement).whole());
  const std::string_view axis = letter == 'u' ? "X" : letter == 'w' ? "Z" : "";
  // In a cycle they are depths and allowances.
  if (axis.empty() || find_word(line, "V Y G71 G72 G73 G76") != nullptr || find_word(line, axis) != nullptr) return;
  f.help +=
      fmt::format("; for a step of {0}, which `{1}` is on other lathes, write `G91` and `{0}`", axis, capital(letter));
}

void missing_axis(const Input& in, const FlowStop& stop, char letter, const std::string& word, Finding& f) {
  const std::string axis = capital(letter);
  f.group = "axis " + axis;  // a program for such a machine has it on every line
  if (in.profile.setup == nullptr || !in.profile.setup->ini.has_section("TRAJ")) {
    f.message = "`" + word + "` is a word of the " + axis + " axis, which most machines do not have";
    f.help = in.profile.setup == nullptr
        ? "name the machine's INI (`--ini`), so that owlint knows its axes"
        : "name an INI that has `[TRAJ]` with `COORDINATES` (`--ini`), so that owlint knows the machine's axes";
    tell_step(in, stop, letter, f);
    f.unproven = true;
    f.uncertain = in.profile.setup != nullptr && asks_for_machine(in.program, stop.statement);
    return;
  }
  f.unproven = stop.reach != Reach::kAlways;  // a macro for several machines asks which axes there are
  f.uncertain = f.unproven && asks_for_machine(in.program, stop.statement);
  const Ini::Entry* axes = in.profile.setup->ini.find("TRAJ", "COORDINATES");
  f.message = "`" + word + "` is a word of the " + axis + " axis, which this machine does not have";
  f.help = axes == nullptr || axes->value.empty()
      ? "its axes are X Y Z, because `[TRAJ]` has no `COORDINATES`"
      : "its axes are " + axes->value + ", as `COORDINATES` in `[TRAJ]` says";
  tell_step(in, stop, letter, f);
  if (axes != nullptr && !axes->value.empty()) f.related.push_back({axes->span, "the machine's axes", axes->source});
}

/// `G71 U2 R1`, `G71 P100 Q110 U1`: whether the line is a cycle of another controller, whose finding says all.
bool is_foreign_cycle(const Input& in, const FlowStop& stop) {
  if (stop.kind != StopKind::kWordUnknown || in.profile.setup != nullptr || stop.statement == kNoStatement)
    return false;
  const std::vector<WrittenWord> line = words_of(*in.program.source, in.program.at(stop.statement).whole());
  const bool both = find_word(line, "P") != nullptr && find_word(line, "Q") != nullptr;
  const bool neither = find_word(line, "P Q") == nullptr;
  return find_word(line, "G71 G72 G73") != nullptr && (both || neither) && habit_of(in, stop.statement).has_value();
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    if (is_foreign_cycle(in, stop)) return nullptr;
    const WordStop at = word_stop(in, stop);
    Finding& f = out.add(at.span, "");
    if (stop.kind == StopKind::kWordUnknown) {
      const char letter = at.letter != 0 ? at.letter : small_letters(at.word.substr(0, 1))[0];
      missing_axis(in, stop, letter, at.word, f);
    } else {
      text_outside_comment(in, stop, std::string(in.program.source->slice(at.span)), f);
    }
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW701",
    .name = "word-unknown",
    .summary = "text, a word of another language, or a word of an axis that the machine lacks",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A line with text outside a comment, or with words of another control or of BASIC: `GOTO 20`, `END1`,
`GOSUB`, `THEN`, a title above the program. owlint says what LinuxCNC has instead.

Also a word of an axis that the machine does not have: `U5` where `[TRAJ]COORDINATES` is `XYZ`.
Without an INI owlint knows no axes: then it warns of `U`, `V` and `W`, which foam cutters have and
few other machines, and reports nothing about `A`, `B` and `C`.)",
            .why = R"(A word is a letter and a value. The interpreter stops when it executes such a line, with `Unknown
word where unary operation could be` or `Unknown word starting with e`; at the letter of a missing
axis with `Bad character 'u' used`. In a skipped branch there is no message.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
GOTO 90
G1 Z-2 F80
N90 G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
o100 if [#5070 EQ 1]
  G1 Z-2 F80
o100 endif
G0 Z5
M2
)",
            .fix =
                R"(Write text in a comment. Replace a jump by an `if` or a loop, and a loop of another control by `o100
while`. Name the machine's INI with `--ini`, or keep it above the program's folder, so that owlint knows
the axes.)",
            .level_reason = "Error if a run gets here: the program stops. Warning for `U`, `V` and `W` without an INI: "
                            "the machine may have them. Warning if it stops at an earlier line first.",
            .interpreter = "Unknown word where unary operation could be",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow701
