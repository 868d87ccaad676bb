// Conditions on modes that are sets of values: the faults that follow, and the modes of the runs that do not stop.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "analyzer/syntax/mode_run.h"

namespace owlint {

/// Values of a mode in which a line stops.
struct BadMode {
  Mode mode;
  ValueSet values;
};
using BadModes = std::initializer_list<BadMode>;
constexpr ValueSet all_but(uint8_t value) { return ~value_bit(value); }

inline constexpr BadMode kCompensationOn{Mode::kCompensation, all_but(modes::kG40)};
/// Without compensation it has no radius.
inline constexpr BadMode kCompensationMoves{Mode::kRadius, value_bit(modes::kRadiusSet)};

enum class Answer : uint8_t { kNo, kMaybe, kYes };

class ModeFaults {
 public:
  ModeFaults(ModeState* state, std::vector<ModeFault>* faults) : state_(*state), faults_(*faults) {}

  ModeState& state() { return state_; }
  ModeSets& now() { return state_.now; }
  const ModeSets& now() const { return state_.now; }
  std::vector<ModeFault>* faults() { return &faults_; }
  /// The value of a mode that has one.
  std::optional<uint8_t> only(Mode mode) const;
  /// Whether each of the modes has one of its values.
  Answer holds(BadModes modes) const;
  /// The line stops on all runs: true, as it is for stop_in() if no run goes on.
  bool stop(StopKind kind, std::string message, uint8_t word, uint8_t other = kNoWord, ModeMask decided_by = 0);
  /// The line stops on the runs that have all these values. The modes become those of the other runs.
  bool stop_in(BadModes modes, StopKind kind, std::string_view message, uint8_t word, uint8_t other = kNoWord);
  /// The line may stop, for something that is not known. `believed`: some machines stop.
  void may_stop(StopKind kind, std::string message, uint8_t word, uint8_t other = kNoWord, ModeMask decided_by = 0,
                bool believed = false);

  void set(Mode mode, uint8_t value) { set_known(mode, value_bit(value)); }
  void set_known(Mode mode, ValueSet values);
  /// The mode has one of these values, and it is not known which.
  void set_open(Mode mode, ValueSet values);
  void set_open(Mode mode) { set_open(mode, all_values(mode)); }

 private:
  bool believes(BadModes modes) const;
  void survive(BadModes modes);

  ModeState& state_;
  std::vector<ModeFault>& faults_;
};

}  // namespace owlint
