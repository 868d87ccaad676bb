// The command line of a run as text for the store; `merge` uses it to compare the parts of a job.
#pragma once

#include <string>

#include "analyzer/checking/settings.h"

namespace owlint::audit {

/// A JSON object with only the given options.
std::string options_text(const checking::CheckRequest& line);

}  // namespace owlint::audit
