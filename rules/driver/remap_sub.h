// What the sub of a REMAP line reads of what it could get.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "rules/driver/remap_rules.h"

namespace owlint::rules {

struct RemapSub {
  std::shared_ptr<const Program> program;
  RegionId region = kNoRegion;

  struct Name {
    char letter;            ///< small
    StatementId first;      ///< the first line that reads it
    bool may_lack = false;  ///< the file asks with EXISTS whether it is there, or assigns it
  };
  std::vector<Name> names;  ///< local names of one letter, in the order in which they are read
  std::string shown;        ///< those that comments show, small: without a value nothing stops there
  uint32_t arguments = 0;   ///< bit n: the value of #n at the call may be read
  bool known = false;       ///< of `arguments`: else any may be read

  std::array<StatementId, 31> argument_lines{};  ///< by n: the first line that reads #n

  /// Also in a comment.
  bool reads(char letter) const;
};

/// Nothing if the file or the sub in it is not there.
RemapSub remap_sub(const SetupInput& in, std::string_view ngc);

}  // namespace owlint::rules
