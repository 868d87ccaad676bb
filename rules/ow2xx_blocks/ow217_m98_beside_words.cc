// OW217 m98-beside-words: M98 or M99 on a line with other words.
// Depends on: they call and return only as the line's first word. LinuxCNC reads all words of an M98 line, even if the line
// is skipped, and checks them against each other if it is not, but only P and L have an effect; in a sub nothing may come
// after M99.
#include <algorithm>

#include "analyzer/syntax/known_line.h"
#include "analyzer/syntax/questions.h"
#include "rules/driver/modes.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow217 {
namespace {

constexpr const char* kTimes = "write a whole number after `L`: `L3` calls the sub three times";

std::string text_of(const Program& p, Span span) {
  constexpr size_t kShown = 40;
  std::string text(p.source->slice(span));
  return text.size() > kShown ? text.substr(0, kShown - 3) + "..." : text;
}

/// Where the word with this letter stands in `text`, with a number or a numbered parameter; an empty span at 0 if there is none.
Span word_of(std::string_view text, const char* letter) {
  const size_t at = text.find_first_of(letter);
  if (at == std::string_view::npos) return {};
  const size_t end = std::min(text.find_first_not_of("#0123456789", at + 1), text.size());
  return end > at + 1 ? Span{at, end} : Span{};
}

void m98_behind(const Program& p, const Statement& s, Span word, Finding& f) {
  if (s.kind == LineKind::kM98) {
    f.message = "a second `M98` on the line: LinuxCNC makes only one call per line";
  } else {
    f.message = "`M98` comes after other words: LinuxCNC calls only if `M98` is the first word of the line";
  }
  f.help = "write `M98` with its `P` on a line of its own";
  if (p.source->slice({word.end, s.end()}).find_first_of("pP") != std::string_view::npos) {
    f.fixes.push_back(split_line(p, s, word.begin, f.help));
    return;
  }
  const std::string_view before = p.source->slice({s.offset, word.begin});
  const Span sub = word_of(before, "pP");
  const Span times = word_of(before, "lL");
  if (sub.end == 0 || before.find('(') != std::string_view::npos) return;
  std::string call = "M98 " + std::string(p.source->slice({s.offset + sub.begin, s.offset + sub.end}));
  if (times.end > 0) call += " " + std::string(p.source->slice({s.offset + times.begin, s.offset + times.end}));
  f.help = "write `" + call + "` on a line of its own";
  // With nothing else on the line it stays where it is.
  const size_t words = (sub.end - sub.begin) + (times.end - times.begin);
  const size_t letters =
      before.size() - static_cast<size_t>(std::ranges::count_if(before, [](char c) { return c == ' ' || c == '\t'; }));
  if (s.kind != LineKind::kM98 && letters == words)
    f.fixes.push_back({"write `" + call + "`", false, {{{s.offset, word.end}, indent_of(*p.source, s) + call}}});
}

void m98_words(const Program& p, const LineError& error, Finding& f) {
  const std::string text = text_of(p, error.span);
  if (error.message.starts_with("Multiple")) {
    f.message = "a second `" + text.substr(0, 1) + "` on the `M98` line";
    f.help = "write only one; call several subs on several lines";
  } else {
    f.message = "`" + text + "` is not a number of calls";
    f.help = kTimes;
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
      if (error != nullptr && error->kind == kind && error->message == interpreter) {
        f.span = error->span;
        m98_words(p, *error, f);
      } else {
        f.message = "the `L` of this `M98` is not a number of calls";
        f.help = kTimes;
      }
      break;
    case StopKind::kM99Behind:
      f.message =
          "`M99` comes after other words: LinuxCNC returns from a sub only if `M99` is the first word of the line";
      f.help = "write `M99` on a line of its own";
      f.fixes.push_back(split_line(p, s, s.keyword_span().begin, f.help));
      if (const StatementId sub = p.regions[p.region_of[id]].opener;
          sub != kNoStatement && p.at(sub).is(Keyword::kSub)) {
        const std::string jump = p.label_at(sub) + " return";
        f.message = "`M99` after other words, in a sub that `call` calls: LinuxCNC returns from it with `return`";
        f.help = "write `" + jump + "` on a line of its own";
        f.fixes[0].title = f.help;
        f.fixes[0].safe = false;
        f.fixes[0].edits.push_back({s.keyword_span(), jump});
      }
      break;
    case StopKind::kM99Jump:
    case StopKind::kM99Rest:
    default: {
      if (interpreter.starts_with("Two m codes")) {
        f.span = error->span;
        f.message = "a second code that ends the program is on the line with `M99`";
        f.help = "write one of them";
        break;
      }
      f.span = s.rest_span();
      const std::string text = text_of(p, f.span);
      const bool jump = text.find_first_not_of("pP0123456789 \t") == std::string::npos && text.find_first_of("pP") == 0;
      f.message = jump ? "`" + text + "` after `M99`: LinuxCNC cannot return to a line number"
                       : "`" + text + "` after `M99`: in a sub nothing may come after `M99`";
      f.help = jump
          ? with_free_label(in,
                            "use `M99` alone: it returns to the line after the call; choose there with `o100 if "
                            "[...]` what to do")
          : "write it on the line before `M99`";
      break;
    }
  }
  return f;
}

/// Whether the words of an M98 line that did not stop may stop it all the same: by what they compute, or by modes that are
/// not known.
bool may_stop(const Program& p, StatementId id) {
  const Statement& s = p.at(id);
  const std::string_view rest = p.source->slice(s.rest_span());
  if (surely_runs(rest)) return false;
  const uint32_t of_l = s.repeats ? 1 : 0;
  return mode_line_of(p.syntax, id) != nullptr || s.value_count > of_l || rest.find_first_of("@^") != rest.npos ||
      rest.find("53") != rest.npos;
}

/// Whether a stop is at this line, or at a question about it.
bool stops_on_line(const Input& in, StatementId id) {
  bool stops = has_stop(in, id);
  for (StatementId asks = id; asks-- > 0 && on_one_line(in.program.at(asks), in.program.at(id));)
    stops = stops || has_stop(in, asks);
  return stops;
}

/// What becomes of the words on an M98 line. Measured: LinuxCNC keeps an assignment to a name until the next line without an
/// O-word, which is usually one of the sub.
std::string_view fate_of(std::string_view words, bool may_stop) {
  if (words.starts_with("#<_")) return "carries it out only at the next line without an O-word, in the sub";
  if (words.starts_with("#<"))
    return "carries it out only at the next line without an O-word, and stops there if the sub has no such name";
  return may_stop ? "checks it and may stop here, but never executes it" : "reads it but does not execute it";
}

/// Words on an M98 line that LinuxCNC does not execute there.
void report_dropped(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  if (s.kind != LineKind::kM98 || s.has_error() || s.rest_to == s.rest_from || stops_on_line(in, id)) return;
  const std::string text = text_of(p, s.rest_span());
  const bool runs = surely_runs(p.source->slice(s.rest_span()));
  Finding& f = out.add(s.rest_span(), "`" + text + "` on an `M98` line: LinuxCNC ");
  f.message += fate_of(text, may_stop(p, id));
  // What ends a sub or the program, and would end it before the call.
  const bool ends = find_word(words_of(*p.source, s.rest_span()), "M99 M2 M30") != nullptr;
  f.help = std::string("write it on a line of its own, ") + (ends ? "after" : "before") + " `M98`";
  if (ends) f.help += ", or remove it";
  f.reach = in.flow.reach(id);
  if (!runs || s.block_delete) return;
  // Never safe: the words would begin to work.
  uint64_t blanks = s.rest_span().begin;
  while (p.source->slice({blanks - 1, blanks}).find_first_of(" \t") == 0) --blanks;
  if (ends) {
    const std::string moved =
        line_end(*p.source, s) + indent_of(*p.source, s) + std::string(p.source->slice(s.rest_span()));
    f.fixes.push_back({"write it on a line of its own, after `M98`", false, {{{blanks, s.rest_span().end}, moved}}});
    return;
  }
  f.fixes.push_back({f.help,
                     false,
                     {{{s.offset, s.offset},
                       indent_of(*p.source, s) + std::string(p.source->slice(s.rest_span())) + line_end(*p.source, s)},
                      {{blanks, s.rest_span().end}, ""}}});
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out,
            [&](const FlowStop& stop) { return &report(in, out, stop.statement, stop.kind, stop.interpreter); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError& error) {
    report(in, out, id, error.kind, error.message).reach = in.flow.reach(id);
  });
  for (const Call& call : in.program.calls) report_dropped(in, out, call.statement);
}

}  // namespace

