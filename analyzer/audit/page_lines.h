// The lines of programs that the page shows. As JSON: stretches of lines, each with the number of its first line (from 1) and
// the texts.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "analyzer/findings/finding.h"
#include "analyzer/program/program.h"

namespace owlint::audit {

/// All lines of a short program; of a long one those with O-words and parameters and what is around findings. CAM programs
/// are millions of lines of motion.
nlohmann::ordered_json shown_lines(const Program& program, const std::vector<Finding>& findings);

/// The lines that an excerpt of a program has kept: those with findings.
nlohmann::ordered_json kept_lines(const Source& source, const std::vector<Finding>& findings);

}  // namespace owlint::audit
