// OW801 feed-missing: a move at feed rate while the feed is 0.
// Depends on: F in G94 and G95 sets the feed, G94 and G95 set it to 0 even when they were in effect, F in G93 counts for its
// own move only. A change of unit takes the feed that the machine has; M72 may restore a feed mode, and so 0.
#include <array>

#include <fmt/format.h>

#include "rules/driver/modes.h"

namespace owlint::rules::ow801 {
namespace {

constexpr std::array kSaid = {
    Said{"Cannot do g1", "G1 *", "moves at feed 0", ""},
    Said{"Cannot make arc", "G2 G3 G5 G5.1 * I J K R", "moves at feed 0", ""},
    Said{"Cannot make a N", "G5.2 * P L", "moves at feed 0", ""},
    Said{"Cannot make a n", "G6.2 * P Q", "moves at feed 0", ""},
    Said{"Cannot probe", "G38.2 G38.3 G38.4 G38.5 *", "probes at feed 0", ""},
    Said{"Cannot feed", "G73 G74 G81 G82 G83 G84 G85 G86 G87 G88 G89 *", "drills at feed 0", ""},
};

/// Whether a line above that of the setter has an `F`: else there was no feed that it could set to 0.
bool has_feed_above(const Setter& setter) {
  constexpr uint32_t kMostLines = 1000;
  const Source& source = *setter.program->source;
  const uint32_t last = setter.line > kMostLines ? setter.line - kMostLines : 0;
  for (uint32_t line = setter.line - 1; line > last; --line) {
    if (find_word(words_of(source, source.line(line)), "F") != nullptr) return true;
  }
  return last > 0;
}

/// Why the feed is 0, and what to do about it.
void explain(const Input& in, const FlowStop& stop, Finding& f) {
  const Statement& s = in.program.at(stop.statement);
  const std::vector<WrittenWord> line = words_of(*in.program.source, s.whole());
  const WrittenWord* given = find_word(line, "F");
  if (given != nullptr && given->value && *given->value != 0) {
    f.message += ": in `G93`, `" + shown(*in.program.source, given->span) + "` does not set the feed";
    f.help = "write `G94` and `F` on this line or before it";
    return;
  }
  const std::optional<Setter> setter = setter_of(in, stop, "F G94 G95 G20 G21");
  if (!setter || (setter->word.starts_with("G9") && !has_feed_above(*setter))) {
    f.message += ": no `F` has been set on the way here";
    f.help = "write `F` and a feed rate on this line or before it";
    return;
  }
  const std::string place = where(in, *setter);
  if (setter->restores()) {
    f.message += ": restoring the modes " + place + " has set it to 0";
    f.help = "write `F` again after it: restoring the feed mode sets the feed to 0";
  } else if (setter->word.starts_with('F')) {
    f.message += fmt::format(": `{}` {} has set it", setter->word, place);
    f.help = "write a feed rate above 0";
    if (setter->word.find('#') != std::string::npos) f.help += "; an argument that a call leaves out is 0";
  } else if (setter->word.starts_with("G2")) {
    f.message += fmt::format(": `{}` {} has changed the unit and lost it", setter->word, place);
    f.help = fmt::format("write `F` again after `{}`", setter->word);
  } else {
    f.message += fmt::format(": `{}` {} has set it to 0", setter->word, place);
    f.help = fmt::format(
        "write `F` again on the line of `{0}` or after it: it sets the feed to 0, even if `{0}` was in effect",
        setter->word);
  }
  relate_setter(in, f, setter, setter->word.starts_with("G9") ? "sets the feed to 0 here" : "is here");
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    explain(in, stop, f);
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW801",
    .name = "feed-missing",
    .summary = "a move at feed rate while the feed is 0",
    .group = Group::kModes,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(`G1`, an arc, a spline, a probe move or a drilling cycle at feed 0: no `F` has been set on the way to it,
or `G94` or `G95` has set the feed to 0 since.)",
            .why =
                R"(LinuxCNC stops with `Cannot do g1 with zero feed rate`, `Cannot make arc with zero feed rate` and the
like. It stops even if the line does not move: for `G1` alone, too.

`G94` and `G95` set the feed to **0**, even if the same mode was already in effect. An `F` on their
own line counts; an `F` on an earlier line does not. In `G93`, an `F` counts only for the move on
its line. `M72`, and the end of a sub with `M73`, may restore `G94` or `G95`: then the feed is 0 as
well.

`rs274`, which owlint follows, starts with feed 0. On a machine, an earlier program may have set a feed:
then this program runs at that feed. In a file that other programs call, owlint assumes nothing about the
feed at its first line.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
F80
G94
G1 Z-2
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G94
F80
G1 Z-2
G0 Z5
M2
)",
            .fix = R"(Write `F` on the line of the first move at feed rate, and on each line with `G94` or `G95`.)",
            .level_reason = "Error if a run gets here with feed 0: the program stops. owlint reports nothing on lines "
                            "that no run reaches.",
            .interpreter = "Cannot do g1 with zero feed rate",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow801
