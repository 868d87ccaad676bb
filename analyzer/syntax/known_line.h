// Is this a line that LinuxCNC runs? Asked by fixes that put text on a line of its own: only what is surely a good line
// may be moved without a human looking at it.
#pragma once

#include <string_view>

namespace owlint {

/// Whether the interpreter surely runs `text` as a line of its own, whatever came before it: blanks, comments,
/// assignments, words of codes that no mode, feed rate or position makes stop, a complete O-word inside a block or sub
/// (not `sub` or `endsub`), M98 or M99. Values that are computed and subs that are called are the flow's to judge.
/// False in doubt: arcs, cycles, probing, tool changes, G1 without F. Left aside: what cutter compensation and G95
/// forbid.
bool surely_runs(std::string_view text);

/// Whether the interpreter surely cannot read `text` as a line of its own.
bool surely_refused(std::string_view text);

}  // namespace owlint
