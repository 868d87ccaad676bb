// The control-flow graph of one sub, or of the main program: which line can be executed after which. Only if all its
// blocks are complete, so that the text shows it; the abstract machine handles all others, and all calls.
#pragma once

#include <array>
#include <vector>

#include "analyzer/flow/facts/structured.h"

namespace owlint::flow {

using NodeId = uint32_t;
inline constexpr NodeId kExit = UINT32_MAX;         ///< the exit: `return`, the end of the sub or of the program
inline constexpr NodeId kNowhere = UINT32_MAX - 1;  ///< there is no such edge

class ControlFlow {
 public:
  struct Node {
    StatementId statement = kNoStatement;
    std::array<NodeId, 2> next{kNowhere, kNowhere};  ///< of a condition: the next line if true, and if false
    bool tests = false;
  };

  /// For region `region`, in the order of the lines. Empty if its blocks are not complete.
  ControlFlow(const Program& program, const Structure& structure, RegionId region,
              std::span<const uint32_t> statements);

  const std::vector<Node>& nodes() const { return nodes_; }
  bool known() const { return known_; }

 private:
  void connect(NodeId id);
  NodeId node_of(StatementId statement) const;
  NodeId after(NodeId id) const;
  NodeId behind(StatementId statement) const { return after(node_of(statement)); }

  const Program& program_;
  std::vector<Node> nodes_;
  bool known_ = true;
};

}  // namespace owlint::flow
