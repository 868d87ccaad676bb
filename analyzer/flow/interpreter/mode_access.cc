#include "analyzer/flow/interpreter/mode_access.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace owlint::flow {
namespace {

template <typename Visit>
void for_modes(ModeMask mask, const Visit& visit) {
  for (; mask != 0; mask &= mask - 1) visit(static_cast<Mode>(std::countr_zero(mask)));
}

void put(ModeSets& sets, Mode mode, ModeValues values) {
  sets[mode] = values.may;
  if (!values.open) sets.open &= ~mask_of(mode);
}

ModeValues of(const ModeSets& sets, Mode mode) { return {sets[mode], sets.is_open(mode)}; }

/// What a line that is not carried out by itself sets is known by the line.
double number_by_line(const ModeChange& change) {
  constexpr uint32_t kLines = 1U << 20;
  if (change.number != ModeSets::kAnyNumber) return change.number;
  return -2 - (static_cast<double>(change.after) * kLines + change.line % kLines);
}

/// The only value of a mode, as a line says it or as it is in effect; else kAny.
uint8_t value_of(const ModeSets& modes, Mode mode, uint8_t said) {
  if (said != ModeChange::kAny || !is_single(modes[mode])) return said;
  return static_cast<uint8_t>(std::countr_zero(modes[mode]));
}

/// Whether lines that are not carried out one by one go somewhere.
bool is_lost(const PlaceChange& change, const ModeSets& modes) {
  const bool other = change.alone && (modes[Mode::kMotion] & ~kPlainMotions) != 0;
  return change.lost || other || value_of(modes, Mode::kCompensation, change.compensation) != modes::kG40;
}

/// The modes of these lines, as far as they are one value; what the lines say is applied behind them.
ModeSets modes_of(const PlaceChange& change, ModeSets modes) {
  for (const auto& [mode, said] : {std::pair(Mode::kUnits, change.units), std::pair(Mode::kSystem, change.system)}) {
    if (said != ModeChange::kAny) modes[mode] = value_bit(said);
  }
  return modes;
}

/// What the numbers of such lines mean.
class MoveReading {
 public:
  MoveReading(const PlaceChange& change, const ModeSets& modes)
      : distance_(value_of(modes, Mode::kDistance, change.distance)),
        diameter_(value_of(modes, Mode::kDiameter, change.diameter)) {}

  bool is_summed() const { return distance_ == modes::kG91; }
  /// Where an axis is behind words that are `word` in G90, and come to `sum` in G91.
  Coordinate end(Coordinate from, size_t axis, double word, double sum) const {
    if (distance_ == ModeChange::kAny || (axis == 0 && diameter_ == ModeChange::kAny)) return Coordinate::unknown();
    const double share = axis == 0 && diameter_ == modes::kG7 ? 0.5 : 1;
    return is_summed() ? from + Coordinate::of(sum * share) : Coordinate::of(word * share);
  }

 private:
  uint8_t distance_, diameter_;
};

constexpr ModeMask kLevel = mask_of(Mode::kSaved);  // belongs to a level of calls, as what is saved does

}  // namespace

ModeState ModeAccess::state(const Parameters& p) const {
  // Code that owlint does not know may have set anything.
  ModeState out = p.outside ? ModeState::unknown() : ModeState{uses_.others(), uses_.others()};
  for_modes(uses_.followed() & ~kLevel, [&](Mode mode) {
    put(out.now, mode, mode_values(values_, mode, p.globals.get(mode_key(mode))));
    if (uses_.follows(Mode::kSaved)) put(out.saved, mode, mode_values(values_, mode, p.locals.get(saved_key(mode))));
  });
  if (!uses_.follows(Mode::kSaved)) return out;
  const auto number = [this](ValueId id) {
    return KnownValues::is_constant(id) ? values_.value(id) : ModeSets::kAnyNumber;
  };
  if (!p.outside) {
    out.now.feed_number = number(p.globals.get(kModeKeys + kFeedNumber));
    out.now.speed_number = number(p.globals.get(kModeKeys + kSpeedNumber));
    out.saved.feed_number = number(p.locals.get(saved_keys_ + kFeedNumber));
    out.saved.speed_number = number(p.locals.get(saved_keys_ + kSpeedNumber));
  }
  put(out.now, Mode::kSaved, mode_values(values_, Mode::kSaved, p.locals.get(saved_key(Mode::kSaved))));
  return out;
}

