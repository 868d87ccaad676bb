#include "analyzer/findings/baseline.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/text/printable.h"

namespace owlint {
namespace {

constexpr const char* kSchema = "owlint-baseline-1";

std::string file_name_of(const Source& source) { return printable(source.path().substr(source.path().rfind('/') + 1)); }

}  // namespace

bool Baseline::parse(std::string_view text, const std::string& path, std::string* error) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("schema", nlohmann::json()) != kSchema || !json.contains("findings") ||
      !json["findings"].is_array()) {
    *error = fmt::format("{} is not a baseline: `--update-baseline` writes one", path);
    return false;
  }
  for (const auto& entry : json["findings"]) {
    const auto field = [&](const char* key) {
      return entry.is_object() && entry.contains(key) && entry[key].is_string() ? entry[key].get<std::string>()
                                                                                : std::string();
    };
    Identity identity{field("file"), field("code"), field("scope"), field("text")};
    const bool counted = entry.is_object() && entry.contains("count") && entry["count"].is_number_unsigned();
    if (identity.file.empty() || identity.code.empty()) {
      *error = fmt::format("{} has an entry without `file` or `code`", path);
      return false;
    }
    known_[std::move(identity)] += counted ? entry["count"].get<size_t>() : 1;
  }
  return true;
}

void Baseline::write(std::ostream& out) const {
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const auto& [identity, count] : known_) {
    nlohmann::ordered_json entry{
        {"file", identity.file}, {"code", identity.code}, {"scope", identity.scope}, {"text", identity.text}};
    if (count > 1) entry["count"] = count;
    entries.push_back(std::move(entry));
  }
  out << nlohmann::ordered_json{{"schema", kSchema}, {"findings", std::move(entries)}}.dump(1) << '\n';
}

void Baseline::add(const Source& source, const std::vector<Finding>& findings) {
  seen_.insert(file_name_of(source));
  for (const Finding& finding : findings) ++known_[identity_of(source, finding)];
}

size_t Baseline::take_out(const Source& source, std::vector<Finding>& findings) {
  seen_.insert(file_name_of(source));
  return std::erase_if(findings, [&](const Finding& finding) {
    const Identity identity = identity_of(source, finding);
    const auto known = known_.find(identity);
    size_t& met = met_[identity];
    if (known == known_.end() || met == known->second) return false;
    ++met;
    return true;
  });
}

size_t Baseline::gone() const {
  size_t count = 0;
  for (const auto& [identity, often] : known_) {
    const auto met = met_.find(identity);
    if (seen_.contains(identity.file)) count += often - (met == met_.end() ? 0 : met->second);
  }
  return count;
}

}  // namespace owlint
