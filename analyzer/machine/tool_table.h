// Reads a tool table as LinuxCNC reads it: which tools a machine has, and what is known of them. Source: LinuxCNC's own
// reader and `rs274 -t`, compared on random tables.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "analyzer/text/source.h"

namespace owlint {

/// A tool, as one line of the table describes it: `T3 P12 D6 Z41.5 ;end mill`.
struct ToolRow {
  static constexpr int32_t kNoNumber = -1;

  int32_t number = kNoNumber;      ///< T
  int32_t pocket = 0;              ///< P
  double diameter = 0;             ///< D, in machine units
  int32_t orientation = 0;         ///< Q, of a lathe tool
  std::array<double, 9> offset{};  ///< X Y Z A B C U V W, in machine units
  bool has_offset = false;         ///< any of them is not 0
  uint32_t line = 0;               ///< from 1
  Span span;                       ///< from the first word to the last one
};

struct ToolTable {
  std::vector<ToolRow> rows;  ///< of each number the one that LinuxCNC finds

  /// Null if the table lacks the number.
  const ToolRow* find(int32_t number) const;
};

enum class ToolChanger : uint8_t {
  kFixed,   ///< each tool has its place
  kRandom,  ///< `[EMCIO]RANDOM_TOOLCHANGER`: tools change places, and P is the place
};

/// Any bytes are a table: lines that LinuxCNC skips are skipped.
ToolTable read_tool_table(std::string_view bytes, ToolChanger changer = ToolChanger::kFixed);

}  // namespace owlint
