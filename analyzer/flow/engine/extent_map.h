// How far a program goes, over all its runs.
#pragma once

#include "analyzer/flow/limits.h"
#include "analyzer/machine/profile.h"
#include "analyzer/program/linker.h"
#include "analyzer/syntax/extents.h"

namespace owlint::flow {

/// Analyses a program whose files were read with Profile::measures_extents; the files of the lines are numbered as in `linked`.
Extents extents_of(const Linked& linked, const Profile& profile, const Limits& limits = {});

}  // namespace owlint::flow
