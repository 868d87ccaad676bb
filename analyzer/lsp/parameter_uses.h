// Where a line names parameters: in its words and expressions, and in the comments that print them, such as
// `(debug, #<depth>)`. The text need not be correct.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace owlint::lsp {

struct ParameterUse {
  size_t begin = 0;  ///< bytes from the line's beginning, at the `#`
  size_t end = 0;
  std::string
      name;  ///< as LinuxCNC keeps it: `<depth>` or `31`; empty where the number is computed: `#[#1 + 2]`, `##2`
  bool assigned = false;
  bool printed = false;  ///< in a comment
};

/// The parameters of one line, in their order. `line`: without its line feed.
std::vector<ParameterUse> parameter_uses(std::string_view line);

/// Whether a parameter belongs to all subs and programs: `<_name>`, and numbers from 31 on.
bool is_shared(std::string_view name);

}  // namespace owlint::lsp