void ModeAccess::set(Parameters& p, const ModeState& state) {
  const PersistentMap::Pool::Batch batch(pool_);
  for_modes(uses_.followed() & ~kLevel,
            [&](Mode mode) { p.globals.set(pool_, mode_key(mode), mode_value(values_, mode, of(state.now, mode))); });
  say(p, state.now.assigned);
  if (!uses_.follows(Mode::kSaved)) return;
  p.globals.set(pool_, kModeKeys + kFeedNumber, values_.intern(state.now.feed_number));
  p.globals.set(pool_, kModeKeys + kSpeedNumber, values_.intern(state.now.speed_number));
  const PersistentMap::Pool::Batch locals(pool_);
  p.locals.set(pool_, saved_keys_ + kFeedNumber, values_.intern(state.saved.feed_number));
  p.locals.set(pool_, saved_keys_ + kSpeedNumber, values_.intern(state.saved.speed_number));
  p.locals.set(pool_, saved_key(Mode::kSaved), mode_value(values_, Mode::kSaved, of(state.now, Mode::kSaved)));
  for_modes(uses_.followed() & ~kLevel,
            [&](Mode mode) { p.locals.set(pool_, saved_key(mode), mode_value(values_, mode, of(state.saved, mode))); });
}

void ModeAccess::apply(Parameters& p, std::span<const ModeChange> changes) {
  const auto feed_mode_of = [&] {
    return mode_values(values_, Mode::kFeedMode, p.globals.get(mode_key(Mode::kFeedMode)));
  };
  const bool feed_modes = uses_.follows(Mode::kFeedMode);
  const ModeValues before = feed_modes ? feed_mode_of() : ModeValues{};
  const auto mode_change = std::ranges::find(changes, Mode::kFeedMode, &ModeChange::mode);
  for (const ModeChange& change : changes) {
    const Mode mode = change.mode;
    if (!uses_.follows(mode)) continue;
    ModeValues values{all_values(mode), true};
    if (change.value != ModeChange::kAny) values = {value_bit(change.value), false};
    // Whether a compensated path has begun depends on how far lines go.
    if (mode == Mode::kEntry && change.value == ModeChange::kAny && uses_.follows_place()) {
      const CompensatedPath path = place(p).path;
      if (path.offsets()) values = {value_bit(path.entered() ? modes::kMade : modes::kToCome), false};
    }
    // In inverse time mode F only counts for its line, and a move leaves a feed that is worked out.
    if (mode == Mode::kFeed && feed_modes) {
      const bool earlier = mode_change != changes.end() && change.line < mode_change->line;
      const ModeValues feed_mode = earlier ? before : feed_mode_of();
      const ValueSet g93 = value_bit(modes::kG93);
      if ((feed_mode.may & g93) != 0 && change.moves) values = {all_values(mode), true};
      if (feed_mode.may == g93 && !change.moves) continue;
      if ((feed_mode.may & g93) != 0 && !change.moves) {
        const ModeValues kept = mode_values(values_, mode, p.globals.get(mode_key(mode)));
        values = {kept.may | values.may, true};
      }
    }
    p.globals.set(pool_, mode_key(mode), mode_value(values_, mode, values));
    say(p, mask_of(mode));
    const bool counts = mode == Mode::kFeed || mode == Mode::kSpeed;
    if (!counts || !uses_.follows(Mode::kSaved)) continue;
    const double number =
        values.open || change.value == ModeChange::kAny ? ModeSets::kAnyNumber : number_by_line(change);
    p.globals.set(pool_, kModeKeys + (mode == Mode::kFeed ? kFeedNumber : kSpeedNumber), values_.intern(number));
  }
}

Place ModeAccess::place(const Parameters& p) const {
  const ValueId id = p.outside ? kUnknown : p.globals.get(kPlaceKey);
  return KnownValues::is_place(id) ? values_.place(id) : Place::unknown();
}

void ModeAccess::set_place(Parameters& p, const Place& place) {
  p.globals.set(pool_, kPlaceKey, values_.intern(place));
}

void ModeAccess::begin_line(Parameters& p) {
  if (!KnownValues::is_place(p.globals.get(kReadPlaceKey)))
    p.globals.set(pool_, kReadPlaceKey, p.globals.get(kPlaceKey));
}

