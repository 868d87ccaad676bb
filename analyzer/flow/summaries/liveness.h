// Which local parameters of a sub are read after a line before they are assigned again.
#pragma once

#include "analyzer/flow/facts/accesses.h"
#include "analyzer/flow/facts/control_flow.h"
#include "analyzer/flow/limits.h"

namespace owlint::flow {

class Liveness {
 public:
  /// `keeps_numbers`: #1 to #30 may be read after the exit, as in the main program.
  Liveness(const ControlFlow& flow, const Accesses& accesses, bool keeps_numbers, const Limits& limits);

  /// False if the graph is too large or too deeply nested for this analysis.
  bool known() const { return known_; }
  bool before(NodeId node, ParameterKey key) const;
  bool after(NodeId node, ParameterKey key) const;

 private:
  bool sweep();
  uint32_t bit(ParameterKey key) const;

  const ControlFlow& flow_;
  const Accesses& accesses_;
  std::vector<ParameterKey> keys_;      // sorted: their places are their bits
  std::vector<uint32_t> uses_, kills_;  // bits, in the order of the accesses; kNone for globals
  std::vector<uint64_t> live_;          // by node and word
  std::vector<uint64_t> numbers_, exit_;
  size_t words_ = 0;
  bool known_ = false;
};

}  // namespace owlint::flow
