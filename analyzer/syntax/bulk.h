// The fast path of the scanner: skips lines that cannot matter to O-words, many bytes at a time, and stops at the first
// one that may. scanner.cc then reads that line. So the fast path may stop too often, but never skip a line that matters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace owlint {

/// The lines that were skipped, and where that ended.
struct Passed {
  size_t next = 0;          ///< offset of the first line that may matter, or the size of the bytes
  uint32_t lines = 0;       ///< lines before it
  uint32_t first_code = 0;  ///< the first of them that is not blank, from 1; 0: all are blank
  uint32_t last_code = 0;   ///< the last of them

  bool operator==(const Passed&) const = default;
};

/// Skips lines from the line start `from` on. A line may matter if it is longer than LinuxCNC reads, has a
/// byte other than letters without `M`, `O` and `Q`, digits, blanks, `+`, `-`, `.` and `$`, a carriage return before its
/// end, two letters side by side, or begins with a digit. Runs with the widest vectors that the processor has.
Passed pass_plain_lines(std::string_view bytes, size_t from);

/// The same, byte by byte: what the vectors are tested against.
Passed pass_plain_lines_scalar(std::string_view bytes, size_t from);

/// The same for one kind of vector instructions.
struct BulkVariant {
  std::string_view name;
  Passed (*pass)(const uint8_t* data, size_t size, size_t from);
};

/// The variants that this processor can run, best first, the scalar one last; for tests.
const std::vector<BulkVariant>& bulk_variants();
/// Uses this variant from now on; null: the best one again. Not thread-safe.
void choose_bulk_variant(const BulkVariant* variant);

}  // namespace owlint
