// What rules about a machine's INI share: how a finding says that LinuxCNC does not start, and fixes of lines.
#pragma once

#include <string>
#include <vector>

#include "analyzer/machine/ini_text.h"
#include "rules/driver/rule.h"

namespace owlint::rules {

/// The check of a rule that has nothing to say of programs.
void nothing_in_programs(const Input& in, Reporter& out);

/// Adds a finding in the file that the line is in.
Finding& add_at(const SetupInput& in, Reporter& out, const IniLine& line, Span span, std::string message);
Finding& add_at(const SetupInput& in, Reporter& out, const IniLine& line, std::string message);

/// LinuxCNC refuses to start, with this message.
void refuses(Finding& finding, std::string message);
/// The same, if LinuxCNC gets that far with this INI: see is_whole_machine().
void refuses_machine(const SetupInput& in, Finding& finding, std::string message);

/// Whether LinuxCNC 2.8 or 2.9 starts from this INI, rather than converting it first: `[EMC]VERSION` is 1.1. Parts of an INI, and
/// those of 2.7, have no such line; what they lack is no mistake.
bool is_whole_machine(const SetupInput& in);
/// What a `VERSION` is without the comment behind it, which LinuxCNC takes for a part of it: OW415.
std::string_view version_meant(std::string_view value);
/// The version in effect is 2.10, which reads the INI otherwise.
bool reads_strictly(const SetupInput& in);

/// The lines of a section as LinuxCNC 2.8 and 2.9 read them: of the first section of that name.
std::vector<const IniLine*> lines_of(const IniText& text, std::string_view section);
/// The line on which they find a key; null if on none, or if the key is there without a value.
const IniLine* find_line(const IniText& text, std::string_view section, std::string_view key);

/// Where a comment begins that became part of a value: a `#` or `;` behind a blank. npos if there is none.
size_t comment_in(std::string_view value);
/// Puts the comment behind a value onto a line of its own, above.
Fix comment_above(const IniText& text, const IniLine& line, size_t comment);
/// Writes another value.
Fix write_value(const IniLine& line, std::string value, bool safe);

}  // namespace owlint::rules