extern const Rule kRule{
    .code = "OW217",
    .name = "m98-beside-words",
    .summary = "M98 or M99 on a line with other words",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what = R"(`G0 X5 M98 P7001`, `G0 X1 M99`, `M99 P100`, `M98 P7001 G0 X5`: a Fanuc-style call or return on a
line with other words. Only a line number and block delete may come before it, and only a comment
after it.)",
            .why = R"(M98 calls and M99 returns only as **the first word of the line**. M98 after other words stops with
`Unknown m code used: M98`. With M99 after other words, LinuxCNC first executes those words. Then in
a sub it stops with `Bug:  Reached convert_stop() from M99 as subprogram return`; in the main
program the run ends. In a sub nothing may come after M99: `Unexpected character after O-word`.
There is no `M99 P…`.

LinuxCNC reads the other words of an `M98` line, even on a skipped line, and checks them where it
calls, but **it does not execute them**: after `M98 P7001 G0 X5` the machine has not moved to X5, and
`M98 P7001 M2` does not end the program. An assignment of `#1` there is lost; one of a name is carried
out at the next line without an O-word. That line is in the sub, and if the sub has no such name, the
program stops there (`Internal error: Could not assign #<depth>`). A word that needs a code, as in
`M98 P7001 H5`, stops the program, and so does an axis word where no motion mode is on: see OW707 and
OW709.)",
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
            .fix = R"(Write M98 with its P and L on a line of its own, and M99 too.)",
            .level_reason = "Error if a run gets here and the program stops. Warning if the line runs, but without its "
                            "other words, or no run gets here.",
            .interpreter = "Bug:  Reached convert_stop() from M99 as subprogram return",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow217
