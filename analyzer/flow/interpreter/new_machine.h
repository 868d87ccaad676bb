// The run on a machine that was just started, beside that on one that has run other programs: numbered parameters that no
// line has set are 0 there, and anything on the other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analyzer/flow/interpreter/evaluator.h"
#include "analyzer/program/program.h"

namespace owlint::flow {

/// The numbered parameters on whose values something depends and that a line reads before any sets them: each once. Of a sub only
/// those count that no line sets: it may be called later. None where a number to write to is computed. Source: measured with
/// rs274, which begins with 0 in all that its file of parameters does not keep; those that it keeps are not among them.
std::vector<uint32_t> read_and_not_set(const Program& program, const TrackedParameters& tracked);

/// A run begins there: `numbers` are 0.
void begin_on_new_machine(std::span<const uint32_t> numbers, Parameters& p, Evaluator& evaluator,
                          PersistentMap::Pool& pool);
/// Whether the run is still known for one that began there.
bool is_on_new_machine(const Parameters& p);

}  // namespace owlint::flow
