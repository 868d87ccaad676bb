// What a line was meant to be that LinuxCNC reads as something else or not at all: `o<loop while [1]` without its `>`,
// `o1 (why) endif`, `o<f> sbu`, `hole sub`, `sub <hole>`, `Q100 if`, `N100 endsub`. So one mistake stays one finding, and
// says where it is.
#pragma once

#include <string>
#include <unordered_map>

#include "analyzer/program/program.h"

namespace owlint {

struct Meant {
  Keyword keyword = Keyword::kUnknown;  ///< kUnknown: nothing is known of what was meant
  bool has_label = false;
  NameId label = kNoName;  ///< also if the line has one that the program does not use elsewhere
  std::string name;        ///< that label, without its `o`
  Span words;              ///< label and keyword, as they are written
  uint64_t name_end = 0;   ///< where the `>` belongs, if it is missing
};

Meant meant_by(const Program& program, StatementId id);

/// The first lines that were meant to begin a sub, by its label. Where the line has none: by that of the `endsub` below.
std::unordered_map<NameId, StatementId> misread_subs(const Program& program);

}  // namespace owlint
