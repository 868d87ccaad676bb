#include "analyzer/report/extents.h"

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "analyzer/text/printable.h"

namespace owlint {
namespace {

using Json = nlohmann::ordered_json;

struct Reason {
  std::string_view name;  ///< in JSON
  std::string_view text;
};

Reason reason_of(UnknownExtent why) {
  switch (why) {
    case UnknownExtent::kPlace: return {"place", "goes where owlint does not know"};
    case UnknownExtent::kArc: return {"arc", "is an arc of which only the end is known"};
    case UnknownExtent::kUnits: return {"units", "is in inches or millimeters, by the way to it"};
    case UnknownExtent::kCode: return {"code", "moves in a way that owlint does not follow"};
    case UnknownExtent::kBesides: break;
  }
  return {"compensation", "moves beside the contour, which counts as it is written"};
}

std::string axis_name(size_t axis) { return {static_cast<char>(kAxisOrder[axis] - 'a' + 'A')}; }

std::string system_name(const Extents::Origin& origin) {
  if (origin.system == Extents::Origin::kMachine) return "machine (G53)";
  if (origin.system == Extents::Origin::kSomeSystem) return "one of several coordinate systems";
  constexpr uint8_t kPlain = 6;  // G54 to G59
  return origin.system < kPlain ? fmt::format("G{}", 54 + origin.system)
                                : fmt::format("G59.{}", origin.system - kPlain + 1);
}

std::string title_of(const Extents::Origin& origin) {
  std::string title = system_name(origin);
  if (origin.shifted) title += " with G92";
  if (origin.from_start) title += ", counted from where the machine stands";
  return title;
}

/// Four decimals at most, without zeros behind them.
std::string coordinate_text(double value) {
  std::string text = fmt::format("{:.4f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string span_of(const Extent& extent) {
  if (extent.empty()) return "-";
  if (extent.least == extent.greatest) return coordinate_text(extent.least);
  return coordinate_text(extent.least) + " to " + coordinate_text(extent.greatest);
}

const Program& program_of(LineOfFile at, const Linked& linked) { return *linked.files()[at.file].program; }

std::string place_of(LineOfFile at, const Linked& linked) {
  const std::string& path = program_of(at, linked).source->path();
  return fmt::format("line {}{}", at.line, at.file == 0 ? "" : " of " + path.substr(path.rfind('/') + 1));
}

Json place_json(LineOfFile at, const Linked& linked) {
  return {{"file", as_utf8(program_of(at, linked).source->path())}, {"line", at.line}};
}

Json extent_json(const Extent& extent) {
  if (extent.empty()) return nullptr;
  return {{"least", extent.least}, {"greatest", extent.greatest}};
}

Json rates_json(const Extents::Rates& rates, const Linked& linked) {
  const Extent both = rates.both();
  Json json = extent_json(both);
  json["least_at"] = place_json(both.least_at, linked);
  json["greatest_at"] = place_json(both.greatest_at, linked);
  json["rapid"] = extent_json(rates.rapid);
  json["feed"] = extent_json(rates.feed);
  return json;
}

/// What is not known, by the lines where that begins.
using Unknown = std::map<std::pair<LineOfFile, UnknownExtent>, std::vector<std::string>>;
Unknown unknown_of(const Extents& extents) {
  Unknown unknown;
  for (const auto& [of, at] : extents.unknown()) unknown[{at, of.first}].push_back(axis_name(of.second));
  return unknown;
}

bool is_inch(const Extents& extents) {
  constexpr double kBetween = 10;
  return extents.unit() > kBetween;
}

/// The rows of a table with its head, each column as wide as it has to be.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<size_t> widths(rows.front().size());
  for (const auto& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) line += fmt::format("  {:<{}}", row[i], widths[i]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace

nlohmann::ordered_json extents_json(const Extents& extents, const Linked& linked) {
  Json json{{"unit", is_inch(extents) ? "inch" : "mm"}, {"origins", Json::array()}};
  for (const auto& [origin, axes] : extents.origins()) {
    Json entry{{"system", origin.system == Extents::Origin::kSomeSystem ? Json(nullptr) : Json(system_name(origin))},
               {"g92", origin.shifted},
               {"from_start", origin.from_start},
               {"axes", Json::object()}};
    if (origin.system == Extents::Origin::kMachine) entry["system"] = "machine";
    for (size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!axes[axis].both().empty()) entry["axes"][axis_name(axis)] = rates_json(axes[axis], linked);
    }
    json["origins"].push_back(std::move(entry));
  }
  json["complete"] = extents.unknown().empty() && extents.stops_at().line == 0;
  json["unknown"] = Json::array();
  for (const auto& [of, axes] : unknown_of(extents)) {
    Json entry = place_json(of.first, linked);
    entry["axes"] = axes;
    entry["why"] = reason_of(of.second).name;
    json["unknown"].push_back(std::move(entry));
  }
  json["stops_at"] = extents.stops_at().line == 0 ? Json(nullptr) : place_json(extents.stops_at(), linked);
  return json;
}

std::string extents_text(const Extents& extents, const Linked& linked) {
  const Program& program = *linked.files()[0].program;
  const bool moves = !extents.origins().empty();
  const std::string_view units = is_inch(extents) ? "inches" : "millimeters";
  std::string text = fmt::format("{}: {}\n", program.source->path(), moves ? units : "no move");
  const bool stops = extents.stops_at().line != 0;
  if (stops) {
    text +=
        fmt::format("a run stops at {}: its moves after that are not included\n", place_of(extents.stops_at(), linked));
  }
  for (const auto& [origin, axes] : extents.origins()) {
    std::vector<std::vector<std::string>> rows{{"", "least", "", "greatest", "", "rapid", "feed"}};
    for (size_t axis = 0; axis < kAxisCount; ++axis) {
      const Extent both = axes[axis].both();
      if (both.empty()) continue;
      rows.push_back({axis_name(axis), coordinate_text(both.least), place_of(both.least_at, linked),
                      coordinate_text(both.greatest), place_of(both.greatest_at, linked), span_of(axes[axis].rapid),
                      span_of(axes[axis].feed)});
    }
    text += title_of(origin) + '\n' + aligned(rows);
  }
  const Unknown unknown = unknown_of(extents);
  if (!unknown.empty()) text += "not included\n";
  for (const auto& [of, axes] : unknown) {
    const auto& [at, why] = of;
    const Source& source = *program_of(at, linked).source;
    text += fmt::format("  {}: {}: `{}` {}\n", place_of(at, linked), fmt::join(axes, " "),
                        printable(source.slice(source.line(at.line))), reason_of(why).text);
  }
  return text;
}

}  // namespace owlint
