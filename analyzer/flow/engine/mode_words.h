// Modes and their values in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analyzer/flow/engine/mode_map.h"

namespace owlint::flow {

/// `a, b and c`; `last`: "and", "or".
std::string joined(const std::vector<std::string>& words, std::string_view last);
/// The names of its values.
std::vector<std::string> values_of(const ModeThere& there);
/// `G20 or G21`; `as before the program` where nothing is known.
std::string value_text(const ModeThere& there);
/// Where it was set: `line 12`, `lines 3 and 8`, `line 2 of helper.ngc`; empty if no line has.
std::string places_of(const ModeThere& there, const Program& own);
/// A mode that only matters to few lines.
bool is_inner(Mode mode);
/// Not an inner mode that is as LinuxCNC starts, or of which nothing is known.
bool is_worth_showing(const ModeThere& there);

}  // namespace owlint::flow
