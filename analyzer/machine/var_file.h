// Reads the file of parameters (`PARAMETER_FILE`) as the interpreter reads it when it starts. Measured with `rs274 -v`.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "analyzer/text/source.h"

namespace owlint {

/// A line with a number and a value; other lines are ignored.
struct VarRow {
  int64_t number = 0;
  uint32_t line = 1;
  Span span;              ///< the number
  bool fraction = false;  ///< the number goes on with a point: the value is what follows the integer
};

/// Why LinuxCNC does not start with the file.
struct VarProblem {
  enum class Kind : uint8_t { kOutOfOrder, kOutOfRange };
  Kind kind = Kind::kOutOfOrder;
  VarRow row;
  VarRow before;  ///< of kOutOfOrder
};

struct VarFile {
  std::vector<VarRow> rows;
  std::optional<VarProblem> problem;  ///< the first; the rest of the file is not read
};

VarFile read_var_file(std::string_view bytes);

}  // namespace owlint
