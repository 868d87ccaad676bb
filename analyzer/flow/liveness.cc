#include "analyzer/flow/liveness.h"

#include <algorithm>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

constexpr size_t kMaxWords = 1U << 22;  // of bits for all lines of a sub together
constexpr int kMaxSweeps = 64;          // one for each loop that stands in another

uint64_t key_of_name(const Syntax& syntax, NameId name) {
  return is_global_name(syntax.names.text(name)) ? (kGlobalNames + name) | LineAccess::kGlobal : kLocalNames + name;
}

/// The key of #n, or UINT64_MAX where n is computed.
uint64_t key_of_number(const Syntax& syntax, ExprId number) {
  double value = 0;
  long index = 0;
  if (!literal_value(syntax.exprs, number, &value) || !to_integer(value, &index) || index < 0) return UINT64_MAX;
  return static_cast<uint64_t>(index) | (index >= kFirstGlobalNumber ? LineAccess::kGlobal : 0);
}

}  // namespace

// Depth is bounded by the length of a line.
void LineAccess::read(const Syntax& syntax, ExprId id) {
  const Expr& expr = syntax.exprs[id];
  switch (expr.op) {
    case Operator::kNumber: return;
    case Operator::kNamed: case Operator::kExistsNamed: reads.push_back(key_of_name(syntax, expr.name())); return;
    case Operator::kParameter: case Operator::kExistsNumbered:
      if (const uint64_t key = key_of_number(syntax, expr.left()); key != UINT64_MAX) {
        reads.push_back(key);
      } else {
        reads_any = true;
      }
      break;
    default: break;
  }
  read(syntax, expr.left());
  if (expr.right() != kNoExpr) read(syntax, expr.right());
}

void LineAccess::look(const Program& program, StatementId id) {
  const Syntax& syntax = program.syntax;
  const Statement& s = program.at(id);
  reads.clear();
  writes.clear();
  reads_any = false;
  if (s.label_expr != kNoExpr) read(syntax, s.label_expr);
  for (uint32_t i = 0; i < s.value_count; ++i) read(syntax, syntax.values[s.first + i]);
  for (uint32_t i = 0; i < s.item_count; ++i) {
    const Item& item = syntax.items[s.first + i];
    read(syntax, item.value);
    if (item.target_name != kNoName) writes.push_back({key_of_name(syntax, item.target_name), i});
    if (item.target == kNoExpr) continue;
    writes.push_back({key_of_number(syntax, item.target), i});
    read(syntax, item.target);
  }
}

Liveness::Liveness(const Program& program, const ControlFlow& flow, bool keeps_numbers) : flow_(flow) {
  if (!flow.known()) return;
  const auto& nodes = flow.nodes();
  uses_.resize(nodes.size());
  kills_.resize(nodes.size());
  uses_numbers_.resize(nodes.size());
  const auto bit = [this](uint64_t key) { return bits_.try_emplace(key, static_cast<uint32_t>(bits_.size())).first->second; };
  LineAccess line;
  for (NodeId id = 0; id < nodes.size(); ++id) {
    line.look(program, nodes[id].statement);
    uses_numbers_[id] = line.reads_any;
    for (const uint64_t key : line.reads) {
      if ((key & LineAccess::kGlobal) == 0) uses_[id].push_back(bit(key));
    }
    for (const auto& write : line.writes) {
      if ((write.key & LineAccess::kGlobal) == 0) kills_[id].push_back(bit(write.key));
    }
  }
  words_ = bits_.size() / 64 + 1;
  if (nodes.size() * words_ > kMaxWords) return;
  live_.assign(nodes.size() * words_, 0);
  numbers_.assign(words_, 0);
  for (const auto& [key, at] : bits_) {
    if (key < kFirstGlobalNumber) numbers_[at / 64] |= 1ULL << (at % 64);
  }
  exit_.assign(words_, 0);
  if (keeps_numbers) exit_ = numbers_;
  for (int i = 0; i < kMaxSweeps && !known_; ++i) known_ = !sweep();
}

/// One pass over all lines, the last first; whether something new was found.
bool Liveness::sweep() {
  bool grew = false;
  std::vector<uint64_t> live(words_);
  const auto& nodes = flow_.nodes();
  for (NodeId id = static_cast<NodeId>(nodes.size()); id-- > 0;) {
    std::ranges::fill(live, 0);
    for (const NodeId next : nodes[id].next) {
      if (next == kNowhere) continue;
      const uint64_t* from = next == kExit ? exit_.data() : &live_[next * words_];
      for (size_t w = 0; w < words_; ++w) live[w] |= from[w];
    }
    for (const uint32_t bit : kills_[id]) live[bit / 64] &= ~(1ULL << (bit % 64));
    for (const uint32_t bit : uses_[id]) live[bit / 64] |= 1ULL << (bit % 64);
    for (size_t w = 0; w < words_; ++w) {
      if (uses_numbers_[id]) live[w] |= numbers_[w];
      uint64_t& known = live_[id * words_ + w];
      grew |= (live[w] & ~known) != 0;
      known |= live[w];
    }
  }
  return grew;
}

bool Liveness::has(NodeId node, uint64_t key) const {
  const auto found = bits_.find(key);
  if (found == bits_.end()) return false;
  const uint32_t bit = found->second;
  const uint64_t word = node == kExit ? exit_[bit / 64] : live_[node * words_ + bit / 64];
  return (word >> (bit % 64) & 1) != 0;
}

bool Liveness::after(NodeId node, uint64_t key) const {
  return std::ranges::any_of(flow_.nodes()[node].next, [&](NodeId next) { return next != kNowhere && has(next, key); });
}

}  // namespace owlint::flow
