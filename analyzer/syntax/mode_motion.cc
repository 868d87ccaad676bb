// What depends on the motion in effect: a line of axis words means something else in each. It is tried with all that may be, and
// the results are joined.
#include <algorithm>
#include <bit>

#include "analyzer/syntax/mode_place.h"

namespace owlint {
namespace {

constexpr MotionSet first_of(MotionSet set) { return set & ~(set - 1); }

template <typename Try>
void for_motions(MotionSet motions, Try attempt) {
  for (; motions != 0; motions &= motions - 1) attempt(static_cast<Motion>(std::countr_zero(motions)));
}

/// Collects the faults of the line in each of the motions. One message is one fault.
class FaultsByMotion {
 public:
  /// `depends`: whether it is the motion in effect that counts.
  FaultsByMotion(bool depends, bool open, MotionSet motions, std::vector<ModeFault>* faults)
      : depends_(depends), open_(open), motions_(motions), faults_(*faults), first_(faults->size()) {}

  void add(Motion motion, ModeFault fault);
  /// Whether the fault has been found in all of these motions.
  bool has(std::string_view message, MotionSet motions) const;
  void finish(bool some_go_on);
  /// Some runs may have another motion in effect, and do not stop.
  void doubt();
  /// Whether some runs have ended.
  bool believed() const {
    return std::any_of(faults_.begin() + static_cast<ptrdiff_t>(first_), faults_.end(),
                       [](const ModeFault& fault) { return fault.believed; });
  }

 private:
  struct Found {
    MotionSet in = 0;
    MotionSet certain = 0;
    bool believed = false;
  };

