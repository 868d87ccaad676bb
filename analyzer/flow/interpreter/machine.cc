#include "analyzer/flow/interpreter/machine.h"

#include <algorithm>
#include <charconv>

#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

constexpr uint32_t kSetMark = 0x80000000U;

uint64_t combine(uint64_t hash, uint64_t value) { return mix(hash, value); }

std::vector<std::pair<FullLabel, uint8_t>> join_counts(const std::vector<std::pair<FullLabel, uint8_t>>& a,
                                                       const std::vector<std::pair<FullLabel, uint8_t>>& b) {
  std::vector<std::pair<FullLabel, uint8_t>> out;
  auto left = a.begin();
  auto right = b.begin();
  while (left != a.end() || right != b.end()) {
    if (right == b.end() || (left != a.end() && left->first < right->first)) {
      out.emplace_back((left++)->first, kAnyCount);
    } else if (left == a.end() || right->first < left->first) {
      out.emplace_back((right++)->first, kAnyCount);
    } else {
      uint8_t count = left->second;
      if (left->second != right->second) {
        count = left->second == kAnyCount || right->second == kAnyCount ? uint8_t{kAnyCount} : uint8_t{kManyLeft};
      }
      out.emplace_back(left->first, count);
      ++left;
      ++right;
    }
  }
  return out;
}

}  // namespace

uint64_t State::hash() const {
  uint64_t h = combine(position, skip);
  h = combine(h, defining);
  h = combine(h,
              static_cast<uint64_t>(executed) | breaking << 4 | continuing << 8 | returned << 12 |
                  static_cast<uint64_t>(seek) << 16 | static_cast<uint64_t>(looped) << 17 |
                  static_cast<uint64_t>(parameters.outside) << 18 | static_cast<uint64_t>(joined) << 19 |
                  static_cast<uint64_t>(mixed) << 20);
  h = combine(h, table.hash());
  h = combine(h, parameters.locals.hash());
  h = combine(h, parameters.globals.hash());
  h = combine(h, parameters.local_facts.hash());
  h = combine(h, parameters.global_facts.hash());
  for (const auto& [label, count] : counts) h = combine(h, static_cast<uint64_t>(label) << 8 | count);
  return h;
}

Definers::Set Definers::get(uint32_t packed) const {
  if (packed == 0) return {{}, true};
  if (packed == kElsewhere) return {{}, false};
  if ((packed & kSetMark) != 0) return sets_[packed & ~kSetMark];
  Set set{{}, (packed & 1) != 0};
  set.lines.push_back((packed >> 1) - 1);
  return set;
}

uint32_t Definers::pack(Set set) {
  if (set.lines.empty()) return 0;
  if (set.lines.size() == 1) return one(*set.lines.begin()) | (set.undefined ? 1 : 0);
  uint64_t hash = set.undefined ? 1 : 0;
  for (const StatementId line : set.lines) hash = mix(hash, line);
  const auto [entry, added] = ids_.try_emplace(hash, static_cast<uint32_t>(sets_.size()) | kSetMark);
  if (added) sets_.push_back(std::move(set));
  return entry->second;
}

uint32_t Definers::join(uint32_t a, uint32_t b) {
  if (a == b) return a;
  const Set left = get(a);
  const Set right = get(b);
  Set out;
  out.undefined = left.undefined || right.undefined;
  std::ranges::set_union(left.lines, right.lines, std::back_inserter(out.lines));
  out.lines.shorten();
  return pack(std::move(out));
}

uint32_t Definers::without_undefined(uint32_t packed) {
  Set set = get(packed);
  set.undefined = false;
  return pack(std::move(set));
}

