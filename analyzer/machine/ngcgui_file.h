// A sub that ngcgui makes a page of: a file of `[DISPLAY]NGCGUI_SUBFILE`. ngcgui reads it by itself, line by line, and refuses
// more than LinuxCNC does. Read from ngcgui as it comes with LinuxCNC 2.9, not run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "analyzer/text/source.h"

namespace owlint {

struct NgcguiProblem {
  enum class Kind : uint8_t {
    kGenerated,    ///< a file that ngcgui has written
    kNotASubfile,  ///< marked `(not_a_subfile)`
    kNumberedSub,  ///< `o100 sub` within the file
    kSeveralSubs,
    kOtherName,      ///< a `sub` or `endsub` whose label is not the file's name; capitals count
    kCodeBefore,     ///< lines before the sub
    kCodeBehind,     ///< lines behind it that are neither comments nor M2
    kOutOfSequence,  ///< `#<name> = #3` without one of #2 before it
    kNoSub,
    kNoEnd,
  };
  Kind kind;
  Span span;            ///< of the line; empty where the whole file is meant
  std::string message;  ///< ngcgui's
};

/// The first thing that ngcgui refuses in a file. `name`: the file's, without its ending.
std::optional<NgcguiProblem> ngcgui_problem(std::string_view name, std::string_view bytes);

}  // namespace owlint
