// Lines that are the end, or the beginning, of another block or sub than they are meant to be.
#pragma once

#include "rules/driver/stops.h"

namespace owlint::rules {

/// Label, keyword and the first value of an O-word.
Span all_of_oword(const Program& program, const Statement& s);
/// Whether a line of another kind, with the label of the block, was surely meant to end it: `o1 if` … `o1 if`. Then the finding
/// about a stop at that line says so.
bool tell_wrong_end(const Program& program, StatementId id, Finding& finding);
/// The first line with `/` that was left out of the program and begins something with a label; 0 if there is none.
uint32_t deleted_opener(const Program& program, NameId label, bool (*wanted)(Keyword));
/// Says so in the finding about a call, if it is the `sub` line of what the call names.
bool tell_deleted_sub(const Program& program, StatementId call, Finding& finding);
/// The block in or around `loop` that the line ends once more, behind the end of `loop`; null if it does not.
const Block* ended_again(const Program& program, BlockId loop, StatementId id);

}  // namespace owlint::rules
