// The page of an audit: one HTML file that needs nothing else. The page itself is written in TypeScript (page/, bundled when
// owlint is built); here its data are put into it. What the data look like is said in page/src/data.ts.
#pragma once

#include <ostream>
#include <string>

#include "analyzer/audit/store.h"
#include "analyzer/cli/settings.h"

namespace owlint::audit {

/// Whether this owlint was built with the page, for which the build needs Node.js.
bool has_page();

/// Writes the page of a run. Programs are read from where they were; one that has changed since is shown by the lines that
/// its findings point at.
void write_page(std::ostream& out, Store& store, int64_t run, const cli::CommandLine& line);

}  // namespace owlint::audit
