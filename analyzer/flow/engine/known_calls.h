// The outcomes of calls, kept from one check of a program to the next. An editor checks after every keystroke, and only
// the sub that is being edited has changed. The key of a call is everything that it depends on: the sub's text, the values
// of its parameters at the call, and how the rest of the program uses them. If a call is found here, the sub need not be
// analysed again. Findings are the same with and without this memory (tests/flow/known_calls_test.cc).
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "analyzer/flow/domain/flags.h"
#include "analyzer/flow/limits.h"
#include "analyzer/syntax/statement.h"

namespace owlint::flow {

/// A call that returns in only one way, without a stop or a hazard, and has no other effects than these.
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

/// The memory for one program. Not thread-safe.
class KnownCalls {
 public:
  explicit KnownCalls(const Limits& limits = {}) : remembered_checks_(limits.remembered_checks) {}

  /// A new check begins; calls that no check has used for a long time are forgotten.
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
  uint64_t remembered_checks_;
};

}  // namespace owlint::flow