Machine::Machine(const Linked& linked, const Profile& profile, const Limits& limits, PersistentMap::Pool& pool)
    : linked_(linked),
      program_(linked.program()),
      profile_(profile),
      limits_(limits),
      pool_(pool),
      evaluator_(program_.syntax, profile_, limits, values_, pool),
      no_fanuc_(profile.setup != nullptr && profile.setup->no_fanuc),
      // Under FEATURE 0x20 any block can be taken for a `do` loop.
      reads_break_(profile.warn_only()),
      structure_(program_),
      effects_(program_, structure_.regular, limits) {
  if (profile.setup != nullptr && profile.setup->has_remaps) evaluator_.distrust_globals();
  labels_.emplace_back(kNoName, kNoName);
  index();
}

void Machine::index() {
  const Syntax& syntax = program_.syntax;
  for (StatementId id = 0; id < syntax.statements.size(); ++id) {
    const Statement& s = syntax.statements[id];
    const LineError* error = syntax.error(s);
    if (s.kind == LineKind::kOWord && s.label_expr != kNoExpr) computed_.push_back(id);
    if (s.is(Keyword::kDo)) reads_break_ = true;
    if (s.opens_sub()) {
      definitions_.push_back(id);
      const std::string_view name =
          s.label == kNoName ? std::string_view() : std::string_view(syntax.names.text(s.label));
      long number = 0;
      const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), number);
      // Not `o<007>`, which no computed label is.
      if (problem == std::errc{} && std::to_string(number) == name) numbered_subs_.emplace_back(number, s.label);
    }
    if ((s.is(Keyword::kEndsub) || s.is(Keyword::kReturn)) && s.value_count > 0 && s.label != kNoName) {
      if (s.label >= returns_value_.size()) returns_value_.resize(std::max<size_t>(s.label + 1, syntax.names.size()));
      returns_value_[s.label] = true;
    }
    if (s.kind == LineKind::kPercent) percents_.push_back(id);
    if (s.kind == LineKind::kFileEnd) file_ends_.push_back(id);
    const bool m98 = s.kind == LineKind::kM98 && (error != nullptr || s.value_count > 0 || s.label_expr != kNoExpr);
    if (refuses_fanuc(s) || m98) {
      always_read_.push_back(id);
      continue;
    }
    if (error == nullptr) continue;
    if (error->kind < StopKind::kKeywordUnknown) always_read_.push_back(id);
    if (error->kind == StopKind::kKeywordUnknown) unknown_keywords_.push_back(id);
  }
  std::ranges::sort(numbered_subs_);
  numbered_subs_.erase(std::unique(numbered_subs_.begin(), numbered_subs_.end()), numbered_subs_.end());
}

void Machine::set_coarse(bool passes_over) {
  evaluator_.set_coarse();
  if (passes_over && !calm_) calm_.emplace(program_, structure_, evaluator_, limits_, profile_.warn_only());
}

const CalmStretch* Machine::pass_over(State& state, const Context& context) {
  if (!calm_ || state.skip != kNoLabel || state.defining != kNoName || state.looped) return nullptr;
  const CalmStretch* stretch = calm_->at(state.position);
  if (stretch == nullptr) return nullptr;
  const bool called = context.depth > 0;
  // In a broken program, subs that are whole are gone through: which loops in them have no end depends on what comes later.
  if (!structure_.regular && structure_.apart[program_.region_of[state.position]]) return nullptr;
  // A constant from before, or an argument that is not passed, may make a difference on the way; so may an unassigned name.
  for (const ParameterId p : calm_->reads(*stretch)) {
    if (!evaluator_.is_plain(p, state.parameters)) return nullptr;
  }
  const auto label_of_sub = [&](StatementId opener) { return full_label(kGlobalScope, program_.at(opener).label); };
  const auto defined = calm_->defined(*stretch);
  if (called && !defined.empty()) return nullptr;
  for (const StatementId opener : calm_->called(*stretch)) {
    if (opener < stretch->first && state.table.get(label_of_sub(opener)) != Definers::one(opener)) return nullptr;
  }
  for (const StatementId opener : defined) {
    if (state.table.get(label_of_sub(opener)) != 0) return nullptr;
  }
  const PersistentMap::Pool::Batch batch(pool_);
  for (const CalmWrite& write : calm_->writes(*stretch))
    evaluator_.assign_unknown(write.parameter, write.certain, state.parameters);
  for (const StatementId opener : defined) state.table.set(pool_, label_of_sub(opener), Definers::one(opener));
  if (stretch->tests) state.executed = kYes;
  if (!called && (stretch->calls || stretch->ends_defining)) state.returned = stretch->ends_defining ? kNo : kYes;
  state.position = stretch->last;
  state.branch = 0;
  return stretch;
}

