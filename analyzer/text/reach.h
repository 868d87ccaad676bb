// Whether runs of a program get to a place. Said by the flow room, shown with every finding.
#pragma once

#include <cstdint>

namespace owlint {

enum class Reach : uint8_t { kNever, kMaybe, kAlways };

}  // namespace owlint
