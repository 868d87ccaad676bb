// The way into the flow room: analyses a program and hands out the results, file by file.
#pragma once

#include <vector>

#include "analyzer/flow/flow.h"
#include "analyzer/flow/limits.h"
#include "analyzer/machine/profile.h"
#include "analyzer/program/linker.h"

namespace owlint {

/// Runs the machine through all files of `linked`, and adds files whose names only the run knows. One result for each
/// file, in the order of `linked.files()`; statement numbers are those of the file's own program. `known`: calls from
/// earlier analyses; remember() adds those of this one. `limits`: how much is kept apart and looked at.
std::vector<FlowResult> analyze_flow(Linked& linked, const Profile& profile, Detail detail = Detail::kBySize,
                                     flow::KnownCalls* known = nullptr, const flow::Limits& limits = {});

/// Call this when you need nothing more from a result of analyze_flow() with `known`: it keeps the calls for the next
/// analysis. Returns false if you asked about lines that were not analysed: then the answers are not valid, nothing is
/// known any more, and the analysis must be made again.
bool remember(const FlowResult& result, flow::KnownCalls& known);

}  // namespace owlint
