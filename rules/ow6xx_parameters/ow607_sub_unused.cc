// OW607 sub-unused: a sub that nothing calls.
// Depends on: a definition is skipped; its lines run only in a call.
#include <algorithm>

#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow607 {
namespace {

/// Whether some call has a name that is known only when it is made.
bool calls_anything(const Program& p) {
  return std::ranges::any_of(p.calls, [&](const Call& call) { return p.at(call.statement).label == kNoName; });
}

/// Subs that no line outside of them calls. What only an unused sub calls is unused for the same reason.
std::vector<RegionId> called_by_no_other(const Program& p) {
  std::vector<bool> called(p.regions.size());
  for (const Call& call : p.calls) {
    if (call.target != kNoRegion && call.target != call.caller) called[call.target] = true;
  }
  std::vector<RegionId> out;
  for (RegionId r = 1; r < p.regions.size(); ++r) {
    const StatementId opener = p.regions[r].opener;
    if (!called[r] && opener != kNoStatement && p.at(opener).is(Keyword::kSub)) out.push_back(r);
  }
  return out;
}

/// The regions that can be reached from `todo` by calls.
std::vector<bool> reached(const Program& p, std::vector<RegionId> todo,
                          const std::vector<std::vector<RegionId>>& called) {
  std::vector<bool> seen(p.regions.size());
  while (!todo.empty()) {
    const RegionId region = todo.back();
    todo.pop_back();
    if (seen[region]) continue;
    seen[region] = true;
    todo.insert(todo.end(), called[region].begin(), called[region].end());
  }
  return seen;
}

/// Whether the program has one of the turning cycles G70 to G72, which take the number of a sub as their Q word.
bool in_cycles(const Program& p) {
  const std::string_view text = p.source->bytes();
  for (size_t at = text.find_first_of("gG"); at != std::string_view::npos; at = text.find_first_of("gG", at + 1)) {
    if (at + 2 < text.size() && text[at + 1] == '7' && text[at + 2] >= '0' && text[at + 2] <= '2') return true;
  }
  return false;
}

/// The names of calls that find no sub, not more than anybody corrects.
std::vector<std::string> undefined_calls(const Input& in) {
  constexpr size_t kMost = 50;
  std::vector<std::string> names;
  const auto stops = in.index.by_code.find("OW208");
  if (stops == in.index.by_code.end()) return names;
  for (const FlowStop* stop : stops->second) {
    if (names.size() < kMost) names.push_back(stop->detail);
  }
  return names;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::vector<RegionId> alone = called_by_no_other(p);
  if (alone.empty() || does_nothing(p)) return;  // other programs call a collection of subs
  if (!p.syntax.errors.empty()) return;          // the call may be on a line that is broken
  std::unordered_set<std::string> from_files;
  for (const LinkedFile& file : in.linked.files()) {
    if (calls_anything(*file.program)) return;
    if (file.program.get() == &p) continue;
    for (const Call& call : file.program->calls) from_files.insert(file.program->name(call.callee));
  }
  std::vector<std::vector<RegionId>> called(p.regions.size());
  for (const Call& call : p.calls) {
    if (call.target != kNoRegion) called[call.caller].push_back(call.target);
  }
  const std::string own_name = small_letters(stem_of(p.source->path()));
  std::vector<RegionId> begins{kMainRegion};
  for (RegionId r = 1; r < p.regions.size(); ++r) {
    const NameId name = p.regions[r].name;
    if (name == kNoName || p.name(name) == own_name || from_files.contains(p.name(name))) begins.push_back(r);
  }
  const std::vector<bool> used = reached(p, begins, called);
  std::unordered_map<NameId, size_t> definitions;
  for (const Region& region : p.regions) ++definitions[region.name];
  std::erase_if(alone, [&](RegionId r) { return used[r] || definitions[p.regions[r].name] > 1; });
  if (alone.empty() || !in.data.structure().regular || in_cycles(p)) return;
  const std::vector<std::string> undefined = undefined_calls(in);
  for (const RegionId r : alone) {
    const Region& region = p.regions[r];
    // The call that is meant for it is reported where its name is misspelled.
    if (!nearest(p.name(region.name), undefined, 1).empty()) continue;
    Finding& f = out.add(p.at(region.opener).head_span(), "nothing calls " + region_words(p, r));
    f.help = "call it or remove it; check that the calls have this label";
    f.reach = in.flow.reach(region.opener);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW607",
    .name = "sub-unused",
    .summary = "a sub that nothing calls",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A sub that neither the program nor a file that it calls ever calls. A file's own sub (with the name
of the file) is not reported, because other programs call it; nor is a file that has only subs. If a
call has a computed label, nothing is reported.)",
            .why = R"(LinuxCNC skips the definition. That is harmless, but the moves in it are never made: a call is
missing, or it has another label. In the first program below the hole at X20 is missing.)",
            .bad = R"(G21 G90
o100 sub
  G0 X#1
  G1 Z-5 F80
  G0 Z5
o100 endsub
o200 sub
  G0 X20
  G1 Z-8 F80
  G0 Z5
o200 endsub
G0 Z5
o100 call [10]
M2
)",
            .good = R"(G21 G90
o100 sub
  G0 X#1
  G1 Z-5 F80
  G0 Z5
o100 endsub
o200 sub
  G0 X20
  G1 Z-8 F80
  G0 Z5
o200 endsub
G0 Z5
o100 call [10]
o200 call
M2
)",
            .fix = R"(Call the sub, or remove it. If you keep a sub for later, suppress the finding with a reason.)",
            .level_reason = "Warning: the program runs without the sub; perhaps a call is missing or misspelt.",
            .interpreter = "",
            .options = "",
            .moves = "X10",
            .moves_good = "X20",
        },
    .check = check,
};

}  // namespace owlint::rules::ow607
