// OW851 mode-leak: a sub comes back with a mode changed, and its caller moves before it sets the mode itself.
// Depends on: modes belong to no sub, so a change outlives the call; M73 in the sub restores all of them at its end.
#include <algorithm>
#include <array>
#include <set>

#include "rules/driver/mode_hazards.h"

namespace owlint::rules::ow851 {
namespace {

constexpr ModeMask kAnyMode = ~ModeMask{0};

/// A word in the name of a sub that says what it does to modes.
struct Telling {
  std::string_view word;
  bool anywhere = false;  ///< also inside a longer word: `millsetup`
  ModeMask of = kAnyMode;
};

// A sub with such a name is called for the modes that it leaves, or to tidy up behind others: its author knows. `set`, `safe` and
// `change` are not here: they are about the axes or the tool, and such subs forget a `G90` as others do.
constexpr std::array kTelling = {
    // It sets what the program needs.
    Telling{"setup", true},
    Telling{"init"},
    Telling{"start"},
    Telling{"startup", true},
    Telling{"begin"},
    Telling{"preamble", true},
    Telling{"prolog", true},
    Telling{"header", true},
    Telling{"default", true},
    Telling{"config", true},
    Telling{"safety", true},
    // It is one of a pair, or the last.
    Telling{"save"},
    Telling{"backup", true},
    Telling{"push"},
    Telling{"pop"},
    Telling{"restore", true},
    Telling{"reset", true},
    Telling{"end"},
    Telling{"finish"},
    Telling{"footer", true},
    Telling{"postamble", true},
    Telling{"epilog", true},
    Telling{"cleanup", true},
    Telling{"abort", true},
    // It names what it sets.
    Telling{"mode"},
    Telling{"modal", true},
    Telling{"state"},
    Telling{"toggle", true},
    Telling{"unit"},
    Telling{"metric", true},
    Telling{"imperial", true},
    Telling{"inch"},
    Telling{"mm"},
    Telling{"absolute", true},
    Telling{"abs"},
    Telling{"incremental", true},
    Telling{"incr"},
    Telling{"inc"},
    Telling{"relative", true},
    Telling{"rel"},
    Telling{"plane"},
    Telling{"diameter", true, mask_of(Mode::kDiameter)},
    Telling{"radius", true, mask_of(Mode::kDiameter)},
    Telling{"wcs", true, mask_of(Mode::kSystem)},
    Telling{"coord", true, mask_of(Mode::kSystem)},
    Telling{"system", true, mask_of(Mode::kSystem)},
    Telling{"fixture", true, mask_of(Mode::kSystem)},
    Telling{"offset", true, mask_of(Mode::kSystem)},
    Telling{"origin", true, mask_of(Mode::kSystem)},
    Telling{"datum", true, mask_of(Mode::kSystem)},
    Telling{"zero", true, mask_of(Mode::kSystem)},
    Telling{"comp", true, mask_of(Mode::kCompensation)},
    Telling{"lead", true, mask_of(Mode::kCompensation)},
    Telling{"entry", true, mask_of(Mode::kCompensation)},
    Telling{"enter", true, mask_of(Mode::kCompensation)},
    Telling{"retract", true, mask_of(Mode::kRetract)},
};

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

/// Whether a word of the name is `word`, or a longer form of it, such as `units` or `initialize`.
bool has_word(std::string_view name, std::string_view word) {
  constexpr size_t kLong = 4;
  for (size_t at = name.find(word); at != std::string_view::npos; at = name.find(word, at + 1)) {
    const size_t end = at + word.size();
    const bool begins = at == 0 || !is_letter_or_digit(name[at - 1]);
    const bool ends = end == name.size() || !is_letter_or_digit(name[end]);
    if (begins && (ends || word.size() >= kLong)) return true;
  }
  return false;
}

/// Whether the name says that the sub sets modes: by a word, or by the code itself, as `set_g91` does.
bool tells(std::string_view name, const Hazard& leak) {
  const std::string code = small_letters(code_of_value(leak.mode, leak.to));
  return name.find(code) != std::string_view::npos || std::ranges::any_of(kTelling, [&](const Telling& telling) {
           return (telling.of & mask_of(leak.mode)) != 0 &&
               (has_word(name, telling.word) ||
                (telling.anywhere && name.find(telling.word) != std::string_view::npos));
         });
}

/// Whether another call of the file takes the change back: then the two belong together.
bool is_taken_back(const Input& in, const Hazard& leak) {
  return std::ranges::any_of(in.flow.hazards, [&](const Hazard& other) {
    return other.kind == HazardKind::kModeLeak && other.mode == leak.mode && other.from == leak.to &&
        other.to == leak.from;
  });
}

/// The call as it is written.
std::string call_words(const Program& p, StatementId call) {
  const Statement& s = p.at(call);
  if (s.kind != LineKind::kM98) return "`" + p.head(call) + "`";
  return s.label == kNoName ? "this `M98`" : "`M98 P" + p.name(s.label) + "`";
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::set<std::pair<const Program*, uint32_t>> said;  // lines that set modes: one that all calls leave is one mistake
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kModeLeak || h.statement == kNoStatement || h.set_in == nullptr) continue;
    const Statement& call = p.at(h.statement);
    const std::string now = move_under(h.mode, h.to);
    if (now.empty() || (call.label != kNoName && tells(p.name(call.label), h))) continue;
    if (is_taken_back(in, h) || asks_for_mode(*h.set_in, h.mode)) continue;
    if (!said.emplace(h.set_in, h.set_line).second) continue;
    const std::string from = code_of_value(h.mode, h.from);
    const std::string to = code_of_value(h.mode, h.to);
    Finding& f = out.add(call.kind == LineKind::kM98 ? call.whole() : call.head_span(),
                         call_words(p, h.statement) + " returns in `" + to + "`, but was called in `" + from + "`");
    relate_mode(in, f, h, h.to);
    if (h.needed_in != nullptr) relate_line(in, f, *h.needed_in, h.needed_line, "*", "this move " + now + " now");
    f.help = h.mode == Mode::kMotion ? "write `" + from +
            "` on the first line that moves after the call, or at the end of the sub; `M73` does not restore it"
                                     : "write `" + from +
            "` at the end of the sub, or after the call; `M73` at the beginning of the sub restores all modes at its "
            "end";
    f.reach = h.reach;
    f.unproven = h.unproven;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW851",
    .name = "mode-leak",
    .summary = "a sub changes a mode, and its caller moves in the changed mode",
    .group = Group::kModes,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A sub changes the distance mode, unit, plane, feed mode, coordinate system, diameter mode or retract mode, or
leaves cutter compensation on, and the caller then moves before it sets the mode again: after the call, the same
words mean something else than before it. A remapped code that runs a sub counts as a call.

The motion in effect is a mode, too: where a sub ends with `G0`, a line `X10` after the call is a rapid,
though the caller wrote `G1` before the call.

A sub whose name says that it sets modes is not reported: `setup`, `metric`, `save_modes`, `set_g91`,
`on_abort` and the like. Nor does owlint report a change that another call reverses, a change in a file
that reads the mode (`#<_absolute>`) to restore it, or a mode that no move depends on.)",
            .why =
                R"(Modes belong to the machine, not to the sub: LinuxCNC keeps them over `endsub`. There is no message. In
the first program below, the sub goes down in `G91` and does not switch back to `G90`: the second hole is
at X40, not at X30.

`M73` in a sub saves the modes and restores them when the sub ends, wherever it ends. `M70` and `M72`
do the same by hand. None of them saves the motion: `G0` or `G1` stays in effect.)",
            .bad = R"(G21 G90
o<peck> sub
  G91
  G1 Z-7 F80
  G0 Z7
o<peck> endsub
G0 X10 Y10 Z2
o<peck> call
G0 X30
o<peck> call
M2
)",
            .good = R"(G21 G90
o<peck> sub
  G91
  G1 Z-7 F80
  G0 Z7
  G90
o<peck> endsub
G0 X10 Y10 Z2
o<peck> call
G0 X30
o<peck> call
M2
)",
            .fix = R"(Set the mode back at the end of the sub and before each `return`, or write `M73` at its beginning.
Suppress it where the caller wants the new mode, or give the sub a name that says so.)",
            .level_reason =
                "Warning: the program runs, and its author may want the new mode, but the caller does not show it.",
            .interpreter = "",
            .options = "",
            .moves = "X40",
            .moves_good = "X30",
        },
    .check = check,
};

}  // namespace owlint::rules::ow851
