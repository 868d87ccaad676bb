#include "analyzer/audit/options.h"

#include <nlohmann/json.hpp>

#include "analyzer/text/printable.h"

namespace owlint::audit {

std::string options_text(const checking::CheckRequest& line) {
  nlohmann::ordered_json options = nlohmann::ordered_json::object();
  const auto text = [&](const char* key, const std::optional<std::string>& value) {
    if (value) options[key] = printable(*value);
  };
  const auto list = [&](const char* key, const std::vector<std::string>& values) {
    for (const std::string& value : values) options[key].push_back(printable(value));
  };
  text("ini", line.ini);
  text("feature", line.feature);
  text("linuxcnc", line.linuxcnc);
  text("config", line.config);
  list("sub-path", line.sub_path);
  list("select", line.select);
  list("extend-select", line.extend_select);
  list("ignore", line.ignore);
  list("severity", line.severity);
  list("exclude", line.walk.exclude);
  list("include", line.walk.include);
  if (line.isolated) options["isolated"] = true;
  if (!line.find_ini) options["find-ini"] = false;
  if (!line.walk.ignore_files) options["ignore-files"] = false;
  return options.dump();
}

}  // namespace owlint::audit
