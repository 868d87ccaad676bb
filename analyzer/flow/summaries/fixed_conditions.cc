#include "analyzer/flow/summaries/fixed_conditions.h"

#include <algorithm>

#include "analyzer/flow/facts/conditions.h"
#include "analyzer/machine/predefined.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

using Ranges = std::vector<Range>;

/// Ranges of the parameters that a sub compares, line by line until nothing changes.
class Solver {
 public:
  Solver(const Program& program, const ControlFlow& flow, const Presets& presets, const Limits& limits)
      : program_(program), exprs_(program.syntax.exprs), flow_(flow), limits_(limits) {
    find_compared(presets);
  }

  bool solve() {
    const size_t count = flow_.nodes().size();
    if (keys_.empty() || count * keys_.size() > limits_.fixed_ranges) return false;
    at_.resize(count * keys_.size());
    reached_.resize(count);
    changed_.resize(count);
    reached_[0] = changed_[0] = true;
    for (int i = 0; i < limits_.fixed_sweeps; ++i) {
      if (!sweep(i >= limits_.exact_sweeps)) return true;
    }
    return false;
  }

  bool reached(NodeId id) const { return reached_[id]; }
  Range value(ExprId id, NodeId at) {
    load(at, now_);
    return evaluate(id, now_);
  }

 private:
  ParameterKey key_of(ExprId id) const {
    const Expr& expr = exprs_[id];
    if (expr.op == Operator::kNamed) {
      return may_be_predefined(program_.name(expr.name())) ? kComputedKey : key_of_name(program_.syntax, expr.name());
    }
    if (expr.op != Operator::kParameter) return kComputedKey;
    const ParameterKey key = key_of_number(program_.syntax, expr.left());
    return (key & ~kGlobalKey) >= kFirstVolatileNumber ? kComputedKey : key;
  }

  void find_compared(const Presets& presets) {
    std::vector<double> numbers;
    for (const auto& node : flow_.nodes()) {
      if (node.tests) collect(program_.syntax.values_of(program_.at(node.statement)).front(), numbers);
    }
    std::erase_if(keys_, [&](ParameterKey key) { return key == kComputedKey || presets.has(key); });
    std::ranges::sort(keys_);
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    thresholds_ = Thresholds(std::move(numbers), limits_.thresholds);
  }

  // Depth is bounded by the length of a line.
  void collect(ExprId condition, std::vector<double>& numbers) {
    const Expr& expr = exprs_[condition];
    if (expr.op == Operator::kAnd || expr.op == Operator::kOr) {
      for_each_operand(expr, [&](ExprId operand) { collect(operand, numbers); });
    } else if (is_comparison(expr.op)) {
      for (const auto& [side, other] : {std::pair(expr.left(), expr.right()), std::pair(expr.right(), expr.left())}) {
        double number = 0;
        keys_.push_back(key_of(side));
        if (literal_value(exprs_, other, &number)) add_thresholds(expr.op, number, numbers);
      }
    } else {
      keys_.push_back(key_of(condition));
    }
  }

  /// The place of a parameter among those that are compared; their number if it is none of them.
  size_t place(ParameterKey key) const {
    const auto found = std::ranges::lower_bound(keys_, key);
    return found != keys_.end() && *found == key ? static_cast<size_t>(found - keys_.begin()) : keys_.size();
  }

  // Depth is bounded by the length of a line.
  Range evaluate(ExprId id, const Ranges& in) const {
    const Expr& expr = exprs_[id];
    if (expr.op == Operator::kNumber) return Range::of(expr.value());
    if (expr.op == Operator::kNamed || expr.op == Operator::kParameter) {
      const size_t at = place(key_of(id));
      return at == keys_.size() ? Range() : in[at];
    }
    if (expr.op == Operator::kExistsNamed || expr.op == Operator::kExistsNumbered) return Range();
    const Range left = evaluate(expr.left(), in);
    return apply(expr.op, left, expr.right() == kNoExpr ? left : evaluate(expr.right(), in));
  }

  void forget(Ranges& ranges, bool globals) const {
    for (size_t i = 0; i < keys_.size(); ++i) {
      if (globals ? is_global(keys_[i]) : (keys_[i] & ~kGlobalKey) <= kLastNumber) ranges[i] = Range();
    }
  }

  /// The values after a line, before it branches.
  void execute(const Statement& s, Ranges& ranges) const {
    if (s.is(Keyword::kCall) || s.kind == LineKind::kRemap) return forget(ranges, true);
    const Ranges before = s.item_count > 1 ? ranges : Ranges();
    for (const Item& item : program_.syntax.items_of(s)) {
      if (!assigns(item)) continue;
      const ParameterKey key = key_of_target(program_.syntax, item);
      if (key == kComputedKey) {
        forget(ranges, false);
        continue;
      }
      if (const size_t at = place(key); at != keys_.size())
        ranges[at] = evaluate(item.value, s.item_count > 1 ? before : ranges);
    }
  }

  /// False if the branch cannot be taken.
  bool branch(ExprId condition, bool truth, Ranges& ranges) const {
    const Range outcome = evaluate(condition, ranges);
    if (truth ? outcome == Range::of(0) : !outcome.has(0)) return false;
    bool possible = true;
    for_known_comparisons(exprs_, condition, truth, [&](ExprId side, Operator op, ExprId other, bool holds) {
      const size_t at = place(key_of(side));
      if (at == keys_.size()) return;
      Range& range = ranges[at];
      range = narrowed(range, op, other == kNoExpr ? Range::of(0) : evaluate(other, ranges), holds);
      possible = possible && !range.is_empty();
    });
    return possible;
  }

