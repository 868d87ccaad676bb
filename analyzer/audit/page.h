// The page of an audit: one HTML file that needs nothing else. The page itself is written in TypeScript (page/, bundled when
// owlint is built); this adds its data. page/src/data.ts describes the form of the data.
#pragma once

#include <ostream>
#include <string>

#include "analyzer/audit/store.h"
#include "analyzer/checking/settings.h"

namespace owlint::audit {

/// Whether this owlint was built with the page, for which the build needs Node.js.
bool has_page();

/// Writes the page of a run. Programs are read from their files; if one has changed since, the page shows only the lines of
/// its findings.
void write_page(std::ostream& out, Store& store, int64_t run, const checking::CheckRequest& line);

}  // namespace owlint::audit
