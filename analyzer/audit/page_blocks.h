// What the page draws of a program: its subs, the blocks in them and what they call.
#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "analyzer/program/linker.h"

namespace owlint::audit {

/// `number` is the page's number of a file, -1 for one that is not in it. See `Blocks` in page/src/data.ts.
nlohmann::ordered_json blocks_json(const Linked& linked, const std::function<int(const std::string& path)>& number);

}  // namespace owlint::audit
