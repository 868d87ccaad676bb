// OW413 ini-section-twice: a second section of one name, with keys that LinuxCNC does not find.
// Depends on: LinuxCNC 2.8 and 2.9 read only the first section of a name; 2.10 joins them (measured).
#include <algorithm>
#include <set>

#include "rules/driver/machine_rules.h"

namespace owlint::rules::ow413 {
namespace {

std::string list(const std::vector<std::string>& names) {
  constexpr size_t kNamed = 4;
  std::string out;
  for (size_t i = 0; i < std::min(names.size(), kNamed); ++i) out += (i == 0 ? "`" : ", `") + names[i] + "`";
  if (names.size() > kNamed) out += " and " + std::to_string(names.size() - kNamed) + " more";
  return out;
}

void check_setup(const SetupInput& in, Reporter& out) {
  if (reads_strictly(in)) return;
  const IniText& text = in.setup.text;
  const auto& sections = text.sections();
  for (size_t i = 0; i < sections.size(); ++i) {
    if (sections[i].first) continue;
    const IniLine& line = text.lines()[sections[i].line];
    std::set<std::pair<std::string_view, std::string_view>> known;  // keys and values of the first
    for (const IniLine* key : lines_of(text, sections[i].name)) known.emplace(text.name(*key), text.value(*key));
    std::vector<std::string> lost;
    std::set<std::string_view> seen;
    for (size_t at = sections[i].line + 1; at < text.lines().size(); ++at) {
      const IniLine& key = text.lines()[at];
      if (key.section != static_cast<int32_t>(i) || key.kind == IniLine::Kind::kOpenSection) break;
      if (key.kind == IniLine::Kind::kKey && !known.contains({text.name(key), text.value(key)}) &&
          seen.insert(text.name(key)).second)
        lost.emplace_back(text.name(key));
    }
    if (lost.empty()) continue;
    const IniText::Section* first = text.find_section(sections[i].name);
    const IniLine& earlier = text.lines()[first->line];
    const uint32_t number = earlier.number;
    const bool same_file = text.source(earlier) == text.source(line);
    Finding& f = add_at(in, out, line,
                        "`[" + sections[i].name + "]` is there already, " +
                            (same_file ? "on line " + std::to_string(number) : "in another file") +
                            ": LinuxCNC reads only the first one and does not find " + list(lost));
    f.help = "move the keys into the first `[" + sections[i].name + "]`";
    f.related.push_back({earlier.span, "the section that is read", same_file ? nullptr : text.source(earlier)});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW413",
    .name = "ini-section-twice",
    .summary = "a second section of one name in the INI, of which LinuxCNC reads only the first",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A section that the INI has already further up, or in an included file, with keys in it.)",
            .why = R"(To find a key, LinuxCNC looks for the first section of that name and reads to the next line that
begins with `[`. It never looks at a second one, and gives no message: the keys there have no effect.
The check before the start joins both, so that it does not complain either. LinuxCNC 2.10 joins them,
too.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
OWORD_NARGS = 1
[TRAJ]
LINEAR_UNITS = mm
[RS274NGC]
RETAIN_G43 = 1
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
OWORD_NARGS = 1
RETAIN_G43 = 1
[TRAJ]
LINEAR_UNITS = mm
)",
            .fix = R"(Move the keys into the first section of that name.)",
            .level_reason = "Warning: LinuxCNC starts, without the keys of the second section.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow413
