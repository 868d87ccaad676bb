// The modes in effect along the lines that the page shows of a program; `owlint modes` prints the same. See `Modes` in
// page/src/data.ts.
#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "analyzer/flow/engine/mode_map.h"

namespace owlint::audit {

/// `source`: the stretches of lines that are shown, as shown_lines() gives them. `number` is the page's number of a file, -1 for
/// one that is not in it.
nlohmann::ordered_json modes_json(const Linked& linked, const Profile& profile, const nlohmann::ordered_json& source,
                                  const std::function<int(const std::string& path)>& number);

}  // namespace owlint::audit
