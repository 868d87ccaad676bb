// LinuxCNC's parameters: which exist, and what they belong to. Source: its page on O-words and parameters, and
// ../../docs/interpreter.md. Predefined ones: ../machine/predefined.h.
#pragma once

#include <cstdint>
#include <string_view>

#include "analyzer/syntax/names.h"

namespace owlint::flow {

/// #1 to #30 and names without `_` belong to the sub that is running; the rest is global.
inline constexpr long kFirstGlobalNumber = 31;
inline constexpr long kLastNumber = 5601;
/// From here on: positions, offsets, probe results, tool data. The machine changes these between two lines.
inline constexpr long kFirstVolatileNumber = 5061;

/// What the machine's inputs answered: the result of a probe, that of M66. Only G38.2 to G38.5 and M66 change them.
inline bool is_answer(long number) { return (number >= 5061 && number <= 5070) || number == 5399; }

/// #5420 to #5428, the position in the program's coordinates.
inline bool is_position(long number) { return number >= 5420 && number <= 5428; }

/// A parameter by number or by name.
struct ParameterId {
  uint32_t id = 0;  ///< the number, or a NameId
  bool named = false;
};

/// Keys of parameters in maps: a number is its own key, the key of a name is one of these plus the NameId.
inline constexpr uint32_t kLocalNames = 32;
inline constexpr uint32_t kGlobalNames = 8192;

/// Whether a name begins with `_` and so is global.
inline bool is_global_name(std::string_view name) { return name.starts_with('_'); }

}  // namespace owlint::flow
