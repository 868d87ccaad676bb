// What a step along a path comes to: nothing, or an error of the interpreter.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace owlint {

enum class PathFault : uint8_t {
  kNone,
  kEntryTooShort,   // the first move is not longer than the tool radius
  kGouge,           // the tool does not fit into a corner or an arc
  kZeroRadius,      // an arc whose center is its start or its end
  kRadiiDiffer,     // an arc whose start and end are not equally far from its center
  kRadiusTooSmall,  // `R` that does not reach the end point
  kSamePoint,       // an arc with `R` that ends where it starts
  kNotStraight,     // a thread where only G0 and G1 are followed
  kBug,             // what the interpreter calls a bug of its own
};

struct PathStep {
  PathFault fault = PathFault::kNone;
  bool undecided = false;  ///< so close to a tie that rounding decides between a stop and none
  std::string message{};   ///< the interpreter's, if there is a fault

  bool stops() const { return fault != PathFault::kNone; }
  /// False, so that a function can leave with it.
  bool stop(PathFault kind, std::string text) {
    fault = kind;
    message = std::move(text);
    return false;
  }
};

/// A text as the interpreter prints it: with its own formats, and no longer than it can be there.
template <typename... Values>
std::string printed(const char* format, Values... values) {
  std::array<char, 255> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// Comparisons closer than this are undecided.
inline constexpr double kTie = 1e-9;

}  // namespace owlint
