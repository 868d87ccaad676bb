#include "analyzer/syntax/mode_names.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/codes.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint {
namespace {

constexpr int16_t kSeveral = -1;   // not one number, but above those of the other values
constexpr int16_t kByMotion = -2;  // ten times that of the code

}  // namespace

struct ModeName::Row {
  std::string_view name;
  Mode mode;
  std::array<int16_t, 9> numbers;  ///< by value of the mode
};

namespace {

// In the order of their names. Compensation with a D word of its own reads 411 and 421 in some releases.
constexpr ModeName::Row kRows[] = {
    {"_absolute", Mode::kDistance, {1, 0}},
    {"_adaptive_feed", Mode::kAdaptiveFeed, {0, 1}},
    {"_ccomp", Mode::kCompensation, {400, kSeveral, kSeveral}},
    {"_coord_system", Mode::kSystem, {540, 550, 560, 570, 580, 590, 591, 592, 593}},
    {"_feed", Mode::kFeed, {0, kSeveral, kSeveral}},
    {"_feed_hold", Mode::kFeedHold, {1, 0}},
    {"_flood", Mode::kCoolant, {0, 0, 1, 1}},
    {"_ijk_absolute_mode", Mode::kArcDistance, {0, 1}},
    {"_imperial", Mode::kUnits, {0, 1}},
    {"_incremental", Mode::kDistance, {0, 1}},
    {"_inverse_time", Mode::kFeedMode, {0, 1, 0}},
    {"_lathe_diameter_mode", Mode::kDiameter, {0, 1}},
    {"_lathe_radius_mode", Mode::kDiameter, {1, 0}},
    {"_metric", Mode::kUnits, {1, 0}},
    {"_mist", Mode::kCoolant, {0, 1, 0, 1}},
    {"_motion_mode", Mode::kMotion, {kByMotion}},
    {"_plane", Mode::kPlane, {170, 180, 190, 171, 181, 191}},
    {"_retract_old_z", Mode::kRetract, {0, 1}},
    {"_retract_r_plane", Mode::kRetract, {1, 0}},
    {"_rpm", Mode::kSpeed, {0, kSeveral, kSeveral}},
    {"_spindle_css_mode", Mode::kSpindleMode, {0, 1}},
    {"_spindle_cw", Mode::kTurning, {0, 1, 0}},
    {"_spindle_on", Mode::kTurning, {0, 1, 1}},
    {"_spindle_rpm_mode", Mode::kSpindleMode, {1, 0}},
    {"_tool_offset", Mode::kToolOffset, {0, 1}},
    {"_units_per_minute", Mode::kFeedMode, {1, 0, 0}},
    {"_units_per_rev", Mode::kFeedMode, {0, 0, 1}},
};
static_assert(std::ranges::is_sorted(kRows, {}, &ModeName::Row::name));

constexpr long kSystemNumber = 5220;
constexpr ModeName::Row kSystem{"", Mode::kSystem, {1, 2, 3, 4, 5, 6, 7, 8, 9}};

/// Where no motion is in effect, it reads as G80. Contours leave any motion.
std::optional<double> number_of_motion(Motion motion) {
  if (motion == Motion::kNone) return code::kG80;
  for (const GCode& code : g_codes()) {
    if (code.motion == motion && code.group == GGroup::kMotion && code.leaves == GCode::kItself) return code.tenths;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ModeName> ModeName::find(std::string_view name) {
  const auto* const found = std::ranges::lower_bound(kRows, name, {}, &Row::name);
  if (found == std::end(kRows) || found->name != name) return std::nullopt;
  return ModeName(*found);
}

std::optional<ModeName> ModeName::find(long number) {
  return number == kSystemNumber ? std::optional(ModeName(kSystem)) : std::nullopt;
}

std::optional<ModeName> ModeName::read_by(const Syntax& syntax, const Expr& expr) {
  if (expr.op == Operator::kNamed) return find(syntax.names.text(expr.name()));
  if (expr.op != Operator::kParameter) return std::nullopt;
  const std::optional<long> number = literal_integer(syntax.exprs, expr.left());
  return number ? find(*number) : std::nullopt;
}

Mode ModeName::mode() const { return row_->mode; }

std::optional<double> ModeName::number_of(uint8_t value) const {
  const auto& numbers = row_->numbers;
  if (numbers.front() == kByMotion) return number_of_motion(static_cast<Motion>(value));
  if (value >= numbers.size() || numbers[value] == kSeveral) return std::nullopt;
  return numbers[value];
}

std::optional<ModeName::Numbers> ModeName::numbers(ValueSet may) const {
  std::optional<Numbers> all;
  for (; may != 0; may &= may - 1) {
    const std::optional<double> one = number_of(static_cast<uint8_t>(std::countr_zero(may)));
    if (!one) return std::nullopt;
    all = all ? Numbers{std::min(all->least, *one), std::max(all->greatest, *one)} : Numbers{*one, *one};
  }
  return all;
}

ValueSet ModeName::with(ValueSet may, Operator op, double number, bool outcome) const {
  bool of_another = false;
  for_values(all_values(mode()), [&](uint8_t value) { of_another = of_another || number_of(value) == number; });
  ValueSet left = 0;
  for_values(may, [&](uint8_t value) {
    double result = outcome ? 1 : 0;
    const std::optional<double> known = number_of(value);
    // What is no certain number is above those of the other values; but a motion may be any.
    if (known || (of_another && row_->numbers.front() != kByMotion))
      apply(op, known ? *known : number + 1, number, &result);
    if ((result != 0) == outcome) left |= value_bit(value);
  });
  return left;
}

}  // namespace owlint
