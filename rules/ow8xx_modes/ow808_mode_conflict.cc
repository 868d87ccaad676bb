// OW808 mode-conflict: any other code that the line's words or the modes in effect refuse when it is carried out.
// Depends on: the numbers of spindles from $, which are 0 and -1 on a machine with one; what G10, G43.2, M19, M61 and M62 to M68
// want of their words; rotary axes that the INI declares as wrapped or indexing.
#include <array>

#include "rules/driver/positions.h"

namespace owlint::rules::ow808 {
namespace {

constexpr std::string_view kSpindle = "`$0` is the first spindle; the INI's `[TRAJ]SPINDLES` says how many there are";
constexpr std::string_view kOutput = "write `P` and the number of the output";
constexpr std::string_view kInput =
    "write `P` and the number of a digital input, or `E` and the number of an analog input";
constexpr std::string_view kNone = "is not a spindle of this machine";
constexpr std::string_view kNoTurn = "is more than one turn, and the INI says that the axis wraps";
constexpr std::string_view kTurn = "write an angle above -360 and below 360";
constexpr std::string_view kNotAlone = "belongs to an indexing axis, which moves alone";
constexpr std::string_view kAlone = "write the other axes on another line";

constexpr std::array kSaid = {
    Said{"in M51 command", "$ M51", "needs a second spindle", "on a machine with one spindle, write `M51` without `$`"},
    Said{"Invalid spindle ($)", "$", kNone, kSpindle},
    Said{"Spindle ($) number", "$", kNone, kSpindle},
    Said{"Invalid D-number in G76", "$", kNone, kSpindle},
    Said{"Invalid E-number in G74", "$", kNone, kSpindle},
    Said{"without offsets has no effect", "G10", "does not set anything for the tool",
         "write what it sets: an axis word, `R`, `I`, `J` or `Q`"},
    Said{"Q number in G10", "Q", "is not a tool orientation: it must be a whole number",
         "write a whole number from 0 to 9"},
    Said{"Invalid tool orientation", "Q", "is not a tool orientation", "write a whole number from 0 to 9"},
    Said{"I J words not allowed", "I J", "has no meaning for a coordinate system",
         "remove it; `G10 L1`, `L10` and `L11` take `I` and `J` as angles of a tool"},
    Said{"R not allowed in G10 L20", "R", "cannot be used with `L20`",
         "write the rotation with `G10 L2`, on another line"},
    Said{"G10 L0 not allowed", "G10", "reads the tool table again, but a tool is in the spindle",
         "use it only while no tool is in the spindle"},
    Said{"M61", "Q M61", "sets no tool: the number `Q` is missing or negative",
         "write `Q` and the number of the tool in the spindle"},
    Said{"Q word with M19", "Q", "is not a time: `M19` needs a `Q` above 0",
         "write the seconds to wait, or remove the `Q`"},
    Said{"No valid P word", "M62 M63 M64 M65", "needs a `P` with the number of the output", kOutput},
    Said{"both a digital and an analog", "M66", "has both a digital and an analog input", "write `P` or `E`, not both"},
    Said{"Zero timeout", "L M66", "waits for an input, but has no `Q` with the time",
         "write `Q` and the seconds to wait, or `L0` to read it at once"},
    Said{"select analog input", "L", "cannot be used with an analog input",
         "write `L0`: an analog input is read at once"},
    Said{"valid P or a valid E", "M66", "needs a `P` or `E` with the number of the input", kInput},
    Said{"put selected out of bounds", "P E", "is not an input of this machine", kInput},
    Said{"Invalid analog index", "E M67 M68", "sets no output: the number `E` is missing or negative",
         "write `E` and the number of the output"},
    Said{"both H and axis words", "G43.2", "has both an `H` and axis words",
         "write `G43.2` with only the `H`; before version 2.10, axis words stop the program"},
    Said{"No axes specified and H", "G43.2", "adds no offset: it has neither an `H` nor axis words",
         "write `H` and the number of the tool"},
    Said{"polar coordinates with G53", "@ ^", "is a polar word, which `G53` does not take", "write `X` and `Y`"},
    Said{"Must specify angle", "@", "has no angle, and at the origin there is none to keep", "add the angle as `^`"},
    Said{"Incremental motion with polar", "@ ^", "has no direction: the tool is at the origin",
         "write `@` and `^` in `G90`, or `X` and `Y`"},
    Said{"G91 motion with polar", "^", "turns around the origin, but the tool is at the origin",
         "write `@` and `^` in `G90`, or `X` and `Y`"},
    Said{"Start point too close", "G38.2 G38.4", "ends where it starts, so it cannot probe",
         "write an end that is not where the tool already is; in `G91`, a distance that is not 0"},
    Said{"wrapped rotary axis A", "A", kNoTurn, kTurn},
    Said{"wrapped rotary axis B", "B", kNoTurn, kTurn},
    Said{"wrapped rotary axis C", "C", kNoTurn, kTurn},
    Said{"axis A can only be moved with G0", "A", "belongs to an indexing axis, which only `G0` moves", "write `G0`"},
    Said{"axis B can only be moved with G0", "B", "belongs to an indexing axis, which only `G0` moves", "write `G0`"},
    Said{"axis C can only be moved with G0", "C", "belongs to an indexing axis, which only `G0` moves", "write `G0`"},
    Said{"axis A can only be moved alone", "A", kNotAlone, kAlone},
    Said{"axis B can only be moved alone", "B", kNotAlone, kAlone},
    Said{"axis C can only be moved alone", "C", kNotAlone, kAlone},
    Said{"moved along with an indexer", "@ ^ *", "moves together with an indexing axis", "write it on another line"},
};

/// Adds the line from which the tool comes, unless the line itself moves it to the origin before it turns.
void relate_origin(const Input& in, const FlowStop& stop, Finding& finding) {
  if (stop.interpreter.starts_with("G91") && word_stop(in, stop).find('@') != nullptr) return;
  if (const auto from = words_above(in, stop.statement, "xy@^"))
    finding.related.push_back({*from, "the tool is where this line ends", nullptr});
}

/// Without its INI it is not known how many spindles the machine has; a program for several names them on many lines.
void doubt_spindle(const Input& in, const FlowStop& stop, Finding& f) {
  if (in.profile.setup != nullptr || !f.message.ends_with(kNone)) return;
  const WordStop at = word_stop(in, stop, "$");
  f.message = "`" + at.word + "` is a further spindle, which most machines do not have";
  f.help = "name the machine's INI (`--ini`), so that owlint knows its spindles";
  f.group = "spindle " + at.word + " in " + in.program.source->path();
}

/// `M66 P0 L3 Q0`: there is a Q.
void tell_timeout(const Input& in, const FlowStop& stop, Finding& f) {
  if (!stop.interpreter.starts_with("Zero timeout")) return;
  const std::vector<WrittenWord> line = words_of(*in.program.source, in.program.at(stop.statement).whole());
  const WrittenWord* const word = find_word(line, "Q");
  if (word == nullptr) return;
  const std::string text = shown(*in.program.source, word->span);
  f.help = fmt::format("`{}` is no time to wait: {}", text, f.help);
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    doubt_spindle(in, stop, f);
    tell_timeout(in, stop, f);
    const bool turns = stop.interpreter.find("rotary axis") != std::string::npos;
    if (stop.kind == StopKind::kModeConflict && stop.words.decided_by == mask_of(Mode::kDistance) && !turns) {
      relate_distance(in, stop, f);
      relate_origin(in, stop, f);
    } else {
      relate_setter(in, f, setter_of(in, stop, "M6", false), "changes the tool here");
    }
    note_start(stop, f);
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW808",
    .name = "mode-conflict",
    .summary = "a code that LinuxCNC refuses only when it runs it, because of its words or the modes in effect",
    .group = Group::kModes,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A code that LinuxCNC reads without a message but then refuses to run, for a reason that no other rule
covers: `$` with a spindle that the machine does not have; `M62` to `M65` without the output's number;
`M66` without an input, or with an input that does not fit its `L` and `Q`; `M67` and `M68` without `E`;
`M61` without `Q`; `G10` with words that it does not take; `G43.2` with both `H` and axis words; a polar word
that needs a direction, when the tool is at the origin; `G38.2` and `G38.4` to where the tool already is.)",
            .why =
                R"(LinuxCNC stops with `No valid P word with M64`, `Zero timeout with wait type != immediate return`, `Invalid
spindle ($) number in Spindle speed command` and the like. By then, LinuxCNC has already run what comes
before the code in the order of execution: `M64` comes after `F`, `S` and `T`, and before the move. See OW711
and docs/codes.md for this order.)",
            .bad = R"(G21 G90
M66 P0 L3
G0 X10 Y10 Z5
M2
)",
            .good = R"(G21 G90
M66 P0 L3 Q10
o100 if [#5399 EQ -1]
  (abort, no input within 10 seconds)
o100 endif
G0 X10 Y10 Z5
M2
)",
            .fix =
                R"(Write the word that is missing, or remove the one that does not fit. `M66` that waits (`L1` to `L4`) needs
the longest time to wait as `Q`, in seconds; `#5399` is -1 if the input did not come.)",
            .level_reason =
                "Error if a run gets here: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "Zero timeout with wait type != immediate return",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow808
