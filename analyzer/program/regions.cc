// Which lines belong to which sub. A definition reaches from `sub` to the first `endsub` with its label, as the
// interpreter skips it; a Fanuc-style sub from its program number to M99.
#include <algorithm>
#include <unordered_set>

#include "analyzer/program/meant.h"

namespace owlint {
namespace {

/// The last `endsub` with the label of the `sub` at `region->opener`, before any other `sub` begins; the first one,
/// if it is another, is the early end.
void find_endsub(const Program& program, StatementId next_sub, Region* region) {
  const auto lines = program.by_label[region->name];
  StatementId first = kNoStatement;
  for (auto at = std::ranges::upper_bound(lines, region->opener); at != lines.end(); ++at) {
    if (program.at(*at).is(Keyword::kSub)) break;
    if (!program.at(*at).is(Keyword::kEndsub) || program.at(*at).refused) continue;
    // Behind another sub only the first one counts: the subs between are nested.
    if (first != kNoStatement && *at > next_sub) break;
    if (first == kNoStatement) first = *at;
    region->end = *at;
  }
  if (first != region->end) region->early_end = first;
}

/// Whether a block is open above the line `place` that began below `opener`, and its end follows before `limit`: then an M99
/// there is an early way out.
bool is_within_block(const Program& program, StatementId opener, StatementId place, StatementId limit) {
  std::vector<const Statement*> open;
  const auto close = [&](const Statement& s, Keyword kind) {
    const auto own = std::find_if(open.rbegin(), open.rend(),
                                  [&](const Statement* o) { return o->label == s.label && o->is(kind); });
    const bool found = own != open.rend();
    if (found) open.erase(std::prev(own.base()), open.end());
    return found;
  };
  const auto read = [&](StatementId id) {
    const Statement& s = program.at(id);
    if (s.kind != LineKind::kOWord || s.label == kNoName || s.refused) return;
    if (ends_block(s.keyword)) {
      close(s, opener_of(s.keyword));
    } else if (opens_block(s.keyword) && (!s.is(Keyword::kWhile) || !close(s, Keyword::kDo))) {
      open.push_back(&s);
    }
  };
  for (StatementId id = opener + 1; id < place; ++id) read(id);
  const size_t depth = open.size();
  for (StatementId id = place + 1; id < limit && open.size() >= depth; ++id) read(id);
  return open.size() < depth;
}

/// `o1 endif` at the end of `o1 sub`, where no `if` has the label.
StatementId wrong_end(const Program& program, StatementId opener, StatementId limit) {
  StatementId end = kNoStatement;
  const auto lines = program.by_label[program.at(opener).label];
  for (auto at = std::ranges::upper_bound(lines, opener); at != lines.end() && *at < limit; ++at) {
    const Statement& s = program.at(*at);
    if (opens_block(s.keyword)) return kNoStatement;
    if (ends_block(s.keyword) && !s.refused) end = *at;
  }
  return end;
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
    if (s.has_m99()) fanuc_returns.push_back(id);
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
    const auto next = std::ranges::upper_bound(subs, id);
    const StatementId next_sub = next == subs.end() ? count : *next;
    if (sub) {
      find_endsub(program, next_sub, &region);
    } else {
      // The last M99 before another sub begins: those before it are early ways out.
      const auto opener = std::ranges::find_if(program.syntax.statements.begin() + id + 1,
                                               program.syntax.statements.end(), &Statement::opens_sub);
      const auto limit = static_cast<StatementId>(opener - program.syntax.statements.begin());
      const auto m99 = std::ranges::lower_bound(fanuc_returns, limit);
      if (m99 != fanuc_returns.begin() && *std::prev(m99) > id) region.end = *std::prev(m99);
      if (region.end != kNoStatement && is_within_block(program, id, region.end, limit)) {
        region.end = kNoStatement;
        region.last = limit;
      }
    }
    if (region.end != kNoStatement) {
      region.last = region.end + 1;
    } else {
      if (region.last == 0) region.last = next_sub;
      // No other sub is open here, so an `endsub` before the next one was probably meant for this.
      for (StatementId at = id + 1; at < region.last && sub; ++at) {
        const Statement& end = program.at(at);
        const bool other_label = end.is(Keyword::kEndsub) && !end.refused;
        if (other_label || meant_by(program, at).keyword == Keyword::kEndsub) region.likely_end = at;
      }
      if (sub && region.likely_end == kNoStatement) region.likely_end = wrong_end(program, id, region.last);
      if (region.likely_end != kNoStatement) region.last = region.likely_end + 1;
    }
    const auto number = static_cast<RegionId>(program.regions.size());
    std::fill(program.region_of.begin() + id, program.region_of.begin() + region.last, number);
    id = region.last;
    program.regions.push_back(region);
  }
  program.regions[kMainRegion].last = count;
}

}  // namespace owlint
