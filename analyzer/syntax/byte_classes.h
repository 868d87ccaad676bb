// Which bytes of a text are digits, letters, line feeds and so on, a bit for each byte: the first step of reading plain lines
// (bulk.h). The processor's vectors find them, 16 to 64 bytes at a time; without vectors they are looked at one by one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace owlint {

/// The bytes of up to kBlocks blocks. The first byte of a block is the lowest bit of its number.
struct ByteClasses {
  static constexpr size_t kBlock = 64;
  static constexpr size_t kBlocks = 64;
  /// The last one stays 0: eight bytes can be read from any place.
  using Bits = std::array<uint64_t, kBlocks + 1>;

  Bits digits{};
  Bits points{};
  Bits signs{};    ///< `+` and `-`
  Bits letters{};  ///< small ones and capitals
  Bits blanks{};   ///< spaces and tabs
  Bits returns{};  ///< carriage returns
  Bits feeds{};    ///< line feeds

  bool operator==(const ByteClasses&) const = default;
};

/// One way to find them.
struct ByteClassifier {
  const char* name;
  /// Sorts so many whole blocks; the first one becomes `classes`' block `first`.
  void (*classify)(const char* bytes, size_t blocks, size_t first, ByteClasses* classes);
  /// Finds letters, line feeds, and where comments begin, in so many whole blocks.
  void (*find_looks)(const char* bytes, size_t blocks, uint64_t* bits);
};

/// Those that this processor can run, the fastest first. The last one uses no vectors.
std::span<const ByteClassifier> byte_classifiers();

}  // namespace owlint
