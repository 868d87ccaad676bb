// Joins the stores of a job's shards, as if one machine had done all the work.
#pragma once

#include <string>
#include <vector>

#include "analyzer/audit/audit.h"
#include "analyzer/audit/store.h"

namespace owlint::audit {

/// Makes one run of `into` from the last run of each of the stores. They must be all shards of one job, made with the
/// same owlint and the same options. Throws StoreProblem and SQLite::Exception.
Outcome merge(Store& into, const std::vector<std::string>& stores);

}  // namespace owlint::audit
