// OW316 code-after-end: lines below the program end that nothing can reach.
// Rests on: M2 and M30 end the run at once; only a call can go below them.
#include <algorithm>

#include "rules/stops.h"

namespace owlint::rules {
namespace {

/// Whether `line` belongs to a sub, where calls can lead.
bool in_sub(const Program& p, StatementId before) { return p.region_of[before] != kMainRegion && p.regions[p.region_of[before]].end != before; }

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  if (p.sub_file) return;
  // The first line behind an executed program end that no run gets to.
  StatementId end = kNoStatement;
  const auto first = std::ranges::find_if(in.index.ends, [&](StatementId id) { return in.flow.executed[id] && p.at(id).kind != LineKind::kM99; });
  for (StatementId id = first == in.index.ends.end() ? static_cast<StatementId>(p.size()) : *first; id < p.size(); ++id) {
    const Statement& s = p.at(id);
    const bool ends = (s.kind == LineKind::kProgramEnd || (s.kind == LineKind::kPercent && id > 0)) && in.flow.executed[id];
    if (ends && p.region_of[id] == kMainRegion && p.block_of[id] == kNoBlock) end = id;
    if (in.flow.executed[id] && !ends && id > 0 && p.region_of[id] == kMainRegion) end = kNoStatement;
    if (end == kNoStatement) continue;
    uint32_t line = 0;
    if (s.plain_code_follows && !in_sub(p, id) && (id == end || !in.flow.executed[id])) line = s.first_plain_line;
    if (id > end && p.region_of[id] == kMainRegion && !in.flow.executed[id] && s.kind != LineKind::kPercent && s.kind != LineKind::kProgramEnd) line = s.line;
    if (line == 0) continue;
    // Inside a block that runs past the end on another path, nothing is certain.
    bool within = false;
    for (const Block& block : p.blocks) within = within || (block.opener < end && block.end != kNoStatement && block.end > end && block.region == kMainRegion);
    if (within) return;
    const Span span = p.source->line(line);
    Finding& f = out.add(span, "no run gets to this line: the program ends on line " + std::to_string(p.at(end).line));
    relate(f, p, end, "the program ends here");
    f.help = "remove what follows, or move it before the end";
    f.reach = Reach::kNever;
    return;
  }
}

}  // namespace

extern const Rule kOw316{
    .code = "OW316",
    .name = "code-after-end",
    .summary = "lines after the program end that nothing can reach",
    .group = Group::kLine,
    .level = Severity::kWarning,
    .page = {
        .what = R"(Lines after the `M2` or `M30` that every run comes to, or after the closing `%`. Subs below the
program end are not meant: a call reads ahead to them.)",
        .why = R"(LinuxCNC never reads these lines. Moves there are never made and mistakes there are never reported;
what looks like a second operation is not cut.)",
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
        .fix = R"(Take the early program end out if the lines below are wanted, or the lines if they are not. To run a
part only sometimes, put it in an `if`.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
