// Helpers for rules about blocks and labels.
#pragma once


#include "rules/stops.h"

namespace owlint::rules {

/// Whether a line with this label carries an unknown keyword: then it may be the part of the block that is missing.
bool has_unreadable_line(const Input& in, NameId label, RegionId region);

/// Whether two statements stand in different branches of one `if`, so that no single pass meets both.
bool in_exclusive_branches(const Program& program, StatementId a, StatementId b);

/// Reports OW102, OW103 or OW104: an opener of kind `keyword` whose label is taken.
void check_label_reused(const Input& in, Reporter& out, Keyword keyword);

/// The fix that gives the block opened at `opener` a free label, on all its lines; no fix when there is none.
void add_relabel_fix(const Input& in, StatementId opener, Finding& finding);

/// `a while`, `an if`.
std::string with_article(Keyword keyword);

/// Reports the parts or ends for which `wanted(keyword)` holds and whose label has no fitting block: stops first,
/// then those that no run meets. `describe` gives the words for an undefined label.
void check_parts(const Input& in, Reporter& out, bool (*wanted)(Keyword), std::string_view openers);

}  // namespace owlint::rules