  void load(NodeId id, Ranges& into) const {
    into.assign(at_.begin() + static_cast<ptrdiff_t>(id * keys_.size()),
                at_.begin() + static_cast<ptrdiff_t>((id + 1) * keys_.size()));
  }

  void arrive(NodeId from, NodeId to, const Ranges& ranges, bool widen) {
    if (to >= flow_.nodes().size()) return;
    Range* at = &at_[to * keys_.size()];
    if (!reached_[to]) {
      reached_[to] = changed_[to] = true;
      std::ranges::copy(ranges, at);
      return;
    }
    for (size_t i = 0; i < ranges.size(); ++i) {
      Range joined = hull(at[i], ranges[i]);
      if (joined == at[i]) continue;
      if (widen && to <= from) joined = thresholds_.widened(joined);
      at[i] = joined;
      changed_[to] = true;
    }
  }

  /// Goes through the lines where something new has arrived; false if there were none.
  bool sweep(bool widen) {
    bool any = false;
    for (NodeId id = 0; id < flow_.nodes().size(); ++id) {
      if (!changed_[id]) continue;
      changed_[id] = false;
      any = true;
      const auto& node = flow_.nodes()[id];
      const Statement& s = program_.at(node.statement);
      load(id, now_);
      execute(s, now_);
      if (!node.tests) {
        for (const NodeId next : node.next) arrive(id, next, now_, widen);
        continue;
      }
      for (const bool truth : {true, false}) {
        branch_ = now_;
        if (branch(program_.syntax.values_of(s).front(), truth, branch_))
          arrive(id, node.next[truth ? 0 : 1], branch_, widen);
      }
    }
    return any;
  }

  const Program& program_;
  const ExprPool& exprs_;
  const ControlFlow& flow_;
  const Limits& limits_;
  std::vector<ParameterKey> keys_;  // sorted
  Thresholds thresholds_;
  Ranges at_;  // by node and key
  Ranges now_, branch_;
  std::vector<bool> reached_, changed_;
};

// Depth is bounded by the length of a line.
bool same(const ExprPool& exprs, ExprId a, ExprId b) {
  const Expr& x = exprs[a];
  const Expr& y = exprs[b];
  if (x.op != y.op || x.name() != y.name()) return false;
  if (x.op == Operator::kNumber) return x.value() == y.value();
  if (x.left() == kNoExpr) return true;
  return same(exprs, x.left(), y.left()) && (x.right() == kNoExpr || same(exprs, x.right(), y.right()));
}

/// An earlier branch of the same `if` with the same condition.
StatementId earlier_branch(const Program& program, StatementId id, const Limits& limits) {
  if (!program.at(id).is(Keyword::kElseif)) return kNoStatement;
  const BlockId block = program.block_of[id];
  const auto condition = [&](StatementId at) { return program.syntax.values_of(program.at(at)).front(); };
  const auto fits = [&](StatementId at) {
    return program.at(at).value_count > 0 && same(program.syntax.exprs, condition(at), condition(id));
  };
  if (fits(program.blocks[block].opener)) return program.blocks[block].opener;
  size_t looked = 0;
  for (const StatementId part : program.parts[block]) {
    if (part >= id || ++looked > limits.compared_branches) break;
    if (program.at(part).is(Keyword::kElseif) && fits(part)) return part;
  }
  return kNoStatement;
}

}  // namespace

Presets::Presets(const Program& program) {
  std::vector<std::pair<ParameterKey, bool>> assigned;  // and whether to a number
  for (const Item& item : program.syntax.items) {
    if (!assigns(item)) continue;
    const ParameterKey key = key_of_target(program.syntax, item);
    double number = 0;
    assigned.emplace_back(key, literal_value(program.syntax.exprs, item.value, &number));
  }
  std::ranges::sort(assigned);
  for (size_t i = 0; i < assigned.size(); ++i) {
    const auto same = [&](size_t other) {
      return other < assigned.size() && assigned[other].first == assigned[i].first;
    };
    if (assigned[i].second && !same(i + 1) && (i == 0 || !same(i - 1))) keys_.push_back(assigned[i].first);
  }
}

bool Presets::has(ParameterKey key) const { return std::ranges::binary_search(keys_, key); }

void find_fixed_conditions(const Program& program, const ControlFlow& flow, const Presets& presets,
                           const Limits& limits, std::vector<FixedCondition>& out) {
  Solver solver(program, flow, presets, limits);
  const bool solved = solver.solve();
  for (NodeId id = 0; id < flow.nodes().size(); ++id) {
    const auto& node = flow.nodes()[id];
    if (!node.tests) continue;
    const Statement& s = program.at(node.statement);
    const ExprId condition = program.syntax.values_of(s).front();
    if (const StatementId earlier = earlier_branch(program, node.statement, limits); earlier != kNoStatement) {
      out.push_back({node.statement, false, earlier});
      continue;
    }
    double number = 0;
    if (!solved || !solver.reached(id) || literal_value(program.syntax.exprs, condition, &number)) continue;
    const Range outcome = solver.value(condition, id);
    if (outcome == Range::of(0)) {
      out.push_back({node.statement, false, kNoStatement});
    } else if (!outcome.has(0) && s.is(Keyword::kIf)) {
      // The last branch of a complete list of cases is always true, and a `while` may be meant to be left by `break`.
      out.push_back({node.statement, true, kNoStatement});
    }
  }
}

}  // namespace owlint::flow
