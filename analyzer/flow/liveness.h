// Which local parameters of a sub are read after a line before they are assigned again.
#pragma once

#include <unordered_map>

#include "analyzer/flow/control_flow.h"
#include "analyzer/flow/parameters.h"

namespace owlint::flow {

/// What one line reads and then assigns, by the keys of parameters.h; globals as well, with kGlobal.
struct LineAccess {
  static constexpr uint64_t kGlobal = 1ULL << 32;
  struct Write {
    uint64_t key;   ///< UINT64_MAX: computed
    uint32_t item;  ///< of the statement's items
  };
  std::vector<uint64_t> reads;
  std::vector<Write> writes;
  bool reads_any = false;  ///< a parameter whose number is computed

  void look(const Program& program, StatementId id);

 private:
  void read(const Syntax& syntax, ExprId id);
};

class Liveness {
 public:
  /// `keeps_numbers`: #1 to #30 are read after the way out, as those of the main program may be.
  Liveness(const Program& program, const ControlFlow& flow, bool keeps_numbers);

  /// False where the graph is too large or too deeply nested to be gone through.
  bool known() const { return known_; }
  bool before(NodeId node, uint64_t key) const { return has(node, key); }
  bool after(NodeId node, uint64_t key) const;

 private:
  bool has(NodeId node, uint64_t key) const;
  bool sweep();

  const ControlFlow& flow_;
  std::unordered_map<uint64_t, uint32_t> bits_;
  std::vector<std::vector<uint32_t>> uses_, kills_;  // by node; bits
  std::vector<bool> uses_numbers_;
  std::vector<uint64_t> live_;  // by node and word
  std::vector<uint64_t> numbers_, exit_;
  size_t words_ = 0;
  bool known_ = false;
};

}  // namespace owlint::flow
