// What a machine's INI names of programs: subs that remaps, buttons and GUIs call, and parameters in its code.
#pragma once

#include <string>

#include "analyzer/lsp/workspace.h"
#include "analyzer/machine/setup.h"

namespace owlint::lsp {

/// The entry that names the sub, or a file of that name; null if there is none.
const Ini::Entry* ini_use_of_sub(const Ini& ini, const std::string& name);
/// Where INIs of the workspace name the sub that a document defines, as locations.
Json ini_places_of_sub(Workspace& workspace, const Document& document, const std::string& name);
/// The entry whose code names the parameter, `<_depth>` or `100`; null if there is none.
const Ini::Entry* ini_use_of_parameter(const Ini& ini, const std::string& name);
/// The same for a remap's own sub.
bool is_remap(const Ini& ini, const std::string& name);

/// The line (from 1) of the machine's PARAMETER_FILE that keeps a number from one run to the next; 0 if none does. `path`
/// is set to the file.
uint32_t line_of_kept_number(const MachineSetup& machine, const std::string& number, std::string* path);

/// `MACRO` on line 12 of machine.ini.
std::string text_of(const Ini::Entry& entry);

}  // namespace owlint::lsp
