// OW852 mode-depends-on-path: a move that means one thing on one path and another on another.
// Depends on: LinuxCNC keeps a mode that one branch sets behind the `endif`, and one that a pass of a loop sets for the next.
#include <algorithm>
#include <set>
#include <tuple>

#include "analyzer/syntax/last_statement.h"
#include "rules/driver/mode_hazards.h"

namespace owlint::rules::ow852 {
namespace {

/// Whether the mode comes from a call that changes it: OW851 reports the call.
bool comes_from_leak(const Input& in, const Hazard& h) {
  return std::ranges::any_of(in.flow.hazards, [&](const Hazard& leak) {
    return leak.kind == HazardKind::kModeLeak && leak.mode == h.mode && leak.set_in == h.set_in &&
        leak.set_line == h.set_line;
  });
}

/// Whether the line is in an `if` that has codes for both values: then the program chooses the mode.
bool is_choice(const Hazard& h) {
  if (h.set_in == nullptr) return false;
  const Program& p = *h.set_in;
  const Source& source = *p.source;
  const StatementId above = last_statement(p.syntax, source.line(h.set_line).begin);
  if (above == kNoStatement) return false;
  const std::string from = code_of_value(h.mode, h.from);
  const std::string to = code_of_value(h.mode, h.to);
  BlockId id = p.open_above(p.region_of[above], above + 1);
  for (; id != kNoBlock; id = p.blocks[id].parent) {
    const Block& block = p.blocks[id];
    if (block.kind != Keyword::kIf || block.end == kNoStatement || p.parts[id].empty()) continue;
    bool has_from = false;
    bool has_to = false;
    for (uint32_t line = p.at(block.opener).line + 1; line < p.at(block.end).line; ++line) {
      const std::vector<WrittenWord> words = words_of(source, source.line(line));
      has_from = has_from || find_word(words, from) != nullptr;
      has_to = has_to || find_word(words, to) != nullptr;
    }
    if (has_from && has_to) return true;
  }
  return false;
}

/// The value that the line sets: one of the two.
uint8_t value_set(const Hazard& h) {
  if (h.set_in == nullptr) return h.to;
  const Source& source = *h.set_in->source;
  const std::vector<WrittenWord> words = words_of(source, source.line(h.set_line));
  return find_word(words, code_of_value(h.mode, h.from)) != nullptr ? h.from : h.to;
}

/// Whether the move goes to zero in all axes that it names: that is one place in inches and in millimeters.
bool goes_to_zero(const Program& p, uint32_t line) {
  const std::vector<WrittenWord> words = words_of(*p.source, p.source->line(line));
  return std::ranges::all_of(words, [](const WrittenWord& word) {
    const bool goes = std::string_view("xyzabcuvwijkr").find(word.letter) != std::string_view::npos;
    return !goes || (word.value && *word.value == 0);
  });
}

/// Whether the line stops on one of the paths: that is said by another rule.
bool stops_on(const Input& in, uint32_t line) {
  return std::ranges::any_of(in.flow.stops, [&](const FlowStop& stop) {
    return stop.statement != kNoStatement && in.program.at(stop.statement).line == line;
  });
}

void check(const Input& in, Reporter& out) {
  std::set<std::tuple<Mode, const Program*, uint32_t>> said;  // the first move behind a line is enough
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kModeDependsOnPath || h.needed_in != &in.program || stops_on(in, h.needed_line)) continue;
    const uint8_t set = value_set(h);
    const uint8_t other = set == h.from ? h.to : h.from;
    const std::string one = move_under(h.mode, set);
    const std::string two = move_under(h.mode, other);
    if (one.empty() || two.empty() || comes_from_leak(in, h) || is_choice(h)) continue;
    if (h.set_in != nullptr && asks_for_mode(*h.set_in, h.mode)) continue;
    if (h.mode == Mode::kUnits && goes_to_zero(in.program, h.needed_line)) continue;
    if (!said.emplace(h.mode, h.set_in, h.set_line).second) continue;
    Finding& f = out.add(word_of_line(in.program, h.needed_line, "*"),
                         "this move " + one + " on one path, and " + two + " on another");
    relate_mode(in, f, h, set);
    f.help = "write `" + code_of_value(h.mode, set) + "` or `" + code_of_value(h.mode, other) +
        "` before this move, after the paths have joined";
    f.reach = h.reach;
    f.unproven = h.unproven;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW852",
    .name = "mode-depends-on-path",
    .summary = "a move that is incremental on one path and absolute on another, or the like",
    .group = Group::kModes,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(Two paths lead to a move, and they set a mode differently: the same line is incremental or absolute, in
inches or in millimeters, or an arc is in XY or in XZ. The paths are the branches of an `if`, a loop that
runs or does not run, or the first pass of a loop and the next one.

owlint does not report an `if` that sets the mode in both branches, such as a choice of inches or
millimeters, or a file that reads the mode (`#<_absolute>`) to restore it. If a called sub has changed the
mode, OW851 reports the call.)",
            .why =
                R"(A mode stays in effect after the `endif`, and from one pass of a loop to the next. There is no message. The
first program below goes to X50 if the probe touches nothing; otherwise it moves 50 mm from where it is.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G91
  G0 Z8
o100 endif
G0 X50
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G91
  G0 Z8
  G90
o100 endif
G0 X50
M2
)",
            .fix =
                R"(Set the mode back at the end of the branch, or once more where the paths have come together. If the
user of the program chooses the mode, and all moves are meant for either, suppress the finding.)",
            .level_reason = "Warning: the program runs, but what the move does depends on the path to it.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow852
