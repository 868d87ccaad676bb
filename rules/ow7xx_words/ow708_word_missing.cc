// OW708 word-missing: a code without a word that it needs.
// Depends on: G4 needs P, G10 L, G96 S, G33 and G33.1 K, G76 P I J K, G52 and G92 and most motions an axis word. P-1 counts
// as no P. What a motion needs when it moves (radius, depth) is found later, by the interpreter and by other rules.
#include <algorithm>

#include <fmt/format.h>

#include "rules/driver/ini_places.h"
#include "rules/driver/words.h"

namespace owlint::rules::ow708 {
namespace {

struct Needed {
  std::string_view interpreter;
  std::string_view code;
  std::string_view message;  ///< behind the code
  std::string_view help;
};

constexpr Needed kNeeded[] = {
    {"Dwell time missing", "G4", "needs the time as `P`", "write `P0.5` for half a second"},
    {"S word missing with G96", "G96", "needs the surface speed as `S` on its line",
     "write `S` and the speed, in meters or feet per minute"},
    {"K word missing with g33", "G33", "needs the pitch as `K`", "write `K` and the travel per revolution"},
    {"P word missing with G76", "G76", "needs the pitch as `P`", "write `P` and the travel per revolution"},
    {"All axes missing with g52", "G52", "needs an axis word", "write the axes that it is about, such as `X0`"},
    {"All axes missing with motion", "the motion", "needs an axis word", "write where it goes"},
};

/// Of a line behind a thread, whose code is still in effect.
constexpr std::string_view kMoveBack = "write `G0` before it for a move back; for another thread ";

void g10(const WordStop& at, Finding& f) {
  f.help = "`L2` and `L20` set a coordinate system, `L1`, `L10` and `L11` an entry of the tool table";
  f.message = at.other_word.empty() ? "`G10` needs an `L` that says what it sets"
                                    : "`" + at.other_word + "` is nothing that `G10` can set";
}

/// I, J and K are one message.
void g76(const WordStop& at, const std::string& code, Finding& f) {
  std::string missing;
  constexpr std::pair<char, std::string_view> kWords[] = {
      {'i', "the thread's crest as `I`"}, {'j', "the first cut's depth as `J`"}, {'k', "the full depth as `K`"}};
  for (const auto& [letter, what] : kWords) {
    if (at.find(letter) == nullptr) missing += (missing.empty() ? "" : " and ") + std::string(what);
  }
  f.message = code + " needs " + (missing.empty() ? "`I`, `J` and `K`" : missing);
  f.help = "write it on this line";
  if (at.letter != 'g') f.help = std::string(kMoveBack) + f.help;
}

/// `G92` alone, as in the first lines of many programs: meant is the code that clears the offset.
bool clears_offset(const WordStop& at, Finding& f) {
  constexpr double kG92 = 92;
  if (!f.interpreter.starts_with("All axes missing with g52") || at.letter != 'g' || at.value != kG92) return false;
  f.message = "`" + at.word + "` needs an axis word: it sets an offset";
  f.help = "write `G92.1` to clear the offset, or the axes that it is about, such as `X0`";
  return true;
}

void explain(const WordStop& at, Finding& f) {
  if (clears_offset(at, f)) return;
  // Where the code is not on the line, it is the motion in effect.
  const bool on_line = at.letter == 'g';
  if (f.interpreter.starts_with("Line with G10")) return g10(at, f);
  if (f.interpreter.starts_with("I J or K")) return g76(at, on_line ? "`" + at.word + "`" : "`G76`", f);
  const auto* needed =
      std::ranges::find_if(kNeeded, [&](const Needed& n) { return f.interpreter.starts_with(n.interpreter); });
  if (needed == std::end(kNeeded)) {
    f.message = "`" + at.word + "` lacks a word that it needs";
    return;
  }
  const std::string in_table = needed->code[0] == 'G' ? fmt::format("`{}`", needed->code) : std::string(needed->code);
  const std::string code = on_line ? "`" + at.word + "`" : in_table;
  f.message = fmt::format("{}{} {}", code, on_line ? "" : ", which is in effect,", needed->message);
  // A computed code: only what it comes to says why.
  if (on_line && !at.value && needed->code[0] == 'G')
    f.message = fmt::format("{} is {} here, which {}", code, in_table, needed->message);
  f.help = needed->help;
  if (!on_line && (needed->code == "G33" || needed->code == "G76")) f.help = std::string(kMoveBack) + f.help;
  if (const WrittenWord* p = at.find('p'); p != nullptr && f.interpreter.starts_with("Dwell"))
    f.help = "`P-1` counts as no `P`: " + f.help;
}

/// What the sub of a remapped code asks for: `user-defined M400: missing: P,RF>0,`.
Finding* of_remap(const Input& in, Reporter& out, const FlowStop& stop) {
  const std::string_view message = stop.interpreter;
  const std::string code = in.program.head(stop.statement);
  std::vector<std::string> missing;
  constexpr std::string_view kMissing = "missing: ";
  const size_t list = message.find(kMissing);
  for (size_t at = list == std::string_view::npos ? message.find(':') + 1 : list + kMissing.size();
       at < message.size();) {
    const std::string_view rest = message.substr(at);
    const bool above = rest.starts_with("F>0") || rest.starts_with("S>0");
    if (above) missing.emplace_back(rest[0] == 'F' ? "a feed" : "a speed");
    if (!above && rest[0] >= 'A' && rest[0] <= 'Z') missing.push_back(fmt::format("`{}`", rest[0]));
    at += above ? 3 : 1;
  }
  std::string words;
  for (size_t i = 0; i < missing.size(); ++i)
    words += (i == 0 ? "" : i + 1 == missing.size() ? " and " : ", ") + missing[i];
  Finding& f = out.add(in.program.at(stop.statement).head_span(),
                       fmt::format("`{}` lacks {}, which its `REMAP` line requires", code, words));
  f.help = "write what is missing on this line; a small letter in `argspec` makes a word optional";
  if (const Ini::Entry* const entry = remap_entry(in, stop.statement))
    relate_ini(f, *entry, fmt::format("`{}` is remapped here", code));
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    if (stop.kind == StopKind::kRemapWords) return of_remap(in, out, stop);
    const WordStop at = word_stop(in, stop);
    Finding& f = out.add(at.span, "");
    f.interpreter = stop.interpreter;
    explain(at, f);
    if (at.letter == 'g' && tell_split_code(*in.program.source, at, f)) return &f;
    if (std::optional<Habit> habit = at.letter == 'g' ? habit_of(in, stop.statement) : std::nullopt) {
      f.message = std::move(habit->message);
      f.help = std::move(habit->help);
    }
    if (at.other.end > at.other.begin) {  // the wrong L of a G10
      f.span = at.other;
      f.related.push_back({at.span, "`" + at.word + "` is here", nullptr});
    }
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW708",
    .name = "word-missing",
    .summary = "a code without a word that it needs",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A code without a word that it needs on its line: `G4` without `P`, `G10` without `L`, `G96` without `S`,
`G33` without `K`, `G76` without `P`, `I`, `J` and `K`, `G92` or a cycle without an axis word.)",
            .why = R"(LinuxCNC stops before it does anything on the line, with `Dwell time missing with g4`,
`All axes missing with motion code` and the like. `G0` and `G1` need no axis word: without one, they
only set the mode.

`S` from a line before does not count for `G96`. `P-1` counts as no `P`. docs/codes.md lists what every
code needs.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G4
G1 Z-2 F80
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G4 P0.5
G1 Z-2 F80
G0 Z5
M2
)",
            .fix = R"(Write the word on the line of its code.)",
            .level_reason = "Error: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "Dwell time missing with g4",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow708
