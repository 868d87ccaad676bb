#include "analyzer/machine/remap_names.h"

#include <algorithm>
#include <array>

#include "analyzer/machine/setup.h"
#include "analyzer/text/source.h"

namespace owlint {
namespace {

/// What the prologs that come with LinuxCNC set, besides letters.
constexpr std::array<std::string_view, 10> kOfPrologs{"current_pocket",  "feed",          "motion_code", "pocket",
                                                      "selected_pocket", "selected_tool", "speed",       "tool",
                                                      "tool_in_spindle", "wear"};

bool of_prolog(std::string_view name) { return std::ranges::find(kOfPrologs, name) != kOfPrologs.end(); }
bool is_letter(std::string_view name) { return name.size() == 1 && name[0] >= 'a' && name[0] <= 'z'; }

}  // namespace

std::string_view remap_option(std::string_view remap, std::string_view option) {
  for (size_t at = remap.find(option); at != std::string_view::npos; at = remap.find(option, at + 1)) {
    if (at > 0 && remap[at - 1] != ' ' && remap[at - 1] != '\t') continue;
    const std::string_view value = remap.substr(at + option.size());
    return value.substr(0, value.find_first_of(" \t"));
  }
  return {};
}

bool remap_gives(std::string_view name, std::string_view sub, const Profile& profile) {
  const MachineSetup* setup = profile.setup.get();
  if (name == "n_args") return setup == nullptr || setup->counts_arguments;
  if (setup == nullptr) return is_letter(name) || of_prolog(name);
  bool remapped = false;
  const bool by_line = std::ranges::any_of(setup->ini.all("RS274NGC", "REMAP"), [&](const Ini::Entry* remap) {
    if (small_letters(remap_option(remap->value, "ngc=")) != sub) return false;
    remapped = true;
    if (!remap_option(remap->value, "prolog=").empty()) return true;  // nobody knows what Python sets
    const std::string words = small_letters(remap_option(remap->value, "argspec="));
    if (!is_letter(name) || words.find('@') != std::string::npos) return false;
    // A feed and a speed that must be there are names, too.
    const char sign = name == "f" ? '>' : name == "s" ? '^' : name[0];
    return words.find(sign) != std::string::npos || words.find(name) != std::string::npos;
  });
  // A file for a remap that this INI does not have, such as one for changing tools by hand.
  return by_line || (!remapped && of_prolog(name));
}

}  // namespace owlint
