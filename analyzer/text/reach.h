// Whether runs of a program get to a line. The flow room finds out; every finding shows it.
#pragma once

#include <cstdint>

namespace owlint {

enum class Reach : uint8_t { kNever, kMaybe, kAlways };

}  // namespace owlint
