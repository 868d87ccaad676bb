// OW306 label-malformed: an O-word whose label is missing, no integer, or a name that is not closed.
// Depends on: a label is an integer (to 0.0001) or `<name>`; after `<` everything to the end of the
// line is the name if there is no `>`, and an O-word without keyword is a program number.
#include "rules/driver/idioms.h"

namespace owlint::rules::ow306 {
namespace {

void word(const Input& in, const Statement& s, StopKind kind, Finding& f) {
  switch (kind) {
    case StopKind::kLabelMissing:
      f.message = "the O-word has no label";
      f.help = "write a number or `<name>` after the `o`";
      break;
    case StopKind::kLabelWord:
      f.message = "the O-word has no label before its keyword";
      f.help = with_free_label(in, "write a number or `<name>` after the `o`: `o100 if` or `o<name> call`");
      break;
    case StopKind::kLabelNotInteger:
    case StopKind::kM98Number:
      f.message = "`" + std::string(in.program.source->slice(s.label_span())) + "` is not a whole number";
      f.help = "use a whole number or a name in `<>`";
      break;
    default:
      f.message = "this label cannot be computed";
      f.help = "check the expression after the `o`";
      break;
  }
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const Statement& s = p.at(stop.statement);
    const LineError* error = p.syntax.error(s);
    Finding& f = out.add(error != nullptr ? error->span : s.label_span(), "");
    word(in, s, stop.kind, f);
    if (error != nullptr && error->kind == stop.kind) explain_idiom(in, stop.statement, f);
    return &f;
  });
  for_unmet_errors(in, out, [&](StatementId id, const LineError& error) {
    Finding& f = out.add(error.span, "");
    word(in, p.at(id), error.kind, f);
    explain_idiom(in, id, f);
    f.interpreter = error.message;
    f.reach = in.flow.reach(id);
  });
  // Without `>` the rest of the line is the name, and the line does nothing: no error, whatever was meant.
  for (const StatementId id : in.index.odd_lines) {
    const Statement& s = p.at(id);
    if (!s.name_open || has_stop(in, id) || in.index.spoken_for.contains(id)) continue;
    Finding& f = out.add(s.label_span(), "the label's name has no `>`: LinuxCNC does nothing on this line");
    f.help = "close the name with `>`";
    if (const Meant meant = meant_by(p, id); meant.keyword != Keyword::kUnknown) {
      const std::string name(p.source->slice({meant.words.begin, meant.name_end}));
      f.help = "write `" + name + "> " + std::string(spelling(meant.keyword)) + "`";
      f.fixes.push_back({f.help, false, {{{meant.name_end, meant.name_end}, ">"}}});
    }
    f.reach = in.flow.reach(id);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW306",
    .name = "label-malformed",
    .summary = "a label that is missing, not a whole number, or a name without its `>`",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(An `o` with no number or name after it, a number with decimals such as `o100.5`, a word without `<
>`, or a name without its `>`.)",
            .why =
                R"(`o100.5 if` stops with `Non integer value for integer`; `odrill call` and `o if` stop with `Unknown
word where unary operation could be`; an `o` alone stops with `No characters found in reading real
value`.

A missing `>` is worse: **there is no message**. In `o<drill call [10]` the whole rest of the line
becomes the name. There is no keyword left, so the interpreter takes the line for a program number
and does not call the sub. If all lines of a block lack the `>`, the block runs once, whatever its
condition is, and a sub runs like ordinary lines. If only one line lacks it, the other end has an
undefined label, or LinuxCNC looks for it up to the end of the file. Inside a sub such a line stops
with `Nested subroutine definition`.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100.5 if [#5070 EQ 1]
  G10 L20 P1 Z0
o100.5 endif
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o105 if [#5070 EQ 1]
  G10 L20 P1 Z0
o105 endif
G0 Z5
M2
)",
            .fix = R"(Use a whole number, or a name between `<` and `>`. Number labels in steps of ten, so that there is
room for more blocks.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "Non integer value for integer",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow306
