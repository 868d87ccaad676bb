// What the rules about hazards of modes have in common (OW851 to OW855): the lines that a hazard names, and what a move is under
// each value of a mode.
#pragma once

#include <string>
#include <string_view>

#include "rules/driver/modes.h"

namespace owlint::rules {

/// `G91`: the value as a code; empty for a value that no code sets.
std::string code_of_value(Mode mode, uint8_t value);
/// The codes that set the mode, as names for find_word().
std::string codes_of_mode(Mode mode);
/// What a move is where a value is in effect, behind `this move `: `is incremental`. Empty for modes that change none.
std::string move_under(Mode mode, uint8_t value);

/// Whether a file asks which value is in effect, by a predefined parameter such as `#<_absolute>`, as one does to set it back.
bool asks_for_mode(const Program& program, Mode mode);

/// The word of a line that `names` means; all words of the line where there is none.
Span word_of_line(const Program& program, uint32_t line, std::string_view names);
/// Adds a line of this file or another one to a finding, at the word that `names` means.
void relate_line(const Input& in, Finding& finding, const Program& program, uint32_t line, std::string_view names,
                 std::string message);
/// Adds the line that sets the mode of a hazard to `value`: "`G91` is set here".
void relate_mode(const Input& in, Finding& finding, const Hazard& hazard, uint8_t value);

}  // namespace owlint::rules
