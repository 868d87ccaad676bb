#include "rules/driver/remap_rules.h"

#include <algorithm>
#include <map>

namespace owlint::rules {

std::vector<Remap> remaps_of(const IniText& text) {
  std::vector<Remap> out;
  std::map<std::string, const IniLine*> known;  // by code, in lower case
  for (const IniLine* line : lines_of(text, "RS274NGC")) {
    if (text.name(*line) != "REMAP") continue;
    if (line->value.begin == line->value.end) break;
    if (line->continued) continue;
    Remap remap{line, read_remap(text.value(*line), line->number), nullptr};
    const auto [entry, added] = known.try_emplace(small_letters(remap.read.code), line);
    if (!added) remap.earlier = entry->second;
    out.push_back(std::move(remap));
  }
  return out;
}

Span span_in(const IniText& text, const IniLine& line, std::string_view part) {
  const auto begin = static_cast<uint64_t>(part.data() - text.source(line)->bytes().data());
  return {begin, begin + part.size()};
}

bool knows_search_path(const MachineSetup& setup) {
  return std::ranges::all_of(setup.folders, [](const IniFolder& folder) {
    return folder.exists || (folder.key != "SUBROUTINE_PATH" && folder.key != "PROGRAM_PREFIX");
  });
}

std::string remap_file(const MachineSetup& setup, std::string_view ngc) {
  if (const auto found = setup.search_path->find(ngc)) return found->path;
  const auto found = setup.search_path->find(small_letters(ngc));
  return found ? found->path : std::string();
}

}  // namespace owlint::rules
