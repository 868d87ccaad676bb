// What a byte can be to the fast path, as one bit each; a byte without a bit makes its line matter.
#pragma once

#include <array>
#include <cstdint>

namespace owlint::bulk {

enum Bit : uint8_t {
  kTab = 1,
  kSpace = 2,
  kFeed = 4,
  kDigit = 8,
  kLetterLow = 16,   // a to n but m: the upper half of the byte is 4 or 6
  kLetterHigh = 32,  // p to z but q: 5 or 7
  kSign = 64,        // $ + - .
  kReturn = 128,
};
inline constexpr uint8_t kBlank = kTab | kSpace | kReturn;
inline constexpr uint8_t kLetter = kLetterLow | kLetterHigh;

// A byte has the bits that both its halves allow, so that two table lookups classify it.
inline constexpr std::array<uint8_t, 16> kUpperHalf = {
    kTab | kFeed | kReturn, 0, kSpace | kSign, kDigit, kLetterLow, kLetterHigh, kLetterLow, kLetterHigh};

constexpr std::array<uint8_t, 16> make_lower_half() {
  std::array<uint8_t, 16> bits{};
  bits[0x9] |= kTab;
  bits[0x0] |= kSpace;
  bits[0xA] |= kFeed;
  bits[0xD] |= kReturn;
  for (int digit = 0; digit <= 9; ++digit) bits[digit] |= kDigit;
  for (int letter = 0x1; letter <= 0xE; ++letter) bits[letter] |= letter == 0xD ? 0 : kLetterLow;
  for (int letter = 0x0; letter <= 0xA; ++letter) bits[letter] |= letter == 0x1 ? 0 : kLetterHigh;
  for (const int sign : {0x4, 0xB, 0xD, 0xE}) bits[sign] |= kSign;
  return bits;
}
inline constexpr std::array<uint8_t, 16> kLowerHalf = make_lower_half();

constexpr uint8_t bits_of(uint8_t byte) { return kUpperHalf[byte >> 4] & kLowerHalf[byte & 15]; }

}  // namespace owlint::bulk
