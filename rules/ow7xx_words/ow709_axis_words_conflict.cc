// OW709 axis-words-conflict: axis words with no code that uses them, or with two.
// Depends on: G10, G28, G30, G52 and G92 take the axis words of their line, and so does a motion, from the line or in effect.
// At the start, and behind G80, none is in effect. @ and ^ are for motions in the XY plane.
#include <algorithm>

#include <fmt/format.h>

#include "rules/driver/modes.h"

namespace owlint::rules::ow709 {
namespace {

/// `G0 G28 Z0`: G28 and G30 are rapid moves themselves.
bool moves_to_stored_place(const Program& p, const FlowStop& stop, const WordStop& at, Finding& f) {
  const WrittenWord* const stored = find_word(at.line, "G28 G30");
  const WrittenWord* const motion = find_word(at.line, "G0 G1");
  if (stored == nullptr || motion == nullptr) return false;
  const std::string code = shown(*p.source, stored->span);
  const std::string other = shown(*p.source, motion->span);
  f.message = fmt::format("`{}` and `{}` cannot be on one line: `{}` is a rapid move itself", code, other, code);
  f.help = fmt::format("remove `{}`", other);
  f.fixes.push_back(without_word(p, p.at(stop.statement), motion->span, other));
  f.fixes.back().safe = false;  // lines behind it may go on with its motion
  return true;
}

void explain(const Program& p, const WordStop& at, Finding& f) {
  const std::string& said = f.interpreter;
  const std::string word = "`" + at.word + "`";
  if (is_angle_for_power(*p.source, at.span, at.line)) {
    f.message = word + " is no power: LinuxCNC reads it as the angle of a polar position";
    f.help = "write the power with `**`, in brackets: `[... ** " + at.word.substr(1) + "]`";
    return;
  }
  if (said.starts_with("Cannot use two g codes")) {
    f.message = fmt::format("{} and {} cannot be on one line: both take its axis words", word,
                            at.other_word.empty() ? "another code" : "`" + at.other_word + "`");
    f.help = "write them on two lines";
  } else if (said.starts_with("Cannot use axis values with g80")) {
    f.message = "`G80` ends the motion mode, and " + word + " is on its line";
    f.help = "write `G80` on a line of its own, and the move with its code, such as `G0`";
  } else if (said.starts_with("Cannot use axis values without")) {
    f.message = word + " moves nothing: there is no G0, G1 or other motion on this line or in effect here";
    f.help = "write `G0` or `G1` on this line";
  } else if (said.starts_with("Polar coordinates can only")) {
    f.message = word + " is a polar word: only a motion can use it" +
        (at.other_word.empty() ? "" : ", not `" + at.other_word + "`");
    f.help = "write `X` and `Y`";
  } else if (said.find("except in G17") != std::string::npos) {
    f.message = word + " is a polar word, but the XY plane is not in effect";
    f.help = "write `G17` on a line before";
  } else if (said.find("lacking X or Y") != std::string::npos) {
    f.message = word + " is a polar word, and the machine has no X or no Y axis";
    f.help = "write the axes that the machine has";
  } else if (said.starts_with("Cannot specify both")) {
    const std::string other = at.other_word.empty() ? said.substr(said.size() - 6, 1) : at.other_word;
    f.message = fmt::format("{} and `{}` cannot be on one line: a position is polar or not", word, other);
    f.help = "write `X` and `Y`, or `@` and `^`";
  } else {
    f.message = word + " has no code that uses it";
    f.help = "write `G0` or `G1` on this line";
  }
}

/// The line that has set the mode which refuses the words.
void relate_mode(const Input& in, const FlowStop& stop, Finding& f) {
  std::optional<Setter> setter;
  std::string_view does = "ends the motion mode here";
  if (stop.interpreter.starts_with("Cannot use axis values without")) {
    setter = setter_of(in, stop, "G80", false);
  } else if (stop.interpreter.find("except in G17") != std::string::npos) {
    setter = setter_of(in, stop, "G18 G19 G17.1 G18.1 G19.1", false);
    does = "is set here";
  }
  if (setter && !setter->restores()) relate_setter(in, f, setter, does);
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const WordStop at = word_stop(in, stop);
    Finding& f = out.add(at.span, "");
    f.interpreter = stop.interpreter;
    if (!stop.interpreter.starts_with("Cannot use two g codes") || !moves_to_stored_place(in.program, stop, at, f))
      explain(in.program, at, f);
    const bool of_call = in.program.at(stop.statement).kind == LineKind::kM98;
    if (of_call && f.help.starts_with("write `G0`")) f.help = "write the move on a line of its own, before `M98`";
    if (at.letter != 0 && at.letter != '^' && stop.interpreter.starts_with("Cannot use axis values without")) {
      if (std::optional<Habit> habit = habit_of(in, stop.statement)) {
        f.message = "`" + at.word + "` moves nothing: " + habit->message;
        f.help = std::move(habit->help);
      }
    }
    relate_word(f, at);
    relate_mode(in, stop, f);
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW709",
    .name = "axis-words-conflict",
    .summary = "axis words with no code that uses them, or with two",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(`X`, `Y`, `Z` and the other axes on a line without a code for them, when no motion is in effect: the
first line of a program, or a line after `G80`. Or axis words that two codes on the line need:
`G28 G1 X5`. Also `@` and `^` where they are not allowed.)",
            .why =
                R"(LinuxCNC stops with `Cannot use axis values without a g code that uses them`, `Cannot use axis values with
g80` or `Cannot use two g codes that both use axis values`. Nothing of the line is executed.

What is in effect depends on the way to the line. `rs274`, which owlint follows, starts with no
motion in effect; on a machine, the `M2` of an earlier program leaves `G1` in effect, so such a line
can move at feed rate there.)",
            .bad = R"(G21 G90
G81 X10 Y10 Z-5 R2 F80
G80
X20 Y20
M2
)",
            .good = R"(G21 G90
G81 X10 Y10 Z-5 R2 F80
G80
G0 X20 Y20
M2
)",
            .fix = R"(Write the code on the line: `G0` for a rapid move, `G1` for a cut.)",
            .level_reason = "Error if a run gets here with no motion in effect: the program stops. owlint reports "
                            "nothing on lines that no run reaches.",
            .interpreter = "Cannot use axis values without a g code that uses them",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow709
