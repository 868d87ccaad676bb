// OW803 feed-mode: a move that the feed mode in effect forbids.
// Depends on: in G93 each line that moves at feed rate has its own F (G0, threads and NURBS curves need none), and there are
// no drilling cycles. In G95 there is no probing.
#include <array>

#include "rules/driver/modes.h"

namespace owlint::rules::ow803 {
namespace {

constexpr std::string_view kOwn =
    "write `F` with 1 divided by the minutes for this move, or write `G94` and a feed rate before it";

constexpr std::array kSaid = {
    Said{"inverse time g1 move", "G1 *", "has no `F` of its own, and `G93` is in effect", kOwn},
    Said{"inverse time arc move", "G2 G3 G5 G5.1 * I J K R", "has no `F` of its own, and `G93` is in effect", kOwn},
    Said{"inverse time feed with canned cycles", "G73 G74 G81 G82 G83 G84 G85 G86 G87 G88 G89 *",
         "drills, which `G93` does not allow", "write `G94` and `F` before it"},
    Said{"probe with feed per rev", "G38.2 G38.3 G38.4 G38.5 *", "probes, which `G95` does not allow",
         "write `G94` and `F` before it"},
};

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    relate_setter(in, f, setter_of(in, stop, "G93 G94 G95"));
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW803",
    .name = "feed-mode",
    .summary = "a move that the feed mode in effect forbids",
    .group = Group::kModes,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `G1`, arc or spline without its own `F` while `G93` (inverse time) is in effect, a drilling cycle in
`G93`, or a probe move in `G95` (feed per revolution).)",
            .why = R"(In `G93`, `F` says how long this one move takes, so every move at feed rate needs its own `F`;
LinuxCNC stops with `F word missing with inverse time g1 move` or
`F word missing with inverse time arc move`. This also applies to lines without `G1` if `G1` is in
effect from an earlier line. `G0`, threads and NURBS curves need no `F`.

Drilling cycles stop in `G93` with `Cannot use inverse time feed with canned cycles`, probe moves in
`G95` with `Cannot probe with feed per rev mode`.)",
            .bad = R"(G21 G90
G0 X0 Y0 A0
G93
G1 X10 A90 F4
X20 A180
M2
)",
            .good = R"(G21 G90
G0 X0 Y0 A0
G93
G1 X10 A90 F4
X20 A180 F4
M2
)",
            .fix =
                R"(Write `F` on every line of the `G93` part. Before cycles and probe moves, switch back with `G94`, and set
the feed again: `G94` has set it to 0.)",
            .level_reason = "Error if a run gets here in that feed mode: the program stops. owlint reports nothing on "
                            "lines that no run reaches.",
            .interpreter = "F word missing with inverse time g1 move",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow803
