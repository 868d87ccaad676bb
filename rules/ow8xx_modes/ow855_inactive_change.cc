// OW855 inactive-change: a line sets a mode, and the next line sets it to something else.
// Depends on: the last one counts; nothing happens in between. Only what is hardly written on purpose is reported.
#include <algorithm>
#include <array>

#include "rules/driver/mode_hazards.h"

namespace owlint::rules::ow855 {
namespace {

/// Whether a line has nothing but the code of this value.
bool is_alone(const Program& p, uint32_t line, const Hazard& h, uint8_t value) {
  const std::vector<WrittenWord> words = words_of(*p.source, p.source->line(line));
  return words.size() == 1 && find_word(words, code_of_value(h.mode, value)) != nullptr;
}

/// Whether the mode was already `h.to` when the first line was reached, as far as the lines above show: a part that sets it back
/// at its end, and one that sets it again at its beginning.
bool is_set_back(const Program& p, const Hazard& h) {
  constexpr uint32_t kMostLines = 500;
  const std::string codes = codes_of_mode(h.mode);
  const std::string code = code_of_value(h.mode, h.to);
  const uint32_t last = h.set_line > kMostLines ? h.set_line - kMostLines : 0;
  for (uint32_t line = h.set_line - 1; line > last; --line) {
    const std::vector<WrittenWord> words = words_of(*p.source, p.source->line(line));
    if (find_word(words, codes) != nullptr) return find_word(words, code) != nullptr;
  }
  return false;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  constexpr std::array kReported = {Mode::kDistance, Mode::kUnits, Mode::kPlane, Mode::kArcDistance, Mode::kDiameter};
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kModeInactive || h.set_in != &p || h.needed_in != &p) continue;
    if (std::ranges::find(kReported, h.mode) == kReported.end() || h.set_line + 1 != h.needed_line) continue;
    if (!is_alone(p, h.set_line, h, h.from) || !is_alone(p, h.needed_line, h, h.to) || is_set_back(p, h)) continue;
    const std::string first = code_of_value(h.mode, h.from);
    const std::string second = code_of_value(h.mode, h.to);
    Finding& f = out.add(word_of_line(p, h.set_line, first),
                         "`" + first + "` changes nothing: `" + second + "` on the next line takes its place");
    relate_line(in, f, p, h.needed_line, second, "`" + second + "` is set here");
    f.help = "remove the line that is not meant";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW855",
    .name = "inactive-change",
    .summary = "a mode is set, and the next line sets it to something else",
    .group = Group::kModes,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A line with only `G90`, and the next line with only `G91`. The same for `G20` and `G21`, for `G17`, `G18` and
`G19`, for `G90.1` and `G91.1`, and for `G7` and `G8`.

owlint does not report lines that set more than one mode, as at the beginning of a program; a mode that the
next part sets again (`G91`, a move, `G90`, `G91`, a move); or two codes with other lines or comments between
them.)",
            .why =
                R"(The second code takes effect, and nothing has used the first. One of the two is probably a mistake. If it is
the second, all moves below it are wrong.)",
            .bad = R"(G21 G90 G17
G0 X10 Y10 Z5
G90
G91
G0 X20
M2
)",
            .good = R"(G21 G90 G17
G0 X10 Y10 Z5
G90
G0 X20
M2
)",
            .fix = R"(Remove the code that you did not mean.)",
            .level_reason =
                "Warning: the program runs, in the mode of the second line; perhaps the first one is meant.",
            .interpreter = "",
            .options = "",
            .moves = "X30",
            .moves_good = "X20",
        },
    .check = check,
};

}  // namespace owlint::rules::ow855
