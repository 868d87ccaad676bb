// How far a program goes, for the page of an audit.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "analyzer/checking/settings.h"
#include "analyzer/text/source.h"

namespace owlint::audit {

/// As extents_json(), with numbers of the page for files; null for a program that is too large for a page, or that does not move.
nlohmann::ordered_json page_extents(const std::shared_ptr<const Source>& source, Profile profile,
                                    const std::function<int(const std::string&)>& number_of);

}  // namespace owlint::audit
