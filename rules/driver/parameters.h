// Helpers for rules about parameters.
#pragma once

#include "analyzer/flow/summaries/data_flow.h"
#include "rules/driver/stops.h"

namespace owlint::rules {

/// `#5`, `#<name>`: as written, with backticks.
std::string parameter_words(const Program& program, flow::ParameterId parameter);
/// The sub that a line returns from, or `otherwise` if that is not known.
std::string returning_sub(const Elsewhere& line, std::string_view otherwise);
/// The position of an assignment or a word on its line.
Span item_span(const Program& program, StatementId statement, uint32_t item);
/// `o100`, or `the main program`.
std::string region_words(const Program& program, RegionId region);
/// A list of arguments by their bits: `#1`, `#1 and #3`, `#1, #2 and #5`; with backticks.
std::string argument_words(uint32_t bits);

/// Whether a value is computed with fractions: a quotient, a root, an angle, a sum or multiple of something like 0.1.
bool computes_fraction(const Program& program, ExprId value);

}  // namespace owlint::rules
