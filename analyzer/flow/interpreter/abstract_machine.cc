#include "analyzer/flow/interpreter/abstract_machine.h"

#include <algorithm>
#include <charconv>

#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/questions.h"

namespace owlint::flow {

AbstractMachine::AbstractMachine(const Linked& linked, const Profile& profile, const Limits& limits,
                                 PersistentMap::Pool& pool, ModeMask modes)
    : linked_(linked),
      program_(linked.program()),
      profile_(profile),
      limits_(limits),
      pool_(pool),
      tracked_(program_.syntax, profile, limits),
      remembered_(program_.syntax, limits, pool),
      evaluator_(program_.syntax, profile_, tracked_, remembered_, values_, pool),
      refinement_(program_.syntax, tracked_, limits, evaluator_, pool),
      machine_words_(profile),
      remapped_codes_(machine_words_.words),
      start_(program_.sub_file ? ModeState::unknown() : machine_words_.start),
      mode_uses_(program_, machine_words_.words, start_.now, modes),
      modes_(mode_uses_, program_.syntax.names.size(), values_, pool),
      states_(values_, definers_, pool),
      no_fanuc_(profile.setup != nullptr && profile.setup->no_fanuc),
      // Under FEATURE 0x20 any block can be taken for a `do` loop.
      reads_break_(profile.warn_only()),
      structure_(program_),
      effects_(program_, structure_.regular, mode_uses_, limits) {
  machine_words_.words.tools_written = program_.syntax.writes_tools;
  if (remapped_codes_.run_python()) evaluator_.distrust_globals();
  evaluator_.set_modes(&modes_);
  labels_.emplace_back(kNoName, kNoName);
  index();
}

void AbstractMachine::index() {
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
    const bool of_m98 = s.kind == LineKind::kMachineCheck && asks_about_call(syntax, id);
    if (refuses_fanuc(s) || m98 || of_m98) {
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

void AbstractMachine::set_coarse(bool passes_over) {
  evaluator_.set_coarse();
  remembered_.set_coarse();
  refinement_.set_coarse();
  if (passes_over && !calm_)
    calm_.emplace(program_, structure_, tracked_, evaluator_, mode_uses_, limits_, profile_.warn_only());
}

const CalmStretch* AbstractMachine::pass_over(State& state, const Context& context) {
  if (!calm_ || (place_watch_ != nullptr && place_watch_->sees_all()) || context.contour || state.skip != kNoLabel ||
      state.defining != kNoName || state.looped)
    return nullptr;
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
  if (stretch->tests) state.flags.executed = kYes;
  if (!called && (stretch->calls || stretch->ends_defining)) state.flags.returned = stretch->ends_defining ? kNo : kYes;
  for (const StatementId id : calm_->changing(*stretch)) {
    modes_.go(state.parameters, program_.syntax.places_after(id));
    modes_.apply(state.parameters, program_.syntax.changes_after(id));
  }
  state.position = stretch->last;
  state.branch = Branch::kNone;
  return stretch;
}

/// The lines behind a statement go somewhere.
void AbstractMachine::go(State& state, StatementId line) {
  const std::span<const PlaceChange> changes = program_.syntax.places_after(line);
  if (place_watch_ == nullptr || !mode_uses_.follows_place()) return modes_.go(state.parameters, changes);
  place_watch_->begin(state, line);
  const Statement& s = program_.at(line);
  const uint32_t first = s.plain_code_follows ? s.first_plain_line : s.line + 1;
  for (const PlaceChange& change : changes) {
    modes_.tell(state.parameters, change, {place_watch_, first});
    modes_.go(state.parameters, {&change, 1});
  }
}

void AbstractMachine::leave_modes(State& state, StatementId line) {
  if (watch_ != nullptr) watch_->left(state, line);
  if (program_.at(line).asks_inputs) remembered_.forget_answers(state.parameters);
  if (program_.at(line).changes_place) go(state, line);
  if (program_.at(line).changes_modes) modes_.apply(state.parameters, program_.syntax.changes_after(line));
}

uint32_t AbstractMachine::entry(const State& state, FullLabel label) const {
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

State AbstractMachine::skip_ahead(State state) const {
  if (state.skip != kNoLabel) state.position = next_stop(state, state.position);
  return state;
}

StatementId AbstractMachine::next_stop(const State& state, StatementId from) const {
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

std::string AbstractMachine::full_text(FullLabel label) const {
  const auto& [scope, name] = labels_[label];
  if (scope == kGlobalScope) return this->name(name);
  return (scope == kNoName ? std::string() : this->name(scope)) + "#" + this->name(name);
}

bool AbstractMachine::is_target(const State& state, const Context& context) const {
  const Statement& s = program_.at(state.position);
  const auto& [scope, label] = labels_[state.skip];
  if (s.kind != LineKind::kOWord || s.label != label) return s.kind == LineKind::kOWord && s.label_expr != kNoExpr;
  if (global_label(s.keyword)) return scope == kGlobalScope;
  return scope == (context.depth > 0 ? context.sub : state.defining);
}

bool AbstractMachine::opens_somewhere(NameId sub) const {
  return sub < program_.by_label.size() &&
      std::ranges::any_of(program_.by_label[sub], [&](StatementId id) { return program_.at(id).opens_sub(); });
}

bool AbstractMachine::may_be_elsewhere(NameId sub) const {
  const std::string& text = name(sub);
  if (profile_.may_be_python() || target(sub).opaque || program_.sub_file) return true;
  if (opens_somewhere(sub)) return false;
  if (profile_.setup != nullptr) return false;
  return text.find_first_not_of("-0123456789") != std::string::npos;
}

NameId AbstractMachine::intern(const std::string& text) {
  const NameId known = program_.syntax.names.find(text);
  if (known != kNoName) return known;
  return static_cast<NameId>(program_.syntax.names.size() + computed_names_.intern(text));
}

const std::string& AbstractMachine::name(NameId id) const {
  const size_t own = program_.syntax.names.size();
  return id < own ? program_.name(id) : computed_names_.text(static_cast<NameId>(id - own));
}

FullLabel AbstractMachine::full_label(NameId scope, NameId label) {
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

State AbstractMachine::resume(const State& caller, const State& exit, const Context& callee, bool joined_calls) {
  State out = exit;
  const bool fanuc = callee.fanuc;
  const Effects& effects = effects_.of(callee.sub);
  if (joined_calls) {
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
  if (joined_calls && !effects.everything) {
    out.parameters.globals = PersistentMap::merge(
        pool_, caller.parameters.globals, exit.parameters.globals, [&](uint32_t key, uint32_t before, uint32_t after) {
          return effects.globals.contains(key) || effects.any_global ? after : before;
        });
    if (!effects.jumps) {
      out.flags.breaking = caller.flags.breaking;
      out.flags.continuing = caller.flags.continuing;
    }
    if (!effects.tests) out.flags.executed = caller.flags.executed;
  }
  out.joined = exit.joined || caller.joined;
  out.mixed = exit.mixed || caller.mixed || (joined_calls && effects.everything);
  out.position = caller.position + 1;
  out.context = caller.context;
  out.defining = kNoName;
  out.skip = kNoLabel;
  out.seek = false;
  out.looped = false;
  out.branch = Branch::kNone;
  // M98 does not save #1 to #30; an O-word call gives the caller's own values back.
  out.parameters.locals =
      fanuc ? evaluator_.share_numbers(caller.parameters.locals, exit.parameters.locals) : caller.parameters.locals;
  out.parameters.local_outcomes = fanuc ? PersistentMap() : caller.parameters.local_outcomes;
  if (watch_ != nullptr) watch_->came_back(caller, out);
  leave_modes(out, caller.position);
  return out;
}

}  // namespace owlint::flow
