#include "analyzer/flow/interpreter/live_variables.h"

#include <algorithm>

#include "analyzer/flow/domain/modes.h"

namespace owlint::flow {
namespace {

void set_bit(uint64_t* set, uint32_t bit) { set[bit / 64] |= uint64_t{1} << (bit % 64); }
void clear_bit(uint64_t* set, uint32_t bit) { set[bit / 64] &= ~(uint64_t{1} << (bit % 64)); }

/// Adds; true if there was something new.
bool add_all(uint64_t* to, const uint64_t* from, size_t words) {
  uint64_t grown = 0;
  for (size_t w = 0; w < words; ++w) {
    grown |= from[w] & ~to[w];
    to[w] |= from[w];
  }
  return grown != 0;
}

Variables::Map map_of(ParameterKey key) { return is_global(key) ? Variables::kGlobals : Variables::kLocals; }
Variables::Map outcomes_of(ParameterKey key) {
  return is_global(key) ? Variables::kGlobalOutcomes : Variables::kLocalOutcomes;
}

/// A line on the way of a run that skips the rest of a block, and is read there: the condition behind a branch that was taken,
/// and that of a loop which `break` leaves. kNowhere without one.
NodeId passed_by(const Program& program, const ControlFlow& flow, NodeId node) {
  const auto& nodes = flow.nodes();
  const auto is_part = [&](NodeId id) {
    const Statement& s = program.at(nodes[id].statement);
    return s.is(Keyword::kElse) || s.is(Keyword::kElseif);
  };
  const StatementId line = nodes[node].statement;
  const bool leaves = program.at(line).is(Keyword::kBreak);
  if (!leaves && node + 1 < nodes.size() && is_part(node + 1)) return node + 1;
  if (!leaves && !is_part(node)) return kNowhere;
  const StatementId end = program.blocks[program.block_of[line]].end;
  return static_cast<NodeId>(std::ranges::lower_bound(nodes, end, {}, &ControlFlow::Node::statement) - nodes.begin());
}

}  // namespace

void Variables::add(Map map, uint32_t key) {
  std::vector<uint32_t>& leaves = leaf_[map];
  if (key / kLeaf >= leaves.size()) leaves.resize(key / kLeaf + 1, kNone);
  if (leaves[key / kLeaf] == kNone) leaves[key / kLeaf] = leaves_++;
}

uint32_t Variables::number(Map map, uint32_t key) const {
  const std::vector<uint32_t>& leaves = leaf_[map];
  const uint32_t leaf = key / kLeaf;
  return leaf >= leaves.size() || leaves[leaf] == kNone ? kNone : leaves[leaf] * kLeaf + key % kLeaf;
}

LiveVariables::LiveVariables(const Program& program, const Structure& structure, const RememberedConditions& outcomes,
                             const Limits& limits)
    : program_(program), outcomes_(outcomes) {
  // Where a run may leave a sub by any line, nothing is known.
  if (!structure.regular || program.size() > limits.data_flow_statements) return;
  lines_.assign(program.regions.size(), static_cast<uint32_t>(program.size()),
                [&](StatementId id) { return program.region_of[id]; });
  table_.emplace(program, lines_.all());
  by_name_.assign(program.syntax.names.size(), static_cast<uint32_t>(program.regions.size()), [&](RegionId r) {
    return program.regions[r].name == kNoName ? Grouped::kNone : program.regions[r].name;
  });
  call_at_.assign(program.size(), Grouped::kNone);
  for (uint32_t i = 0; i < program.calls.size(); ++i) call_at_[program.calls[i].statement] = i;
  find_subs(structure);
  number_variables();
  const size_t size = lines_.all().size() * words_;
  if (2 * size > limits.liveness_words) return;
  read_.assign(size, 0);
  passed_.assign(size, 0);
  find_always_live();
  // A sweep sees what the one before has found of the called subs.
  bool grows = true;
  for (int sweeps = 0; grows && sweeps < limits.liveness_sweeps; ++sweeps) {
    grows = false;
    for (size_t r = subs_.size(); r-- > 0;) grows = (subs_[r].known && sweep(subs_[r])) || grows;
  }
  if (grows) return;
  find_exits();
  finish();
}

/// Whether no other sub begins in it: the lines of that would run in its place.
bool LiveVariables::is_whole(RegionId region) const {
  const Region& r = program_.regions[region];
  if (r.opener == kNoStatement) return true;
  for (StatementId id = r.opener; id < r.last; ++id) {
    if (program_.region_of[id] != region) return false;
  }
  return true;
}

void LiveVariables::find_subs(const Structure& structure) {
  for (RegionId r = 0; r < program_.regions.size(); ++r) {
    Sub sub{ControlFlow(program_, structure, r, lines_[r]),
            table_->lines(lines_.first(r), lines_[r].size()),
            lines_.first(r),
            false,
            {},
            {}};
    sub.known = sub.flow.known() && !sub.flow.nodes().empty() && is_whole(r);
    subs_.push_back(std::move(sub));
  }
}

void LiveVariables::add(ParameterKey key) {
  if (key == kComputedKey) return;
  variables_.add(map_of(key), static_cast<uint32_t>(key));
  for (const uint32_t id : outcomes_.conditions_of(key)) variables_.add(outcomes_of(key), id);
}

void LiveVariables::put(ParameterKey key, uint64_t* set) const {
  if (key == kComputedKey) {
    add_all(set, numbers_.data(), words_);
  } else {
    set_bit(set, variables_.number(map_of(key), static_cast<uint32_t>(key)));
  }
}

void LiveVariables::number_variables() {
  const Syntax& syntax = program_.syntax;
  for (const Sub& sub : subs_) {
    for (const ParameterKey key : sub.accesses.all_reads()) add(key);
    for (const Write& write : sub.accesses.all_writes()) add(write.key);
  }
  const auto saved_modes = kLocalNames + static_cast<uint32_t>(syntax.names.size());
  for (uint32_t key = kModeKeys; key <= kLastModeKey; ++key) variables_.add(Variables::kGlobals, key);
  for (uint32_t mode = 0; mode <= kPlaceNumber; ++mode) variables_.add(Variables::kLocals, saved_modes + mode);
  for (const NameId name : {syntax.names.find("_value"), syntax.names.find("_value_returned")}) {
    if (name != kNoName) add(key_of_name(syntax, name));
  }
  words_ = variables_.words();
  for (Set* set : {&always_, &globals_, &numbers_}) set->assign(words_, 0);
  variables_.for_each([&](Variables::Map map, uint32_t key, uint32_t number) {
    const bool global = map == Variables::kGlobals || map == Variables::kGlobalOutcomes;
    if (global) set_bit(globals_.data(), number);
    const bool numbered =
        map == Variables::kGlobals ? key <= kLastNumber : map == Variables::kLocals && key < kFirstGlobalNumber;
    if (numbered) set_bit(numbers_.data(), number);
    const bool of_modes = map == Variables::kGlobals ? key >= kModeKeys && key <= kLastModeKey
                                                     : map == Variables::kLocals && key >= saved_modes;
    if (of_modes) set_bit(always_.data(), number);
  });
}

/// What is read also by runs that are not at the line: the results of calls, the values of a sub that is being defined, and what
/// stops wherever it stands.
void LiveVariables::find_always_live() {
  const Syntax& syntax = program_.syntax;
  for (const NameId name : {syntax.names.find("_value"), syntax.names.find("_value_returned")}) {
    if (name != kNoName) put(key_of_name(syntax, name), always_.data());
  }
  for (const Sub& sub : subs_) {
    for (size_t line = 0; line < sub.accesses.size(); ++line) {
      const Statement& s = program_.at(lines_.all()[sub.first + line]);
      if (!s.has_error() && !s.is(Keyword::kEndsub) && !s.is(Keyword::kReturn)) continue;
      for (const ParameterKey key : sub.accesses.reads(line)) put(key, always_.data());
      if (sub.accesses.reads_any(line)) put(kComputedKey, always_.data());
    }
  }
}

/// Goes over all lines once, the last first; returns whether something new was found.
bool LiveVariables::sweep(const Sub& sub) {
  bool grew = false;
  Set read(words_);
  Set passed(words_);
  const Live out{read.data(), passed.data()};
  for (auto node = static_cast<NodeId>(sub.flow.nodes().size()); node-- > 0;) {
    come_from_next(sub, node, out);
    come_from_call(sub.flow.nodes()[node].statement, out);
    read_line(sub, node, out);
    const Live known = at(sub.first + node);
    grew = add_all(known.read, out.read, words_) || grew;
    grew = add_all(known.passed, out.passed, words_) || grew;
  }
  return grew;
}

void LiveVariables::come_from_next(const Sub& sub, NodeId node, Live out) {
  std::fill_n(out.read, words_, 0);
  std::fill_n(out.passed, words_, 0);
  const auto [first, second] = sub.flow.nodes()[node].next;
  for (const NodeId next : {first, second, passed_by(program_, sub.flow, node)}) {
    if (next == kNowhere) continue;
    if (next == kExit) {
      std::fill_n(out.passed, words_, ~uint64_t{0});
      continue;
    }
    const Live live = at(sub.first + next);
    add_all(out.read, live.read, words_);
    add_all(out.passed, live.passed, words_);
  }
}

/// Whether the sub is not known by its name: a path means its last part in the label table.
bool LiveVariables::may_mean_any(const Call& call) const {
  return call.callee == kNoName || call.callee >= by_name_.size() ||
      program_.name(call.callee).find('/') != std::string::npos;
}

bool LiveVariables::leads_anywhere(const Call& call) const {
  return may_mean_any(call) || std::ranges::any_of(by_name_[call.callee], [&](RegionId r) { return !subs_[r].known; });
}

/// What the called sub reads, and what it leaves as it was. The caller's own parameters are all among the latter.
void LiveVariables::come_from_call(StatementId line, Live out) {
  if (call_at_[line] == Grouped::kNone) return;
  const Call& call = program_.calls[call_at_[line]];
  if (leads_anywhere(call)) {
    add_all(out.read, globals_.data(), words_);
    return;
  }
  const std::span<const RegionId> subs = by_name_[call.callee];
  // A sub that is nowhere reads nothing; the code of a remap may be built in, and not call at all.
  const bool may_pass = subs.empty() || program_.at(line).kind == LineKind::kRemap;
  for (size_t w = 0; w < words_; ++w) {
    uint64_t read = 0;
    uint64_t passed = may_pass ? ~uint64_t{0} : ~globals_[w];
    for (const RegionId r : subs) {
      const Live entry = at(subs_[r].first);
      read |= entry.read[w];
      passed |= entry.passed[w];
    }
    out.read[w] = (out.read[w] & passed) | (read & globals_[w]);
    out.passed[w] &= passed;
  }
}

/// The line assigns after it has read.
void LiveVariables::read_line(const Sub& sub, NodeId node, Live out) const {
  const auto assign = [&](uint32_t variable) {
    if (variable == Variables::kNone) return;
    clear_bit(out.read, variable);
    clear_bit(out.passed, variable);
  };
  for (const Write& write : sub.accesses.writes(node)) {
    if (write.key == kComputedKey) continue;
    assign(variables_.number(map_of(write.key), static_cast<uint32_t>(write.key)));
    for (const uint32_t id : outcomes_.conditions_of(write.key)) assign(variables_.number(outcomes_of(write.key), id));
  }
  for (const ParameterKey key : sub.accesses.reads(node)) put(key, out.read);
  if (sub.accesses.reads_any(node)) put(kComputedKey, out.read);
  const Syntax& syntax = program_.syntax;
  const Statement& s = program_.at(sub.flow.nodes()[node].statement);
  if (s.kind == LineKind::kModeLine || s.kind == LineKind::kRemap) {
    std::vector<ParameterKey> reads;
    for (const ModeWord& word : syntax.words_of(s)) {
      if (word.computed != kNoExpr) add_reads(syntax, word.computed, reads);
    }
    for (const ParameterKey key : reads) put(key, out.read);
  }
  if (s.kind != LineKind::kOWord || s.value_count == 0) return;
  const ConditionId tested = outcomes_.condition(syntax.values_of(s).front());
  if (tested.id == 0) return;
  const auto map = tested.global ? Variables::kGlobalOutcomes : Variables::kLocalOutcomes;
  set_bit(out.read, variables_.number(map, tested.id));
}

/// What is live behind a sub is what is live where its calls come back.
void LiveVariables::find_exits() {
  for (Sub& sub : subs_) sub.exit.assign(words_, 0);
  for (const Call& call : program_.calls) {
    if (!may_mean_any(call)) continue;
    for (Sub& sub : subs_) sub.exit = globals_;
  }
  for (bool grew = true; grew;) {
    grew = false;
    for (const Call& call : program_.calls) grew = spread_exit(call) || grew;
  }
}

/// True if something new is live behind the subs that are called.
bool LiveVariables::spread_exit(const Call& call) {
  if (may_mean_any(call) || by_name_[call.callee].empty()) return false;
  const Sub& caller = subs_[call.caller];
  Set live = globals_;
  if (caller.known) {
    Set passed(words_);
    const auto lines = lines_[call.caller];
    const auto node = static_cast<NodeId>(std::ranges::lower_bound(lines, call.statement) - lines.begin());
    come_from_next(caller, node, {live.data(), passed.data()});
    for (size_t w = 0; w < words_; ++w) live[w] = (live[w] | (passed[w] & caller.exit[w])) & globals_[w];
  }
  bool grew = false;
  for (const RegionId r : by_name_[call.callee]) grew = add_all(subs_[r].exit.data(), live.data(), words_) || grew;
  return grew;
}

/// Of what is live behind a sub, each line knows what of that is live before it.
void LiveVariables::finish() {
  line_of_.assign(program_.size(), Grouped::kNone);
  for (Sub& sub : subs_) {
    if (!sub.known) continue;
    for (NodeId node = 0; node < sub.flow.nodes().size(); ++node) {
      const Live live = at(sub.first + node);
      for (size_t w = 0; w < words_; ++w) live.read[w] |= (live.passed[w] & sub.exit[w]) | always_[w];
      line_of_[sub.flow.nodes()[node].statement] = static_cast<uint32_t>(sub.first + node);
    }
    const uint64_t* const entry = at(sub.first).read;
    sub.entry.assign(entry, entry + words_);
    add_all(sub.exit.data(), always_.data(), words_);
  }
  passed_ = {};
}

void LiveVariables::keep(const uint64_t* live, Parameters& p, PersistentMap::Pool& pool) const {
  const auto keep_in = [&](PersistentMap& map, Variables::Map kind) {
    map.keep(pool, [&](uint32_t leaf) { return variables_.in_leaf(live, kind, leaf); });
  };
  keep_in(p.locals, Variables::kLocals);
  keep_in(p.globals, Variables::kGlobals);
  keep_in(p.local_outcomes, Variables::kLocalOutcomes);
  keep_in(p.global_outcomes, Variables::kGlobalOutcomes);
}

void LiveVariables::keep_before(StatementId line, Parameters& p, PersistentMap::Pool& pool) const {
  if (line >= line_of_.size() || line_of_[line] == Grouped::kNone) return;
  keep(&read_[line_of_[line] * words_], p, pool);
}

/// The one sub of that name of which something is known; null if there are others.
const LiveVariables::Sub* LiveVariables::only(NameId name) const {
  if (line_of_.empty() || name >= by_name_.size() || by_name_[name].size() != 1) return nullptr;
  const Sub& sub = subs_[by_name_[name].front()];
  return sub.known ? &sub : nullptr;
}

void LiveVariables::keep_at_entry(NameId sub, Parameters& p, PersistentMap::Pool& pool) const {
  if (const Sub* called = only(sub)) keep(called->entry.data(), p, pool);
}

void LiveVariables::keep_at_exit(NameId sub, Parameters& p, PersistentMap::Pool& pool) const {
  if (const Sub* called = only(sub)) keep(called->exit.data(), p, pool);
}

}  // namespace owlint::flow
