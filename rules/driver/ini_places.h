// Lines of the machine's INI that findings about programs name.
#pragma once

#include <string>

#include "rules/driver/stops.h"

namespace owlint::rules {

/// Adds the place of a value in the INI.
void relate_ini(Finding& finding, const Ini::Entry& entry, std::string message);

/// The `REMAP` line of a code, by its letter (small) and number; G codes in tenths, T, S and F with 0. Null if the INI has none.
const Ini::Entry* remap_entry(const Profile& profile, char letter, int number);
/// The same of a line that runs a remap (LineKind::kRemap).
const Ini::Entry* remap_entry(const Input& in, StatementId remap);

/// The same for a code that is there, but on a line that LinuxCNC does not read: names that line.
void relate_unread_remap(const Profile& profile, char letter, int number, Finding& finding);

/// A code that lacks what its built-in meaning needs, where a `REMAP` of the INI wants to replace that meaning and cannot: names
/// that line, which is the mistake.
void relate_unused_remap(const Input& in, const FlowStop& stop, Finding& finding);

/// An entry that a program reads as `#<_ini[section]key>` and LinuxCNC does not find: names the line that was meant, if there is
/// one, and why it does not count. Section and key in any case. False if there is none.
bool relate_unread_entry(const Profile& profile, std::string_view section, std::string_view key, Finding& finding);

/// A name that is read and that the INI could give: an entry of its own where it hides them, `#<n_args>`, or `#<p>` in the sub of
/// a `REMAP` line that passes no P, or one that may be left out. Names that line and says what to write. False for other names.
bool relate_given_name(const Profile& profile, std::string_view sub, std::string_view name, Finding& finding);

/// Where the INI says in which folders called files are, for findings about files that are not found: the line that is read, or
/// lines with `SUBROUTINE_PATH` that are not.
std::vector<Related> search_path_places(const Profile& profile);
/// Folders of `SUBROUTINE_PATH` behind the tenth that exists, and of `USER_M_PATH` behind the fifth: LinuxCNC uses none of them
/// (measured).
std::vector<const IniFolder*> unused_folders(const MachineSetup& setup);
/// Those in which LinuxCNC looks for user M codes.
std::vector<const IniFolder*> user_code_folders(const MachineSetup& setup);
/// Names them in a finding.
void relate_user_folders(const Profile& profile, Finding& finding);

}  // namespace owlint::rules
