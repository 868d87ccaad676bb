// LinuxCNC's parameters: which there are, and whose they are. Source: its page on O-words and parameters, and
// ../../docs/interpreter.md. What LinuxCNC keeps itself: ../machine/predefined.h.
#pragma once

#include <cstdint>
#include <string_view>

#include "analyzer/syntax/names.h"

namespace owlint::flow {

/// #1 to #30 belong to the sub that is executed, named ones without `_` too; the rest is global.
inline constexpr long kFirstGlobalNumber = 31;
inline constexpr long kLastNumber = 5601;
/// From here on positions, offsets, probe results, tool data: the machine changes these between two lines.
inline constexpr long kFirstVolatileNumber = 5061;

/// A parameter by number or by name.
struct ParameterId {
  uint32_t id = 0;  ///< the number, or a NameId
  bool named = false;
};

/// Keys of parameters in maps: numbers are their own, names these plus the NameId.
inline constexpr uint32_t kLocalNames = 32;
inline constexpr uint32_t kGlobalNames = 8192;

/// Whether a name begins with `_` and so is shared by all subs.
inline bool is_global_name(std::string_view name) { return name.starts_with('_'); }

}  // namespace owlint::flow
