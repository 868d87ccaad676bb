// What the command line said of a run, as text for the store; merging takes it for comparing parts of one job.
#pragma once

#include <string>

#include "analyzer/cli/settings.h"

namespace owlint::audit {

/// A JSON object with what was given, and nothing else.
std::string options_text(const cli::CommandLine& line);

}  // namespace owlint::audit
