// OW713 angle-for-power: `^` behind a value, which is a power in other languages and the angle of a move in LinuxCNC.
// Depends on (measured): `#1=2^3` is the assignment `#1=2` and the polar word `^3`. With a motion in effect the line moves;
// without one, and beside X or Y, it stops (OW709). In brackets `^` is no operator (OW303).
#include <algorithm>

#include <fmt/format.h>

#include "analyzer/syntax/last_statement.h"
#include "analyzer/syntax/line_text.h"
#include "rules/driver/words.h"

namespace owlint::rules::ow713 {
namespace {

void report(const Input& in, Reporter& out, Span line) {
  const Program& p = in.program;
  const StatementId id = last_statement(p.syntax, line.begin);
  const bool of_line = id != kNoStatement && p.at(id).offset == line.begin;
  if (of_line && (p.at(id).has_error() || p.at(id).kind != LineKind::kWords)) return;
  const std::vector<WrittenWord> words = words_of(*p.source, line);
  const auto angle = std::ranges::find(words, '^', &WrittenWord::letter);
  if (angle == words.end() || !is_angle_for_power(*p.source, angle->span, words)) return;
  // The rule about the stop says so.
  const auto is_here = [&](const FlowStop& stop) {
    return stop.statement != kNoStatement && p.at(stop.statement).offset >= line.begin &&
        p.at(stop.statement).offset < line.end;
  };
  if (std::ranges::any_of(in.flow.stops, is_here)) return;
  const std::string written = shown(*p.source, angle->span);
  Finding& f = out.add(angle->span, fmt::format("`{}` is no power: LinuxCNC moves to this angle", written));
  f.help = fmt::format("write the power with `**`, in brackets: `[... ** {}]`", written.substr(1));
  if (of_line) f.reach = in.flow.reach(id);
}

void check(const Input& in, Reporter& out) {
  if (in.program.syntax.angle_lines.empty()) return;
  const Source& source = *in.program.source;
  const uint64_t end = source.line(in.program.syntax.last_code).end;
  for (const uint64_t begin : in.program.syntax.angle_lines) {
    if (begin >= end) return;
    const size_t behind = std::min(source.bytes().find('\n', begin), source.bytes().size());
    if (behind - begin <= kLineLimit) report(in, out, {begin, behind});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW713",
    .name = "angle-for-power",
    .summary = "`^` behind a value: LinuxCNC moves to an angle",
    .group = Group::kWords,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(`^` right behind a value, outside of brackets, on a line without `@`: `#1=#2^2`, `Z#1^2`. In brackets LinuxCNC
stops at it (OW303), and where no motion is in effect, too (OW709).)",
            .why =
                R"(In other languages `^` is a power. LinuxCNC reads the angle of a polar position, a word of its own: `#1=#2^2`
sets `#1` to the value of `#2`, and **moves** at the distance that the tool has from the origin, to 2
degrees. There is no message.)",
            .bad = R"(G21 G90
G0 X10 Y10
#1=3^2
G0 X#1
M2
)",
            .good = R"(G21 G90
G0 X10 Y10
#1=[3 ** 2]
G0 X#1
M2
)",
            .fix = R"(Write the power with `**`, in brackets.)",
            .level_reason = "Warning: LinuxCNC runs the line, and moves.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow713