void ModeAccess::end_line(Parameters& p) {
  if (p.globals.get(kReadPlaceKey) != kUnassigned) p.globals.set(pool_, kReadPlaceKey, kUnassigned);
}

void ModeAccess::go(Parameters& p, std::span<const PlaceChange> changes) {
  if (!uses_.follows_place() || changes.empty()) return;
  Place place = this->place(p);
  const ModeSets modes = state(p).now;
  for (const PlaceChange& change : changes) {
    if (is_lost(change, modes)) {
      place.lose_offsets();
      continue;
    }
    const MoveReading reading(change, modes);
    for (size_t axis = 0; axis < kAxisCount; ++axis) {
      if ((change.axes >> axis & 1) == 0) continue;
      place.at[axis] = reading.end(place.at[axis], axis, change.last[axis], change.sum[axis]);
    }
    place.keeps_height = false;
  }
  place.settle();
  set_place(p, place);
}

void ModeAccess::tell(const Parameters& p, const PlaceChange& change, MoveWatch watch) const {
  const ModeSets modes = modes_of(change, state(p).now);
  if (is_lost(change, modes)) return watch.visitor->lose(watch.line, kAllAxes);
  if (change.reaches == nullptr) return;
  const Place place = this->place(p);
  const MoveReading reading(change, modes);
  for (const bool rapid : {true, false}) {
    const PlainReach& reach = rapid ? change.reaches->rapid : change.reaches->feed;
    if (reach.letters == 0) continue;
    Moves moves;
    moves.kind = rapid ? MoveKind::kRapid : MoveKind::kFeed;
    moves.place = &place;
    if (is_single(modes[Mode::kSystem])) moves.system = static_cast<uint8_t>(std::countr_zero(modes[Mode::kSystem]));
    moves.unit = unit_in_effect(modes);
    moves.end_at(place.at, watch.line);
    for (size_t axis = 0; axis < kAxisCount; ++axis) {
      const Extremes& words = reach.words[axis];
      const Extremes& sums = reach.sums[axis];
      if (!(words.least <= words.greatest)) continue;
      const bool summed = reading.is_summed();
      moves.axes |= axis_set(axis);
      moves.ways[axis] = {reading.end(place.at[axis], axis, words.least, sums.least),
                          reading.end(place.at[axis], axis, words.greatest, sums.greatest),
                          summed ? sums.least_line : words.least_line,
                          summed ? sums.greatest_line : words.greatest_line};
    }
    watch.visitor->visit(moves);
  }
  if (change.reaches->curves) watch.visitor->lose(watch.line, axis_set(0) | axis_set(1) | axis_set(2));
}

void ModeAccess::begin_level(Parameters& p) {
  if (!uses_.follows(Mode::kSaved)) return;
  p.locals.set(pool_, saved_key(Mode::kSaved), mode_value(values_, Mode::kSaved, {value_bit(modes::kNotSaved), false}));
}

void ModeAccess::keep_motion(Parameters& p, const ModeState& state) {
  if (uses_.follows(Mode::kMotion))
    p.locals.set(pool_, motion_key(), mode_value(values_, Mode::kMotion, of(state.now, Mode::kMotion)));
}

ModeValues ModeAccess::kept_motion(const Parameters& p) const {
  // What is not followed is the same everywhere.
  if (!uses_.follows(Mode::kMotion)) return {};
  return mode_values(values_, Mode::kMotion, p.locals.get(motion_key()));
}

void ModeAccess::drop_motion(Parameters& p) {
  if (uses_.follows(Mode::kMotion)) p.locals.set(pool_, motion_key(), kUnassigned);
}

bool ModeAccess::compensates(const Parameters& p) const {
  if (!uses_.follows(Mode::kCompensation)) return false;
  const ModeValues side = mode_values(values_, Mode::kCompensation, p.globals.get(mode_key(Mode::kCompensation)));
  return (side.may & value_bit(modes::kG40)) == 0;
}

bool ModeAccess::restores(const Parameters& p) const {
  if (!uses_.follows(Mode::kSaved)) return false;
  const ModeValues saved = mode_values(values_, Mode::kSaved, p.locals.get(saved_key(Mode::kSaved)));
  return (saved.may & value_bit(modes::kSavedByM73)) != 0;
}

}  // namespace owlint::flow
