// The fast path of the scanner: passes over the lines of a program that cannot matter to O-words, many bytes at a time,
// and stops at the first one that may. What it lets through is looked at line by line (scanner.cc), so it may let
// through too much, never too little.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace owlint {

/// Lines passed over, and where that ended.
struct Passed {
  size_t next = 0;          ///< offset of the first line that may matter, or the size of the bytes
  uint32_t lines = 0;       ///< lines before it
  uint32_t first_code = 0;  ///< the first of them that is not blank, from 1; 0: all are blank
  uint32_t last_code = 0;   ///< the last of them

  bool operator==(const Passed&) const = default;
};

/// Passes over lines from the line start `from` on. A line may matter when it is longer than LinuxCNC reads, has a
/// byte other than letters without `M` and `O`, digits, blanks, `+`, `-`, `.` and `$`, a carriage return before its
/// end, or begins with a digit or two letters. Runs with the widest vectors that the processor has.
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
/// From now on this one is used; null: the best again. Not for several threads at a time.
void choose_bulk_variant(const BulkVariant* variant);

}  // namespace owlint
