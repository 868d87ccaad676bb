// OW315 program-end-missing: a program whose flow reaches the end of the file without M2, M30 or a closing `%`.
// Rests on: a file that does not begin with `%` must execute M2 or M30; reading past its last line
// is an error.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    if (stop.statement != kNoStatement) {
      Finding& f = out.add(p.at(stop.statement).keyword_span(), "`%` ends a program only where another `%` begins it");
      f.help = "begin the file with `%`, or end it with `M2`";
      return &f;
    }
    const uint32_t line = p.syntax.last_code == 0 ? std::max(1U, p.syntax.lines) : p.syntax.last_code;
    const Span span = p.source->line(line);
    Finding& f = out.add(span, p.syntax.blank ? "the file is empty" : "the program ends without `M2`, `M30` or `%`");
    f.help = p.syntax.percent ? "end it with `%`" : "end it with `M2`";
    if (p.syntax.blank) return &f;
    const std::string_view bytes = p.source->bytes();
    const std::string end = bytes.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
    const std::string text = (bytes.ends_with('\n') ? "" : end) + (p.syntax.percent ? "%" : "M2") + end;
    f.fixes.push_back({f.help, true, {{{bytes.size(), bytes.size()}, text}}});
    return &f;
  });
}

}  // namespace

extern const Rule kOw315{
    .code = "OW315",
    .name = "program-end-missing",
    .summary = "the flow reaches the end of the file without M2, M30 or `%`",
    .group = Group::kLine,
    .level = Severity::kError,
    .page = {
        .what = R"(A program without `M2` or `M30` at its end, one that has it only inside a branch, or one that begins
with `%` and lacks the second `%`.)",
        .why = R"(All moves are made, then the interpreter reports an error at the end of the file: the job never
counts as finished, and the resets that come with `M2` and `M30` are not done. In a file that begins
with `%` and lacks the closing one the message is `File ended with no percent sign`; a `%` only at
the end stops with `Bad character '%' used`. From 2.9.10 the message reads
`File ended with no percent sign (%) or program end (M2)`.

Files that hold only subs for other programs need no program end.)",
        .bad = R"(G21 G90
S1200 M3
G0 X10 Y10 Z5
G81 X10 Y10 Z-5 R2 F80
X30
G80
M5
)",
        .good = R"(G21 G90
S1200 M3
G0 X10 Y10 Z5
G81 X10 Y10 Z-5 R2 F80
X30
G80
M5
M2
)",
        .fix = R"(End the program with `M2` or `M30`, on a line that every run reaches.)",
        .interpreter = "File ended with no percent sign or program end",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
