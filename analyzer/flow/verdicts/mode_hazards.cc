#include "analyzer/flow/verdicts/mode_hazards.h"

#include <algorithm>
#include <bit>

namespace owlint::flow {
namespace {

// Of these a sub that does not put them back is a mistake more often than not.
constexpr Mode kLeaking[] = {Mode::kMotion, Mode::kUnits,    Mode::kPlane,   Mode::kDistance,    Mode::kFeedMode,
                             Mode::kSystem, Mode::kDiameter, Mode::kRetract, Mode::kCompensation};

bool matters_by_path(Mode mode) { return mode == Mode::kUnits || mode == Mode::kDistance || mode == Mode::kPlane; }

}  // namespace

ModeValues ModeHazards::values(const State& state, Mode mode) const {
  return mode_values(analysis_.machine().evaluator().values(), mode, state.parameters.globals.get(mode_key(mode)));
}

void ModeHazards::left(const State& at, StatementId line) {
  if (!program_.at(line).needs_modes) return;
  const auto needs = program_.syntax.needs_after(line);
  const auto first = static_cast<size_t>(needs.data() - program_.syntax.mode_needs.data());
  for (size_t i = 0; i < needs.size(); ++i) {
    const ModeValues now = values(at, needs[i].mode);
    if (now.open) continue;
    auto& had = seen_[first + i];
    for (ValueSet rest = now.may; rest != 0; rest &= rest - 1) {
      const auto value = static_cast<uint8_t>(std::countr_zero(rest));
      if (std::ranges::find(had, value, &Had::value) == had.end()) had.push_back({value, at.record});
    }
  }
}

void ModeHazards::came_back(const State& caller, const State& back) {
  const ModeUses& uses = analysis_.machine().mode_uses();
  for (const Mode mode : kLeaking) {
    if (!uses.follows(mode)) continue;
    const ModeValues before = values(caller, mode), behind = values(back, mode);
    const bool known = !before.open && !behind.open && is_single(before.may) && is_single(behind.may);
    if (!known || before.may == behind.may) continue;
    // Under other motions a line wants other words.
    if (mode == Mode::kMotion && ((before.may | behind.may) & ~kStraightMotions) != 0) continue;
    // A sub that ends compensation does what it is for.
    if (mode == Mode::kCompensation && behind.may == value_bit(modes::kG40)) continue;
    leaks_.try_emplace({caller.position, mode},
                       Leak{static_cast<uint8_t>(std::countr_zero(before.may)),
                            static_cast<uint8_t>(std::countr_zero(behind.may)), back.record});
  }
}

/// The first line of a region from a statement on, in the order of the file, that depends on a mode before anything sets it.
const ModeNeed* ModeHazards::needed_in(RegionId region, StatementId from, Mode mode, int depth) const {
  const ModeUses& uses = analysis_.machine().mode_uses();
  for (StatementId id = from; id < program_.size(); ++id) {
    if (program_.region_of[id] != region) {
      if (region != kMainRegion) return nullptr;
      continue;
    }
    const Statement& s = program_.at(id);
    if (s.kind == LineKind::kFileEnd || s.kind == LineKind::kProgramEnd) return nullptr;
    if (id != from && leaks_.contains({id, mode})) return nullptr;  // which may put it right
    if (s.kind == LineKind::kModeLine && (uses.set_at(id) & mask_of(mode)) != 0) return nullptr;
    if (id != from && s.calls() && depth > 0) {
      const auto call = std::ranges::lower_bound(program_.calls, id, {}, &Call::statement);
      const bool known = call != program_.calls.end() && call->statement == id && call->target != kNoRegion;
      const ModeNeed* const need =
          known ? needed_in(call->target, program_.regions[call->target].opener, mode, depth - 1) : nullptr;
      if (need != nullptr) return need;
    }
    for (const ModeNeed& need : program_.syntax.needs_after(id)) {
      if (need.mode == mode) return &need;
    }
    for (const ModeChange& change : program_.syntax.changes_after(id)) {
      if (change.mode == mode) return nullptr;
    }
  }
  return nullptr;
}

/// The first line behind a call that depends on a mode.
const ModeNeed* ModeHazards::needed_behind(StatementId call, Mode mode) const {
  constexpr int kDeepest = 2;  // subs that the lines behind it call
  return needed_in(program_.region_of[call], call, mode, kDeepest);
}

/// Whether the caller has set the mode itself, or has moved in it: then it expects to find it like that.
bool ModeHazards::uses_before(StatementId call, Mode mode) const {
  const ModeUses& uses = analysis_.machine().mode_uses();
  const RegionId region = program_.region_of[call];
  const auto sets = [mode](const ModeChange& change) { return change.mode == mode; };
  const auto needs = [mode](const ModeNeed& need) { return need.mode == mode; };
  if (region == kMainRegion &&
      (std::ranges::any_of(program_.syntax.first_changes, sets) ||
       std::ranges::any_of(program_.syntax.first_needs, needs)))
    return true;
  for (StatementId id = call; id-- > 0 && (region == kMainRegion || program_.region_of[id] == region);) {
    if (program_.region_of[id] != region) continue;
    if ((uses.set_at(id) & mask_of(mode)) != 0 || std::ranges::any_of(program_.syntax.changes_after(id), sets) ||
        std::ranges::any_of(program_.syntax.needs_after(id), needs))
      return true;
  }
  return false;
}

void ModeHazards::find_leaks(Hazards& hazards) const {
  const Linked& linked = analysis_.linked();
  for (const auto& [place, leak] : leaks_) {
    const auto& [call, mode] = place;
    const bool incremental = mode == Mode::kDistance && leak.to == modes::kG91;
    if (!incremental && !uses_before(call, mode)) continue;
    const ModeNeed* const need = needed_behind(call, mode);
    if (need == nullptr) continue;
    const ModeSetter setter = last_setter(analysis_, leak.record, kNoStatement, mask_of(mode));
    Hazard hazard = hazard_at(HazardKind::kModeLeak, call);
    hazard.mode = mode;
    hazard.from = leak.from;
    hazard.to = leak.to;
    hazard.set_in = setter.file;
    hazard.set_line = setter.line;
    hazard.needed_in = linked.files()[linked.file_of(need->after)].program.get();
    hazard.needed_line = need->line;
    hazards.add(std::move(hazard), static_cast<uint32_t>(mode));
  }
}

void ModeHazards::find_different(Hazards& hazards) const {
  const Linked& linked = analysis_.linked();
  for (size_t i = 0; i < seen_.size(); ++i) {
    const ModeNeed& need = program_.syntax.mode_needs[i];
    if (seen_[i].size() < 2 || !matters_by_path(need.mode)) continue;
    Hazard hazard = hazard_at(HazardKind::kModeDependsOnPath, need.after);
    hazard.mode = need.mode;
    hazard.from = seen_[i][0].value;
    hazard.to = seen_[i][1].value;
    for (const Had& had : seen_[i]) {
      const ModeSetter setter = last_setter(analysis_, had.record, need.after + 1, mask_of(need.mode));
      if (setter.file == nullptr) continue;
      hazard.set_in = setter.file;
      hazard.set_line = setter.line;
    }
    hazard.needed_in = linked.files()[linked.file_of(need.after)].program.get();
    hazard.needed_line = need.line;
    hazards.add(std::move(hazard), static_cast<uint32_t>(need.mode));
  }
}

/// The first lines of the main program that depend on a mode that it has not set.
void ModeHazards::find_assumed(Hazards& hazards) const {
  if (program_.sub_file) return;
  const Linked& linked = analysis_.linked();
  const Program* const main = linked.files()[0].program.get();
  ModeMask done = 0;
  const auto assumes = [&](const ModeNeed& need, StatementId statement) {
    done |= mask_of(need.mode);
    Hazard hazard = hazard_at(HazardKind::kModeAssumed, statement);
    hazard.mode = need.mode;
    hazard.needed_in = main;
    hazard.needed_line = need.line;
    hazards.add(std::move(hazard), static_cast<uint32_t>(need.mode));
  };
  for (const ModeNeed& need : program_.syntax.first_needs) {
    if (matters_by_path(need.mode) && program_.size() > 0) assumes(need, 0);
  }
  for (const ModeChange& change : program_.syntax.first_changes) done |= mask_of(change.mode);
  for (size_t i = 0; i < seen_.size(); ++i) {
    const ModeNeed& need = program_.syntax.mode_needs[i];
    const bool first =
        (done & mask_of(need.mode)) == 0 && matters_by_path(need.mode) && linked.file_of(need.after) == 0;
    if (!first || program_.region_of[need.after] != kMainRegion || seen_[i].empty()) continue;
    const ModeSetter setter = last_setter(analysis_, seen_[i][0].record, need.after + 1, mask_of(need.mode));
    if (setter.file == nullptr) assumes(need, need.after);
    done |= mask_of(need.mode);
  }
}

void ModeHazards::find_unused(Hazards& hazards) const {
  const Program& main = *analysis_.linked().files()[0].program;
  for (const UnusedChange& change : main.syntax.unused_changes) {
    if (!matters_by_path(change.first.mode) || change.first.after >= main.size()) continue;
    Hazard hazard = hazard_at(HazardKind::kModeInactive, change.first.after);
    hazard.mode = change.first.mode;
    hazard.from = change.first.value;
    hazard.to = change.value;
    hazard.set_in = hazard.needed_in = &main;
    hazard.set_line = change.first.line;
    hazard.needed_line = change.line;
    hazards.add(std::move(hazard), change.line);
  }
}

void ModeHazards::find(Hazards& hazards) const {
  find_leaks(hazards);
  find_different(hazards);
  find_assumed(hazards);
  find_unused(hazards);
}

}  // namespace owlint::flow
