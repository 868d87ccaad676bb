// OW604 name-read-only: an assignment to a parameter that only LinuxCNC can set.
// Depends on: predefined `#<_…>` names and #5400 to #5413 and #5420 to #5428 cannot be written; the
// check is made when the line is executed.
#include "rules/driver/stops.h"

namespace owlint::rules::ow604 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) -> Finding* {
    const Statement& line = p.at(s.statement);
    const bool missing = s.interpreter == "Parameter number out of range";
    const std::string what = s.detail.empty() ? "this parameter" : "`#<" + s.detail + ">`";
    Finding& f = out.add(line.whole(),
                         missing ? "there is no parameter with this number: the numbers are #1 to #5601"
                                 : what + " belongs to LinuxCNC and cannot be set");
    if (s.detail.starts_with("_ini[")) f.message = what + " is an entry of the machine's INI and cannot be set";
    f.help = "use another name or number";
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW604",
    .name = "name-read-only",
    .summary = "an assignment to a predefined or read-only parameter",
    .group = Group::kDataFlow,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(An assignment to a name that LinuxCNC predefines, such as `#<_feed>`, `#<_x>`, `#<_a>`, `#<_line>`,
`#<_task>` or `#<_value>`; to an entry of the machine's INI (`#<_ini[section]entry>`); or to a
numbered parameter that only shows the machine's state, such as `#5400` (tool) or `#5420`
(position).)",
            .why =
                R"(The interpreter stops at the line when it executes it. In a sub that nothing calls, or in a skipped
branch, there is no message. For numbers the message is `Parameter is readonly`. It is easy to
choose a global name that LinuxCNC already uses: `#<_a>` is the position of the A axis, `#<_feed>`
the current feed. Without the underscore (`#<feed>`) the name is free.)",
            .bad = R"(G21 G90
#<_feed> = 120
G0 X10 Y10 Z5
G1 Z-2 F#<_feed>
G0 Z5
M2
)",
            .good = R"(G21 G90
#<_cut_feed> = 120
G0 X10 Y10 Z5
G1 Z-2 F#<_cut_feed>
G0 Z5
M2
)",
            .fix =
                R"(Choose another name. To set the feed, the speed or the position, program it: `F120`, `S800`, `G92`.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "Cannot assign to read-only parameter #<_feed>",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow604
