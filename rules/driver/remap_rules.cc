#include "rules/driver/remap_rules.h"

#include <map>

namespace owlint::rules {

std::vector<Remap> remaps_of(const IniText& text) {
  std::vector<Remap> out;
  std::map<std::string, const IniLine*> known;  // by code, in lower case
  for (const IniLine* line : lines_of(text, "RS274NGC")) {
    if (text.name(*line) != "REMAP") continue;
    if (line->value.begin == line->value.end) break;
    if (line->continued) continue;
    constexpr size_t kMost = 1000;  // a machine has a few dozen
    if (out.size() == kMost) break;
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

std::string remap_file(const MachineSetup& setup, std::string_view ngc) {
  if (const auto found = setup.search_path->find(ngc)) return found->path;
  const auto found = setup.search_path->find(small_letters(ngc));
  return found ? found->path : std::string();
}

}  // namespace owlint::rules
