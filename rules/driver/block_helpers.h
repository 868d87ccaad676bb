// Helpers for rules about blocks and labels.
#pragma once

#include "rules/driver/stops.h"

namespace owlint::rules {

/// Whether a line with this label has an unknown keyword: then it may be the missing part of the block.
bool has_unreadable_line(const Input& in, NameId label, RegionId region);

/// Whether the line belongs to a block whose first line LinuxCNC cannot read: the finding about that line speaks for it.
bool has_misread_opener(const Input& in, StatementId id);

/// Whether two statements are in different branches of one `if`, so that no single pass executes both.
bool in_exclusive_branches(const Program& program, StatementId a, StatementId b);

/// Whether they are in different branches of one `if` whose conditions the machine decides on, once for all runs.
bool divided_by_machine(const Program& program, StatementId a, StatementId b);

/// Reports OW102, OW103 or OW104: the first line of a block, with `keyword`, whose label is already used.
void check_label_reused(const Input& in, Reporter& out, Keyword keyword);

/// The fix that gives the block at `opener` a free label, on all its lines; no fix if there is no free label.
void add_relabel_fix(const Input& in, StatementId opener, Finding& finding);

/// Whether a run goes round for ever because this second end of a loop goes back to it.
bool loops_again(const Input& in, StatementId id);

/// Whether an O-word without a keyword was surely meant to end the innermost open block, whose label it has.
bool is_forgotten_end(const Program& program, StatementId id);
/// Says so in the finding about a stop at that line.
void tell_forgotten_end(const Program& program, StatementId id, Finding& finding);

/// `a while`, `an if`.
std::string with_article(Keyword keyword);

/// Reports parts and ends of blocks for which `wanted(keyword)` is true and whose label has no matching block: first the
/// stops, then those that no run reaches. `openers` names the keywords that should have the label.
void check_parts(const Input& in, Reporter& out, bool (*wanted)(Keyword), std::string_view openers);

}  // namespace owlint::rules
