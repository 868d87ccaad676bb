#include "analyzer/flow/facts/mode_uses.h"

#include <algorithm>
#include <initializer_list>

#include "analyzer/flow/domain/modes.h"
#include "analyzer/flow/domain/parameters.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/mode_line.h"
#include "analyzer/syntax/mode_names.h"
#include "analyzer/syntax/place_names.h"
#include "analyzer/syntax/questions.h"
#include "analyzer/syntax/remaps.h"

namespace owlint::flow {
namespace {

bool has_store(const WordLine& words) {
  const MCode* const code = words.code(MGroup::kSpindle);
  return code != nullptr && code->number >= code::kM70 && code->number <= code::kM73;
}

/// Modes of which it is told where a program has not set them.
bool is_assumed(Mode mode) { return mode == Mode::kUnits || mode == Mode::kDistance || mode == Mode::kPlane; }

/// Whether a parameter is read that must not be while compensation is on.
bool reads_position(const Syntax& syntax) {
  return std::ranges::any_of(syntax.exprs, [&](const Expr& expr) {
    if (expr.op != Operator::kParameter) return false;
    const auto place = PlaceName::read_by(syntax, expr);
    return place && place->axis();
  });
}

/// What most codes ask for before they act: a computed one may be any of them.
constexpr ModeMask kAskedByCodes = mask_of(Mode::kFeed) | mask_of(Mode::kTurning) | mask_of(Mode::kPlane) |
    mask_of(Mode::kDistance) | mask_of(Mode::kCompensation) | mask_of(Mode::kMotion) | mask_of(Mode::kUnits) |
    mask_of(Mode::kRadius) | mask_of(Mode::kEntry);

bool computes_code(const Syntax& syntax, const Statement& asks) {
  return std::ranges::any_of(syntax.words_of(asks), [](const ModeWord& word) {
    return word.computed != kNoExpr && (word.letter == 'g' || word.letter == 'm');
  });
}

/// Modes that the program reads as parameters. What it sets itself is not that of the mode any more.
ModeMask modes_read(const Syntax& syntax) {
  ModeMask read = 0, set = 0;
  for (const Expr& expr : syntax.exprs) {
    if (const auto shown = ModeName::read_by(syntax, expr)) (expr.target ? set : read) |= mask_of(shown->mode());
  }
  return read & ~set;
}

ModeSets only(ModeSets sets, const ModeChange& change) {
  sets[change.mode] |= change.value == ModeChange::kAny ? all_values(change.mode) : value_bit(change.value);
  return sets;
}

}  // namespace

bool read_words(const Syntax& syntax, const Statement& asks, WordLine& into) {
  const bool calls = asks_about_call(syntax, static_cast<StatementId>(&asks - syntax.statements.data()));
  if (calls) into.begin_call();
  for (const ModeWord& word : syntax.words_of(asks))
    into.add({word.letter, word.known, word.value, word.from, word.to});
  return !calls;
}

ModeUses::ModeUses(const Program& program, const MachineWords& machine, const ModeSets& start, ModeMask others)
    : program_(program), machine_(machine), reachable_(start), others_(start), followed_(others) {
  find_reachable();
  find_followed();
  others_ = reachable_;
  for (size_t i = 0; i < kModes; ++i) {
    if (!is_single(reachable_.may[i])) others_.open |= ModeMask{1} << i;
  }
}

void ModeUses::find_reachable() {
  for (const auto* changes : {&program_.syntax.first_changes, &program_.syntax.mode_changes}) {
    for (const ModeChange& change : *changes) reachable_ = only(reachable_, change);
  }
  // What a line leaves may depend on what others leave.
  constexpr int kRounds = 8;
  bool grew = true;
  for (int round = 0; round < kRounds && grew; ++round) {
    grew = false;
    std::vector<ModeFault> faults;
    for (StatementId id = 0; id < program_.size(); ++id) {
      if (program_.at(id).kind == LineKind::kModeLine) grew = run(id, &faults) || grew;
    }
  }
}

bool ModeUses::run_part(StatementId id, const WordLine& words, ModeState* after, std::vector<ModeFault>* faults) const {
  const RemapsAround around = remaps_around(program_.syntax, id);
  if (around.before == nullptr && around.next == nullptr) return ModeRun(machine_, words).act(after, faults);
  const auto code_of = [&](const Statement* remap) {
    return remap == nullptr ? nullptr : code_of_remap(program_.syntax, *remap, machine_);
  };
  const LinePart part{code_of(around.before), code_of(around.next)};
  if (part.behind != nullptr && (part.behind->python_before || part.behind->python_behind))
    *after = ModeState::unknown();
  if (!ModeRun(machine_, words).act_part(part, after, faults)) return false;
  // Within their own subs some codes are built in.
  MachineWords plain = machine_;
  plain.remapped = {};
  WordLine built_in(plain);
  read_words(program_.syntax, program_.at(id), built_in);
  ModeState own = *after;
  if (ModeRun(plain, built_in).act_part(part, &own, faults)) *after = join(*after, own);
  return true;
}

bool ModeUses::run(StatementId id, std::vector<ModeFault>* faults) {
  WordLine words(machine_);
  const bool acts = read_words(program_.syntax, program_.at(id), words);
  ModeState after{reachable_, reachable_};
  const ModeRun run(machine_, words);
  if (!run.check(&after, faults) || !acts || !run_part(id, words, &after, faults)) return false;
  const ModeSets before = reachable_;
  after.now.assigned = 0;
  reachable_ = join(before, after.now);
  return reachable_ != before;
}

void ModeUses::find_followed() {
  std::vector<ModeFault> faults;
  bool stores = false;
  for (StatementId id = 0; id < program_.size(); ++id) {
    const Statement& s = program_.at(id);
    if (s.kind != LineKind::kModeLine) continue;
    run(id, &faults);
    WordLine words(machine_);
    if (!read_words(program_.syntax, s, words)) continue;
    stores = stores || has_store(words);
    if (computes_code(program_.syntax, s)) followed_ |= kAskedByCodes;
    // Whether it feeds depends on the lines of its sub.
    if (cuts_contour(words)) followed_ |= mask_of(Mode::kFeed) | mask_of(Mode::kSpeed);
  }
  for (const ModeFault& fault : faults) followed_ |= fault.decided_by;
  refuses_ = !faults.empty();
  const bool compensates = reachable_[Mode::kCompensation] != value_bit(modes::kG40);
  if (compensates && reads_position(program_.syntax)) followed_ |= mask_of(Mode::kCompensation);
  // A first move with compensation stops where it stays in place: only all of these together say that it is one.
  if (compensates && (reachable_[Mode::kRadius] & value_bit(modes::kRadiusSet)) != 0)
    followed_ |= mask_of(Mode::kCompensation) | mask_of(Mode::kRadius) | mask_of(Mode::kEntry) | mask_of(Mode::kPlane);
  // What moves mean differs only where a program has both.
  for (const auto* needs : {&program_.syntax.first_needs, &program_.syntax.mode_needs}) {
    for (const ModeNeed& need : *needs) {
      if (is_assumed(need.mode) || !is_single(reachable_[need.mode])) followed_ |= mask_of(need.mode);
    }
  }
  // What a sub gets may have to be above 0.
  for (const RemappedCode& code : machine_.remapped) {
    if (code.argspec.find('>') != std::string_view::npos) followed_ |= mask_of(Mode::kFeed);
    if (code.argspec.find('^') != std::string_view::npos) followed_ |= mask_of(Mode::kSpeed);
  }
  if (follows_place()) {
    for (const Mode mode :
         {Mode::kMotion, Mode::kPlane, Mode::kUnits, Mode::kDistance, Mode::kArcDistance, Mode::kDiameter,
          Mode::kSystem, Mode::kRetract, Mode::kCompensation, Mode::kRadius, Mode::kEntry}) {
      if (!is_single(reachable_[mode])) followed_ |= mask_of(mode);
    }
  }
  named_ = modes_read(program_.syntax);
  followed_ |= named_;
  // What these depend on.
  const auto needs = [this](Mode mode, std::initializer_list<Mode> others) {
    if (!follows(mode)) return;
    for (const Mode other : others) followed_ |= mask_of(other);
  };
  needs(Mode::kFeed, {Mode::kFeedMode, Mode::kMotion});
  needs(Mode::kStraightOwed, {Mode::kEntry});
  needs(Mode::kEntry, {Mode::kRadius, Mode::kMotion, Mode::kPlane});
  for (const Mode mode : {Mode::kRadius, Mode::kEntry, Mode::kStraightOwed}) needs(mode, {Mode::kCompensation});
  if (!stores) return;
  // Whether M72 has anything to restore, and so what becomes of its line, depends on every mode.
  for (size_t i = 0; i < kModes; ++i) {
    if (!is_single(reachable_.may[i])) followed_ |= ModeMask{1} << i;
  }
  if (followed_ != 0) followed_ |= mask_of(Mode::kSaved);
}

ModeMask ModeUses::changed_at(StatementId id) const {
  if (followed_ == 0 && !follows_place()) return 0;
  const Statement& s = program_.at(id);
  const bool goes = follows_place(id) && (s.changes_place || s.kind == LineKind::kModeLine);
  ModeMask changed = modes_changed_at(s, id) & followed_;
  if (follows(Mode::kSaved) && (changed & mask_of(Mode::kFeed)) != 0) changed |= ModeMask{1} << kFeedNumber;
  if (follows(Mode::kSaved) && (changed & mask_of(Mode::kSpeed)) != 0) changed |= ModeMask{1} << kSpeedNumber;
  return changed | (goes ? kPlaceBit : 0);
}

ModeMask ModeUses::set_at(StatementId id) const {
  const Statement& s = program_.at(id);
  WordLine words(machine_);
  if (s.kind != LineKind::kModeLine || !read_words(program_.syntax, s, words)) return 0;
  const MCode* const code = words.code(MGroup::kSpindle);
  const bool restores = code != nullptr && code->number == code::kM72;
  const Statement* const before = remaps_around(program_.syntax, id).before;
  const RemappedCode* const behind = before == nullptr ? nullptr : code_of_remap(program_.syntax, *before, machine_);
  const bool python = behind != nullptr && (behind->python_before || behind->python_behind);
  if (restores || python || words.has_unknown_code()) return followed_;
  ModeState after{reachable_, reachable_};
  after.now.assigned = 0;
  std::vector<ModeFault> faults;
  run_part(id, words, &after, &faults);
  return after.now.assigned & followed_;
}

ModeMask ModeUses::modes_changed_at(const Statement& s, StatementId id) const {
  ModeMask changed = 0;
  if (s.changes_modes) {
    for (const ModeChange& change : program_.syntax.changes_after(id)) changed |= mask_of(change.mode);
  }
  if (s.kind == LineKind::kModeLine) {
    WordLine words(machine_);
    if (!read_words(program_.syntax, s, words)) return changed;
    if (words.has_unknown_code() || words.has_remapped_code() || has_store(words)) return followed_;
    ModeState after{reachable_, reachable_};
    std::vector<ModeFault> faults;
    ModeRun(machine_, words).run(&after, &faults);
    changed |= after.now.assigned;
  }
  return changed;
}

}  // namespace owlint::flow
