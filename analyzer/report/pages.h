// A rule's documentation as a Markdown page: installed with the program, shown by editors.
#pragma once

#include <string>

#include "rules/driver/rule.h"

namespace owlint {

std::string rule_page(const Rule& rule);

/// The rules by group, each with a link to its page.
std::string rule_index();

/// Writes one page for each rule, `OW104.md`, and the index `README.md` into a folder, which is made if needed. Returns
/// false and a message on failure.
bool write_rule_pages(const std::string& folder, std::string* error);

/// Where the page of a rule is installed with this program; empty if it is not.
std::string installed_rule_page(std::string_view code);

}  // namespace owlint
