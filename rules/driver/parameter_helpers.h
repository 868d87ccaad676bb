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
/// Where a line reads a parameter, `#5` or `#<name>`, a name in small letters and without blanks; the whole line where that is
/// computed.
Span read_span(const Program& program, StatementId statement, std::string_view parameter);
/// Where a line asks whether there is a name, with `EXISTS`; empty if it does not.
Span asked_span(const Program& program, StatementId statement, std::string_view name);
/// `o100`, or `the main program`.
std::string region_words(const Program& program, RegionId region);
/// A list of arguments by their bits: `#1`, `#1 and #3`, `#1, #2 and #5`; with backticks.
std::string argument_words(uint32_t bits);

/// Another name that was probably meant by one that has no value: one that the same lines assign, one that is global, or one that
/// is predefined.
struct NearName {
  std::string name;                     ///< empty: there is none
  StatementId assigned = kNoStatement;  ///< the first line that assigns it, if any does
};
NearName near_name(const Input& in, const std::string& name, RegionId reader);

/// Of a stop on a machine that was just started alone: says where that one stands, or which numbers nothing has set.
void tell_new_machine(const Input& in, const FlowStop& stop, Finding& finding);

/// Whether the lines of a sub are those that a call from elsewhere enters.
bool enters_from_outside(const Program& program, RegionId region);
/// Whether some run is in the lines of a region.
bool reached(const Input& in, RegionId region);

/// The first call of a sub after which its caller reads a name that both have for themselves; null if there is none.
const Call* call_before_reading(const Input& in, RegionId region, NameId name);

/// Whether a value is computed with fractions: a quotient, a root, an angle, a sum or multiple of something like 0.1.
bool computes_fraction(const Program& program, ExprId value);

/// The parameter that an argument is, if it is only that.
std::optional<flow::ParameterKey> passed_parameter(const Program& program, ExprId argument);

/// The comment lines that a program begins with, in small letters and without blanks.
std::string leading_comment(const Source& source);

}  // namespace owlint::rules
