#include "analyzer/audit/page_modes.h"

#include "analyzer/flow/engine/mode_words.h"
#include "analyzer/text/printable.h"

namespace owlint::audit {
namespace {

using Json = nlohmann::ordered_json;

/// Modes that change all the time, as programs mean it: the page lists them, and leaves the lines alone.
bool is_restless(Mode mode) {
  switch (mode) {
    case Mode::kMotion:
    case Mode::kFeed:
    case Mode::kSpeed:
    case Mode::kTurning:
    case Mode::kLoaded:
    case Mode::kCoolant: return true;
    default: return false;
  }
}

std::vector<uint32_t> lines_in(const Json& source) {
  std::vector<uint32_t> lines;
  for (const Json& stretch : source) {
    const uint32_t first = stretch.at(0);
    for (uint32_t i = 0; i < stretch.at(1).size(); ++i) lines.push_back(first + i);
  }
  return lines;
}

}  // namespace

Json modes_json(const Linked& linked, const Profile& profile, const Json& source,
                const std::function<int(const std::string& path)>& number) {
  const Program& own = *linked.files()[0].program;
  const flow::ModeMap map(linked, profile, flow::Limits{});
  Json names = Json::array(), steps = Json::array();
  std::vector<Mode> listed;
  const auto number_of = [&](Mode mode) {
    const auto at = std::ranges::find(listed, mode);
    if (at != listed.end()) return at - listed.begin();
    listed.push_back(mode);
    names.push_back({mode_name(mode), is_restless(mode) ? 0 : 1});
    return static_cast<std::ptrdiff_t>(listed.size()) - 1;
  };
  for (const flow::ModeStep& step : map.steps(lines_in(source))) {
    Json changes = Json::array();
    for (const flow::ModeThere& there : step.changed) {
      if (flow::is_inner(there.mode)) continue;
      Json places = Json::array();
      for (const flow::ModeSetter& setter : there.set_on) {
        if (setter.file == &own) {
          places.push_back(setter.line);
        } else {
          const std::string& path = setter.file->source->path();
          places.push_back({number(path), setter.line, printable(path.substr(path.rfind('/') + 1))});
        }
      }
      changes.push_back({number_of(there.mode), flow::value_text(there), std::move(places)});
    }
    const bool comes_back = !steps.empty() && steps.back().at(1).is_null();
    if (!step.reached) {
      steps.push_back({step.line, nullptr});
    } else if (!changes.empty() || comes_back) {
      steps.push_back({step.line, std::move(changes)});
    }
  }
  return {{"names", std::move(names)}, {"steps", std::move(steps)}};
}

}  // namespace owlint::audit
