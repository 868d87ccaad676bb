#include "analyzer/flow/interpreter/refinement.h"

#include <span>

#include "analyzer/flow/facts/conditions.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

Refinement::Refinement(const Syntax& syntax, const TrackedParameters& tracked, const Limits& limits,
                       Evaluator& evaluator, PersistentMap::Pool& pool)
    : syntax_(syntax), tracked_(tracked), evaluator_(evaluator), pool_(pool) {
  for (const ParameterKey key : tracked.operands()) compared_.emplace_back(key, kCanFail);
  find_compared(limits);
}

ParameterKey Refinement::trusted_key_of(ExprId side) const {
  const ParameterKey key = tracked_.lasting_key_of(side);
  return key != kComputedKey && is_global(key) && evaluator_.distrusts_globals() ? kComputedKey : key;
}

uint8_t* Refinement::compared(ParameterKey key) {
  const auto found = std::ranges::lower_bound(compared_, key, {}, &std::pair<ParameterKey, uint8_t>::first);
  return found != compared_.end() && found->first == key ? &found->second : nullptr;
}

/// The parameter of `#1`, `[#1 - 2]`, `[2 - #1]` or `ABS[#1]`. `numbers`, with which that is compared, become those with which
/// the parameter is.
ParameterKey Refinement::counted_key_of(ExprId side, std::vector<double>& numbers) const {
  for (;;) {
    const Expr& expr = syntax_.exprs[side];
    double by = 0;
    if (expr.op == Operator::kAbs) {
      for (size_t i = 0, count = numbers.size(); i < count; ++i) numbers.push_back(-numbers[i]);
      side = expr.left();
    } else if (expr.op != Operator::kPlus && expr.op != Operator::kMinus) {
      return tracked_.lasting_key_of(side);
    } else if (literal_value(syntax_.exprs, expr.right(), &by)) {
      for (double& number : numbers) number += expr.op == Operator::kPlus ? -by : by;
      side = expr.left();
    } else if (literal_value(syntax_.exprs, expr.left(), &by)) {
      for (double& number : numbers) number = expr.op == Operator::kPlus ? number - by : by - number;
      side = expr.right();
    } else {
      return kComputedKey;
    }
  }
}

/// The numbers that calls pass, by argument: what a sub compares with `#3`.
std::vector<std::vector<double>> Refinement::numbers_passed() const {
  constexpr size_t kMost = 8;  // of one argument: loops are called with few
  std::vector<std::vector<double>> out(kFirstGlobalNumber);
  for (const Statement& s : syntax_.statements) {
    if (!s.is(Keyword::kCall)) continue;
    const auto values = syntax_.values_of(s);
    for (size_t i = 0; i < values.size() && i + 1 < out.size(); ++i) {
      double number = 0;
      if (out[i + 1].size() < kMost && literal_value(syntax_.exprs, values[i], &number)) out[i + 1].push_back(number);
    }
  }
  return out;
}

/// What a condition compares with: a number, or those that calls pass for an argument, if `of_while`.
std::vector<double> Refinement::compared_numbers(ExprId other, bool of_while) {
  double number = 0;
  if (literal_value(syntax_.exprs, other, &number)) return {number};
  const Expr& expr = syntax_.exprs[other];
  if (!of_while || expr.op != Operator::kParameter || !literal_value(syntax_.exprs, expr.left(), &number) ||
      number < 1 || number >= kFirstGlobalNumber)
    return {};
  if (passed_.empty()) passed_ = numbers_passed();
  return passed_[static_cast<size_t>(number)];
}

