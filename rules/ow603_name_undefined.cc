// OW603 name-undefined: a named parameter that is read where some path has not assigned it.
// Rests on: reading an unassigned name stops the run; `#<name>` is local to the sub that runs,
// `#<_name>` is global.
#include <optional>

#include "analyzer/machine/predefined.h"
#include "rules/stops.h"

namespace owlint::rules {
namespace {

/// The comment lines that a program begins with, in small letters and without blanks.
std::string leading_comment(const Source& source) {
  constexpr uint64_t kMost = 16'384;  // bytes
  const std::string_view text = source.bytes().substr(0, kMost);
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    std::string line;
    for (const char c : text.substr(at, end - at)) {
      if (c != ' ' && c != '\t' && c != '\r') line += c;
    }
    if (!line.empty() && line[0] != '(' && line[0] != ';' && line[0] != '%') break;
    out += small_letters(line);
    at = end + 1;
  }
  return out;
}

/// What is said of `#<_ini[section]entry>`, which the machine's INI does not have.
void tell_entry(const Profile& profile, const std::string& name, Finding& f) {
  f.message = name + " is read here, but " + (profile.setup->reads_ini ? "the machine's INI has no number for it" : "`INI_VARS = 0` in the machine's INI hides its entries");
  if (!profile.setup->reads_ini) return;
  f.help = "LinuxCNC looks for section and entry in capital letters, and takes nothing but a decimal number: no unit, no comment behind it; `EXISTS[#<…>]` asks first";
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::optional<std::string> documented;
  for_stops(in, out, [&](const FlowStop& s) -> Finding* {
    // A global that the program says it needs comes from outside.
    if (!documented) documented = leading_comment(*p.source);
    if (s.detail.starts_with("_") && documented->find("#<" + s.detail + ">") != std::string::npos) return nullptr;
    const Statement& line = p.at(s.statement);
    const std::string name = "`#<" + s.detail + ">`";
    const bool some = s.reach != Reach::kAlways;
    Finding& f = out.add(line.whole(), name + (some ? " is read here, but not assigned on every path" : " is read here, but not assigned before"));
    f.help = "assign " + name + " first; a name without `_` belongs to the sub in which it is assigned";
    if (const auto since = predefined_since(s.detail)) {
      const std::string version(version_text(in.profile.version));
      f.message = name + " is read here, but " + (*since > in.profile.version ? "LinuxCNC " + version + " does not have it; it came with " + std::string(version_text(*since)) : "not every release of LinuxCNC " + version + " has it");
      f.help = "do without it, ask with `EXISTS[" + name.substr(1, name.size() - 2) + "]` first, or say which version the machine has (`--linuxcnc`)";
    } else if (s.detail.starts_with("_ini[") && in.profile.setup != nullptr) {
      tell_entry(in.profile, name, f);
    }
    return &f;
  });
}

}  // namespace

extern const Rule kOw603{
    .code = "OW603",
    .name = "name-undefined",
    .summary = "`#<name>` is read where some path has not assigned it",
    .group = Group::kDataFlow,
    .level = Severity::kError,
    .page = {
        .what = R"(A `#<name>` that is read although no line has given it a value on the way there: a typing error in
the name, an assignment that stands only in one branch, or a name that belongs to the caller or to
the called sub.)",
        .why = R"(The interpreter stops at the line that reads the name, on the run that gets there without an
assignment. Unlike numbers, which read 0, names have no value until they get one. `#<name>` belongs
to the sub that is running: the main program's `#<depth>` does not exist inside a sub, nor the sub's
outside. `#<_name>` with an underscore is shared by all. Skipped lines are not looked at, and
`EXISTS[#<name>]` may ask. A global name that the comment at the top of the program speaks of is taken to be
there.

`#<_ini[section]entry>` is an entry of the machine's INI, which owlint looks up where it knows the INI;
`#<_hal[pin]>` is taken to be there. A name that only some releases of the version have gets a warning.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  #<top> = #5063
o100 endif
G0 Z[#<top> + 5]
M2
)",
        .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
#<top> = 0
o100 if [#5070 EQ 1]
  #<top> = #5063
o100 endif
G0 Z[#<top> + 5]
M2
)",
        .fix = R"(Assign the name before the branch, pass it to the sub as an argument, or use a global name with an
underscore.)",
        .interpreter = "Named parameter #<top> not defined",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