uint32_t Machine::entry(const State& state, FullLabel label) const {
  const uint32_t packed = state.table.get(label);
  if (packed != 0) return packed;
  const auto& [scope, name] = labels_[label];
  if (scope == kGlobalScope || name >= program_.by_label.size()) return 0;
  // A structured block's entry: the one block with that label, in that scope if there are several.
  for (const StatementId id : program_.by_label[name]) {
    const BlockId block = program_.block_of[id];
    if (block == kNoBlock || !structure_.structured[block]) continue;
    if (program_.regions[program_.blocks[block].region].name == scope)
      return Definers::one(program_.blocks[block].opener);
  }
  return 0;
}

StatementId Machine::next_stop(const State& state, StatementId from) const {
  auto next = static_cast<StatementId>(program_.size());
  const auto look = [&](std::span<const StatementId> list) {
    const auto found = std::ranges::lower_bound(list, from);
    if (found != list.end()) next = std::min(next, *found);
  };
  const NameId label = labels_[state.skip].second;
  if (label < program_.by_label.size()) look(program_.by_label[label]);
  look(computed_);
  look(always_read_);
  look(percents_);
  look(file_ends_);
  if (state.defining != kNoName) {
    look(definitions_);
  } else {
    look(unknown_keywords_);
  }
  return next;
}

std::string Machine::full_text(FullLabel label) const {
  const auto& [scope, name] = labels_[label];
  if (scope == kGlobalScope) return this->name(name);
  return (scope == kNoName ? std::string() : this->name(scope)) + "#" + this->name(name);
}

bool Machine::is_target(const State& state, const Context& context) const {
  const Statement& s = program_.at(state.position);
  const auto& [scope, label] = labels_[state.skip];
  if (s.kind != LineKind::kOWord || s.label != label) return s.kind == LineKind::kOWord && s.label_expr != kNoExpr;
  if (global_label(s.keyword)) return scope == kGlobalScope;
  return scope == (context.depth > 0 ? context.sub : state.defining);
}

bool Machine::opens_somewhere(NameId sub) const {
  return sub < program_.by_label.size() &&
      std::ranges::any_of(program_.by_label[sub], [&](StatementId id) { return program_.at(id).opens_sub(); });
}

bool Machine::may_be_elsewhere(NameId sub) const {
  const std::string& text = name(sub);
  if (profile_.may_be_python() || target(sub).opaque || program_.sub_file) return true;
  if (opens_somewhere(sub)) return false;
  if (profile_.setup != nullptr) return false;
  return text.find_first_not_of("-0123456789") != std::string::npos;
}

NameId Machine::intern(const std::string& text) {
  const NameId known = program_.syntax.names.find(text);
  if (known != kNoName) return known;
  return static_cast<NameId>(program_.syntax.names.size() + computed_names_.intern(text));
}

const std::string& Machine::name(NameId id) const {
  const size_t own = program_.syntax.names.size();
  return id < own ? program_.name(id) : computed_names_.text(static_cast<NameId>(id - own));
}

