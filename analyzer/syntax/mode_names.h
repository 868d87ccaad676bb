// Names by which a program reads the modes of the machine, such as `#<_metric>`, and the one number: which mode each shows, and
// as what number.
// Source: measured with rs274, name by name.
#pragma once

#include <optional>
#include <string_view>

#include "analyzer/syntax/modes.h"
#include "analyzer/syntax/statement.h"

namespace owlint {

class ModeName {
 public:
  struct Row;  ///< of the table

  /// The mode that a predefined name shows, without `#<` and `>`; nothing for other names.
  static std::optional<ModeName> find(std::string_view name);
  /// The same of a numbered parameter: #5220.
  static std::optional<ModeName> find(long number);
  /// What an expression reads; nothing if it is no such parameter.
  static std::optional<ModeName> read_by(const Syntax& syntax, const Expr& expr);

  Mode mode() const;
  struct Numbers {
    double least, greatest;
  };
  /// Between which numbers the one is that is read while one of these values is in effect. Nothing if that is not known.
  std::optional<Numbers> numbers(ValueSet may) const;
  /// Those of the values with which `name op number` may come out like this.
  ValueSet with(ValueSet may, Operator op, double number, bool outcome) const;

 private:
  explicit ModeName(const Row& row) : row_(&row) {}
  /// Of one value; nothing where it may be several numbers.
  std::optional<double> number_of(uint8_t value) const;

  const Row* row_;
};

}  // namespace owlint
