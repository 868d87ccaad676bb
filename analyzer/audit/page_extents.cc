#include "analyzer/audit/page_extents.h"

#include "analyzer/flow/engine/extent_map.h"
#include "analyzer/report/extents.h"
#include "analyzer/text/files.h"

namespace owlint::audit {
namespace {

using Json = nlohmann::ordered_json;

/// Files become numbers, wherever they are.
void number_files(Json& json, const std::function<int(const std::string&)>& number_of) {
  for (const auto& [key, value] : json.items()) {
    if (key == "file" && value.is_string()) {
      value = number_of(value.get<std::string>());
    } else if (value.is_structured()) {
      number_files(value, number_of);
    }
  }
}

}  // namespace

Json page_extents(const std::shared_ptr<const Source>& source, Profile profile,
                  const std::function<int(const std::string&)>& number_of) {
  constexpr size_t kLargest = size_t{4} << 20;  // bytes
  if (source->bytes().size() > kLargest) return nullptr;
  profile.measures_extents = true;
  // A library of its own: files are read in another way than for findings.
  Library library(disk());
  const Linked linked(library.load(source, profile), profile, library);
  if (linked.program().sub_file) return nullptr;
  const Extents extents = flow::extents_of(linked, profile);
  if (extents.origins().empty() && extents.unknown().empty()) return nullptr;
  Json json = extents_json(extents, linked);
  number_files(json, number_of);
  return json;
}

}  // namespace owlint::audit
