#include "analyzer/flow/fixed_conditions.h"

#include <algorithm>

#include "analyzer/flow/conditions.h"
#include "analyzer/flow/liveness.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

constexpr size_t kMaxRanges = 1U << 20;  // of all lines of a sub together
constexpr int kMaxSweeps = 64;
constexpr int kExactSweeps = 3;  // then ranges at the beginning of loops are widened

using Ranges = std::vector<Range>;

/// Ranges of the parameters that a sub compares, line by line until nothing changes.
class Solver {
 public:
  Solver(const Program& program, const ControlFlow& flow, const Settings& settings) : program_(program), exprs_(program.syntax.exprs), flow_(flow) {
    find_compared(settings);
  }

  bool solve() {
    const size_t count = flow_.nodes().size();
    if (keys_.empty() || count * keys_.size() > kMaxRanges) return false;
    at_.resize(count);
    reached_.resize(count);
    reached_[0] = true;
    at_[0].resize(keys_.size());
    for (int i = 0; i < kMaxSweeps; ++i) {
      if (!sweep(i >= kExactSweeps)) return true;
    }
    return false;
  }

  bool reached(NodeId id) const { return reached_[id]; }
  Range value(ExprId id, NodeId at) const { return evaluate(id, at_[at]); }

 private:
  uint64_t key_of(ExprId id) const {
    const Expr& expr = exprs_[id];
    if (expr.op == Operator::kNamed) {
      const std::string_view name = program_.name(expr.name());
      if (predefined_name(name) || machine_name(name)) return UINT64_MAX;
      return is_global_name(name) ? (kGlobalNames + expr.name()) | LineAccess::kGlobal : kLocalNames + expr.name();
    }
    double number = 0;
    long index = 0;
    if (expr.op != Operator::kParameter || !literal_value(exprs_, expr.left(), &number) || !to_integer(number, &index)) return UINT64_MAX;
    if (index < 1 || index >= kFirstVolatileNumber) return UINT64_MAX;
    return static_cast<uint64_t>(index) | (index >= kFirstGlobalNumber ? LineAccess::kGlobal : 0);
  }

  void find_compared(const Settings& settings) {
    std::vector<double> numbers;
    for (const auto& node : flow_.nodes()) {
      if (!node.tests) continue;
      for (const bool truth : {true, false}) {
        for_known_comparisons(exprs_, program_.syntax.values[program_.at(node.statement).first], truth, [&](ExprId side, Operator op, ExprId other, bool) {
          double number = 0;
          if (other != kNoExpr && literal_value(exprs_, other, &number)) add_thresholds(op, number, numbers);
          const uint64_t key = key_of(side);
          if (key != UINT64_MAX && !settings.has(key) && place_.emplace(key, keys_.size()).second) keys_.push_back(key);
        });
      }
    }
    thresholds_ = Thresholds(std::move(numbers));
  }

  // Depth is bounded by the length of a line.
  Range evaluate(ExprId id, const Ranges& in) const {
    const Expr& expr = exprs_[id];
    if (expr.op == Operator::kNumber) return Range::of(expr.value());
    if (expr.op == Operator::kNamed || expr.op == Operator::kParameter) {
      const auto place = place_.find(key_of(id));
      return place == place_.end() ? Range() : in[place->second];
    }
    if (expr.op == Operator::kExistsNamed || expr.op == Operator::kExistsNumbered) return Range();
    const Range left = evaluate(expr.left(), in);
    return apply(expr.op, left, expr.right() == kNoExpr ? left : evaluate(expr.right(), in));
  }

  void forget(Ranges& ranges, bool globals) const {
    for (size_t i = 0; i < keys_.size(); ++i) {
      const bool global = (keys_[i] & LineAccess::kGlobal) != 0;
      if (globals ? global : (keys_[i] & ~LineAccess::kGlobal) <= kLastNumber) ranges[i] = Range();
    }
  }

  /// What a line leaves behind, before it branches.
  void execute(const Statement& s, Ranges& ranges) const {
    if (s.is(Keyword::kCall)) return forget(ranges, true);
    const Ranges before = s.item_count > 1 ? ranges : Ranges();
    for (uint32_t i = 0; i < s.item_count; ++i) {
      const Item& item = program_.syntax.items[s.first + i];
      uint64_t key = UINT64_MAX;
      if (item.target_name != kNoName) {
        const std::string_view name = program_.name(item.target_name);
        key = is_global_name(name) ? (kGlobalNames + item.target_name) | LineAccess::kGlobal : kLocalNames + item.target_name;
      } else if (item.target != kNoExpr) {
        double number = 0;
        long index = 0;
        if (!literal_value(exprs_, item.target, &number) || !to_integer(number, &index)) {
          forget(ranges, false);
          continue;
        }
        key = static_cast<uint64_t>(index) | (index >= kFirstGlobalNumber ? LineAccess::kGlobal : 0);
      } else {
        continue;
      }
      if (const auto place = place_.find(key); place != place_.end()) ranges[place->second] = evaluate(item.value, s.item_count > 1 ? before : ranges);
    }
  }

