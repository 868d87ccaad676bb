#include "analyzer/syntax/arithmetic.h"

#include <cmath>

#include "analyzer/geometry/plane_point.h"

namespace owlint {
namespace {

// The interpreter computes with all digits of π that the processor has, and rounds where these do (measured): its COS[90] is a
// little less than 0, so that FIX[COS[90]] is -1, and its ACOS[0.5] is exactly 60.
long double in_radians(double degrees) { return degrees * kPi / 180.0L; }
double in_degrees(double radians) { return static_cast<double>(radians * 180.0 / kPi); }

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
  switch (op) {
    case Operator::kNegate: *result = -left; return nullptr;
    case Operator::kAbs: *result = std::fabs(left); return nullptr;
    case Operator::kAcos:
      if (left < -1 || left > 1) return "Argument to acos out of range";
      *result = in_degrees(std::acos(left));
      return nullptr;
    case Operator::kAsin:
      if (left < -1 || left > 1) return "Argument to asin out of range";
      *result = in_degrees(std::asin(left));
      return nullptr;
    case Operator::kCos: *result = static_cast<double>(std::cos(in_radians(left))); return nullptr;
    case Operator::kExp: *result = std::exp(left); break;
    case Operator::kFix: *result = std::floor(left); return nullptr;
    case Operator::kFup: *result = std::ceil(left); return nullptr;
    case Operator::kLn:
      if (left <= 0) return "Zero or negative argument to ln";
      *result = std::log(left);
      return nullptr;
    case Operator::kRound: *result = std::round(left); return nullptr;
    case Operator::kSin: *result = static_cast<double>(std::sin(in_radians(left))); return nullptr;
    case Operator::kSqrt:
      if (left < 0) return "Negative argument to sqrt";
      *result = std::sqrt(left);
      return nullptr;
    case Operator::kTan: *result = static_cast<double>(std::tan(in_radians(left))); return nullptr;
    case Operator::kAtan: *result = in_degrees(std::atan2(left, right)); return nullptr;
    case Operator::kPower:
      if (left < 0 && std::floor(right) != right) return "Attempt to raise negative to non integer power";
      *result = std::pow(left, right);
      break;
    case Operator::kTimes: *result = left * right; break;
    case Operator::kDivide:
      if (right == 0) return "Attempt to divide by zero";
      *result = left / right;
      break;
    case Operator::kModulo:
      *result = std::fmod(left, right);
      if (*result < 0) *result += std::fabs(right);
      break;
    case Operator::kPlus: *result = left + right; break;
    case Operator::kMinus: *result = left - right; break;
    case Operator::kEq: *result = truth(std::fabs(left - right) < kEqualTolerance); return nullptr;
    case Operator::kNe: *result = truth(std::fabs(left - right) >= kEqualTolerance); return nullptr;
    case Operator::kGt: *result = truth(left > right); return nullptr;
    case Operator::kGe: *result = truth(left >= right); return nullptr;
    case Operator::kLt: *result = truth(left < right); return nullptr;
    case Operator::kLe: *result = truth(left <= right); return nullptr;
    case Operator::kAnd: *result = truth(left != 0 && right != 0); return nullptr;
    case Operator::kOr: *result = truth(left != 0 || right != 0); return nullptr;
    case Operator::kXor: *result = truth((left == 0) != (right == 0)); return nullptr;
    default: *result = left; return nullptr;
  }
  if (std::isnan(*result)) return kNotANumber;
  if (std::isinf(*result)) return kInfinite;
  return nullptr;
}

}  // namespace owlint
