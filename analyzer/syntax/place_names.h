// Numbers and names by which a program reads where the machine stands, `#5420` and `#<_x>`, and which tool is in the spindle.
// Source: measured with rs274.
#pragma once

#include <optional>
#include <string_view>

#include "analyzer/syntax/place.h"
#include "analyzer/syntax/statement.h"

namespace owlint {

class PlaceName {
 public:
  static std::optional<PlaceName> find(long number);
  /// Without `#<` and `>`.
  static std::optional<PlaceName> find(std::string_view name);
  /// What an expression reads; nothing if it is no such parameter, or is set by its line.
  static std::optional<PlaceName> read_by(const Syntax& syntax, const Expr& expr);

  /// Nothing for the tool.
  std::optional<Axis> axis() const { return axis_; }
  /// What is read, if it is the same wherever the program has begun, or with `started` on a machine that was just started.
  std::optional<double> number(const Place& place, bool started) const;

 private:
  explicit PlaceName(std::optional<Axis> axis) : axis_(axis) {}

  std::optional<Axis> axis_;
};

}  // namespace owlint
