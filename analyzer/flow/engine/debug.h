// The fixpoint to watch: what the states at each line are, and why some were joined. For those who work on the analysis.
#pragma once

#include <ostream>

#include "analyzer/flow/limits.h"
#include "analyzer/machine/profile.h"
#include "analyzer/program/linker.h"

namespace owlint::flow {

/// Analyses a program and writes its lines, each with the states that were executed there in the order of their steps.
void write_states(std::ostream& out, const Linked& linked, const Profile& profile, const Limits& limits);

}  // namespace owlint::flow
