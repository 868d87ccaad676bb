// The domain of the flags that the interpreter keeps besides its label table: for each, the set of its possible values.
#pragma once

#include <cstdint>

namespace owlint::flow {

/// One bit for each possible value of a flag.
enum FlagSet : uint8_t {
  kNo = 1,
  kYes = 2,    // for breaking and continuing: set by the kind of loop that clears it
  kStale = 4,  // set by the other kind of loop, and not cleared
};

/// Sets of FlagSet's bits. A join is the union of the sets: commutative, associative and idempotent. There are few sets, so
/// chains come to rest without widening.
struct Flags {
  uint8_t executed = kNo;  ///< "a branch has been taken"
  uint8_t breaking = kNo;
  uint8_t continuing = kNo;
  uint8_t returned = kNo;  ///< level 0: a call has come back since the last definition

  bool operator==(const Flags&) const = default;
  /// All sets as one number; equal flags have equal ones, and no others have.
  uint32_t hash() const {
    return static_cast<uint32_t>(executed) | static_cast<uint32_t>(breaking) << 8 |
        static_cast<uint32_t>(continuing) << 16 | static_cast<uint32_t>(returned) << 24;
  }
};

inline Flags join(const Flags& a, const Flags& b) {
  Flags out = a;
  out.executed |= b.executed;
  out.breaking |= b.breaking;
  out.continuing |= b.continuing;
  out.returned |= b.returned;
  return out;
}

}  // namespace owlint::flow
