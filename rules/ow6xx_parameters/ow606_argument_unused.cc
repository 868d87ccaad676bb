// OW606 argument-unused: a call passes an argument that its sub never reads.
// Depends on: arguments are #1 to #30 of the sub, and nothing else sees them.
#include <bit>

#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow606 {
namespace {

/// Whether the sub only assigns each argument behind the last that it reads, and the caller reads the parameter that it passes
/// there after the call: they are meant as results, and OW605 says what becomes of them.
bool are_results(const Input& in, const Call& call, uint32_t read) {
  const Program& p = in.program;
  const std::span<const ExprId> values = p.syntax.values_of(p.at(call.statement));
  const uint32_t left = in.data.left_behind(call.target);
  for (uint32_t i = read; i < values.size(); ++i) {
    const auto key = passed_parameter(p, values[i]);
    if (i + 1 >= flow::kFirstGlobalNumber || (left >> (i + 1) & 1) == 0 || !key) return false;
    if (!in.data.reads_after(call.statement, *key)) return false;
  }
  return true;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Call& call : p.calls) {
    const Statement& s = p.at(call.statement);
    if (call.target == kNoRegion || s.kind == LineKind::kM98 || s.value_count == 0 || s.has_error()) continue;
    if (in.data.surely_reads(call.target, s.value_count)) continue;
    const flow::Summary& sub = in.data.of(call.target);
    if (!sub.known || sub.any_number) continue;
    // An argument in the middle has to be passed because of those after it.
    const int read = sub.last_argument();
    if (s.value_count <= read || are_results(in, call, static_cast<uint32_t>(read))) continue;
    const std::string reads = read == 0 ? "reads none"
        : read == 1                     ? "reads only `#1`"
                                        : "reads only `#1` to `#" + std::to_string(read) + "`";
    Finding& f = out.add(s.head_span(),
                         "`" + p.head(call.statement) + "` passes " + std::to_string(s.value_count) +
                             (s.value_count == 1 ? " argument" : " arguments") + ", but the sub " + reads);
    relate(f, p, p.regions[call.target].opener, "the sub begins here");
    f.help = "remove the argument, or use it in the sub";
    f.reach = in.flow.reach(call.statement);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW606",
    .name = "argument-unused",
    .summary = "an argument that the sub never reads",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A call passes more arguments than its sub reads, and the sub is in the same program. For example,
the call passes a feed but the sub has a fixed number, or there is one `[...]` too many.)",
            .why = R"(LinuxCNC accepts up to 30 arguments for every sub, and gives no message if the sub does not read
them. The value in the call has no effect: in the first program below, the machine goes to X0.)",
            .bad = R"(G21 G90
o100 sub
  G0 Z5
  G0 X#<_x_start>
o100 endsub
#<_x_start> = 0
G0 X50 Z5
o100 call [20]
M2
)",
            .good = R"(G21 G90
o100 sub
  G0 Z5
  G0 X#1
o100 endsub
G0 X50 Z5
o100 call [20]
M2
)",
            .fix = R"(Remove the unused arguments from the call, or read them in the sub.)",
            .level_reason = "Warning: the program runs, and the argument has no effect.",
            .interpreter = "",
            .options = "",
            .moves = "X0",
            .moves_good = "X20",
        },
    .check = check,
};

}  // namespace owlint::rules::ow606
