// The modes of the machine as values of a state. Each lives under a key of its own beside the parameters, so calls, joins and
// remembered calls treat it as one: modes as global parameters, and what M70 has saved as local names of its call level.
#pragma once

#include "analyzer/flow/domain/known_values.h"
#include "analyzer/flow/domain/parameters.h"
#include "analyzer/syntax/modes.h"

namespace owlint::flow {

/// Keys beside the numbered parameters.
inline constexpr uint32_t kModeKeys = kLastNumber + 1;
constexpr uint32_t mode_key(Mode mode) { return kModeKeys + static_cast<uint32_t>(mode); }

/// Behind the modes: which feed and speed they are, for M72, and the place.
inline constexpr uint32_t kFeedNumber = 29, kSpeedNumber = 30, kPlaceNumber = 31;
inline constexpr uint32_t kPlaceKey = kModeKeys + kPlaceNumber;
inline constexpr ModeMask kPlaceBit = ModeMask{1} << kPlaceNumber;
/// And for each mode whether the program has set it: a machine that has run before may begin with another mode than one that was
/// just started, and a program that reads its modes runs on both.
constexpr uint32_t said_key(Mode mode) { return kPlaceKey + 1 + static_cast<uint32_t>(mode); }
/// Set in a run on a machine that was just started, beside that on any machine (interpreter/new_machine.h).
inline constexpr uint32_t kNewMachineKey = said_key(Mode::kSaved) + 1;
/// The place that the values of the line are read in: a line moves when all of it has been read.
inline constexpr uint32_t kReadPlaceKey = kNewMachineKey + 1;
inline constexpr uint32_t kLastModeKey = kReadPlaceKey;
static_assert(kModes <= kFeedNumber && kLastModeKey < kGlobalNames);

/// The values of one mode.
struct ModeValues {
  ValueSet may = 0;
  bool open = false;  ///< see ModeSets
};

/// As a value of a state. Any value, of which none is certain, is kUnknown.
inline ValueId mode_value(KnownValues& values, Mode mode, ModeValues of_mode) {
  return of_mode.open && of_mode.may == all_values(mode) ? kUnknown
                                                         : values.intern(KnownSet{of_mode.may, of_mode.open});
}
/// The other way round. What the state does not have may be anything.
inline ModeValues mode_values(const KnownValues& values, Mode mode, ValueId id) {
  if (!KnownValues::is_set(id)) return {all_values(mode), true};
  const KnownSet& set = values.set(id);
  return {set.members, set.open};
}

}  // namespace owlint::flow
