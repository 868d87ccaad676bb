#include "analyzer/audit/page_blocks.h"

#include <algorithm>

#include "analyzer/text/printable.h"

namespace owlint::audit {
namespace {

using Json = nlohmann::ordered_json;

class Drawn {
 public:
  Drawn(const Linked& linked, const std::function<int(const std::string& path)>& number)
      : linked_(linked), program_(*linked.files()[0].program), number_(number) {}

  Json json() const {
    Json all{{"scopes", Json::array()}, {"blocks", Json::array()}, {"calls", Json::array()}};
    for (RegionId r = 0; r < program_.regions.size(); ++r) all["scopes"].push_back(scope(r));
    for (BlockId b = 0; b < program_.blocks.size(); ++b) all["blocks"].push_back(block(b));
    for (const Call& call : program_.calls) all["calls"].push_back(called(call));
    return all;
  }

 private:
  Json line_of(StatementId id) const { return id == kNoStatement ? Json(nullptr) : Json(program_.at(id).line); }

  Json scope(RegionId id) const {
    const Region& region = program_.regions[id];
    if (id != kMainRegion)
      return {{"title", printable(program_.head(region.opener))},
              {"line", line_of(region.opener)},
              {"end", line_of(region.end)}};
    const auto first = std::ranges::find(program_.region_of, kMainRegion);
    const uint32_t line = first == program_.region_of.end()
        ? 1
        : program_.at(static_cast<StatementId>(first - program_.region_of.begin())).line;
    return {{"title", program_.sub_file ? "outside of subs" : "main program"}, {"line", line}, {"end", nullptr}};
  }

  Json block(BlockId id) const {
    const Block& block = program_.blocks[id];
    Json parts = Json::array();
    for (const StatementId part : program_.parts[id])
      parts.push_back({{"title", printable(program_.head(part))}, {"line", line_of(part)}});
    return {{"title", printable(program_.head_of(block))},
            {"line", line_of(block.opener)},
            {"end", line_of(block.end)},
            {"scope", block.region},
            {"parent", block.parent == kNoBlock ? Json(nullptr) : Json(block.parent)},
            {"parts", std::move(parts)}};
  }

  Json called(const Call& call) const {
    Json json{{"title",
               call.callee == kNoName ? printable(program_.head(call.statement))
                                      : printable(program_.label_text(call.callee))},
              {"line", line_of(call.statement)},
              {"scope", call.caller},
              {"to", nullptr}};
    if (call.target != kNoRegion) {
      json["to"] = {{"file", number_(program_.source->path())},
                    {"line", line_of(program_.regions[call.target].opener)}};
    } else if (call.callee != kNoName) {
      const CallTarget target = linked_.target(program_.name(call.callee));
      if (target.file == CallTarget::kNotFound) return json;
      const Program& other = *linked_.files()[target.file].program;
      const std::string name(called_label(program_.name(call.callee), Version::k2_9));
      const auto sub = std::ranges::find_if(other.regions, [&](const Region& region) {
        return region.name != kNoName && other.name(region.name) == name;
      });
      json["to"] = {{"file", number_(other.source->path())},
                    {"line", sub == other.regions.end() ? 1 : other.at(sub->opener).line}};
    }
    return json;
  }

  const Linked& linked_;
  const Program& program_;
  const std::function<int(const std::string& path)>& number_;
};

}  // namespace

Json blocks_json(const Linked& linked, const std::function<int(const std::string& path)>& number) {
  return Drawn(linked, number).json();
}

}  // namespace owlint::audit
