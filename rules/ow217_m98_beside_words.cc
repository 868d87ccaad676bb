// OW217 m98-beside-words: M98 or M99 on a line with other words.
// Depends on: both are a call and a return only as the line's first word. All words of an M98 line are read, even where it
// is skipped, and none but P and L does anything; in a sub nothing may stand behind M99.
#include "analyzer/syntax/known_line.h"
#include "rules/stops.h"

namespace owlint::rules {
namespace {

std::string text_of(const Program& p, Span span) {
  constexpr size_t kShown = 40;
  std::string text(p.source->slice(span));
  return text.size() > kShown ? text.substr(0, kShown - 3) + "..." : text;
}

void m98_behind(const Program& p, const Statement& s, Span word, Finding& f) {
  if (s.kind == LineKind::kM98) {
    f.message = "a second `M98` stands on the line: LinuxCNC makes one call for a line";
  } else {
    f.message = "`M98` stands behind other words: LinuxCNC makes a call only where `M98` is the line's first word";
  }
  f.help = "put `M98` with its `P` on a line of its own";
  if (p.source->slice({word.end, s.end()}).find_first_of("pP") != std::string_view::npos) f.fixes.push_back(split_line(p, s, word.begin, f.help));
}

void m98_words(const Program& p, const LineError& error, Finding& f) {
  const std::string text = text_of(p, error.span);
  if (error.message.starts_with("Multiple")) {
    f.message = "a second `" + text.substr(0, 1) + "` stands on the `M98` line";
    f.help = "write one; several subs are called on several lines";
  } else {
    f.message = "`" + text + "` is no number of calls";
    f.help = "give `L` a whole number: `L3` calls the sub three times";
  }
}

Finding& report(const Input& in, Reporter& out, StatementId id, StopKind kind, const std::string& interpreter) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  const LineError* error = p.syntax.error(s);
  Finding& f = out.add(s.keyword_span(), "");
  f.interpreter = interpreter;
  switch (kind) {
    case StopKind::kM98Behind:
      f.span = error->span;
      m98_behind(p, s, error->span, f);
      break;
    case StopKind::kM98Words:
      f.span = error != nullptr ? error->span : s.keyword_span();
      m98_words(p, error != nullptr ? *error : LineError{kind, s.rest_span(), interpreter}, f);
      if (error == nullptr) f.message = "the `L` of this `M98` is no number of calls";
      break;
    case StopKind::kM99Behind:
      f.message = "`M99` stands behind other words: LinuxCNC returns from a sub only where `M99` is the line's first word";
      f.help = "put `M99` on a line of its own";
      f.fixes.push_back(split_line(p, s, s.keyword_span().begin, f.help));
      break;
    case StopKind::kM99Jump: case StopKind::kM99Rest: default: {
      if (interpreter.starts_with("Two m codes")) {
        f.span = error->span;
        f.message = "a second code that ends the program is on the line with `M99`";
        f.help = "write one of them";
        break;
      }
      f.span = s.rest_span();
      const std::string text = text_of(p, f.span);
      const bool jump = text.find_first_not_of("pP0123456789 \t") == std::string::npos && text.find_first_of("pP") == 0;
      f.message = jump ? "`" + text + "` stands behind `M99`: LinuxCNC cannot return to a line number"
                       : "`" + text + "` stands behind `M99`, where nothing may stand in a sub";
      f.help = jump ? "write `M99` alone: it returns behind the call; choose what to do there with `o100 if [...]`" : "put it on the line before `M99`";
      break;
    }
  }
  return f;
}

/// What LinuxCNC reads on an M98 line and does not do.
void report_dropped(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  if (s.kind != LineKind::kM98 || s.error != UINT32_MAX || s.rest_to == s.rest_from || has_stop(in, id)) return;
  const std::string text = text_of(p, s.rest_span());
  Finding& f = out.add(s.rest_span(), "`" + text + "` stands on an `M98` line: LinuxCNC reads it and does not do it");
  f.help = "put it on a line of its own, before `M98`";
  f.reach = in.flow.reach(id);
  if (!surely_runs(p.source->slice(s.rest_span())) || s.block_delete) return;
  // Never safe: the words would begin to work.
  uint64_t blanks = s.rest_span().begin;
  while (p.source->slice({blanks - 1, blanks}).find_first_of(" \t") == 0) --blanks;
  f.fixes.push_back({f.help, false, {{{s.offset, s.offset}, indent_of(*p.source, s) + std::string(p.source->slice(s.rest_span())) + line_end(*p.source, s)},
                                     {{blanks, s.rest_span().end}, ""}}});
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) { return &report(in, out, stop.statement, stop.kind, stop.interpreter); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError& error) {
    report(in, out, id, error.kind, error.message).reach = in.flow.reach(id);
  });
  for (const Call& call : in.program.calls) report_dropped(in, out, call.statement);
}

}  // namespace

extern const Rule kOw217{
    .code = "OW217",
    .name = "m98-beside-words",
    .summary = "M98 or M99 on a line with other words",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page = {
        .what = R"(`G0 X5 M98 P7001`, `G0 X1 M99`, `M99 P100`, `M98 P7001 G0 X5`: lines on which a call or a return of the
Fanuc kind stands beside other words. A line number and block delete may stand before it, a comment behind it.)",
        .why = R"(For LinuxCNC, M98 calls and M99 returns only as **the first word of the line**. M98 behind other words
stops with `Unknown m code used: M98`. M99 behind other words first carries them out, then stops with
`Bug:  Reached convert_stop() from M99 as subprogram return` in a sub; in the main program it ends the run. In a
sub nothing may stand behind M99: `Unexpected character after O-word`. There is no `M99 P…`.

Words behind `M98 P…` are read, and checked even where the line is skipped, but **nothing of them is done**: after
`M98 P7001 G0 X5` the machine has not moved to X5, and `M98 P7001 M2` does not end the program. An assignment there
is lost.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
G0 X0 Y0 Z5
M98 P7001 L3
M2
O7001
  G91 G1 Z-1 F80
  G90 G0 Z5 M99
)",
        .good = R"(G21 G90
G0 X0 Y0 Z5
M98 P7001 L3
M2
O7001
  G91 G1 Z-1 F80
  G90 G0 Z5
M99
)",
        .fix = R"(Give M98 with its P and L, and M99, a line of their own.)",
        .level_reason = "Error where a run gets here and the program stops. Warning where the line runs, but without its other words, or no run gets here.",
        .interpreter = "Bug:  Reached convert_stop() from M99 as subprogram return",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
