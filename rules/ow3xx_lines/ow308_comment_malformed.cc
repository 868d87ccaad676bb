// OW308 comment-malformed: a comment inside a comment, or one that is not closed on its line.
// Depends on: comments are found while the line is read, before anything else, in skipped lines and
// uncalled subs too.
#include "analyzer/syntax/known_line.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow308 {
namespace {

/// Whether what stands behind the `(` is words that LinuxCNC would carry out, or the `(` is within a number.
bool holds_words(const Program& p, Span comment) {
  const std::string_view text = p.source->slice(comment);
  if (text.empty()) return false;
  const std::string_view inside = text.substr(1);
  if (inside.find_first_not_of(" \t") == std::string_view::npos) return false;
  if (!surely_refused(std::string(inside))) return true;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool digit_before = comment.begin > 0 && is_digit(p.source->bytes()[comment.begin - 1]);
  return digit_before && is_digit(inside[0]);
}

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const LineError* error = in.program.syntax.error(in.program.at(id));
  const bool nested = error->kind == StopKind::kCommentNested;
  Finding& f = out.add(error->span,
                       nested ? "a comment begins inside another comment" : "the comment is not closed on its line");
  f.help = nested ? "use other brackets inside the comment" : "close it with `)`, or begin it with `;`";
  // All of the rest is then a comment, unless it is words: `X50( Z10`.
  if (!nested && !holds_words(in.program, error->span))
    f.fixes.push_back({"close the comment at the end of the line", false, {{{error->span.end, error->span.end}, ")"}}});
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError&) {
    Finding* f = report(in, out, id);
    f->reach = Reach::kNever;
    // One habit of the author, if no run gets that far.
    if (f->fixes.empty()) f->group = in.program.source->path();
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW308",
    .name = "comment-malformed",
    .summary = "a nested or unclosed comment",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `(` inside a `( … )` comment, or a `(` without its `)` on the same line. A comment cannot have
several lines.)",
            .why = R"(The interpreter stops when it reads the line, even in a branch that is not taken or in a sub that
nothing calls, because it removes comments first. The two messages are `Nested comment found` and
`Unclosed comment found`. After `;` any text is allowed, brackets too. A `)` without `(` is not a
comment: it stops with `Bad character ')' used` when the line is executed.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
(drill 4 holes (deep) through the plate)
G81 X10 Y10 Z-12 R2 F80
X30
Y30
X10
G80
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
(drill 4 holes, deep, through the plate)
G81 X10 Y10 Z-12 R2 F80
X30
Y30
X10
G80
M2
)",
            .fix = R"(Use `[ ]` or a dash inside comments, or begin the comment with `;`.)",
            .level_reason = "Error if a run reads the line: the program stops. Warning if no run does.",
            .interpreter = "Nested comment found",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow308
