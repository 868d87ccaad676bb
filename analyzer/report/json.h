// A finding in the form of owlint-report-1; see share/owlint-report-1.schema.json.
#pragma once

#include <nlohmann/json.hpp>

#include "analyzer/findings/finding.h"

namespace owlint {

nlohmann::ordered_json finding_json(const Source& source, const Finding& finding);

}  // namespace owlint
