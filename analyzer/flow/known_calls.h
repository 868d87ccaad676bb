// What calls of subs came to, kept from one check of a program to the next. An editor checks at every key, and all subs
// but the one that is being written are as they were. A call is kept under everything that it depends on: the sub's
// text, what its parameters are when it is entered, and what the rest of the program makes of them. Whoever finds it
// there need not walk through the sub again. Findings are the same with and without (tests/known_calls_test.cc).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "analyzer/flow/machine.h"

namespace owlint::flow {

/// A call that comes back in one way only, without a stop or a hazard in it, and leaves nothing behind but these.
struct CallOutcome {
  uint8_t executed = kNo;
  uint8_t returned = kNo;
  bool joined = false;
  bool mixed = false;
  std::vector<bool> lines;  ///< by statement, from the sub's opener on: executed
  uint64_t steps = 0;       ///< that the analysis took
};

/// An outcome that an analysis has found, for KnownCalls.
struct LearnedCall {
  std::string key;
  CallOutcome outcome;
  StatementId opener = 0;
};

/// The memory of one program. Not for several threads at a time.
class KnownCalls {
 public:
  /// A new check begins; what no check has used for long is forgotten.
  void next_check();
  const CallOutcome* find(const std::string& key);
  void learn(LearnedCall call);
  void clear() { calls_.clear(); }
  size_t size() const { return calls_.size(); }

 private:
  struct Known {
    CallOutcome outcome;
    uint64_t used = 0;  // the last check that found or learned it
  };
  std::unordered_map<std::string, Known> calls_;
  uint64_t check_ = 0;
};

/// Makes the keys of calls in one analysis.
class CallKeys {
 public:
  CallKeys(const Linked& linked, const Machine& machine) : linked_(linked), program_(linked.program()), machine_(machine), circumstances_(machine.circumstances()), subs_(program_.regions.size()) {}

  /// The key of a call that enters `entry`, at the sub's opener; none for calls that cannot be kept. `level`: how closely
  /// the analysis follows runs.
  std::optional<std::string> of(const Context& callee, const State& entry, size_t level);

 private:
  struct Sub {
    bool looked_at = false;
    bool fits = false;  ///< calls of it can be kept
    std::string text;   ///< what it is, and what the rest of the program makes of its parameters
    Dependence dependence;
  };
  void look_at(RegionId region, Sub& sub) const;
  bool note_line(StatementId id, Dependence& out) const;

  const Linked& linked_;
  const Program& program_;
  const Machine& machine_;
  uint64_t circumstances_;
  std::vector<Sub> subs_;  // by region
};

}  // namespace owlint::flow
