// GitLab's code quality report: an array of issues, told apart by their fingerprints.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/findings/identity.h"
#include "analyzer/report/formats.h"

namespace owlint {

void write_gitlab(std::ostream& out, const Reports& files, const ReportStyle& style) {
  using Json = nlohmann::ordered_json;
  const auto severity = [](const Finding& f) {
    return f.severity == Severity::kError ? "critical" : f.severity == Severity::kWarning ? "minor" : "info";
  };
  Json issues = Json::array();
  for (const FileReport& file : files) {
    const std::vector<std::string> prints = fingerprints(*file.source, file.findings);
    for (size_t i = 0; i < file.findings.size(); ++i) {
      const Finding& f = file.findings[i];
      const Source& source = source_of(file, f);
      const std::string path = json_path(source, style);
      issues.push_back(
          {{"description", whole_message(f, "; ")},
           {"check_name", fmt::format("{} {}", f.code, f.rule)},
           // Programs are often copied, whole, into another folder.
           {"fingerprint", prints[i] + percent_encoded(path)},
           {"severity", severity(f)},
           {"location",
            {{"path", path},
             {"lines", {{"begin", source.position(f.span.begin).line}, {"end", source.position(f.span.end).line}}}}}});
    }
  }
  out << issues.dump(2) << '\n';
}

}  // namespace owlint