FullLabel Machine::full_label(NameId scope, NameId label) {
  // Labels of subs are asked for at every call and definition.
  if (scope == kGlobalScope && label != kNoName) {
    if (label >= sub_labels_.size())
      sub_labels_.resize(std::max<size_t>(label + 1, program_.syntax.names.size()), kNoLabel);
    FullLabel& known = sub_labels_[label];
    if (known == kNoLabel) {
      known = static_cast<FullLabel>(labels_.size());
      labels_.emplace_back(scope, label);
    }
    return known;
  }
  const uint64_t key = static_cast<uint64_t>(scope) << 32 | label;
  const auto [entry, added] = label_ids_.try_emplace(key, static_cast<FullLabel>(labels_.size()));
  if (added) labels_.emplace_back(scope, label);
  return entry->second;
}

State Machine::join(const State& a, const State& b) {
  State out = a;
  out.executed |= b.executed;
  out.breaking |= b.breaking;
  out.continuing |= b.continuing;
  out.returned |= b.returned;
  out.looped = a.looped && b.looped;
  out.joined = true;
  out.mixed = a.mixed && b.mixed;
  out.table = PersistentMap::merge(pool_, a.table, b.table,
                                   [this](uint32_t, uint32_t x, uint32_t y) { return definers_.join(x, y); });
  if (a.counts != b.counts) out.counts = join_counts(a.counts, b.counts);
  const auto join = [this](uint32_t, uint32_t x, uint32_t y) { return values_.join(x, y); };
  out.parameters.locals = PersistentMap::merge(pool_, a.parameters.locals, b.parameters.locals, join);
  out.parameters.globals = PersistentMap::merge(pool_, a.parameters.globals, b.parameters.globals, join);
  const auto same = [](uint32_t, uint32_t x, uint32_t y) { return x == y ? x : 0; };
  out.parameters.local_facts = PersistentMap::merge(pool_, a.parameters.local_facts, b.parameters.local_facts, same);
  out.parameters.global_facts = PersistentMap::merge(pool_, a.parameters.global_facts, b.parameters.global_facts, same);
  out.parameters.outside = a.parameters.outside || b.parameters.outside;
  return out;
}

State Machine::resume(const State& caller, const State& exit, const Context& callee, bool merged) {
  State out = exit;
  const bool fanuc = callee.fanuc;
  const Effects& effects = effects_.of(callee.sub);
  if (merged) {
    // The exit was computed for many callers at once. What the callee cannot have changed is as it was for this one, and a
    // label that was defined still is: no call takes one away.
    out.table =
        PersistentMap::merge(pool_, caller.table, exit.table, [&](uint32_t label, uint32_t before, uint32_t after) {
          const auto& [scope, name] = labels_[label];
          if (!effects.everything && !effects.subs.contains(scope == kGlobalScope ? name : scope)) return before;
          if (before == 0 || definers_.get(before).undefined) return after;
          return after == 0 ? before : definers_.without_undefined(after);
        });
  }
  if (merged && !effects.everything) {
    out.parameters.globals = PersistentMap::merge(
        pool_, caller.parameters.globals, exit.parameters.globals, [&](uint32_t key, uint32_t before, uint32_t after) {
          return effects.globals.contains(key) || effects.any_global ? after : before;
        });
    if (!effects.jumps) {
      out.breaking = caller.breaking;
      out.continuing = caller.continuing;
    }
    if (!effects.tests) out.executed = caller.executed;
  }
  out.joined = exit.joined || caller.joined;
  out.mixed = exit.mixed || caller.mixed || (merged && effects.everything);
  out.position = caller.position + 1;
  out.context = caller.context;
  out.defining = kNoName;
  out.skip = kNoLabel;
  out.seek = false;
  out.looped = false;
  out.branch = 0;
  // M98 does not save #1 to #30; an O-word call gives the caller's own values back.
  out.parameters.locals =
      fanuc ? evaluator_.share_numbers(caller.parameters.locals, exit.parameters.locals) : caller.parameters.locals;
  out.parameters.local_facts = fanuc ? PersistentMap() : caller.parameters.local_facts;
  return out;
}

}  // namespace owlint::flow
