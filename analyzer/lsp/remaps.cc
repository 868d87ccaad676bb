#include "analyzer/lsp/remaps.h"

#include <fmt/format.h>

#include "analyzer/machine/remap_names.h"
#include "analyzer/program/machine_words.h"
#include "analyzer/program/program.h"

namespace owlint::lsp {
namespace {

/// The letter and number that a REMAP line is for; a letter of 0 for those that LinuxCNC never calls.
std::pair<char, int> code_of(const std::string& remap, Release release) {
  const std::optional<RemappedCode> code = remapped_code(remap, release);
  if (code && code->letter != 'g' && code->letter != 'm') return {code->letter, -1};
  const bool built_in = code && code->letter == 'g' && g_code(code->number, release) != nullptr;
  return code && !built_in ? std::pair<char, int>(code->letter, code->number) : std::pair<char, int>();
}

}  // namespace

std::vector<Remap> remaps(const Profile& profile) {
  std::vector<Remap> out;
  if (profile.setup == nullptr) return out;
  for (const Ini::Entry* entry : profile.setup->ini.all("RS274NGC", "REMAP")) {
    const auto [letter, number] = code_of(entry->value, release_of(profile));
    const std::string_view sub = remap_option(entry->value, "ngc=");
    const std::string_view function = remap_option(entry->value, "python=");
    if (letter == 0 || (sub.empty() && function.empty())) continue;
    out.push_back(
        {letter, number,
         sub.empty() ? fmt::format("the Python function `{}`", function) : "`" + label_text(small_letters(sub)) + "`",
         entry});
  }
  return out;
}

}  // namespace owlint::lsp
