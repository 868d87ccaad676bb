#include "analyzer/flow/domain/ranges.h"

#include <algorithm>
#include <cmath>

#include "analyzer/syntax/arithmetic.h"

namespace owlint::flow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Range kAll;
const Range kTruths{0, 1, false, false};

Range truth(bool can_be_false, bool can_be_true) {
  if (can_be_false && can_be_true) return kTruths;
  return Range::of(can_be_true ? 1 : 0);
}

/// What `a OP b` can come out as: whether some pair of members makes it false, and whether some makes it true.
Range compare(Operator op, const Range& a, const Range& b) {
  return truth(!narrowed(a, op, b, false).is_empty(), !narrowed(a, op, b, true).is_empty());
}

Range negated(const Range& r) { return {-r.high, -r.low, r.below_high, r.above_low}; }

Range absolute(const Range& r) {
  if (r.low >= 0) return r;
  if (r.high <= 0) return negated(r);
  const Range other = negated(r);
  const bool other_longer = other.high > r.high || (other.high == r.high && !other.below_high);
  const Range& longer = other_longer ? other : r;
  return {0, longer.high, false, longer.below_high};
}

Range sum(const Range& a, const Range& b) {
  // Sums round: an open end may be met.
  const Range out{a.low + b.low, a.high + b.high, false, false};
  return std::isnan(out.low) || std::isnan(out.high) ? kAll : out;
}

Range product(const Range& a, const Range& b) {
  Range out{kInfinity, -kInfinity, false, false};
  for (const double x : {a.low, a.high}) {
    for (const double y : {b.low, b.high}) {
      const double p = x == 0 || y == 0 ? 0 : x * y;  // the ends at infinity are no members
      out.low = std::min(out.low, p);
      out.high = std::max(out.high, p);
    }
  }
  return out;
}

Range quotient(const Range& a, const Range& b) {
  if (b.low <= 0 && b.high >= 0) return kAll;
  const Range inverse{1 / b.high, 1 / b.low, false, false};
  Range out = product(a, inverse);
  // Dividing rounds otherwise than multiplying by the inverse does.
  out.low = std::nextafter(out.low, -kInfinity);
  out.high = std::nextafter(out.high, kInfinity);
  if (a.low >= 0 && b.low > 0) out.low = std::max(out.low, 0.0);
  return out;
}

Range rounded(Operator op, const Range& r) {
  const auto at = [op](double value) {
    double out = value;
    if (std::isfinite(value)) owlint::apply(op, value, 0, &out);
    return out;
  };
  return {at(r.low), at(r.high), false, false};
}

}  // namespace

bool Range::is_all() const { return low == -kInfinity && high == kInfinity; }

bool Range::has(double value) const {
  return (above_low ? value > low : value >= low) && (below_high ? value < high : value <= high);
}

Range hull(const Range& a, const Range& b) {
  Range out = a;
  if (b.low < a.low || (b.low == a.low && !b.above_low)) {
    out.low = b.low;
    out.above_low = b.above_low;
  }
  if (b.high > a.high || (b.high == a.high && !b.below_high)) {
    out.high = b.high;
    out.below_high = b.below_high;
  }
  return out;
}

Range intersection(const Range& a, const Range& b) {
  Range out = a;
  if (b.low > a.low || (b.low == a.low && b.above_low)) {
    out.low = b.low;
    out.above_low = b.above_low;
  }
  if (b.high < a.high || (b.high == a.high && b.below_high)) {
    out.high = b.high;
    out.below_high = b.below_high;
  }
  return out;
}

bool is_comparison(Operator op) { return op >= Operator::kEq && op <= Operator::kLe; }

Operator mirrored(Operator op) {
  switch (op) {
    case Operator::kGt: return Operator::kLt;
    case Operator::kGe: return Operator::kLe;
    case Operator::kLt: return Operator::kGt;
    case Operator::kLe: return Operator::kGe;
    default: return op;
  }
}

Range narrowed(const Range& left, Operator op, const Range& right, bool truth) {
  if (left.is_empty() || right.is_empty()) return left;
  switch (op) {
    case Operator::kEq:
    case Operator::kNe: {
      const bool equal = (op == Operator::kEq) == truth;
      // Equal is what differs by less than the tolerance; computing that rounds.
      const double near = kEqualTolerance * (1 + 1e-9);
      if (equal) return intersection(left, {right.low - near, right.high + near, false, false});
      if (!right.is_one()) return left;
      const double least = kEqualTolerance * (1 - 1e-9);
      const bool all_equal = left.low > right.low - least && left.high < right.low + least;
      return all_equal ? Range{1, 0, false, false} : left;
    }
    case Operator::kGt:
      return truth ? intersection(left, {right.low, kInfinity, true, false})
                   : narrowed(left, Operator::kLe, right, true);
    case Operator::kGe:
      return truth ? intersection(left, {right.low, kInfinity, right.above_low, false})
                   : narrowed(left, Operator::kLt, right, true);
    case Operator::kLt:
      return truth ? intersection(left, {-kInfinity, right.high, false, true})
                   : narrowed(left, Operator::kGe, right, true);
    case Operator::kLe:
      return truth ? intersection(left, {-kInfinity, right.high, false, right.below_high})
                   : narrowed(left, Operator::kGt, right, true);
    default: return left;
  }
}

