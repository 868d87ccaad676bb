// What the interpreter remembers between two lines: the product of all domains. A new domain is a member here, and takes part in
// hash() and in StateDomain::join().
#pragma once

#include <cstdint>

#include "analyzer/flow/domain/definers.h"
#include "analyzer/flow/domain/flags.h"
#include "analyzer/flow/domain/known_parameters.h"
#include "analyzer/flow/domain/known_values.h"
#include "analyzer/flow/domain/persistent_map.h"
#include "analyzer/flow/domain/repeat_counts.h"

namespace owlint::flow {

using ContextId = uint32_t;  ///< a call in progress, see engine/calls.h; 0 is none
using RecordId = uint32_t;   ///< see engine/trace.h
inline constexpr RecordId kNoRecord = UINT32_MAX;

/// The outcome of the condition on the step that led somewhere.
enum class Branch : uint8_t { kNone, kTrue, kFalse };

struct State {
  // Where the run is. States that are joined are alike in all of these: partitions are kept apart by them, and Calls gives the
  // exits of a call the same ones first.
  StatementId position = 0;  ///< the line; where the machine stands is a Place, among the parameters
  ContextId context = 0;
  FullLabel skip = kNoLabel;  ///< lines are skipped up to one with this label
  NameId defining = kNoName;  ///< the sub whose definition is skipped
  bool seek = false;          ///< a call looks for its sub
  bool looped = false;        ///< arrived by the jump back of a loop
  // What is known of the run.
  bool joined = false;  ///< represents several states whose differences are lost
  bool mixed = false;   ///< such a state was split again: perhaps no run is in it
  Flags flags;
  PersistentMap table;  ///< FullLabel -> first lines, see Definers
  RepeatCounts counts;
  Parameters parameters;
  // How the run got here; no part of what is compared and joined.
  RecordId record = kNoRecord;  ///< the trace record before this state
  Branch branch = Branch::kNone;

  /// A fingerprint of everything but the context and how the run got here. Equal states have equal ones.
  ///
  /// That different states have different fingerprints is a bet, and states are known again by theirs alone: keeping and
  /// comparing the states themselves would cost more memory than all else. A state that arrives is compared with the some
  /// hundreds at most of its partition, or of its sub's contexts (see Limits::Level). Fingerprints are well mixed, so each
  /// pair is equal by accident with odds of 2^-64: in ten million arrivals one state is lost with odds below 1 in a billion.
  /// Then its successors are not followed, and a finding may be missing. Nobody is protected from a program that was made
  /// for that.
  uint64_t hash() const;
};

/// The lattice of states at one point of the program. `a ≤ b`, so that b holds whatever a holds, if the join of the two is b.
class StateDomain {
 public:
  /// All three must outlive it.
  StateDomain(KnownValues& values, Definers& definers, PersistentMap::Pool& pool)
      : values_(values), definers_(definers), pool_(pool) {}

  /// The least state that holds both: each part is joined by its own domain. Commutative and associative; idempotent but for
  /// `joined`, which says that precision may be lost. Where the run is, and how it got there, is as in `a`. Values widen
  /// to their thresholds, and all other parts have finite chains, so a state that is joined with more and more others comes to
  /// rest.
  State join(const State& a, const State& b);

 private:
  KnownValues& values_;
  Definers& definers_;
  PersistentMap::Pool& pool_;
};

}  // namespace owlint::flow
