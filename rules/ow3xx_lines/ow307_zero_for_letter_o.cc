// OW307 zero-for-letter-o: the figure zero typed where the letter O belongs.
// Depends on: a line cannot begin with a digit; while skipping, the line is not an O-word and ends
// nothing.
#include <algorithm>
#include <vector>

#include "rules/driver/idioms.h"

namespace owlint::rules::ow307 {
namespace {

/// The lines with this mistake that belong together by their label: a block is a block again only if all of its lines are
/// corrected.
std::vector<StatementId> lines_with(const Program& p, StatementId id) {
  const Statement& s = p.at(id);
  std::vector<StatementId> lines;
  if (s.label == kNoName) return {id};
  for (const StatementId other : p.by_label[s.label]) {
    const LineError* error = p.syntax.error(p.at(other));
    const bool one_space = global_label(s.keyword)
        ? global_label(p.at(other).keyword)
        : !global_label(p.at(other).keyword) && p.region_of[other] == p.region_of[id];
    if (error != nullptr && error->kind == StopKind::kZeroForO && one_space) lines.push_back(other);
  }
  if (std::ranges::find(lines, id) == lines.end()) lines.push_back(id);
  return lines;
}

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  Finding& f =
      out.add(p.syntax.error(p.at(id))->span, "this O-word begins with the digit zero instead of the letter O");
  f.help = "write the letter `o`";
  constexpr size_t kMost = 20;  // of one label
  const size_t words = p.at(id).label == kNoName ? 1 : p.by_label[p.at(id).label].size();
  const bool all = words <= 10 * kMost;
  std::vector<StatementId> lines = all ? lines_with(p, id) : std::vector{id};
  const bool safe = all && lines.size() <= kMost;
  if (!safe) lines = {id};
  Fix fix{lines.size() > 1 ? "write the letter `o` on all lines of the label" : f.help, safe, {}, true};
  for (const StatementId line : lines) {
    const uint64_t zero = p.syntax.error(p.at(line))->span.begin;
    fix.edits.push_back({{zero, zero + 1}, "o"});
    const Statement& s = p.at(line);
    fix.safe = fix.safe && !bounds_sub(s) && (!s.is(Keyword::kCall) || calls_known_subs(in, p.head(line)));
  }
  f.fixes.push_back(std::move(fix));
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError&) { report(in, out, id)->reach = in.flow.reach(id); });
}

}  // namespace

extern const Rule kRule{
    .code = "OW307",
    .name = "zero-for-letter-o",
    .summary = "the digit 0 instead of the letter O",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A line such as `0100 sub` or `01 endif` that begins with the digit zero and looks like an O-word. On
many screens and printouts the two look the same.)",
            .why = R"(The interpreter stops at the line. While it skips, or in a sub that nothing calls, it ignores the
line: a `01 else` does not count, a `01 endif` does not end its block, and LinuxCNC skips everything
below, up to the end of the file.)",
            .bad = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
0100 call [30]
M2
)",
            .good = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
o100 call [30]
M2
)",
            .fix = R"(Write a small `o`: it does not look like a zero.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "Bad character '0' used",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow307