// Depth is bounded by the length of a line.
void Refinement::count_comparisons(ExprId id, bool of_while, std::vector<double>& thresholds) {
  const Expr& expr = syntax_.exprs[id];
  // `[[#1 EQ 3] EQ 0]` compares an outcome.
  const auto compares = [&](ExprId side) { return side != kNoExpr && is_comparison(syntax_.exprs[side].op); };
  const bool of_outcome = is_comparison(expr.op) && (compares(expr.left()) || compares(expr.right()));
  const auto count = [&](ExprId side, ExprId other) {
    const std::vector<double> written = other == kNoExpr ? std::vector<double>() : compared_numbers(other, of_while);
    std::vector<double> numbers = written;
    const ParameterKey key = counted_key_of(side, numbers);
    if (key == kComputedKey) return;
    compared_.emplace_back(key, of_while ? kOnce | kByLoop : kOnce);
    for (const double compared_with : numbers) add_thresholds(expr.op, compared_with, thresholds);
    if (numbers == written) return;
    // What the parameter is compared in is a range of its own, which begins a little beyond where that of the parameter does.
    for (const double compared_with : written) add_thresholds(expr.op, compared_with, thresholds);
    for (const double compared_with : numbers) {
      thresholds.push_back(compared_with - 3 * kEqualTolerance);
      thresholds.push_back(compared_with + 3 * kEqualTolerance);
    }
  };
  if (expr.op == Operator::kAnd || expr.op == Operator::kOr || of_outcome) {
    for_each_operand(expr, [&](ExprId operand) { count_comparisons(operand, of_while, thresholds); });
  } else if (is_comparison(expr.op)) {
    count(expr.left(), expr.right());
    count(expr.right(), expr.left());
  } else if (expr.op == Operator::kNamed || expr.op == Operator::kParameter) {
    count(id, kNoExpr);
  }
}

void Refinement::find_compared(const Limits& limits) {
  std::vector<double> thresholds;
  const std::span all(syntax_.statements);
  const auto first = all.first(std::min(all.size(), limits.remembered_statements));
  for (size_t i = 0; i < first.size(); ++i) {
    const Statement& s = first[i];
    const bool is_test = s.is(Keyword::kIf) || s.is(Keyword::kElseif) || s.is(Keyword::kWhile);
    const bool ends_loop = s.is(Keyword::kWhile) || (i + 1 < first.size() && first[i + 1].is(Keyword::kBreak));
    if (is_test && s.value_count > 0) count_comparisons(syntax_.values_of(s).front(), ends_loop, thresholds);
  }
  if (compared_.empty()) return;
  std::ranges::sort(compared_);
  size_t kept = 0;
  for (size_t i = 1; i < compared_.size(); ++i) {
    auto& [key, how] = compared_[kept];
    const auto [next_key, next] = compared_[i];
    if (next_key != key) {
      compared_[++kept] = compared_[i];
    } else {
      how |= (how & next & kOnce) != 0 ? next | kMoreThanOnce : next;
    }
  }
  compared_.resize(kept + 1);
  for (const Item& item : syntax_.items) {
    double number = 0;
    if (!assigns(item) || literal_value(syntax_.exprs, item.value, &number)) continue;
    if (uint8_t* how = compared(key_of_target(syntax_, item))) *how |= kComputed;
  }
  std::erase_if(compared_, [](const auto& entry) {
    constexpr uint8_t kCounter = kByLoop | kComputed;
    const uint8_t how = entry.second;
    return (how & kOnce) == 0 || ((how & (kMoreThanOnce | kCanFail)) == 0 && (how & kCounter) != kCounter);
  });
  if (compared_.empty()) return;
  std::ranges::sort(thresholds);
  thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
  if (thresholds.size() > limits.thresholds) {  // ranges between so many numbers would only tell states apart
    compared_.clear();
    return;
  }
  evaluator_.values().set_thresholds(Thresholds(std::move(thresholds), limits.thresholds));
}

