// What identifies things in the store: bytes, this owlint, settings.
#pragma once

#include <string>
#include <string_view>

#include "analyzer/checking/settings.h"

namespace owlint::audit {

/// XXH3, 128 bits, as 32 hexadecimal digits.
std::string hash_of(std::string_view bytes);

/// Of the running program: another build may have other findings.
const std::string& tool_hash();

/// Of everything besides programs that the findings depend on: the tool, the machine's INI, the options.
std::string settings_hash(const checking::Settings& settings);

}  // namespace owlint::audit