Range apply(Operator op, const Range& left, const Range& right) {
  if (left.is_empty() || right.is_empty()) return kAll;
  if (is_comparison(op)) return compare(op, left, right);
  const auto can_be_true = [](const Range& r) { return r != Range::of(0); };
  const auto can_be_false = [](const Range& r) { return r.has(0); };
  switch (op) {
    case Operator::kAnd:
      return truth(can_be_false(left) || can_be_false(right), can_be_true(left) && can_be_true(right));
    case Operator::kOr:
      return truth(can_be_false(left) && can_be_false(right), can_be_true(left) || can_be_true(right));
    case Operator::kXor: return kTruths;
    case Operator::kNegate: return negated(left);
    case Operator::kAbs: return absolute(left);
    case Operator::kFix:
    case Operator::kFup:
    case Operator::kRound: return rounded(op, left);
    case Operator::kSqrt:
      return {left.low > 0 ? std::sqrt(left.low) : 0, left.high > 0 ? std::sqrt(left.high) : 0, false, false};
    case Operator::kSin:
    case Operator::kCos: return {-1, 1, false, false};
    case Operator::kAsin: return {-90, 90, false, false};
    case Operator::kAcos: return {0, 180, false, false};
    case Operator::kAtan: return {-180, 180, false, false};
    case Operator::kExp: return {0, kInfinity, false, false};
    case Operator::kPlus: return sum(left, right);
    case Operator::kMinus: return sum(left, negated(right));
    case Operator::kTimes: return product(left, right);
    case Operator::kDivide: return quotient(left, right);
    case Operator::kModulo:
      return right.is_one() && right.low != 0 ? Range{0, std::fabs(right.low), false, false} : kAll;
    default: return kAll;
  }
}

const char* always_fails(Operator op, const Range& left, const Range& right) {
  if (left.is_empty() || right.is_empty()) return nullptr;
  // Where all members fail, the ones at the ends do, and with the same words.
  const auto fails = [&](double value) {
    double result = 0;
    return owlint::apply(op, value, right.low, &result);
  };
  const bool below = left.high < 0 || (left.high == 0 && left.below_high);
  switch (op) {
    case Operator::kDivide: return right == Range::of(0) ? fails(1) : nullptr;
    case Operator::kSqrt: return below ? fails(-1) : nullptr;
    case Operator::kLn: return left.high <= 0 ? fails(-1) : nullptr;
    case Operator::kAcos:
    case Operator::kAsin: {
      const bool outside =
          left.low > 1 || left.high < -1 || (left.low == 1 && left.above_low) || (left.high == -1 && left.below_high);
      return outside ? fails(2) : nullptr;
    }
    default: return nullptr;
  }
}

void add_thresholds(Operator op, double number, std::vector<double>& out) {
  out.push_back(number);
  if (op != Operator::kEq && op != Operator::kNe) return;
  // Farther away than what is equal, or a range that ends there could not be told from the number.
  out.push_back(number - 2 * kEqualTolerance);
  out.push_back(number + 2 * kEqualTolerance);
}

Thresholds::Thresholds(std::vector<double> numbers, size_t most) : numbers_(std::move(numbers)) {
  std::ranges::sort(numbers_);
  numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  if (numbers_.size() > most) numbers_.clear();
  if (!std::ranges::binary_search(numbers_, 0.0)) numbers_.insert(std::ranges::lower_bound(numbers_, 0.0), 0.0);
}

Range Thresholds::widened(const Range& range) const {
  Range out;
  const auto above = std::ranges::upper_bound(numbers_, range.low);
  if (above != numbers_.begin()) {
    out.low = above[-1];
    out.above_low = out.low < range.low || range.above_low;
  }
  const auto end = std::ranges::lower_bound(numbers_, range.high);
  if (end != numbers_.end()) {
    out.high = *end;
    out.below_high = out.high > range.high || range.below_high;
  }
  return out;
}

}  // namespace owlint::flow
