#include "analyzer/syntax/arithmetic.h"

#include <cmath>
#include <numbers>

namespace owlint {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double truth(bool value) { return value ? 1.0 : 0.0; }

}  // namespace

bool to_integer(double value, long* result) {
  if (!(std::fabs(value) < 2147483648.0)) return false;
  *result = static_cast<long>(value);
  if (static_cast<double>(*result) == value) return true;  // as nearly always; rounding down is a call of a function
  const double floor = std::floor(value);
  if (value - floor > 0.9999) {
    *result = static_cast<long>(std::ceil(value));
    return true;
  }
  *result = static_cast<long>(floor);
  return value - floor <= 0.0001;
}

const char* apply(Operator op, double left, double right, double* result) {
  double& out = *result;
  switch (op) {
    case Operator::kNegate: out = -left; return nullptr;
    case Operator::kAbs: out = std::fabs(left); return nullptr;
    case Operator::kAcos:
      if (left < -1 || left > 1) return "Argument to acos out of range";
      out = std::acos(left) * kDegrees;
      return nullptr;
    case Operator::kAsin:
      if (left < -1 || left > 1) return "Argument to asin out of range";
      out = std::asin(left) * kDegrees;
      return nullptr;
    case Operator::kCos: out = std::cos(left / kDegrees); return nullptr;
    case Operator::kExp: out = std::exp(left); break;
    case Operator::kFix: out = std::floor(left); return nullptr;
    case Operator::kFup: out = std::ceil(left); return nullptr;
    case Operator::kLn:
      if (left <= 0) return "Zero or negative argument to ln";
      out = std::log(left);
      return nullptr;
    case Operator::kRound: out = std::round(left); return nullptr;
    case Operator::kSin: out = std::sin(left / kDegrees); return nullptr;
    case Operator::kSqrt:
      if (left < 0) return "Negative argument to sqrt";
      out = std::sqrt(left);
      return nullptr;
    case Operator::kTan: out = std::tan(left / kDegrees); return nullptr;
    case Operator::kAtan: out = std::atan2(left, right) * kDegrees; return nullptr;
    case Operator::kPower:
      if (left < 0 && std::floor(right) != right) return "Attempt to raise negative to non integer power";
      out = std::pow(left, right);
      break;
    case Operator::kTimes: out = left * right; break;
    case Operator::kDivide:
      if (right == 0) return "Attempt to divide by zero";
      out = left / right;
      break;
    case Operator::kModulo:
      out = std::fmod(left, right);
      if (out < 0) out += std::fabs(right);
      break;
    case Operator::kPlus: out = left + right; break;
    case Operator::kMinus: out = left - right; break;
    case Operator::kEq: out = truth(std::fabs(left - right) < kEqualTolerance); return nullptr;
    case Operator::kNe: out = truth(std::fabs(left - right) >= kEqualTolerance); return nullptr;
    case Operator::kGt: out = truth(left > right); return nullptr;
    case Operator::kGe: out = truth(left >= right); return nullptr;
    case Operator::kLt: out = truth(left < right); return nullptr;
    case Operator::kLe: out = truth(left <= right); return nullptr;
    case Operator::kAnd: out = truth(left != 0 && right != 0); return nullptr;
    case Operator::kOr: out = truth(left != 0 || right != 0); return nullptr;
    case Operator::kXor: out = truth((left == 0) != (right == 0)); return nullptr;
    default: out = left; return nullptr;
  }
  if (std::isnan(out)) return "Calculation resulted in 'not a number'";
  if (std::isinf(out)) return "Calculation resulted in 'infinity'";
  return nullptr;
}

}  // namespace owlint
