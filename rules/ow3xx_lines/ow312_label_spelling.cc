// OW312 label-spelling: a label in an unusual spelling, or in several spellings.
// Depends on: numbers are compared by value, and names without spaces and in lower case, so this
// always works.
#include "rules/driver/stops.h"

namespace owlint::rules::ow312 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (StatementId id = 0; id < p.size(); ++id) {
    const Statement& s = p.at(id);
    if (s.kind != LineKind::kOWord || s.label == kNoName || s.name_open) continue;
    const std::string written(p.source->slice(s.label_span()));
    const std::string plain = s.named ? "o<" + p.name(s.label) + ">" : p.label_text(s.label);
    // The letter itself is OW311's, or OW307's.
    if (written[0] == '0' || written.substr(1) == plain.substr(1) || written.find_first_of("[#") != std::string::npos)
      continue;
    Finding& f = out.add(s.label_span(), "`" + written + "` is read as `" + plain + "`");
    f.help = "write `" + plain + "`";
    f.reach = in.flow.reach(id);
    f.fixes.push_back({"write `" + plain + "`", true, {{s.label_span(), plain}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW312",
    .name = "label-spelling",
    .summary = "leading zeros, decimals, spaces or capital letters in a label",
    .group = Group::kLine,
    .level = Severity::kInfo,
    .page =
        {
            .what = R"(A label with leading zeros (`o0100`), decimals (`o100.0`), a sign, spaces inside (`o 100`, `o<my
sub>`) or capital letters in a name (`o<Drill>`).)",
            .why =
                R"(LinuxCNC reads `o0100`, `o100.0`, `o 1 0 0` and `o<100>` as `o100`, and `o<My Sub>` as `o<mysub>`. A
search for the label does not find them all. The file for `o<Drill> call` must have the name
`drill.ngc`, in small letters.)",
            .bad = R"(G21 G90
G0 X0 Y0 Z5
o0100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o0100 endrepeat
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
            .fix = R"(Write a label the same way everywhere: plain digits, or small letters without spaces. This rule is
off unless you select it.)",
            .level_reason = "Info: LinuxCNC reads both spellings as one label.",
            .interpreter = "",
            .options = "--extend-select OW312",
        },
    .check = check,
};

}  // namespace owlint::rules::ow312
