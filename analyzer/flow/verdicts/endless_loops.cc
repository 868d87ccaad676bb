#include "analyzer/flow/verdicts/endless_loops.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "analyzer/flow/facts/accesses.h"
#include "analyzer/flow/facts/conditions.h"
#include "analyzer/machine/predefined.h"

namespace owlint::flow {
namespace {

bool is_loop(const Statement& s) { return s.is(Keyword::kWhile) || s.is(Keyword::kDo) || s.is(Keyword::kRepeat); }

template <typename Item>
void sort_once(std::vector<Item>& items) {
  std::ranges::sort(items);
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Whether nothing that these lines read is changed by those, or by the machine. Each line is in its list once.
bool stays_the_same(const Program& program, const std::vector<StatementId>& reading,
                    const std::vector<StatementId>& changing) {
  const AccessTable read(program, reading);
  const AccessTable changed(program, changing);
  const Accesses reads = read.lines(0, reading.size());
  const Accesses writes = changed.lines(0, changing.size());
  if (reads.reads_any() || writes.writes_any()) return false;
  // A call of something that is not known may assign any global.
  const bool calls_out = std::ranges::any_of(
      changing, [&](StatementId id) { return program.at(id).calls() && program.at(id).label_expr != kNoExpr; });
  std::vector<ParameterKey> written;
  for (const Write& write : writes.all_writes()) written.push_back(write.key);
  std::ranges::sort(written);
  return std::ranges::none_of(reads.all_reads(), [&](ParameterKey key) {
    if (calls_out && is_global(key)) return true;
    const ParameterId id = parameter_of(key);
    const bool of_machine = id.named ? may_be_predefined(program.name(id.id)) : id.id >= kFirstVolatileNumber;
    return of_machine || std::ranges::binary_search(written, key);
  });
}

/// Two parameters may only be far apart where the step is not 0.
bool compare_with_numbers(const Program& program, const std::vector<StatementId>& deciding) {
  return std::ranges::all_of(deciding, [&](StatementId id) {
    return compares_with_numbers(program.syntax, program.syntax.values_of(program.at(id)).front());
  });
}

}  // namespace

void EndlessLoops::find() {
  stuck_.assign(trace_.size(), false);
  find_idle();
  // After a message of FEATURE 0x20 that leads round and round, no stop is that of every run.
  may_go_round_ = hazards_.has(HazardKind::kHang);
  if (may_go_round_) return;  // one mistake, one finding
  find_closed();
  find_stuck();
}

void EndlessLoops::add(StatementId loop, bool is_left) {
  Hazard hazard = hazard_at(HazardKind::kEndlessLoop, loop);
  hazard.not_always = is_left;
  hazards_.add(std::move(hazard));
}

/// Whether the second of two loops on one way round runs within the first: of one sub the first one does, else what calls the
/// other's sub.
bool EndlessLoops::is_around(StatementId loop, StatementId inner) const {
  const RegionId outer_sub = program_.region_of[loop], inner_sub = program_.region_of[inner];
  if (outer_sub == inner_sub) return loop < inner;
  std::vector<bool> seen(program_.regions.size());
  std::vector<RegionId> todo{outer_sub};
  seen[outer_sub] = true;
  while (!todo.empty()) {
    const RegionId caller = todo.back();
    todo.pop_back();
    for (const Call& call : program_.calls) {
      if (call.caller != caller || call.target == kNoRegion || seen[call.target]) continue;
      if (call.target == inner_sub) return true;
      seen[call.target] = true;
      todo.push_back(call.target);
    }
  }
  return false;
}

/// By statement: how many before it some run passes, executing them, that comes to an end.
std::vector<uint32_t> EndlessLoops::passed_well() const {
  std::vector<uint32_t> out(program_.size() + 1);
  for (RecordId id = 0; id < trace_.size(); ++id) {
    const Trace::Record& record = trace_.at(id);
    if (record.statement != kNoStatement && record.executed && !trace_.hanging()[id]) out[record.statement + 1] = 1;
  }
  std::partial_sum(out.begin(), out.end(), out.begin());
  return out;
}

/// Loops that no run leaves: nothing leads out of their way round, and no end is on it. A loop inside one of them that ends is
/// left for the rest of the outer one: it shows when the way back to the beginning of the outer one is taken away.
void EndlessLoops::find_closed() {
  const std::vector<bool>& hanging = trace_.hanging();
  if (std::ranges::find(hanging, true) == hanging.end()) return;
  std::vector<bool> found(program_.size());  // by statement: the opener of such a loop
  const std::vector<uint32_t> passed = passed_well();
  const auto is_left = [&](StatementId loop) {
    const BlockId block = program_.block_of[loop];
    if (block == kNoBlock || program_.blocks[block].end == kNoStatement) return false;
    // Of a `while` whose condition is false at once, the two ends are passed.
    const StatementId last = program_.blocks[block].end + (program_.at(loop).is(Keyword::kDo) ? 1 : 0);
    return last > loop + 1 && passed[last] != passed[loop + 1];
  };
  const auto goes_back = [&](RecordId from, RecordId to) {
    const StatementId target = trace_.at(to).statement;
    const StatementId source = trace_.at(from).statement;
    if (target == kNoStatement || source == kNoStatement || target > source) return false;
    const Statement& s = program_.at(target);
    return is_loop(s);
  };
  const auto removed = [&](RecordId from, RecordId to) {
    return goes_back(from, to) && found[trace_.at(to).statement];
  };
  for (int i = 0; i < analysis_.limits().endless_nesting; ++i) {
    const std::vector<uint32_t> round = trace_.closed_cycles(removed);
    std::vector<StatementId> outermost(trace_.size() + 1, kNoStatement);  // by way round
    trace_.for_edges([&](RecordId from, RecordId to) {
      if (!hanging[from] || round[from] == 0 || round[from] != round[to] || !goes_back(from, to) || removed(from, to))
        return;
      StatementId& loop = outermost[round[from]];
      const StatementId other = trace_.at(to).statement;
      if (loop == kNoStatement || is_around(other, loop)) loop = other;
    });
    bool grew = false;
    for (const StatementId loop : outermost) {
      if (loop == kNoStatement) continue;
      grew = found[loop] = true;
      add(loop, is_left(loop));
    }
    if (!grew) return;
  }
}

/// Under FEATURE 0x20: ways round that an error which became a message leads into or keeps going. Loops as they
/// are meant go round while a condition is true; these do with every condition false, so that nothing ends them.
void EndlessLoops::find_idle() {
  if (warned_.empty()) return;
  const std::vector<uint32_t> group = trace_.idle_cycles();
  struct Loop {
    StatementId first = kNoStatement;   ///< the foremost line of the way round
    StatementId warned = kNoStatement;  ///< the foremost warning on it
    RecordId entry = kNoRecord;
  };
  std::map<uint32_t, Loop> loops;
  for (RecordId id = 0; id < trace_.size(); ++id) {
    const StatementId here = trace_.at(id).statement;
    if (group[id] == 0 || here == kNoStatement) continue;
    Loop& loop = loops[group[id]];
    if (loop.entry == kNoRecord) loop.entry = id;
    if (loop.first == kNoStatement || here < loop.first) loop.first = here;
    if (warned_.contains(id) && (loop.warned == kNoStatement || here < loop.warned)) loop.warned = here;
  }
  for (auto& [number, loop] : loops) {
    for (RecordId id = loop.entry; loop.warned == kNoStatement && id != kNoRecord; id = trace_.at(id).parent) {
      if (warned_.contains(id)) loop.warned = trace_.at(id).statement;
    }
    if (loop.warned == kNoStatement) continue;
    hazards_.add(hazard_at(HazardKind::kHang, loop.warned, loop.first));
  }
}

/// Loops that other runs leave, but in which a run may go round for ever: nothing on the way round changes what decides.
void EndlessLoops::find_stuck() {
  // Codes that are remapped, and stretches that were passed over, may assign something.
  const bool has_remaps = analysis_.profile().setup != nullptr && analysis_.profile().setup->has_remaps;
  if (has_remaps || analysis_.precision().coarse()) return;
  const std::vector<uint32_t> group = trace_.cycles();
  struct Round {
    std::vector<StatementId> lines;     ///< but those that change nothing
    std::vector<StatementId> deciding;  ///< conditions with a way out
    StatementId opener = kNoStatement;
    bool fixed = true;
    bool keeps_values = false;  ///< some lines assign, but change nothing
  };
  std::map<uint32_t, Round> rounds;
  for (RecordId id = 0; id < trace_.size(); ++id) {
    if (group[id] == 0 || trace_.at(id).statement == kNoStatement) continue;
    Round& round = rounds[group[id]];
    const bool keeps = keep_values_.contains(id);
    round.keeps_values = round.keeps_values || keeps;
    if (!keeps) round.lines.push_back(trace_.at(id).statement);
  }
  if (rounds.empty()) return;
  trace_.for_edges([&](RecordId from, RecordId to) {
    const StatementId here = trace_.at(from).statement;
    if (group[from] == 0) return;
    Round& round = rounds[group[from]];
    const Statement* s = here == kNoStatement ? nullptr : &program_.at(here);
    if (group[from] == group[to]) {
      const StatementId target = trace_.at(to).statement;
      if (target != kNoStatement && here != kNoStatement && target <= here && is_loop(program_.at(target)))
        round.opener = std::min(round.opener, target);
      return;
    }
    const bool tests = s != nullptr && (s->is(Keyword::kIf) || s->is(Keyword::kElseif) || s->is(Keyword::kWhile));
    // The counter of `repeat` comes to an end; the number that it begins with decides whether there is a pass.
    const bool begins = s != nullptr && s->is(Keyword::kRepeat) && trace_.at(to).parent == from &&
        trace_.at(to).branch == Branch::kTrue;
    if (tests || begins) {
      round.deciding.push_back(here);
    } else {
      round.fixed = false;
    }
  });
  std::vector<bool> stuck(trace_.size() + 1);  // by way round
  for (auto& [number, round] : rounds) {
    if (!round.fixed || round.opener == kNoStatement || round.deciding.empty()) continue;
    sort_once(round.lines);
    sort_once(round.deciding);
    if (round.keeps_values && !compare_with_numbers(program_, round.deciding)) continue;
    if (!stays_the_same(program_, round.deciding, round.lines)) continue;
    // What a call that was not gone through assigns decides, if it assigns anything.
    if (trace_.leaves_out() &&
        std::ranges::any_of(round.lines, [&](StatementId id) { return program_.at(id).calls(); }))
      trace_.miss_left_out();
    stuck[number] = may_go_round_ = true;
    add(round.opener, true);
  }
  for (RecordId id = 0; id < trace_.size(); ++id) stuck_[id] = stuck[group[id]];
}

}  // namespace owlint::flow
