#include "analyzer/syntax/mode_run.h"

#include <algorithm>

#include "analyzer/syntax/mode_place.h"
#include "analyzer/syntax/mode_restore.h"

namespace owlint {
namespace {

using Step = bool (*)(ModeLine&);

/// The words in the order in which they act. M72 comes between the two: where it restores something, the rest is lost.
constexpr auto kFirstSteps =
    std::to_array<Step>({steps::spindle_mode, steps::feed_mode, steps::feed, steps::speed, steps::select_tool,
                         steps::inputs_outputs, steps::change_tool, steps::spindle, steps::save});
/// The first two of the rest are the last M codes of LinuxCNC's own; those of the machine, M100 to M199, follow them.
constexpr size_t kBeforeUserCodes = 2;
constexpr auto kRest =
    std::to_array<Step>({steps::coolant, steps::overrides, steps::plane, steps::units, steps::diameter,
                         steps::compensation, steps::tool_length, steps::system, steps::path_control, steps::distance,
                         steps::retract, steps::non_modal, steps::axis_offsets, stops_moving, steps::pause});

bool stops_at(std::span<const Step> steps, ModeLine& line) {
  return std::ranges::any_of(steps, [&](Step step) { return step(line); });
}

/// The rest of the steps. False if no run goes on.
bool run_rest(ModeLine& line, const WordLine& words) {
  const std::span rest(kRest);
  if (!words.is_user_m()) return !stops_at(rest, line);
  if (stops_at(rest.first(kBeforeUserCodes), line)) return false;
  const size_t before = line.faults()->size();
  const bool runs = !stops_at(rest.subspan(kBeforeUserCodes), line);
  for (ModeFault& fault : std::span(*line.faults()).subspan(before)) fault.behind_user_code = true;
  return runs;
}

/// A step that a remapped word replaces.
bool is_replaced(Step step, const WordLine& words) {
  if (step == steps::feed) return words.is_remapped('f');
  if (step == steps::speed) return words.is_remapped('s');
  if (step == steps::select_tool) return words.is_remapped('t');
  return step == stops_moving && words.moves_by_remap();
}

/// The last step that acts with a remapped code, or before it.
Step step_of(const RemappedCode& code) {
  switch (code.letter) {
    case 'f': return steps::feed;
    case 's': return steps::speed;
    case 't': return steps::select_tool;
    case 'g': return stops_moving;
    default: break;
  }
  switch (code.group) {
    case MGroup::kInputsOutputs: return steps::inputs_outputs;
    case MGroup::kToolChange: return steps::change_tool;
    case MGroup::kSpindle: return steps::save;
    case MGroup::kCoolant: return steps::coolant;
    case MGroup::kStop: return steps::pause;
    default: return steps::overrides;
  }
}

/// Faults of one of two courses: which of them a run takes is not known.
void add_possible(const std::vector<ModeFault>& found, std::vector<ModeFault>* faults) {
  for (const ModeFault& fault : found) {
    faults->push_back(fault);
    faults->back().fault.certain = faults->back().believed = false;
  }
}

/// The states behind two courses.
ModeState either(const ModeState& a, const ModeState& b) {
  ModeState joined = join(a, b);
  for (size_t i = 0; i < kModes; ++i) {
    if (a.now.may[i] != b.now.may[i]) joined.now.open |= mask_of(static_cast<Mode>(i));
    if (a.saved.may[i] != b.saved.may[i]) joined.saved.open |= mask_of(static_cast<Mode>(i));
  }
  return joined;
}

std::optional<Place> place_of(const Place* place) { return place == nullptr ? std::nullopt : std::optional(*place); }

/// What is restored of `before` may give the point other numbers.
void restore_place(const ModeState& before, bool certain, Place* place) {
  if (place == nullptr) return;
  constexpr Mode kSide = Mode::kCompensation;
  if ((before.now[kSide] | before.saved[kSide]) != value_bit(modes::kG40)) place->lose_path();
  for (const Mode mode : {Mode::kSystem, Mode::kToolOffset, Mode::kAxisOffsets}) {
    if (!is_single(before.now[mode] | before.saved[mode])) return place->lose_offsets();
  }
  const ValueSet now = before.now[Mode::kUnits], saved = before.saved[Mode::kUnits];
  if (now == saved && is_single(now)) return;
  if (!certain || !is_single(now) || !is_single(saved)) return place->lose_offsets();
  places::convert_units(place, saved == value_bit(modes::kG20));
}

bool asks_position(const ModeLine& line) {
  if (line.at(MGroup::kToolChange) != kNoWord) return true;
  int32_t what = 0;
  const double* const l = line.value('l');
  return line.code(GGroup::kNonModal) == code::kG10 && (l == nullptr || (word_integer(*l, &what) && what == 0));
}

/// Before the next line is read, the interpreter asks the machine where it is.
void ask_machine(ModeLine& line) {
  Place* const place = line.place();
  if (place == nullptr || !asks_position(line)) return;
  // Of a curve the stand-alone interpreter's machine does not know where it ends.
  constexpr MotionSet kNurbs = set_of(Motion::kG5_2) | set_of(Motion::kG6_2);
  if ((line.now()[Mode::kMotion] & (kSplines | kNurbs)) != 0) return place->lose_point();
  place->ask_machine(line.code(MGroup::kToolChange) == code::kM6 && !line.machine().change_stays);
}

/// M72, and the rest of its line if there was nothing to restore. False if no run goes on.
bool run_from_m72(ModeLine& line) {
  const uint8_t word = line.at(MGroup::kSpindle);
  if (line.stop_in({{Mode::kSaved, value_bit(modes::kNotSaved)}}, StopKind::kSavedModes,
                   "Cannot restore context from invalid stack frame - missing M70/M73?", word))
    return false;
  ModeState as_before = line.state();
  const Restored restored = restore(line.machine(), as_before.saved, word, line);
  if (restored.something == Answer::kNo) return !stops_at(kRest, line);
  if (restored.stops) return false;
  if (restored.something == Answer::kMaybe) places::lose_moves(line);
  std::optional<Place> place = place_of(line.place());
  restore_place(as_before, true, line.place());
  if (restored.something == Answer::kYes) return true;
  std::vector<ModeFault> faults;
  ModeLine unlost(line, &as_before, &faults, place ? &*place : nullptr);
  const bool runs = !stops_at(kRest, unlost);
  add_possible(faults, line.faults());
  if (!runs) return true;
  line.state() = either(line.state(), as_before);
  if (place) *line.place() = join(*line.place(), *place);
  return true;
}

}  // namespace

bool ModeRun::check(ModeState* state, std::vector<ModeFault>* faults) const {
  return !stops_before_it_acts(machine_, line_, state, faults);
}

bool ModeRun::act(ModeState* state, std::vector<ModeFault>* faults, Place* place, MoveWatch watch,
                  const ContourSub* contour) const {
  if (line_.has_unknown_code() || line_.has_remapped_code()) {
    *state = ModeState::unknown();
    if (place != nullptr) *place = Place::unknown();
    if (watch.visitor != nullptr) watch.visitor->lose(watch.line, kAllAxes);
    return true;
  }
  ModeLine line(machine_, line_, state, faults, place, watch, contour);
  if (stops_at(kFirstSteps, line)) return false;
  const bool restores = line.code(MGroup::kSpindle) == code::kM72;
  if (restores ? !run_from_m72(line) : !run_rest(line, line_)) return false;
  ask_machine(line);
  return true;
}

std::optional<bool> ModeRun::loses_rest(const ModeState& before) const {
  const MCode* const code = line_.code(MGroup::kSpindle);
  if (code == nullptr || code->number != code::kM72 || line_.has_unknown_code()) return false;
  ModeState state = before;
  std::vector<ModeFault> faults;
  ModeLine line(machine_, line_, &state, &faults, nullptr);
  if (stops_at(kFirstSteps, line)) return false;
  const ModeSets saved = state.saved;
  const Answer something = restore(machine_, saved, line.at(MGroup::kSpindle), line).something;
  if (something == Answer::kMaybe) return std::nullopt;
  return something == Answer::kYes;
}

bool ModeRun::act_part(const LinePart& part, ModeState* state, std::vector<ModeFault>* faults, Place* place,
                       MoveWatch watch) const {
  ModeLine line(machine_, line_, state, faults, place, watch);
  bool runs = part.behind == nullptr;
  for (const auto steps : {std::span<const Step>(kFirstSteps), std::span<const Step>(kRest)}) {
    for (const Step step : steps) {
      if (runs && step == stops_moving && part.motion != 0 && line_.depends_on_motion()) {
        line.now()[Mode::kMotion] = part.motion;
        line.now().open &= ~mask_of(Mode::kMotion);
        if (part.motion_open) line.now().open |= mask_of(Mode::kMotion);
      }
      if (runs && !is_replaced(step, line_) && step(line)) return false;
      if (part.until != nullptr && step == step_of(*part.until)) return true;
      runs = runs || step == step_of(*part.behind);
    }
  }
  ask_machine(line);
  return true;
}

bool read_position(ModeState* state, std::vector<ModeFault>* faults) {
  return !ModeFaults(state, faults)
              .stop_in({kCompensationOn}, StopKind::kCompensation,
                       "Cannot read current position with cutter radius compensation on", kNoWord);
}

bool restore_modes(const MachineWords& machine, ModeState* state, std::vector<ModeFault>* faults, Place* place) {
  const ValueSet saved = state->now[Mode::kSaved];
  if ((saved & value_bit(modes::kSavedByM73)) == 0) return true;
  restore_place(*state, saved == value_bit(modes::kSavedByM73), place);
  if (saved == value_bit(modes::kSavedByM73)) {
    ModeFaults line(state, faults);
    return !restore(machine, state->saved, kNoWord, line).stops;
  }
  ModeState restored = *state;
  std::vector<ModeFault> found;
  ModeFaults line(&restored, &found);
  const bool runs = !restore(machine, state->saved, kNoWord, line).stops;
  add_possible(found, faults);
  if (runs) *state = either(*state, restored);
  return true;
}

}  // namespace owlint
