// What a machine's INI does with codes: each REMAP line, and the words that tell users of it.
#pragma once

#include <string>
#include <vector>

#include "analyzer/machine/profile.h"

namespace owlint::lsp {

struct Remap {
  char letter;        ///< `g` or `m`, or `t`, `s`, `f`: then all such words
  int number;         ///< of the code, of a G code in tenths; -1 of a word
  std::string calls;  ///< "`o<probe>`" or "the Python function `probe`"
  const Ini::Entry* entry;
};

/// The remaps that LinuxCNC calls: it does not remap most of its own codes.
std::vector<Remap> remaps(const Profile& profile);

}  // namespace owlint::lsp
