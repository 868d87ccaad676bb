// Which lines belong to which sub. A definition reaches from `sub` to the first `endsub` with its label, as the
// interpreter passes over it; a Fanuc-style sub from its program number to M99.
#include <algorithm>
#include <unordered_set>

#include "analyzer/program/program.h"

namespace owlint {
namespace {

/// The `endsub` with the label of the `sub` at `opener`, unless the label's next `sub` comes first.
StatementId matching_endsub(const Program& program, StatementId opener) {
  const auto& lines = program.by_label[program.at(opener).label];
  for (auto at = std::ranges::upper_bound(lines, opener); at != lines.end(); ++at) {
    if (program.at(*at).is(Keyword::kEndsub)) return *at;
    if (program.at(*at).is(Keyword::kSub)) break;
  }
  return kNoStatement;
}

bool later_in(const std::vector<StatementId>& sorted, StatementId from, StatementId to) {
  const auto found = std::ranges::lower_bound(sorted, from);
  return found != sorted.end() && *found < to;
}

}  // namespace

void find_regions(Program& program) {
  program.regions.assign(1, Region{});
  const auto count = static_cast<StatementId>(program.size());
  program.region_of.assign(count, kMainRegion);

  std::unordered_set<NameId> fanuc_subs;  // program numbers that some M98 calls
  std::vector<StatementId> subs;
  std::vector<StatementId> fanuc_returns;
  for (StatementId id = 0; id < count; ++id) {
    const Statement& s = program.at(id);
    if (s.kind == LineKind::kM98 && s.label != kNoName) fanuc_subs.insert(s.label);
    if (s.is(Keyword::kSub)) subs.push_back(id);
    if (s.kind == LineKind::kM99) fanuc_returns.push_back(id);
  }

  for (StatementId id = 0; id < count;) {
    const Statement& s = program.at(id);
    const bool sub = s.is(Keyword::kSub) && s.label != kNoName;
    const bool fanuc = s.is(Keyword::kBare) && s.label != kNoName && fanuc_subs.contains(s.label);
    if (!sub && !fanuc) {
      ++id;
      continue;
    }
    Region region;
    region.name = s.label;
    region.opener = id;
    if (sub) {
      region.end = matching_endsub(program, id);
    } else if (const auto m99 = std::ranges::upper_bound(fanuc_returns, id); m99 != fanuc_returns.end()) {
      region.end = *m99;
    }
    if (region.end != kNoStatement) {
      region.last = region.end + 1;
    } else {
      const auto next = std::ranges::upper_bound(subs, id);
      region.last = next == subs.end() ? count : *next;
      for (StatementId at = id + 1; at < region.last && sub; ++at) {
        // An `endsub` whose own `sub` does not exist was probably meant for this one.
        const Statement& other = program.at(at);
        if (!other.is(Keyword::kEndsub) || other.label == kNoName) continue;
        const auto& lines = program.by_label[other.label];
        if (std::ranges::any_of(lines, [&](StatementId l) { return program.at(l).is(Keyword::kSub); })) continue;
        region.likely_end = at;
        region.last = at + 1;
        break;
      }
      if (region.likely_end == kNoStatement && later_in(subs, id + 1, count)) region.last = *next;
    }
    const auto number = static_cast<RegionId>(program.regions.size());
    std::fill(program.region_of.begin() + id, program.region_of.begin() + region.last, number);
    id = region.last;
    program.regions.push_back(region);
  }
  program.regions[kMainRegion].last = count;
}

}  // namespace owlint
