// One mistake, one finding: what a mistake in a block's labels leads to further down is no finding of its own.
#pragma once

#include "rules/driver/rule.h"

namespace owlint::rules {

/// Whether every run of the report's own file stops at the finding.
bool stops_every_run(const Finding& f);

/// Moves findings about parts of blocks into the consequences of the finding that speaks of their mistake: those that no run
/// reaches and that have the label of another finding, and a block that is not closed because its end has a wrong label. The
/// same for what no run reaches in a program for another controller, and what else its marked line has; and for mistakes in one
/// stretch of lines that every run leaves out: the first of them speaks for all. The mistake at which every run stops, made
/// again further down, is one as well.
void fold_consequences(const Program& program, const FlowResult& flow, std::vector<Finding>& findings);

/// Moves findings about the parts and the end of a block whose first line LinuxCNC does not read into the one about that line,
/// where the same is wrong with them or they are right but for it.
void fold_ends(const Program& program, std::vector<Finding>& findings);

}  // namespace owlint::rules
