// Names by which a program reads the modes of the machine, such as `#<_metric>`: which mode each one shows, and as what number.
// Source: measured with rs274, name by name.
#pragma once

#include <optional>
#include <string_view>

#include "analyzer/syntax/expression.h"
#include "analyzer/syntax/modes.h"

namespace owlint {

class ModeName {
 public:
  struct Row;  ///< of the table

  /// The mode that a predefined name shows, without `#<` and `>`; nothing for other names.
  static std::optional<ModeName> find(std::string_view name);

  Mode mode() const;
  /// The number that is read while one of these values is in effect, if it is the same for all of them.
  std::optional<double> number(ValueSet may) const;
  /// Those of the values with which `name op number` may come out like this.
  ValueSet with(ValueSet may, Operator op, double number, bool outcome) const;

 private:
  explicit ModeName(const Row& row) : row_(&row) {}
  /// Of one value; nothing where it may be several numbers.
  std::optional<double> number_of(uint8_t value) const;

  const Row* row_;
};

}  // namespace owlint
