#include "rules/driver/remap_rules.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "rules/driver/words.h"

namespace owlint::rules {
namespace {

constexpr std::array kMotion{0,   10,  20,  30,  50,  51,  52,  53,  330, 331, 382, 383, 384, 385, 700, 710, 711, 712,
                             720, 721, 722, 730, 740, 750, 760, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890};

/// The group in which a code is the built-in one inside its own sub.
constexpr std::array<std::pair<int, int>, 12> kInside{
    {{0, 4}, {1, 4}, {60, 4}, {6, 6}, {61, 6}, {62, 5}, {63, 5}, {64, 5}, {65, 5}, {66, 5}, {67, 5}, {68, 5}}};

}  // namespace

bool is_built_in_motion(int code) { return std::ranges::find(kMotion, code) != kMotion.end(); }

bool is_built_in_inside(int code, int group) {
  return std::ranges::find(kInside, std::pair(code, group)) != kInside.end();
}

std::string help_for_own_code(int code) {
  const auto own = std::ranges::find(kInside, code, &std::pair<int, int>::first);
  if (own == kInside.end()) return "use another code in the sub";
  return "write `modalgroup=" + std::to_string(own->second) + "` and the code as `M" + std::to_string(code) +
      "`: then the sub uses the built-in one";
}

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

std::vector<LostRemap> lost_codes(const Profile& profile) {
  std::vector<LostRemap> lost;
  if (profile.setup == nullptr) return lost;
  const IniText& text = profile.setup->text;
  for (const Remap& remap : remaps_of(text)) {
    const std::optional<LostCode> code = lost_code(text.value(*remap.line), release_of(profile));
    if (!code || remap.earlier != nullptr) continue;
    constexpr std::array kCrashes{3, 4, 7, 30, 48, 50, 73};
    const bool crashes = code->letter == 'm' && code->group == MGroup::kUser &&
        std::ranges::find(kCrashes, code->number) != kCrashes.end();
    lost.push_back({remap.line, *code, code->letter == 'g' ? g_name(code->number) : m_name(code->number), crashes});
  }
  return lost;
}

void blame(const Profile& profile, const LostRemap& lost, Finding& f) {
  f.help = "remove the `REMAP` line from the INI, or let it name a code that is free, such as " +
      std::string(lost.code.letter == 'g' ? "`G88.1`" : "`M400`");
  f.related.push_back({lost.line->span, "this line", profile.setup->text.source(*lost.line)});
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
