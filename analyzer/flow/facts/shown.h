// Parameters in comments that LinuxCNC shows: `(debug, size #<size>)`.
#pragma once

#include <string>
#include <vector>

#include "analyzer/flow/facts/accesses.h"

namespace owlint::flow {

struct Shown {
  Span span;                         ///< `#5`, `#<name>`
  std::string local;                 ///< the name, if it is one without `_`
  ParameterKey key = kComputedKey;   ///< kComputedKey: a name that only comments have
  StatementId above = kNoStatement;  ///< the last statement above the comment, or on its line
  RegionId region = kMainRegion;
  bool acts = false;  ///< false: LinuxCNC shows the text as it is, whatever its author thinks
};

/// What `(debug, …)`, `(print, …)`, `(log, …)`, `(abort, …)` and `(msg, …)` read, in the order of the file.
std::vector<Shown> shown_in_comments(const Program& program);

/// The same as reads of statements: what a comment shows has the value that the next line of its sub finds.
std::vector<ShownRead> reads_of(const Program& program, const std::vector<Shown>& shown);

}  // namespace owlint::flow
