// OW703 number-out-of-range: a number that its word cannot have.
// Depends on: F, S, L and T are not negative, H is -1 or more; H, L, T and M are whole within 0.0001; G has one decimal and
// ends at 99.9. P of G10, M19 and arcs, and R of M19, have limits of their own.
#include <algorithm>
#include <cmath>

#include "rules/driver/words.h"

namespace owlint::rules::ow703 {
namespace {

constexpr double kWraps = 2147483647;  // what is larger becomes the smallest number

struct Limited {
  std::string_view interpreter;
  std::string_view message;  ///< behind the word
  std::string_view help;
};

constexpr Limited kLimited[] = {
    {"Negative f word", "is a negative feed rate", "write a feed rate above 0"},
    {"Negative spindle speed", "is a negative spindle speed",
     "write a speed of 0 or more; `M4` turns counterclockwise"},
    {"Negative tool id", "is a negative tool number", "write the number of a tool in the tool table, or T0 for none"},
    {"Negative h word", "is no tool number",
     "write the number of a tool in the tool table; `G49` switches the offset off"},
    {"Negative l word", "is negative", "write a number of 0 or more"},
    {"Negative g code", "is negative", "codes are `G0` to `G99.9`"},
    {"Negative m code", "is negative", "codes are `M0` to `M199`"},
    {"P value not an integer with G10", "is not a whole number",
     "write the number of the coordinate system or of the tool"},
    {"P value out of range (0-9)", "is not a coordinate system",
     "`P1` is G54, `P2` is G55 and so on to `P9`, G59.3; `P0` is the one in effect"},
    {"P value out of range with G10", "is no tool", "write the number of a tool in the tool table"},
    {"P value must be 0", "is not a direction of M19",
     "`P0` takes the shortest way, `P1` turns clockwise, `P2` counterclockwise"},
    {"P value not an integer with M19", "is not a whole number",
     "for an arc, P is the number of turns; for M19, P0, P1 or P2 is the direction"},
    {"P value should be 1", "is not a number of turns", "write `P1` or more, or no P for less than one turn"},
    {"R value must be within", "is not an angle of M19", "write an angle from 0 to 360"},
};

/// G10 without the P that it needs: the finding is at the G10.
bool lacks_p(const WordStop& at, Finding& f) {
  if (at.letter == 'p' || at.find('p') != nullptr || !f.interpreter.starts_with("P value")) return false;
  const bool system = f.interpreter.starts_with("P value out of range (0-9)");
  f.message = std::string("`G10` needs ") + (system ? "the coordinate system" : "the tool") + " as `P`";
  f.help = system ? "write `P1` for G54, `P2` for G55 and so on; `P0` is the one in effect" : "write `P1` for tool 1";
  return true;
}

void range_of_g(const WordStop& at, Release release, Finding& f) {
  if (!at.value) {
    f.message = "`" + at.word + "` computes a number that is no code: it is above 99.9, or has more than one decimal";
    f.help = "check how the number is computed";
    return;
  }
  if (at.value < 100) {
    f.message = "`" + at.word + "` has more than one decimal";
    f.help = "write one decimal at most: `G59.1`";
    return;
  }
  f.message = "`" + at.word + "` is not a code of LinuxCNC: G codes end at G99.9";
  if (at.value > kWraps) return;
  constexpr int kTenths = 10;
  const CodeAdvice advice = advice_for_code('g', static_cast<int>(std::lround(*at.value)) * kTenths, release);
  if (!advice.what.empty()) f.message = "`" + at.word + "` " + advice.what + "; LinuxCNC does not have it";
  f.help = advice.help;
}

void explain(const Input& in, const WordStop& at, Finding& f) {
  if (f.interpreter.starts_with("G-code out of range") && tell_split_code(*in.program.source, at, f)) return;
  if (f.interpreter.starts_with("G-code out of range")) return range_of_g(at, release_of(in.profile), f);
  if (f.interpreter.starts_with("Non integer value")) {
    f.message = "`" + at.word + "` is not a whole number";
    f.help = at.letter == 't' || at.letter == 'h' ? "write the number of a tool in the tool table"
        : at.letter == 'm'                        ? "M codes have no decimals"
                                                  : "write a whole number";
    if (!at.value) f.help = "compute a whole number: `ROUND[...]` or `FIX[...]`";
    return;
  }
  if (lacks_p(at, f)) return;
  const auto* limited =
      std::ranges::find_if(kLimited, [&](const Limited& l) { return f.interpreter.starts_with(l.interpreter); });
  const bool huge = at.value && at.value > kWraps && f.interpreter.starts_with("Negative");
  f.message = "`" + at.word + "` " +
      (huge                                ? "is too large"
           : limited == std::end(kLimited) ? "is out of range"
                                           : std::string(limited->message));
  f.help = limited == std::end(kLimited) ? "" : limited->help;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const WordStop at = word_stop(in, stop);
    Finding& f = out.add(at.span, "");
    f.interpreter = stop.interpreter;
    explain(in, at, f);
    relate_word(f, at);
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW703",
    .name = "number-out-of-range",
    .summary = "a number that its word cannot have: negative, too large, or not whole",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A negative `F`, `S`, `T`, `L` or `H`; a fraction where a whole number is needed (`T1.5`, `M3.5`); a
G code with two decimals or above 99.9; a `P` that cannot be a coordinate system or a tool (`G10`),
a number of turns (an arc) or a direction (`M19`).)",
            .why =
                R"(LinuxCNC checks a number as soon as it has read the word, and stops with `Negative f word used`, `Non
integer value for integer`, `G-code out of range` and the like. Nothing of the line is executed.

`D`, `P`, `Q`, `R` and the axes may have any value; the codes that use them check it when they run.
A number counts as whole within 0.0001. A whole number above 2147483647 counts as negative. `G10`
takes a `P` of 1.5 to 1.99 for 2, but refuses 1.4.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2 F-80
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2 F80
G0 Z5
M2
)",
            .fix = R"(Write the number that is meant. A computed value can be made whole with `ROUND[...]`.)",
            .level_reason = "Error: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "Negative f word used",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow703
