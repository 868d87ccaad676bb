// OW311 uppercase-o: a capital O before a label.
// Depends on: LinuxCNC changes letters to lower case before it reads a line, so this always works.
#include "rules/driver/stops.h"

namespace owlint::rules::ow311 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (StatementId id = 0; id < p.size(); ++id) {
    const Statement& s = p.at(id);
    if (s.kind != LineKind::kOWord || p.source->bytes()[s.offset + s.label_from] != 'O') continue;
    const Span letter{s.offset + s.label_from, s.offset + s.label_from + 1};
    Finding& f = out.add(letter, "a capital `O` looks like a zero");
    f.help = "write a small `o`";
    f.reach = in.flow.reach(id);
    f.fixes.push_back({"write a small `o`", true, {{letter, "o"}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW311",
    .name = "uppercase-o",
    .summary = "a capital `O` that looks like a zero",
    .group = Group::kLine,
    .level = Severity::kInfo,
    .page =
        {
            .what = R"(An O-word written with a capital `O`: `O100 sub`.)",
            .why = R"(LinuxCNC accepts both. But on a screen `O100` and `0100` look the same, and the second stops the
program, or is ignored in a skipped branch (OW307).)",
            .bad = R"(G21 G90
G0 X0 Y0 Z5
O100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
O100 endrepeat
M2
)",
            .good = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
M2
)",
            .fix = R"(Write a small `o`. If your other controls need the capital letter, leave this rule off; it is off
unless you select it.)",
            .level_reason = "Info: LinuxCNC reads both alike; the letter only matters to people.",
            .interpreter = "",
            .options = "--extend-select OW311",
        },
    .check = check,
};

}  // namespace owlint::rules::ow311
