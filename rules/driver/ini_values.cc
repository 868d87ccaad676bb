#include "rules/driver/ini_values.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

namespace owlint::rules {
namespace {

template <typename Number>
std::optional<Number> whole(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

template <size_t Size>
bool is_one_of(const std::array<std::string_view, Size>& words, std::string_view value) {
  return std::ranges::find(words, small_letters(value)) != words.end();
}

}  // namespace

std::optional<double> ini_real(std::string_view value) { return whole<double>(value); }
std::optional<int> ini_integer(std::string_view value) { return whole<int>(value); }

std::optional<bool> ini_switch(std::string_view value) {
  const std::optional<int> number = ini_integer(value);
  if (!number || (*number != 0 && *number != 1)) return std::nullopt;
  return *number == 1;
}

std::optional<bool> ini_truth(std::string_view value) {
  static constexpr std::array<std::string_view, 4> kTrue{"true", "yes", "on", "1"};
  static constexpr std::array<std::string_view, 4> kFalse{"false", "no", "off", "0"};
  if (is_one_of(kTrue, value)) return true;
  if (is_one_of(kFalse, value)) return false;
  return std::nullopt;
}

bool is_linear_unit(std::string_view value) {
  static constexpr std::array<std::string_view, 5> kUnits{"mm", "metric", "in", "inch", "imperial"};
  return is_one_of(kUnits, value) || ini_real(value);
}

bool is_angular_unit(std::string_view value) {
  static constexpr std::array<std::string_view, 6> kUnits{"deg", "degree", "grad", "gon", "rad", "radian"};
  return is_one_of(kUnits, value) || ini_real(value);
}

bool reads_section(const IniText& text, std::string_view section) {
  if (section.starts_with("JOINT_")) {
    const IniLine* joints = find_line(text, "KINS", "JOINTS");
    const std::optional<int> count = joints == nullptr ? std::nullopt : ini_integer(text.value(*joints));
    const std::optional<int> number = ini_integer(section.substr(section.find('_') + 1));
    return count && number && *number < *count;
  }
  if (section.starts_with("AXIS_")) {
    const IniLine* coordinates = find_line(text, "TRAJ", "COORDINATES");
    const std::string letters = small_letters(coordinates == nullptr ? "xyz" : text.value(*coordinates));
    const std::string letter = small_letters(section.substr(section.find('_') + 1));
    return letter.size() == 1 && letters.find(letter) != std::string::npos;
  }
  return true;
}

std::string conversion_error(const IniText& text, const IniLine& line) {
  return fmt::format("INIFILE: ERR_CONVERSION, section={}, tag={}, num=1, lineNo={}", text.section_of(line),
                     text.name(line), line.number);
}

}  // namespace owlint::rules
