#include "rules/driver/unreached.h"

#include <algorithm>

#include <fmt/format.h>

#include "analyzer/syntax/last_statement.h"
#include "rules/driver/behind_stops.h"
#include "rules/driver/stops.h"

namespace owlint::rules {

Unreached::Unreached(const Input& in)
    : in_(in), last_(in.program.size()), first_call_(in.program.syntax.names.size(), kNoStatement) {
  for (const Call& call : in.program.calls) {
    if (call.callee == kNoName)
      calls_computed_ = true;
    else if (first_call_[call.callee] == kNoStatement)
      first_call_[call.callee] = call.statement;
  }
  stop_ = stop_of_every_run(in.flow);
  std::vector<StatementId> last(in.program.regions.size(), kNoStatement);
  for (StatementId id = 0; id < last_.size(); ++id) {
    StatementId& known = last[in.program.region_of[id]];
    last_[id] = known;
    if (in.flow.executed[id]) known = id;
    // A call that is refused is meant as one.
    const Statement& s = in.program.at(id);
    if (s.keyword == Keyword::kCall && s.label != kNoName && first_call_[s.label] == kNoStatement)
      first_call_[s.label] = id;
  }
}

std::optional<Related> Unreached::reason(uint64_t offset) const {
  const Program& p = in_.program;
  const StatementId id = last_statement(p.syntax, offset);
  if (id == kNoStatement) return std::nullopt;
  if (in_.flow.executed[id]) return std::nullopt;
  const RegionId region = p.region_of[id];
  // The `sub` line is executed when the definition is skipped, too.
  if (region != kMainRegion && (last_[id] == kNoStatement || last_[id] == p.regions[region].opener))
    return of_sub(region);
  return of(id);
}

/// A sub that no run enters.
std::optional<Related> Unreached::of_sub(RegionId region) const {
  const Program& p = in_.program;
  const NameId sub = p.regions[region].name;
  const StatementId opener = p.regions[region].opener;
  if (sub == kNoName || calls_computed_) return at(opener, "no run gets here");
  const StatementId call = first_call_[sub];
  if (call != kNoStatement) return in_.flow.executed[call] ? at(opener, "no run gets here") : of(call);
  if (sub == p.entry) return std::nullopt;  // other files call it
  return Related{p.at(opener).head_span(), fmt::format("nothing in this file calls `{}`", p.label_text(sub)), nullptr};
}

/// A line after others of its sub, or of the main program.
std::optional<Related> Unreached::of(StatementId statement) const {
  const Program& p = in_.program;
  const StatementId last = last_[statement];
  if (last == kNoStatement) return at(statement, "no run gets here");
  const Statement& s = p.at(last);
  if (stop_ != kNoStatement && (last == stop_ || s.is(Keyword::kCall) || s.kind == LineKind::kM98))
    return at(stop_, "the program stops at line {} first");
  if (!has_stop(in_, last)) {
    const bool opens = p.block_of[last] != kNoBlock && p.blocks[p.block_of[last]].opener == last;
    if (s.kind == LineKind::kProgramEnd) return at(last, "the program ends at line {} first");
    if (opens && s.is(Keyword::kRepeat)) return at(last, "`{1}` on line {0} never runs a pass");
    if (opens && !s.is(Keyword::kDo)) return at(last, "`{1}` on line {0} is never true");
    if (s.is(Keyword::kElse) || s.is(Keyword::kElseif)) return at(last, "every run skips `{1}` on line {0}");
  }
  return at(last, "no run gets past line {}");
}

Related Unreached::at(StatementId statement, const std::string& what) const {
  const Statement& s = in_.program.at(statement);
  const bool oword = s.kind == LineKind::kOWord;
  return {oword ? s.head_span() : s.whole(),
          fmt::format(fmt::runtime(what), s.line, oword ? in_.program.head(statement) : ""), nullptr};
}

}  // namespace owlint::rules
