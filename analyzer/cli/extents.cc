// `owlint extents`: how far a program goes along each axis.
#include <iostream>

#include <nlohmann/json.hpp>

#include "analyzer/cli/commands.h"
#include "analyzer/flow/engine/extent_map.h"
#include "analyzer/report/extents.h"
#include "analyzer/text/files.h"

namespace owlint::cli {

int extents_command(const CommandLine& line, const std::string& format) {
  checking::Settings settings;
  const auto source = read_program(line, &settings);
  if (source == nullptr) return kUsage;
  settings.profile.measures_extents = true;
  Library library(disk());
  const Linked linked(library.load(source, settings.profile), settings.profile, library);
  const Extents extents = flow::extents_of(linked, settings.profile);
  if (format != "json") {
    std::cout << extents_text(extents, linked);
    return kClean;
  }
  nlohmann::ordered_json json{{"file", source->path()}};
  json.update(extents_json(extents, linked));
  std::cout << json.dump(2) << '\n';
  return kClean;
}

}  // namespace owlint::cli