void Refinement::narrow(Parameters& p, ExprId side, Operator op, ExprId other, bool truth) {
  const ParameterKey key = tracked_.key_of(side);
  // What may not be narrowed has not been counted.
  if (key == kComputedKey || !is_compared(key) || (is_global(key) && evaluator_.distrusts_globals())) return;
  PersistentMap& map = is_global(key) ? p.globals : p.locals;
  const ValueId before = map.get(static_cast<uint32_t>(key));
  if (KnownValues::is_constant(before) || before == kMaybeUnassigned || before == kNotPassed) return;
  Range right = Range::of(0);
  if (other != kNoExpr) right = evaluator_.values().range(evaluator_.evaluate(other, p).value);
  const ValueId after = evaluator_.values().intern(narrowed(evaluator_.values().range(before), op, right, truth));
  if (after != kUnknown) map.set(pool_, static_cast<uint32_t>(key), after);
}

/// Whether `EXISTS[#<name>] OP number` comes out as `truth` only where the name exists.
bool Refinement::tells_existence(const Expr& comparison, bool truth, NameId* name) const {
  double number = 0;
  const bool left = syntax_.exprs[comparison.left()].op == Operator::kExistsNamed;
  const Expr& asked = syntax_.exprs[left ? comparison.left() : comparison.right()];
  if (asked.op != Operator::kExistsNamed ||
      !literal_value(syntax_.exprs, left ? comparison.right() : comparison.left(), &number))
    return false;
  *name = asked.name();
  const auto outcome = [&](double exists) {
    double result = 0;
    owlint::apply(comparison.op, left ? exists : number, left ? number : exists, &result);
    return result != 0;
  };
  return outcome(1) == truth && outcome(0) != truth && tracked_.kind(*name) != NameKind::kPredefined;
}

// Depth is bounded by the length of a line.
bool Refinement::followed(ExprId condition, std::vector<ParameterKey>& reads) const {
  const Expr& expr = syntax_.exprs[condition];
  double number = 0;
  if (expr.op == Operator::kNumber) return true;
  if (expr.op == Operator::kExistsNumbered) return false;
  if (expr.op == Operator::kNamed || expr.op == Operator::kParameter) {
    const ParameterKey kept = trusted_key_of(condition);
    reads.push_back(kept != kComputedKey              ? kept
                        : expr.op == Operator::kNamed ? tracked_.key_of_name(expr.name())
                                                      : key_of_number(syntax_, expr.left()));
    return kept != kComputedKey;
  }
  if (expr.op == Operator::kExistsNamed) {
    reads.push_back(tracked_.key_of_name(expr.name()));
    return true;
  }
  const bool left = followed(expr.left(), reads);
  const bool right = expr.right() == kNoExpr || followed(expr.right(), reads);
  if (!left || !right) return false;
  if (expr.op == Operator::kAnd || expr.op == Operator::kOr) return true;
  if (!is_comparison(expr.op)) return false;
  const bool with_number =
      literal_value(syntax_.exprs, expr.left(), &number) || literal_value(syntax_.exprs, expr.right(), &number);
  return with_number && (trusted_key_of(expr.left()) != kComputedKey || trusted_key_of(expr.right()) != kComputedKey);
}

void Refinement::refine(Parameters& p, ExprId condition, bool truth) {
  if (coarse_) return;
  find_existing(p, condition, truth);
  for_known_comparisons(syntax_.exprs, condition, truth, [&](ExprId side, Operator op, ExprId other, bool outcome) {
    narrow(p, side, op, other, outcome);
  });
}

// Depth is bounded by the length of a line.
void Refinement::find_existing(Parameters& p, ExprId condition, bool truth) {
  const Expr& expr = syntax_.exprs[condition];
  NameId name = kNoName;
  if (expr.op == Operator::kAnd || expr.op == Operator::kOr) {
    if (truth != (expr.op == Operator::kAnd)) return;
    find_existing(p, expr.left(), truth);
    find_existing(p, expr.right(), truth);
  } else if (expr.op == Operator::kExistsNamed) {
    if (truth && tracked_.kind(expr.name()) != NameKind::kPredefined) evaluator_.assume_there(expr.name(), p);
  } else if (is_comparison(expr.op) && tells_existence(expr, truth, &name)) {
    evaluator_.assume_there(name, p);
  }
}

}  // namespace owlint::flow
