// OW316 code-after-end: lines below the program end that nothing can reach; lines outside of the subs in a called file.
// Depends on: M2 and M30 end the run at once; only a call can go below them. A call of a file begins at the sub of its name and
// comes back at that sub's end (measured).
#include <algorithm>

#include "analyzer/syntax/questions.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow316 {
namespace {

/// Whether `line` belongs to a sub, where calls can lead.
bool in_sub(const Program& p, StatementId before) {
  return p.region_of[before] != kMainRegion && p.regions[p.region_of[before]].end != before;
}

/// The first line of code outside of subs in the statements from `first` on, up to `last` or to a program end; 0 if
/// there is none.
uint32_t code_outside(const Input& in, StatementId first, StatementId last) {
  const Program& p = in.program;
  for (StatementId id = first; id < last; ++id) {
    const Statement& s = p.at(id);
    const bool outside = p.region_of[id] == kMainRegion;
    if (outside && s.kind == LineKind::kProgramEnd) return 0;
    if (outside && s.kind != LineKind::kPercent && !s.has_error() && !in.flow.executed[id]) return s.line;
    if (s.plain_code_follows && !in_sub(p, id)) return s.first_plain_line;
  }
  return 0;
}

/// Lines above and below the sub of a called file, which a call of it does not execute.
void check_sub_file(const Input& in, Reporter& out) {
  const Program& p = in.program;
  const auto lines = p.by_label[p.entry];
  const StatementId opener = *std::ranges::find_if(lines, [&](StatementId id) { return p.at(id).is(Keyword::kSub); });
  const std::string sub = p.label_text(p.entry);
  const auto report = [&](uint32_t line, const std::string& why, StatementId place, const std::string& words,
                          const std::string& help) {
    if (line == 0) return;
    Finding& f = out.add(p.source->line(line), "this line never runs when `" + sub + "` is called: " + why);
    relate(f, p, place, words);
    f.help = help + ", or remove it";
    f.reach = Reach::kNever;
  };
  const uint32_t before = p.syntax.first_plain_line != 0 ? p.syntax.first_plain_line : code_outside(in, 0, opener);
  report(before, "LinuxCNC begins at `" + sub + " sub`", opener, "a call begins here", "move it into the sub");
  const StatementId end = p.regions[p.region_of[opener]].end;
  if (end == kNoStatement) return;
  const std::string closed = "`" + sub + " endsub`";
  report(code_outside(in, end, static_cast<StatementId>(p.size())), "LinuxCNC goes back at " + closed, end,
         "a call ends here", "move it above " + closed);
}

/// Lines below a program end in a sub, up to the end of the sub.
void check_subs(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const StatementId end : in.index.ends) {
    const RegionId sub = p.region_of[end];
    const Statement& s = p.at(end);
    if (sub == kMainRegion || s.kind != LineKind::kProgramEnd || s.has_m99() || !in.flow.executed[end]) continue;
    if (p.regions[sub].end == kNoStatement || end >= p.regions[sub].end || may_lose_rest(p.syntax, end)) continue;
    if (p.open_above(sub, end) != kNoBlock) continue;
    const StatementId next = end + 1;
    const bool runs = p.region_of[next] != sub || next == p.regions[sub].end || in.flow.executed[next];
    const uint32_t line = s.plain_code_follows ? s.first_plain_line : runs ? 0 : p.at(next).line;
    if (line == 0) continue;
    Finding& f =
        out.add(p.source->line(line), "no run gets to this line: the program ends on line " + std::to_string(s.line));
    relate(f, p, end, "the program ends here");
    f.help = "remove the line, or move it before the end of the program";
    f.reach = Reach::kNever;
  }
}

/// Whether a call goes to a number that is computed: it may be that of any sub.
bool calls_any_number(const Program& p) {
  return std::ranges::any_of(
      p.calls, [&](const Call& call) { return call.callee == kNoName && p.at(call.statement).kind == LineKind::kM98; });
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  check_subs(in, out);
  if (p.sub_file) return check_sub_file(in, out);
  // The first line after an executed program end that no run gets to.
  StatementId end = kNoStatement;
  const auto first =
      std::ranges::find_if(in.index.ends, [&](StatementId id) { return in.flow.executed[id] && !p.at(id).has_m99(); });
  for (StatementId id = first == in.index.ends.end() ? static_cast<StatementId>(p.size()) : *first; id < p.size();
       ++id) {
    const Statement& s = p.at(id);
    const bool ends = ((s.kind == LineKind::kProgramEnd && !may_lose_rest(p.syntax, id)) ||
                       (s.kind == LineKind::kPercent && id > 0)) &&
        in.flow.executed[id];
    if (ends && p.region_of[id] == kMainRegion && p.block_of[id] == kNoBlock) end = id;
    if (in.flow.executed[id] && !ends && id > 0 && p.region_of[id] == kMainRegion) end = kNoStatement;
    if (end == kNoStatement) continue;
    uint32_t line = 0;
    if (s.plain_code_follows && !in_sub(p, id) && (id == end || !in.flow.executed[id])) line = s.first_plain_line;
    if (id > end && p.region_of[id] == kMainRegion && !in.flow.executed[id] && s.kind != LineKind::kPercent &&
        s.kind != LineKind::kProgramEnd && !s.nul)
      line = s.line;
    if (line == 0) continue;
    // Inside a block that runs past the end on another path, nothing is certain.
    bool within = false;
    for (const Block& block : p.blocks)
      within =
          within || (block.opener < end && block.end != kNoStatement && block.end > end && block.region == kMainRegion);
    if (within) return;
    if (p.at(end).kind == LineKind::kPercent && has_stop(in, end)) return;  // its own rule says so
    if (s.is(Keyword::kBare) && line == s.line && calls_any_number(p)) return;
    // These lines are a sub: what is wrong with its first one is said there, or where it is called.
    if (std::ranges::any_of(in.index.subs, [&](const auto& sub) { return sub.second > end; })) return;
    const Span span = p.source->line(line);
    Finding& f = out.add(span, "no run gets to this line: the program ends on line " + std::to_string(p.at(end).line));
    relate(f, p, end, "the program ends here");
    f.help = "remove the lines below the end, or move them before it";
    f.reach = Reach::kNever;
    return;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW316",
    .name = "code-after-end",
    .summary = "lines after the program end that no run reaches",
    .group = Group::kLine,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(Lines after an `M2` or `M30` that every run reaches, or after the closing `%`. Subs below the
program end are not reported, because a call looks ahead for them.

In a file that other programs call, lines outside the sub are reported, too. owlint takes a file for
such a file if it defines a sub with its own name and calls nothing outside that sub.)",
            .why =
                R"(LinuxCNC never reads these lines. It never makes moves there, and never reports mistakes there; what
looks like a second operation is not cut.

When a file is called, LinuxCNC skips to the sub with the file's name and returns at its `endsub`.
It executes nothing above or below: a `G21` or `#<depth> = 5` there has no effect.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G81 X10 Y10 Z-5 R2 F80
G80
M2
G0 X30 Y10
G81 X30 Y10 Z-5 R2 F80
G80
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G81 X10 Y10 Z-5 R2 F80
G80
G0 X30 Y10
G81 X30 Y10 Z-5 R2 F80
G80
M2
)",
            .fix = R"(Remove the early program end if you want the lines below it; otherwise remove the lines. If a part
should run only sometimes, put it into an `if`.)",
            .level_reason = "Warning: the program runs but these lines never do.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
    .of_programs = true,
    .fades = true,
    .leaves_out = true,
};

}  // namespace owlint::rules::ow316
