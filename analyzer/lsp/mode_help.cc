#include "analyzer/lsp/mode_help.h"

#include <fmt/format.h>

#include "analyzer/flow/engine/mode_words.h"

namespace owlint::lsp {

std::string modes_before(Workspace& workspace, const Document& document, uint32_t line) {
  Library library(workspace.files());
  const Profile profile = workspace.profile_of(document);
  const Linked linked(library.load(document.source(), profile), profile, library);
  const flow::ModeMap map(linked, profile, flow::Limits{});
  const auto modes = map.before(line);
  if (!modes) return {};
  std::string out = "Before this line:\n";
  for (const flow::ModeThere& there : *modes) {
    // What is as LinuxCNC starts would hide the rest.
    if (!flow::is_worth_showing(there) || there.set_on.empty()) continue;
    out += fmt::format("\n- {}: {}, {}", mode_name(there.mode), flow::value_text(there),
                       flow::places_of(there, *linked.files()[0].program));
  }
  return out.ends_with('\n') ? std::string() : out;
}

}  // namespace owlint::lsp
