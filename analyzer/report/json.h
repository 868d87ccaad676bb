// A finding as owlint-report-1 has it; see share/owlint-report-1.schema.json.
#pragma once

#include <nlohmann/json.hpp>

#include "analyzer/findings/finding.h"

namespace owlint {

nlohmann::ordered_json finding_json(const Source& source, const Finding& finding);

}  // namespace owlint
