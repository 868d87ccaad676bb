// OW801 feed-missing: a move at feed rate while the feed is 0.
// Depends on: F in G94 and G95 sets the feed, G94 and G95 set it to 0 even when they were in effect, F in G93 counts for its
// own move only. A change of unit takes the feed that the machine has; M72 may restore a feed mode, and so 0.
#include <array>

#include <fmt/format.h>

#include "rules/driver/ini_places.h"
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

constexpr uint32_t kMostLines = 1000;

/// Whether a line above this one has the word.
bool has_above(const Source& source, uint32_t below, std::string_view word) {
  const uint32_t last = below > kMostLines ? below - kMostLines : 0;
  for (uint32_t line = below - 1; line > last; --line) {
    if (find_word(words_of(source, source.line(line)), word) != nullptr) return true;
  }
  return last > 0;
}

/// Whether there may have been a feed that the setter could set to 0: above it, or above the line that stops.
bool has_feed_above(const Input& in, const Setter& setter, uint32_t stops) {
  return has_above(*setter.program->source, setter.line, "F") ||
      ((setter.program != &in.program || stops > setter.line) && has_above(*in.program.source, stops, "F"));
}

/// `F100`: what it sets is not 0. Of a computed feed that is not known.
bool is_above_zero(const Setter& setter) {
  const std::vector<WrittenWord> line = words_of(*setter.program->source, setter.span);
  const WrittenWord* const word = find_word(line, "F");
  return word != nullptr && word->value && *word->value > 0;
}

/// The only block around the line that sets the feed, but not around the one that stops; null if there is none, or more.
const Block* block_of_setter(const Input& in, const Setter& setter, uint32_t stops) {
  const Program& p = *setter.program;
  const auto around = [&](const Block& block, uint32_t line) {
    return block.end != kNoStatement && p.at(block.opener).line < line && line < p.at(block.end).line;
  };
  const Block* only = nullptr;
  for (const Block& block : p.blocks) {
    if (!around(block, setter.line) || (setter.program == &in.program && around(block, stops))) continue;
    if (only != nullptr) return nullptr;
    only = &block;
  }
  return only;
}

/// A feed is set, but not on this way.
void explain_other_way(const Input& in, const Setter& setter, uint32_t stops, Finding& f) {
  f.help = "write `F` and a feed rate on this line or before it";
  const Program& p = *setter.program;
  const Block* const block = block_of_setter(in, setter, stops);
  const bool same_file = setter.program == &in.program;
  const std::string place = where(in, setter);
  if (const Ini::Entry* const remap = remap_entry(in.profile, 'f', 0);
      remap != nullptr && setter.word.starts_with('F')) {
    f.message += fmt::format(": `{}` {} calls the sub of a `REMAP`, which sets no feed here", setter.word, place);
    f.help = "let the sub set the feed, with an `F` of its own";
    relate_ini(f, *remap, "`F` is remapped here");
    return relate_setter(in, f, setter, "is here");
  }
  if (block == nullptr && same_file && has_above(*p.source, setter.line + 1, "G93")) {
    f.message += fmt::format(": in `G93`, `{}` {} does not set the feed", setter.word, place);
    f.help = "write `G94` and `F` on this line or before it";
  } else if (block != nullptr && same_file && p.parts[static_cast<BlockId>(block - p.blocks.data())].empty() &&
             (block->kind == Keyword::kIf || block->kind == Keyword::kWhile || block->kind == Keyword::kRepeat)) {
    f.message += fmt::format(": no `F` is set when `{}` on line {} {}", p.head(block->opener), p.at(block->opener).line,
                             block->kind == Keyword::kRepeat ? "does not repeat" : "is false");
  } else {
    f.message += fmt::format(": `{}` {} sets one only on another way here", setter.word, place);
  }
  relate_setter(in, f, setter, "is here");
}

/// Why the feed is 0, and what to do about it.
void explain(const Input& in, const FlowStop& stop, Finding& f) {
  const Statement& s = in.program.at(stop.statement);
  const std::vector<WrittenWord> line = words_of(*in.program.source, s.whole());
  const WrittenWord* given = find_word(line, "F");
  if (given != nullptr && given->value && *given->value == 0) {
    f.message += ": `" + shown(*in.program.source, given->span) + "` on this line sets it";
    f.help = "write a feed rate above 0";
    return;
  }
  if (given != nullptr && given->value && *given->value != 0) {
    f.message += ": in `G93`, `" + shown(*in.program.source, given->span) + "` does not set the feed";
    f.help = "write `G94` and `F` on this line or before it";
    return;
  }
  // In G93 a computed feed may be any, and the feed is still 0.
  if (given != nullptr && !has_above(*in.program.source, s.line + 1, "G93")) {
    f.message += ": `" + shown(*in.program.source, given->span) + "` on this line sets it";
    f.help = "write a feed rate above 0; an argument that a call leaves out is 0";
    return;
  }
  const std::optional<Setter> setter = setter_of(in, stop, "F G93 G94 G95 G20 G21");
  const bool feed_mode = setter && setter->word.starts_with("G9");
  if (!setter || (feed_mode && !has_feed_above(in, *setter, s.line))) {
    f.message += ": no `F` has been set on the way here";
    f.help = "write `F` and a feed rate on this line or before it";
    return;
  }
  const std::string place = where(in, *setter);
  if (feed_mode && find_word(words_of(*setter->program->source, setter->span), "G93") != nullptr) {
    f.message +=
        fmt::format(": in `{}`, which is set {}, an `F` counts only for the move on its line", setter->word, place);
    f.help = "write `G94` and `F` on this line or before it";
    return relate_setter(in, f, setter);
  }
  if (setter->restores()) {
    f.message += ": restoring the modes " + place + " has set it to 0";
    f.help = "write `F` again after it: restoring the feed mode sets the feed to 0";
  } else if (is_above_zero(*setter)) {
    return explain_other_way(in, *setter, s.line, f);
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

/// `G73 U5 W5 R3`: on Fanuc lathes no drilling cycle.
std::optional<Habit> of_cycle(const Input& in, const FlowStop& stop) {
  const std::vector<WrittenWord> line = words_of(*in.program.source, in.program.at(stop.statement).whole());
  return find_word(line, "G73") == nullptr ? std::nullopt : habit_of(in, stop.statement);
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    explain(in, stop, f);
    if (std::optional<Habit> habit = of_cycle(in, stop)) {
      f.message = std::move(habit->message);
      f.help = std::move(habit->help);
    }
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
feed at its first line.)",
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
            .level_reason = "Error if a run gets here with feed 0: the program stops. Warning if it stops at an "
                            "earlier line first.",
            .interpreter = "Cannot do g1 with zero feed rate",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow801
