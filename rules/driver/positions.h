// What the rules about positions have in common (OW9xx, OW808): numbers as messages show them, the line from which a machine
// comes, and what to say where another machine may stand elsewhere.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rules/driver/modes.h"

namespace owlint::rules {

/// Four decimals at most, without zeros behind them: `5`, `0.0283`.
std::string number_text(double value, int decimals = 4);
/// How many decimals two numbers need to look different; four at least.
int telling_decimals(double a, double b);
/// `5 mm`, `0.5 inch`, `2 inches`.
std::string length(double value, bool inch, int decimals = 4);

/// Says that it is so from where a machine stands that was just started, if that is all that is known.
void note_start(const FlowStop& stop, Finding& finding);
/// The same of any stop.
void add_start(Finding& finding);

/// Adds the line that has set G91, if that is in effect; true then.
bool relate_distance(const Input& in, const FlowStop& stop, Finding& finding);

/// The words with these letters of the nearest line above that has any, if each run comes down from there.
std::optional<Span> words_above(const Input& in, StatementId statement, std::string_view letters);

}  // namespace owlint::rules
