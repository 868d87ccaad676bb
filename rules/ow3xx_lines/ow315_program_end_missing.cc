// OW315 program-end-missing: a program whose flow reaches the end of the file without M2, M30 or a closing `%`.
// Depends on: a file that does not begin with `%` must execute M2 or M30; reading past its last line
// is an error.
#include <algorithm>

#include "analyzer/machine/setup.h"
#include "rules/driver/remap_rules.h"
#include "rules/driver/words.h"

namespace owlint::rules::ow315 {
namespace {

/// Whether a `%` is the first of two.
bool begins_pair(const Program& p, StatementId id) {
  const auto percent = [](const Statement& s) { return s.kind == LineKind::kPercent; };
  const auto begin = p.syntax.statements.begin();
  return std::none_of(begin, begin + id, percent) && std::any_of(begin + id + 1, p.syntax.statements.end(), percent);
}

/// The first line that is not blank.
Span first_line(const Program& p) {
  uint32_t line = 1;
  while (p.source->slice(p.source->line(line)).find_first_not_of(" \t\r\v\f") == std::string_view::npos) ++line;
  return p.source->line(line);
}

/// Whether ngcgui puts the file before or after a program that it makes: a comment in the file says so, or the INI.
bool part_of_a_program(const Input& in) {
  constexpr size_t kHead = 16'384;  // bytes
  if (in.program.source->bytes().substr(0, kHead).find("(not_a_subfile)") != std::string_view::npos) return true;
  if (in.profile.setup == nullptr) return false;
  const std::string_view own = stem_of(in.program.source->path());
  return std::ranges::any_of(std::array{"NGCGUI_PREAMBLE", "NGCGUI_POSTAMBLE"}, [&](const char* key) {
    return std::ranges::any_of(in.profile.setup->ini.all("DISPLAY", key),
                               [&](const Ini::Entry* entry) { return stem_of(entry->value) == own; });
  });
}

/// The end of the program, if it is below a sub: then the sub is in the middle of the program.
StatementId end_below(const Program& p, StatementId sub) {
  const StatementId last = p.regions[p.region_of[sub]].end;
  if (p.regions[p.region_of[sub]].opener != sub || last == kNoStatement) return kNoStatement;
  for (StatementId id = last + 1; id < p.size(); ++id) {
    if (p.region_of[id] == kMainRegion && p.at(id).kind == LineKind::kProgramEnd) return id;
  }
  return kNoStatement;
}

Fix move_below(const Program& p, const Region& sub, StatementId end) {
  const Source& source = *p.source;
  const uint64_t from = p.at(sub.opener).offset;
  const uint64_t to = std::min<uint64_t>(p.at(sub.end).end() + 1, source.bytes().size());
  const uint64_t place = std::min<uint64_t>(p.at(end).end() + 1, source.bytes().size());
  std::string lines(source.slice({from, to}));
  if (place == p.at(end).end()) lines = line_end(source, p.at(sub.opener)) + lines;
  return {"move the sub below the end of the program", false, {{{from, to}, ""}, {{place, place}, std::move(lines)}}};
}

/// Whether the last line is an `M2` or `M30` that a `REMAP` line has taken away from its meaning: that is the mistake then.
bool lost_end(const Input& in, Span last, Finding& f) {
  const std::vector<WrittenWord> words = words_of(*in.program.source, last);
  for (const LostRemap& lost : lost_codes(in.profile)) {
    constexpr int kM2 = 2, kM30 = 30;
    if (lost.code.letter != 'm' || (lost.code.number != kM2 && lost.code.number != kM30)) continue;
    const auto is_code = [&](const WrittenWord& word) { return word.letter == 'm' && word.value == lost.code.number; };
    if (std::ranges::none_of(words, is_code)) continue;
    f.message = "the program does not end: because of a `REMAP`, `" + lost.name + "` does nothing";
    blame(in.profile, lost, f);
    return true;
  }
  return false;
}

/// `O1000` … `M99` below the program, which nothing calls and the program runs into.
void check_uncalled_subs(const Input& in, Reporter& out) {
  const Program& p = in.program;
  // `M98 P#1` may call any of them.
  if (std::ranges::any_of(p.calls, [](const Call& call) { return call.callee == kNoName; })) return;
  for (const StatementId id : in.index.program_numbers) {
    const Statement& s = p.at(id);
    if (p.region_of[id] != kMainRegion || !in.flow.executed[id] || s.name_open || s.has_error()) continue;
    if (p.block_of[id] != kNoBlock || p.open_above(kMainRegion, id) != kNoBlock) continue;
    uint32_t code = p.syntax.first_plain_line;
    for (StatementId above = 0; above < id && (code == 0 || code > s.line); ++above) {
      if (p.region_of[above] == kMainRegion && p.at(above).has_items()) code = p.at(above).line;
    }
    if (code == 0 || code > s.line) continue;
    const auto end = std::ranges::find_if(in.index.ends, [&](StatementId at) { return at > id; });
    if (end == in.index.ends.end() || !p.at(*end).has_m99() || p.region_of[*end] != kMainRegion ||
        !in.flow.executed[*end] || p.open_above(kMainRegion, *end) != kNoBlock)
      continue;
    Finding& f =
        out.add(s.head_span(), "the program runs into `" + p.head(id) + "`, a sub for `M98` that nothing calls");
    relate(f, p, *end, "LinuxCNC starts the program again here, for ever; `rs274` ends it here");
    f.help = "end the program with `M30` before this line";
    f.fixes.push_back({f.help, false, {{{s.offset, s.offset}, "M30" + line_end(*p.source, s)}}});
    f.reach = in.flow.reach(id);
    f.never_ends = true;
    f.unproven = true;  // `rs274` ends it
    return;
  }
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    if (stop.statement == kNoStatement && part_of_a_program(in)) return nullptr;
    if (stop.statement != kNoStatement) {
      Finding& f = out.add(p.at(stop.statement).keyword_span(), "`%` ends a program only if another `%` begins it");
      f.help = "begin the file with `%`, or end it with `M2`";
      if (!begins_pair(p, stop.statement)) return &f;
      const Span first = first_line(p);
      f.message = "`%` must be the first line of the file";
      f.help = "put `%` first, or remove it and end the program with `M2`";
      f.related.push_back({first, "this comes before it", nullptr});
      const Span line = p.source->line(p.at(stop.statement).line);
      const Span with_end{line.begin, std::min<uint64_t>(line.end + 1, p.source->bytes().size())};
      f.fixes.push_back({"put `%` first",
                         false,
                         {{{first.begin, first.begin}, std::string(p.source->slice(with_end))}, {with_end, ""}}});
      return &f;
    }
    const uint32_t line = p.syntax.last_code == 0 ? std::max(1U, p.syntax.lines) : p.syntax.last_code;
    const Span span = p.source->line(line);
    Finding& f = out.add(span, p.syntax.blank ? "the file is empty" : "the program ends without `M2`, `M30` or `%`");
    f.help = p.syntax.percent ? "end it with `%`" : "end it with `M2`";
    if (p.syntax.blank || lost_end(in, span, f)) return &f;
    const Elsewhere call = place_of(in, stop.call, stop.call_elsewhere);
    const bool by_m98 = call.program != nullptr && call.program->at(call.statement).kind == LineKind::kM98;
    if (by_m98) {
      f.message = "the sub for `M98` ends without `M99`";
      f.help = "end it with `M99`";
      if (call.program == &p) relate(in, f, call, "called here");
    }
    const std::string_view bytes = p.source->bytes();
    const std::string end = bytes.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
    const std::string text = (bytes.ends_with('\n') ? "" : end) +
        (by_m98                 ? "M99"
             : p.syntax.percent ? "%"
                                : "M2") +
        end;
    f.fixes.push_back({f.help, true, {{{bytes.size(), bytes.size()}, text}}});
    return &f;
  });
  check_uncalled_subs(in, out);
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kRunsIntoSub || h.other == kNoStatement) continue;
    const Statement& s = p.at(h.statement);
    Finding& f = out.add(s.head_span(), "the program runs into `" + p.head(h.statement) + "`, a sub for `M98`");
    relate(f, p, h.other, "LinuxCNC starts the program again here, for ever; `rs274` ends it here");
    f.reach = h.reach;
    f.never_ends = true;
    f.unproven = true;  // `rs274` ends it
    if (const StatementId end = end_below(p, h.statement); end != kNoStatement) {
      f.help = "move the sub below the end of the program, on line " + std::to_string(p.at(end).line);
      f.fixes.push_back(move_below(p, p.regions[p.region_of[h.statement]], end));
      continue;
    }
    f.help = "end the program with `M30` before this line";
    f.fixes.push_back({f.help, false, {{{s.offset, s.offset}, "M30" + line_end(*p.source, s)}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW315",
    .name = "program-end-missing",
    .summary = "the program reaches the end of the file without M2, M30 or `%`",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A program without `M2` or `M30` at its end, one that has it only in a branch, or one that begins
with `%` but has no second `%`.)",
            .why = R"(The machine makes all moves, then the interpreter reports an error at the end of the file. The job
never counts as finished, and the resets that `M2` and `M30` make are missing. If a file begins with
`%` and has no closing one, the message is `File ended with no percent sign`; a `%` only at the end
stops with `Bad character '%' used`. From 2.9.10 on the message is `File ended with no percent sign
(%) or program end (M2)`.

If there is a Fanuc-style sub below (`O1000` … `M99`), the program runs into it instead: the machine
makes the sub's moves once more, and `M99` starts the whole program again, for ever. (`rs274` ends
the program there.)

A file that other programs call needs no program end. Neither does a file that ngcgui puts before or
after a program (with `(not_a_subfile)` in it, or named in the INI as `NGCGUI_PREAMBLE` or
`NGCGUI_POSTAMBLE`).)",
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
            .level_reason = "Error: every run that gets to the end of the file stops there, after the last move.",
            .interpreter = "File ended with no percent sign or program end",
            .options = "",
        },
    .check = check,
    .of_programs = true,
};

}  // namespace owlint::rules::ow315
