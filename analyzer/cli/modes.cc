// `owlint modes`: which modes are in effect before a line of a program, and where they were set.
#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/cli/commands.h"
#include "analyzer/flow/engine/mode_words.h"
#include "analyzer/text/files.h"

namespace owlint::cli {
namespace {

using Json = nlohmann::ordered_json;
using flow::joined;
using flow::ModeMap;
using flow::ModeThere;
using flow::value_text;
using flow::values_of;

/// The value, as its line has it where that says more: `F150` instead of `set`, `G43` instead of `G49 or on`.
std::string as_written(const ModeThere& there, const ModeMap& map) {
  if (there.set_on.size() != 1) return value_text(there);
  const auto number = [&](char letter) -> std::string {
    const auto value = map.written(there.set_on[0], letter);
    return value ? fmt::format("{}{}", static_cast<char>(letter - 'a' + 'A'), *value) : std::string();
  };
  std::string text;
  switch (there.mode) {
    case Mode::kFeed: text = number('f'); break;
    case Mode::kSpeed: text = number('s'); break;
    case Mode::kLoaded: text = number('t'); break;
    case Mode::kToolOffset: text = map.code_written(there.set_on[0], GGroup::kToolLength); break;
    case Mode::kCompensation: text = map.code_written(there.set_on[0], GGroup::kCutterCompensation); break;
    default: break;
  }
  return text.empty() ? value_text(there) : text;
}

void print(const Program& program, uint32_t line, const std::vector<ModeThere>& modes, const ModeMap& map) {
  const Source& source = *program.source;
  const ModeSets start = ModeSets::started();
  std::cout << fmt::format("{}:{}: {}\n", source.path(), line, source.slice(source.line(line)));
  for (const ModeThere& there : modes) {
    if (!is_worth_showing(there)) continue;
    std::string place = places_of(there, program);
    if (place.empty() && there.known)
      place = there.may == start[there.mode] ? "as LinuxCNC starts" : "by the start-up code of the INI";
    std::cout << fmt::format("  {:<21}{:<12}", mode_name(there.mode), as_written(there, map))
              << (place.empty() ? "" : "  " + place) << '\n';
  }
}

Json as_json(const std::vector<ModeThere>& modes) {
  Json out = Json::object();
  for (const ModeThere& there : modes) {
    Json places = Json::array();
    for (const flow::ModeSetter& setter : there.set_on)
      places.push_back({{"file", setter.file->source->path()}, {"line", setter.line}});
    out[std::string(mode_name(there.mode))] = {
        {"values", values_of(there)}, {"known", there.known}, {"set_on", std::move(places)}};
  }
  return out;
}

/// Every line that changes modes, with what it changes.
void print_changes(const Program& program, const ModeMap& map, bool json) {
  Json out = Json::array();
  const Source& source = *program.source;
  for (const flow::ModeStep& step : map.changes()) {
    if (!step.reached) {
      // What ends the program says so itself.
      if (!json && map.stops_at(step.line - 1))
        std::cout << fmt::format("{}:{}: no run gets past this line: it stops\n", source.path(), step.line - 1);
      continue;
    }
    if (json) {
      out.push_back({{"line", step.line}, {"changes", as_json(step.changed)}});
      continue;
    }
    std::vector<std::string> words;
    for (const ModeThere& there : step.changed) {
      if (!flow::is_inner(there.mode))
        words.push_back(fmt::format("{} {}", mode_name(there.mode), as_written(there, map)));
    }
    if (words.empty()) continue;
    std::cout << fmt::format("{}:{}: {}\n  {}\n", source.path(), step.line, source.slice(source.line(step.line)),
                             joined(words, "and"));
  }
  if (json) std::cout << Json{{"file", source.path()}, {"lines", std::move(out)}}.dump(2) << '\n';
}

/// Why no run gets to a line, as far as a line before it says so.
std::string why_unreached(const ModeMap& map, uint32_t at) {
  constexpr uint32_t kMostLines = 1000;
  for (uint32_t line = at - 1; line > 0 && at - line < kMostLines; --line) {
    if (map.stops_at(line)) return fmt::format(": the program stops at line {} first", line);
    if (map.before(line)) break;
  }
  return "";
}

}  // namespace

int modes_command(const CommandLine& line, uint32_t at, const std::string& format) {
  checking::Settings settings;
  const auto source = read_program(line, &settings);
  if (source == nullptr) return kUsage;
  Library library(disk());
  const Linked linked(library.load(source, settings.profile), settings.profile, library);
  const Program& program = *linked.files()[0].program;
  const ModeMap map(linked, settings.profile, flow::Limits{});
  const bool json = format == "json";
  if (at == 0) {
    print_changes(program, map, json);
    return kClean;
  }
  if (at > program.syntax.lines) {
    complain(fmt::format("{} has {} lines", source->path(), program.syntax.lines));
    return kUsage;
  }
  const auto modes = map.before(at);
  if (json) {
    std::cout << Json{{"file", source->path()},
                      {"line", at},
                      {"reached", modes.has_value()},
                      {"modes", modes ? as_json(*modes) : Json(nullptr)}}
                     .dump(2)
              << '\n';
  } else if (modes) {
    print(program, at, *modes, map);
  } else {
    std::cout << fmt::format("{}:{}: no run gets to this line{}\n", source->path(), at, why_unreached(map, at));
  }
  return kClean;
}

}  // namespace owlint::cli
