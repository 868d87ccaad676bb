// OW853 mode-assumed: a program moves before it has set its units, distance mode or plane.
// Depends on: a program begins in the modes that the last one, or the operator, has left; M2 resets G90, G17 and G54, but not the
// units.
#include <map>

#include "rules/driver/mode_hazards.h"

namespace owlint::rules::ow853 {
namespace {

/// `a`, `a and b`, `a, b and c`.
std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (size_t i = 0; i < words.size(); ++i) out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return out;
}

/// What sets the mode, as help says it.
std::string setters(Mode mode) {
  switch (mode) {
    case Mode::kUnits: return "`G21` or `G20`";
    case Mode::kDistance: return "`G90` or `G91`";
    case Mode::kPlane: return "`G17`, `G18` or `G19`";
    default: return {};
  }
}

void check(const Input& in, Reporter& out) {
  std::map<uint32_t, std::vector<const Hazard*>> lines;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind == HazardKind::kModeAssumed && h.needed_in == &in.program && !setters(h.mode).empty())
      lines[h.needed_line].push_back(&h);
  }
  for (const auto& [line, hazards] : lines) {
    std::vector<std::string> names;
    std::string help;
    for (const Hazard* h : hazards) {
      names.emplace_back(mode_name(h->mode));
      help += (help.empty() ? "write " : ", and ") + setters(h->mode);
    }
    Finding& f =
        out.add(word_of_line(in.program, line, "*"), "the program moves here before it has set its " + joined(names));
    f.help = help + " before the first move";
    f.reach = hazards.front()->reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW853",
    .name = "mode-assumed",
    .summary = "a program moves before it has set its units, distance mode and plane",
    .group = Group::kModes,
    .level = Severity::kInfo,
    .page =
        {
            .what =
                R"(The first move of a program, if no line before it sets the units (`G20`, `G21`) or the distance mode
(`G90`, `G91`). Also the first arc or drilling cycle, if no line before it sets the plane (`G17`, `G18`,
`G19`). owlint does not report files that other programs call: they run in the modes of their caller.)",
            .why =
                R"(The program runs in the modes that the last program, the operator or the INI's `RS274NGC_STARTUP_CODE` has
set. `M2` sets `G90` and `G17` again, but not the units: on a machine that has just run a program in inches,
the first program below moves 254 mm.)",
            .bad = R"(G0 X10 Y10 Z5
G1 Z-2 F80
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2 F80
G0 Z5
M2
)",
            .fix = R"(Begin each program with a line such as `G21 G90 G17`.)",
            .level_reason = "Info: many programs leave this to the machine, and on that machine they are right.",
            .interpreter = "",
            .options = "--extend-select OW853",
        },
    .check = check,
    .of_programs = true,
};

}  // namespace owlint::rules::ow853
