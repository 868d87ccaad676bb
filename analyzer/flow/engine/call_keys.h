// The keys of calls, by which KnownCalls finds them: everything that the outcome of a call depends on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/flow/interpreter/abstract_machine.h"

namespace owlint::flow {

/// Makes the keys of calls in one analysis.
class CallKeys {
 public:
  CallKeys(const Linked& linked, const AbstractMachine& machine)
      : linked_(linked),
        program_(linked.program()),
        machine_(machine),
        circumstances_(machine.circumstances()),
        subs_(program_.regions.size()) {}

  /// The key of a call that enters `entry`, at the sub's first line; none for calls that cannot be kept. `level`: how exactly
  /// the analysis follows runs.
  std::optional<std::string> of(const Context& callee, const State& entry, size_t level);

 private:
  struct Sub {
    bool looked_at = false;
    bool fits = false;  ///< calls of it can be kept
    std::string text;   ///< its text, and how the rest of the program uses its parameters
    Dependence dependence;
  };
  void look_at(RegionId number, Sub& sub) const;
  bool note_line(StatementId id, Dependence& out) const;

  const Linked& linked_;
  const Program& program_;
  const AbstractMachine& machine_;
  uint64_t circumstances_;
  std::vector<Sub> subs_;  // by region
};

}  // namespace owlint::flow
