// OW208 call-undefined: a call of a sub that is defined nowhere.
// Rests on: an unknown sub is looked for as a file, then by reading ahead to the end of the
// program; not found is an error there.
#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "rules/stops.h"

namespace owlint::rules {
namespace {

std::string number_only(const std::string& name) {
  return name.find_first_not_of("-0123456789") == std::string::npos ? name : std::string();
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  constexpr size_t kMaxCandidates = 2000;  // and as many misspelt names: beyond, nobody reads suggestions
  std::vector<std::string> known;
  std::unordered_map<std::string, const Region*> by_name;
  for (const Region& region : p.regions) {
    if (region.name == kNoName || !by_name.emplace(p.name(region.name), &region).second) continue;
    if (known.size() < kMaxCandidates) known.push_back(p.name(region.name));
  }
  size_t suggestions = 0;
  std::unordered_set<std::string> told;  // names that may be in a file elsewhere, each said once
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const Statement& s = p.at(stop.statement);
    if (stop.unproven && !told.insert(stop.detail).second) return nullptr;
    if (stop.kind == StopKind::kM98NoTarget) {
      Finding& f = out.add(s.keyword_span(), "`M98` has no `P` with the number of the sub");
      f.help = "write `M98 P100`";
      return &f;
    }
    const std::string label = number_only(stop.detail).empty() ? "o<" + stop.detail + ">" : "o" + stop.detail;
    Finding& f = out.add(s.head_span(), "no sub `" + label + "` in this program, and no file `" + stop.detail + ".ngc` in its folder");
    if (const auto found = by_name.find(stop.detail); found != by_name.end()) {
      const Region& region = *found->second;
      f.message = "`" + label + "` is not known here: its definition on line " + std::to_string(p.at(region.opener).line) + " was not run before";
      relate(f, p, region.opener, region.enclosing == kNoBlock ? "defined here" : "defined here, inside a block that may be skipped");
      f.help = "define the sub before the call, outside of blocks";
      return &f;
    }
    std::string near;
    if (number_only(stop.detail).empty() && suggestions++ < kMaxCandidates) near = nearest(stop.detail, known, 1);
    if (!near.empty()) {
      const std::string meant = number_only(near).empty() ? "o<" + near + ">" : "o" + near;
      f.help = "write `" + meant + "`";
      relate(f, p, by_name.at(near)->opener, "`" + meant + "` is defined here");
    } else if (stop.unproven) {
      f.help = "define the sub, or correct the name, unless a file on the machine's search path has it: owlint does not look there";
    } else {
      f.help = "define the sub, or correct the label";
    }
    return &f;
  });
  for_unmet_errors(in, out, [&](StatementId id, const LineError& error) {
    Finding& f = out.add(p.at(id).keyword_span(), "`M98` has no `P` with the number of the sub");
    f.interpreter = error.message;
    f.reach = Reach::kNever;
  });
  // Calls that no run gets to, of subs that nobody defines.
  for (const Call& call : p.calls) {
    if (call.callee == kNoName || call.target != UINT32_MAX || has_stop(in, call.statement)) continue;
    if (in.flow.executed[call.statement] || p.outside_subs.contains(call.callee)) continue;
    if (std::ranges::any_of(p.by_label[call.callee], [&](StatementId id) { return p.at(id).opens_sub(); })) continue;
    if (number_only(p.name(call.callee)).empty() && !in.profile.ini_given) continue;
    Finding& f = out.add(p.at(call.statement).head_span(), "no sub `" + p.label_text(call.callee) + "` is defined");
    f.help = "define the sub, or correct the label";
    f.reach = Reach::kNever;
  }
}

}  // namespace

extern const Rule kOw208{
    .code = "OW208",
    .name = "call-undefined",
    .summary = "`call` or M98 of a sub that neither the program nor a file in the search path defines",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page = {
        .what = R"(A `call`, or `M98 P…`, whose sub is neither defined in the program nor found as a file with that
name in the program folder or the machine's subroutine path.)",
        .why = R"(The interpreter first looks for a file (`o200 call` for `200.ngc`, `o<drill> call` for `drill.ngc`),
then reads ahead through the rest of the program for the `sub` line, and stops at the end of the
file. In a program between `%` signs the message is `Failed to find sub 'O200' before EOF`. It
happens when the call is executed, not when the program is loaded.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
o200 call [30]
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
        .fix = R"(Correct the name, or add the definition. owlint looks for a file of that name
beside the program only; if yours is elsewhere on the machine's search path, ignore the warning with
`(owlint: ignore OW208 -- in subs/)`.)",
        .interpreter = "EOF in file:PROGRAM seeking o-word: o<200> from line: N",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
