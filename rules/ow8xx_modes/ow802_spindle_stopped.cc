// OW802 spindle-stopped: a move that needs a turning spindle, or a speed.
// Depends on: M3 and M4 turn the spindle, even at speed 0; M5, M19 and M6 stop it. G95 looks at S alone, not at M3. Tapping
// also needs the right direction.
#include <array>

#include "rules/driver/modes.h"

namespace owlint::rules::ow802 {
namespace {

constexpr std::string_view kStart = "write `S` and `M3` before it";

constexpr std::array kSaid = {
    Said{"Cannot feed with zero spindle speed", "G1 G2 G3 * I J K R",
         "moves at a feed per turn of the spindle, and its speed is 0",
         "write `S` and the speed before it; `M3` alone does not set one"},
    Said{"not turning in G33", "G33 G33.1 *", "cuts a thread, and the spindle does not turn", kStart},
    Said{"not turning in G76", "G76 *", "cuts a thread, and the spindle does not turn", kStart},
    Said{"not turning in G74", "G74 *", "taps a left-hand thread, and the spindle does not turn",
         "write `S` and `M4` before it"},
    Said{"not turning in G84", "G84 *", "taps a thread, and the spindle does not turn", kStart},
    Said{"not turning in g8", "G86 G87 G88 *", "bores, and the spindle does not turn", kStart},
    Said{"turning clockwise in G74", "G74 *", "taps a left-hand thread, and the spindle turns clockwise",
         "write `M4` before it, or `G84` for a right-hand thread"},
    Said{"turning counterclockwise in G84", "G84 *", "taps a right-hand thread, and the spindle turns counterclockwise",
         "write `M3` before it, or `G74` for a left-hand thread"},
};

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    const bool speed = stop.interpreter.starts_with("Cannot feed");
    const std::optional<Setter> setter = setter_of(in, stop, speed ? "S G95" : "M3 M4 M5 M6 M19");
    const bool stops = setter && !speed && !setter->word.starts_with("M3") && !setter->word.starts_with("M4");
    relate_setter(in, f, setter, stops ? "stops the spindle here" : "is set here");
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW802",
    .name = "spindle-stopped",
    .summary = "a move that needs a turning spindle or a speed",
    .group = Group::kModes,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A thread (`G33`, `G33.1`, `G76`), tapping (`G74`, `G84`) or boring (`G86`, `G87`, `G88`) while the spindle
stands still, tapping while it turns the wrong way, or a move in `G95` while the speed `S` is 0.)",
            .why =
                R"(These moves follow the spindle, so LinuxCNC stops with `Spindle not turning in G33`, `Spindle turning
clockwise in G74` and the like. In `G95` it stops with `Cannot feed with zero spindle speed in feed per
rev mode`.

`M5` stops the spindle, and so do `M19` and a tool change with `M6`, unless the INI has
`TOOL_CHANGE_WITH_SPINDLE_ON`. After `M3` or `M4` the spindle counts as turning, even at speed
0, but `G95` looks only at `S`. `M6` and `M3` may be on one line: then the spindle turns.)",
            .bad = R"(G21 G90
S500 M3
G0 X10 Y10 Z5
T1 M6
G84 X10 Y10 Z-8 R2 F500
G80
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
T1 M6
S500 M3
G84 X10 Y10 Z-8 R2 F500
G80
M2
)",
            .fix = R"(Write `S` and `M3` or `M4` before the move, and again after each tool change.)",
            .level_reason = "Error if a run gets here with the spindle stopped: the program stops. owlint reports "
                            "nothing on lines that no run reaches.",
            .interpreter = "Spindle not turning in G84",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow802
