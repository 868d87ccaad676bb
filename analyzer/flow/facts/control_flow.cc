#include "analyzer/flow/facts/control_flow.h"

#include <algorithm>

#include "analyzer/syntax/questions.h"

namespace owlint::flow {
namespace {

bool fits(const Program& program, const Structure& structure, RegionId region, StatementId id) {
  const Statement& s = program.at(id);
  if (s.has_error() || s.refused || s.kind == LineKind::kM98 || s.has_m99() || s.kind == LineKind::kContour)
    return false;
  if (s.kind != LineKind::kOWord) return true;
  if (s.label == kNoName && !s.is(Keyword::kCall)) return false;
  const bool of_sub = s.is(Keyword::kSub) || s.is(Keyword::kEndsub) || s.is(Keyword::kReturn) || s.is(Keyword::kCall);
  if (of_sub) return region != kMainRegion || s.is(Keyword::kCall);
  const BlockId block = program.block_of[id];
  return block != kNoBlock && program.blocks[block].region == region && structure.structured[block];
}

}  // namespace

ControlFlow::ControlFlow(const Program& program, const Structure& structure, RegionId region,
                         std::span<const uint32_t> statements)
    : program_(program) {
  known_ = structure.regular || structure.apart[region];
  nodes_.reserve(statements.size());
  for (const StatementId id : statements) {
    known_ = known_ && fits(program, structure, region, id);
    nodes_.push_back({id, {kNowhere, kNowhere}, false});
  }
  if (!known_) {
    nodes_.clear();
    return;
  }
  for (NodeId id = 0; id < nodes_.size(); ++id) connect(id);
}

NodeId ControlFlow::node_of(StatementId statement) const {
  return static_cast<NodeId>(std::ranges::lower_bound(nodes_, statement, {}, &Node::statement) - nodes_.begin());
}

/// Where the run goes on after a line that was executed: from the end of one branch to the end of all.
NodeId ControlFlow::after(NodeId id) const {
  if (id + 1 >= nodes_.size()) return kExit;
  const StatementId next = nodes_[id + 1].statement;
  const Statement& s = program_.at(next);
  if (!s.is(Keyword::kElse) && !s.is(Keyword::kElseif)) return id + 1;
  return node_of(program_.blocks[program_.block_of[next]].end);
}

void ControlFlow::connect(NodeId id) {
  Node& node = nodes_[id];
  const Statement& s = program_.at(node.statement);
  if (s.kind == LineKind::kProgramEnd || s.kind == LineKind::kAbort) {
    node.next[0] = kExit;
    // What M72 restores makes it lose the end.
    if (may_lose_rest(program_.syntax, node.statement)) node.next[1] = after(id);
    return;
  }
  node.next[0] = after(id);
  if (s.kind != LineKind::kOWord) return;
  const BlockId number = program_.block_of[node.statement];
  const Block* block = number == kNoBlock ? nullptr : &program_.blocks[number];
  switch (s.keyword) {
    case Keyword::kReturn:
    case Keyword::kEndsub: node.next[0] = kExit; break;
    case Keyword::kIf:
    case Keyword::kElseif: {
      node.tests = true;
      const auto parts = program_.parts[number];
      const auto next = std::ranges::upper_bound(parts, node.statement);
      node.next[1] = node_of(next == parts.end() ? block->end : *next);
      break;
    }
    case Keyword::kWhile:
      node.tests = true;
      if (block->kind == Keyword::kDo) {
        node.next = {behind(block->opener), after(id)};
      } else {
        node.next[1] = behind(block->end);
      }
      break;
    case Keyword::kRepeat: node.next[1] = behind(block->end); break;
    case Keyword::kEndwhile:
    case Keyword::kEndrepeat: node.next[0] = node_of(block->opener); break;
    case Keyword::kBreak: node.next[0] = behind(block->end); break;
    case Keyword::kContinue: node.next[0] = node_of(block->kind == Keyword::kDo ? block->end : block->opener); break;
    default: break;
  }
}

}  // namespace owlint::flow
