// The codes that the machine's INI remaps, while a program runs: some are built in within the subs that they run, so that these
// can use them. Measured with `rs274 -i`.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "analyzer/syntax/remaps.h"

namespace owlint::flow {

class RemappedCodes {
 public:
  /// `machine` must outlive it.
  explicit RemappedCodes(const MachineWords& machine);

  /// The bit of a code that is built in within its own sub, for Context::built_in; 0 for all others.
  uint16_t own_bit(const RemappedCode& code) const;
  /// The words of the machine where these are built in.
  const MachineWords& words_within(uint16_t built_in) const;
  /// What the line of a kRemap runs; null where its code is built in.
  const RemappedCode* code_at(const Syntax& syntax, const Statement& remap, uint16_t built_in) const;
  /// The codes that are built in within a sub, because they run it.
  uint16_t built_in_within(std::string_view sub) const;
  /// Whether some remap runs Python, which may do anything.
  bool run_python() const;

 private:
  struct Within {
    std::vector<RemappedCode> remapped;
    MachineWords words;  ///< refers to them
  };

  const MachineWords& machine_;
  mutable std::map<uint16_t, Within> within_;  // by the codes that are built in; as they are needed
};

}  // namespace owlint::flow
