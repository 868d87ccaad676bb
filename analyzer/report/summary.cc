#include "analyzer/report/summary.h"

#include "analyzer/text/printable.h"

namespace owlint {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMaxNamed = 8;  // in words; a longer list is no overview

std::vector<std::string> arguments_of(const flow::Summary& summary) {
  std::vector<std::string> out;
  for (int n = 1; n < flow::kFirstGlobalNumber; ++n) {
    if ((summary.arguments >> n & 1) != 0) out.push_back("#" + std::to_string(n));
  }
  return out;
}

std::vector<std::string> texts(const Program& program, const std::vector<flow::ParameterId>& parameters) {
  std::vector<std::string> out;
  for (const flow::ParameterId parameter : parameters)
    out.push_back(printable(flow::parameter_text(program, parameter)));
  return out;
}

std::string list(const std::vector<std::string>& parts) {
  std::string out;
  for (size_t i = 0; i < parts.size() && i < kMaxNamed; ++i) out += (i == 0 ? "" : ", ") + parts[i];
  if (parts.size() > kMaxNamed) out += " and " + std::to_string(parts.size() - kMaxNamed) + " more";
  return out;
}

}  // namespace

std::string summary_text(const Program& program, const flow::Summary& summary) {
  if (!summary.known) return {};
  std::vector<std::string> reads = arguments_of(summary);
  for (std::string& global : texts(program, summary.reads)) reads.push_back(std::move(global));
  if (summary.any_number) reads.emplace_back("a computed number");
  std::string out = reads.empty() ? "reads nothing" : "reads " + list(reads);
  if (!summary.writes.empty()) out += "; writes " + list(texts(program, summary.writes));
  switch (summary.returns) {
    case flow::Returns::kNothing: return out + "; returns no value";
    case flow::Returns::kSometimes: return out + "; returns a value on some paths";
    case flow::Returns::kValue: return out + "; returns a value on every path";
  }
  return out;
}

Json summary_json(const Program& program, const flow::Summary& summary) {
  if (!summary.known) return nullptr;
  Json arguments = Json::array();
  for (int n = 1; n < flow::kFirstGlobalNumber; ++n) {
    if ((summary.arguments >> n & 1) != 0) arguments.push_back(n);
  }
  constexpr const char* kReturns[] = {"never", "sometimes", "always"};
  return {{"arguments", arguments},
          {"computed", summary.any_number},
          {"reads", texts(program, summary.reads)},
          {"writes", texts(program, summary.writes)},
          {"returns", kReturns[static_cast<size_t>(summary.returns)]}};
}

nlohmann::ordered_json modes_json(const Program& program, RegionId region) {
  const flow::ModeSummary modes = flow::summary_of_modes(program, region);
  Json out{{"needs", Json::object()}, {"changes", Json::array()}, {"leaves", Json::object()}};
  for (const auto& [mode, line] : modes.needs) out["needs"][std::string(mode_name(mode))] = line;
  for (const Mode mode : modes.changes) out["changes"].push_back(mode_name(mode));
  for (const auto& [mode, value] : modes.leaves) out["leaves"][std::string(mode_name(mode))] = value_name(mode, value);
  return out;
}

}  // namespace owlint
