// OW309 line-too-long: a line with more characters than the interpreter's buffer takes.
// Depends on: 252 characters and a line feed are read, one more is an error; skipped lines and
// comments count.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow309 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Statement& s = in.program.at(id);
  const Source& source = *in.program.source;
  Span span = in.program.syntax.error(s)->span;
  // Not from within a letter that is written with several bytes.
  const auto begins_inside = [&] { return (static_cast<unsigned char>(source.slice(span)[0]) & 0xC0) == 0x80; };
  while (span.begin > s.offset && begins_inside()) --span.begin;
  const bool several = std::ranges::any_of(source.slice(s.whole()), is_foreign);
  Finding& f = out.add(span,
                       "the line has " + std::to_string(s.length) +
                           (several ? " bytes, and letters with accents have several; LinuxCNC reads at most 252"
                                    : " characters; LinuxCNC reads at most 252"));
  f.help = "split the line, or shorten the comment";
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError&) { report(in, out, id)->reach = Reach::kNever; });
}

}  // namespace

extern const Rule kRule{
    .code = "OW309",
    .name = "line-too-long",
    .summary = "a line longer than LinuxCNC reads",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A line of more than 252 characters, with spaces and comment. The line end does not count.)",
            .why = R"(The interpreter stops when it reads the line, anywhere before the program end: in a comment, in a
skipped branch, in a sub that nothing calls. Some post-processors write a whole job description into
one comment.)",
            .bad = R"(G21 G90
(part 4711 rev C, plate 160x120x12 EN AW-6082, clamp in the low vice with parallels 12 mm, stop on the left, zero on the upper left corner and on the top face, check the height of the clamps before the first run, tool 1 drill 8.5, tool 2 tap M10, tool 3 countersink 90 degrees, deburr all edges 0.3)
G0 X10 Y10 Z5
G81 X10 Y10 Z-12 R2 F80
G80
M2
)",
            .good = R"(G21 G90
(part 4711 rev C, plate 160x120x12 EN AW-6082, clamp in the low vice with parallels 12 mm)
(stop on the left, zero on the upper left corner and on the top face)
G0 X10 Y10 Z5
G81 X10 Y10 Z-12 R2 F80
G80
M2
)",
            .fix = R"(Split the comment, the expression or the call over several lines. Put a part of a long expression
into a named parameter first.)",
            .level_reason = "Error if a run reads the line: the program stops. Warning if no run does.",
            .interpreter = "Command too long",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow309
