#include "analyzer/syntax/mode_faults.h"

#include <bit>

namespace owlint {
namespace {

ModeMask masks_of(BadModes modes) {
  ModeMask mask = 0;
  for (const BadMode& bad : modes) mask |= mask_of(bad.mode);
  return mask;
}

}  // namespace

std::optional<uint8_t> ModeFaults::only(Mode mode) const {
  const ValueSet values = now()[mode];
  if (!is_single(values)) return std::nullopt;
  return static_cast<uint8_t>(std::countr_zero(values));
}

Answer ModeFaults::holds(BadModes modes) const {
  Answer answer = Answer::kYes;
  for (const BadMode& bad : modes) {
    const ValueSet may = now()[bad.mode];
    if ((may & bad.values) == 0) return Answer::kNo;
    if ((may & ~bad.values) != 0) answer = Answer::kMaybe;
  }
  return answer;
}

/// Of the values that an open mode may have, the bad ones may be on no run; where two modes have several values, they may be
/// bad on different runs.
bool ModeFaults::believes(BadModes modes) const {
  int several = 0;
  for (const BadMode& bad : modes) {
    if (is_single(now()[bad.mode])) continue;
    if (now().is_open(bad.mode)) return false;
    ++several;
  }
  return several <= 1;
}

/// The runs that go on have only good values, if one mode alone decides.
void ModeFaults::survive(BadModes modes) {
  const BadMode* decides = nullptr;
  for (const BadMode& bad : modes) {
    if ((now()[bad.mode] & ~bad.values) == 0) continue;
    if (decides != nullptr) return;
    decides = &bad;
  }
  now()[decides->mode] &= ~decides->values;
}

bool ModeFaults::stop(StopKind kind, std::string message, uint8_t word, uint8_t other, ModeMask decided_by) {
  faults_.push_back({{kind, std::move(message), word, other, true}, true, decided_by});
  return true;
}

bool ModeFaults::stop_in(BadModes modes, StopKind kind, std::string_view message, uint8_t word, uint8_t other) {
  const Answer answer = holds(modes);
  if (answer == Answer::kNo) return false;
  const bool certain = answer == Answer::kYes;
  const bool believed = certain || believes(modes);
  faults_.push_back({{kind, std::string(message), word, other, certain}, believed, masks_of(modes)});
  if (certain) return true;
  survive(modes);
  if (believed) state_.lose_runs();
  return false;
}

void ModeFaults::may_stop(StopKind kind, std::string message, uint8_t word, uint8_t other, ModeMask decided_by,
                          bool believed) {
  faults_.push_back({{kind, std::move(message), word, other, false}, believed, decided_by});
}

void ModeFaults::set_known(Mode mode, ValueSet values) {
  now()[mode] = values;
  // No feed and no speed are 0.
  if (double* const number = now().number(mode))
    *number = values == value_bit(modes::kNoFeed) ? 0 : ModeSets::kAnyNumber;
  now().open &= ~mask_of(mode);
  now().assigned |= mask_of(mode);
}

void ModeFaults::set_open(Mode mode, ValueSet values) {
  if (double* const number = now().number(mode)) *number = ModeSets::kAnyNumber;
  now()[mode] = values;
  now().open |= mask_of(mode);
  now().assigned |= mask_of(mode);
}

}  // namespace owlint