  const bool depends_;
  const bool open_;
  const MotionSet motions_;
  std::vector<ModeFault>& faults_;
  const size_t first_;
  std::vector<Found> found_;
};

void FaultsByMotion::add(Motion motion, ModeFault fault) {
  const auto begin = faults_.begin() + static_cast<ptrdiff_t>(first_);
  const auto same = std::find_if(begin, faults_.end(),
                                 [&](const ModeFault& one) { return one.fault.message == fault.fault.message; });
  const auto index = static_cast<size_t>(same - begin);
  if (index == found_.size()) found_.emplace_back();
  Found& found = found_[index];
  found.in |= set_of(motion);
  if (fault.fault.certain) found.certain |= set_of(motion);
  found.believed = found.believed || fault.believed;
  if (same == faults_.end()) faults_.push_back(std::move(fault));
}

bool FaultsByMotion::has(std::string_view message, MotionSet motions) const {
  for (size_t i = 0; i < found_.size(); ++i) {
    if (faults_[first_ + i].fault.message == message) return (motions & ~found_[i].in) == 0;
  }
  return false;
}

void FaultsByMotion::finish(bool some_go_on) {
  for (size_t i = 0; i < found_.size(); ++i) {
    ModeFault& fault = faults_[first_ + i];
    const Found& found = found_[i];
    const bool motion_decides = found.in != motions_ || (found.certain != 0 && found.certain != motions_);
    fault.fault.certain = found.certain == motions_;
    fault.believed = motion_decides ? found.certain != 0 && !open_ : found.believed;
    if (depends_) fault.decided_by |= mask_of(Mode::kMotion);
  }
  if (some_go_on) return;
  faults_.back().fault.certain = faults_.back().believed = true;
}

void FaultsByMotion::doubt() {
  for (size_t i = first_; i < faults_.size(); ++i) faults_[i].fault.certain = faults_[i].believed = false;
}

/// Whether a G code that the INI defines may be the motion in effect, as its Python may leave it: it takes any word.
bool may_be_remapped(const MachineWords& machine, bool open) {
  return open && std::ranges::any_of(machine.remapped, [](const RemappedCode& code) { return code.letter == 'g'; });
}

/// What WordLine::check has to know of the modes.
Modes modes_of(const ModeSets& now, Motion motion) {
  const ValueSet distance = now[Mode::kDistance], plane = now[Mode::kPlane];
  Modes modes{motion, Modes::kDistanceUnknown, Modes::kPlaneUnknown};
  if (distance == value_bit(modes::kG90)) modes.distance = Modes::kAbsolute;
  if (distance == value_bit(modes::kG91)) modes.distance = Modes::kIncremental;
  if (plane == value_bit(modes::kG17)) modes.plane = Modes::kG17;
  if ((plane & value_bit(modes::kG17)) == 0) modes.plane = Modes::kOtherPlane;
  return modes;
}

/// The faults of WordLine::check that a mode decides, and the value that passes.
struct ByMode {
  const char* message;
  Mode mode;
  uint8_t good;
};
constexpr ByMode kByMode[] = {{kPolarOutsideG17, Mode::kPlane, modes::kG17},
                              {kIncrementalG53, Mode::kDistance, modes::kG90}};

/// The mode that decides the fault, or null.
const ByMode* decider(const WordLine& words, const Fault& fault) {
  const auto* const row = std::ranges::find_if(kByMode, [&](const ByMode& by) { return by.message == fault.message; });
  if (row == std::end(kByMode) || words.has_unknown_code()) return nullptr;
  return row->mode == Mode::kDistance && words.code(GGroup::kDistance) != nullptr ? nullptr : row;
}

ModeFault with_modes(const WordLine& words, Fault fault, const ModeSets& now) {
  const ByMode* const by = decider(words, fault);
  const bool certain = fault.certain;
  if (by == nullptr) return {std::move(fault), certain, 0};
  return {std::move(fault), certain || !now.is_open(by->mode), mask_of(by->mode)};
}

bool move(ModeLine& line, Motion motion) {
  constexpr MotionSet kNurbs = set_of(Motion::kG5_2) | set_of(Motion::kG6_2);
  constexpr MotionSet kThreads = set_of(Motion::kG33) | set_of(Motion::kG33_1) | set_of(Motion::kG76);
  if (contains(kStraightMotions, motion)) return steps::straight(line, motion);
  if (contains(kArcMotions, motion)) return steps::arc(line, motion);
  if (contains(kSplines, motion)) return steps::spline(line, motion);
  if (contains(kNurbs, motion)) return steps::nurbs(line, motion);
  if (contains(kThreads, motion)) return steps::thread(line, motion);
  if (contains(kProbes, motion)) return steps::probe(line, motion);
  if (contains(kCycles, motion)) return steps::cycle(line, motion);
  return contains(kContours, motion) && steps::contour(line, motion);
}

/// The motion mode behind the line; a contour has set it itself.
void leave(ModeLine& line) {
  if (cuts_contour(line.words())) return;
  const MotionSet before = line.now()[Mode::kMotion];
  const MotionSet after = line.words().after(before) & all_modes();
  const GCode* const own = line.words().code(GGroup::kMotion);
  if (after == before && (own == nullptr || own->leaves != GCode::kItself)) return;
  if (is_single(after)) return line.set_known(Mode::kMotion, after);
  line.set_open(Mode::kMotion, after);
}

bool stops_moving_by(ModeLine& line, Motion mode) {
  const Motion motion = line.words().motion(mode);
  if (line.place() != nullptr && motion != Motion::kNone && !contains(kCycles, motion))
    line.place()->keeps_height = false;
  if (places::moves_indexing_axis(line, motion) || move(line, motion)) return true;
  // Measured: such a move leaves the motion mode as it was.
  if (motion != Motion::kG0 || !places::names_indexing_axis(line)) leave(line);
  return false;
}

}  // namespace

bool stops_before_it_acts(const MachineWords& machine, const WordLine& words, ModeState* state,
                          std::vector<ModeFault>* faults) {
  ModeSets& now = state->now;
  const MotionSet in_effect = now[Mode::kMotion];
  const MotionSet motions = words.depends_on_motion() ? in_effect : first_of(in_effect);
  FaultsByMotion found(words.depends_on_motion(), now.is_open(Mode::kMotion), motions, faults);
  MotionSet pass = motions;
  for_motions(motions, [&](Motion motion) {
    Modes modes = modes_of(now, motion);
    std::optional<Fault> fault = words.check(modes);
    if (!fault) return;
    // Polar words outside of G17 come before what the line stops with in any plane.
    if (fault->certain && modes.plane == Modes::kPlaneUnknown && words.has_polar_words()) {
      modes.plane = Modes::kOtherPlane;
      const std::optional<Fault> other = words.check(modes);
      if (other && other->message == kPolarOutsideG17) {
        ModeFault first{*other, !now.is_open(Mode::kPlane), mask_of(Mode::kPlane)};
        first.fault.certain = false;
        found.add(motion, std::move(first));
      }
    }
    if (fault->certain) pass &= ~set_of(motion);
    found.add(motion, with_modes(words, *std::move(fault), now));
  });
  const bool doubtful = words.depends_on_motion() && may_be_remapped(machine, now.is_open(Mode::kMotion));
  found.finish(pass != 0 || doubtful);
  if (doubtful) {
    found.doubt();
    return false;
  }
  if (pass == 0) return true;
  for (const ByMode& by : kByMode) {
    // With one value of the mode it is possible for what is not known of the line.
    if (found.has(by.message, pass) && (now[by.mode] & value_bit(by.good)) != 0) now[by.mode] &= value_bit(by.good);
  }
  if (motions == in_effect) now[Mode::kMotion] = pass;
  if (found.believed()) state->lose_runs();
  return false;
}

bool stops_moving(ModeLine& line) {
  const WordLine& words = line.words();
  const MotionSet motions = line.now()[Mode::kMotion];
  if (!words.depends_on_motion() || is_single(motions)) {
    const auto mode = static_cast<Motion>(std::countr_zero(motions));
    return stops_moving_by(line, mode);
  }
  const bool open = line.now().is_open(Mode::kMotion);
  places::lose_moves(line, places::named_axes(line));
  FaultsByMotion found(true, open, motions, line.faults());
  std::optional<ModeState> joined;
  std::optional<Place> behind;
  std::vector<ModeFault> faults;
  for_motions(motions, [&](Motion mode) {
    ModeState state = line.state();
    std::optional<Place> place;
    if (line.place() != nullptr) place = *line.place();
    faults.clear();
    state.now[Mode::kMotion] = set_of(mode);
    state.now.open &= ~mask_of(Mode::kMotion);
    ModeLine one(line, &state, &faults, place ? &*place : nullptr);
    const bool stops = stops_moving_by(one, mode);
    for (ModeFault& fault : faults) found.add(mode, std::move(fault));
    if (stops) return;
    joined = joined ? join(*joined, state) : state;
    if (place) behind = behind ? join(*behind, *place) : *place;
  });
  const bool doubtful = may_be_remapped(line.machine(), open);
  found.finish(joined.has_value() || doubtful);
  if (doubtful) {
    found.doubt();
    line.state() = ModeState::unknown();
    if (line.place() != nullptr) *line.place() = Place::unknown();
    return false;
  }
  if (!joined) return true;
  line.state() = *joined;
  if (behind) *line.place() = *behind;
  if (open) line.now().open |= mask_of(Mode::kMotion);
  if (found.believed()) line.state().lose_runs();
  return false;
}

}  // namespace owlint
