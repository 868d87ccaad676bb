// A sub's summary in words and as JSON, for the graph and the editor.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "analyzer/flow/summaries/data_flow.h"
#include "analyzer/flow/summaries/mode_summary.h"

namespace owlint {

/// `reads #1, #2; writes #<_result>; returns a value on every path`. Empty if nothing is known.
std::string summary_text(const Program& program, const flow::Summary& summary);
/// Null if nothing is known.
nlohmann::ordered_json summary_json(const Program& program, const flow::Summary& summary);
/// What the own lines of a sub need of the modes, which ones they change, and which values they leave.
nlohmann::ordered_json modes_json(const Program& program, RegionId region);

}  // namespace owlint