  /// False if the branch cannot be taken.
  bool branch(ExprId condition, bool truth, Ranges& ranges) const {
    const Range outcome = evaluate(condition, ranges);
    if (truth ? outcome == Range::of(0) : !outcome.has(0)) return false;
    bool possible = true;
    for_known_comparisons(exprs_, condition, truth, [&](ExprId side, Operator op, ExprId other, bool holds) {
      const auto place = place_.find(key_of(side));
      if (place == place_.end()) return;
      Range& range = ranges[place->second];
      range = narrowed(range, op, other == kNoExpr ? Range::of(0) : evaluate(other, ranges), holds);
      possible = possible && !range.is_empty();
    });
    return possible;
  }

  bool arrive(NodeId from, NodeId to, const Ranges& ranges, bool widen) {
    if (to >= flow_.nodes().size()) return false;
    if (!reached_[to]) {
      reached_[to] = true;
      at_[to] = ranges;
      return true;
    }
    bool changed = false;
    for (size_t i = 0; i < ranges.size(); ++i) {
      Range joined = hull(at_[to][i], ranges[i]);
      if (joined == at_[to][i]) continue;
      if (widen && to <= from) joined = thresholds_.widened(joined);
      at_[to][i] = joined;
      changed = true;
    }
    return changed;
  }

  bool sweep(bool widen) {
    bool changed = false;
    for (NodeId id = 0; id < flow_.nodes().size(); ++id) {
      if (!reached_[id]) continue;
      const auto& node = flow_.nodes()[id];
      const Statement& s = program_.at(node.statement);
      Ranges ranges = at_[id];
      execute(s, ranges);
      if (!node.tests) {
        for (const NodeId next : node.next) changed |= arrive(id, next, ranges, widen);
        continue;
      }
      for (const bool truth : {true, false}) {
        Ranges one = ranges;
        if (branch(program_.syntax.values[s.first], truth, one)) changed |= arrive(id, node.next[truth ? 0 : 1], one, widen);
      }
    }
    return changed;
  }

  const Program& program_;
  const ExprPool& exprs_;
  const ControlFlow& flow_;
  std::vector<uint64_t> keys_;
  std::unordered_map<uint64_t, size_t> place_;
  Thresholds thresholds_;
  std::vector<Ranges> at_;
  std::vector<bool> reached_;
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
StatementId earlier_branch(const Program& program, StatementId id) {
  constexpr size_t kMaxBranches = 64;
  if (!program.at(id).is(Keyword::kElseif)) return kNoStatement;
  const BlockId block = program.block_of[id];
  const auto condition = [&](StatementId at) { return program.syntax.values[program.at(at).first]; };
  const auto fits = [&](StatementId at) { return program.at(at).value_count > 0 && same(program.syntax.exprs, condition(at), condition(id)); };
  if (fits(program.blocks[block].opener)) return program.blocks[block].opener;
  size_t looked = 0;
  for (const StatementId part : program.parts[block]) {
    if (part >= id || ++looked > kMaxBranches) break;
    if (program.at(part).is(Keyword::kElseif) && fits(part)) return part;
  }
  return kNoStatement;
}

}  // namespace

Settings::Settings(const Program& program) {
  for (const Statement& s : program.syntax.statements) {
    for (uint32_t i = 0; i < s.item_count; ++i) {
      const Item& item = program.syntax.items[s.first + i];
      double number = 0;
      long index = 0;
      uint64_t key = 0;
      if (item.target_name != kNoName) {
        key = is_global_name(program.name(item.target_name)) ? (kGlobalNames + item.target_name) | LineAccess::kGlobal : kLocalNames + item.target_name;
      } else {
        if (item.target == kNoExpr || !literal_value(program.syntax.exprs, item.target, &number) || !to_integer(number, &index)) continue;
        key = static_cast<uint64_t>(index) | (index >= kFirstGlobalNumber ? LineAccess::kGlobal : 0);
      }
      Assigned& assigned = assigned_[key];
      ++assigned.times;
      assigned.literal = assigned.literal && literal_value(program.syntax.exprs, item.value, &number);
    }
  }
}

bool Settings::has(uint64_t key) const {
  const auto found = assigned_.find(key);
  return found != assigned_.end() && found->second.times == 1 && found->second.literal;
}

void find_fixed_conditions(const Program& program, const ControlFlow& flow, const Settings& settings, std::vector<FixedCondition>& out) {
  Solver solver(program, flow, settings);
  const bool solved = solver.solve();
  for (NodeId id = 0; id < flow.nodes().size(); ++id) {
    const auto& node = flow.nodes()[id];
    if (!node.tests) continue;
    const Statement& s = program.at(node.statement);
    const ExprId condition = program.syntax.values[s.first];
    if (const StatementId earlier = earlier_branch(program, node.statement); earlier != kNoStatement) {
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
