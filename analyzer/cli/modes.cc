// `owlint modes`: which modes are in effect before a line of a program, and where they were set.
#include <iostream>
#include <numeric>
#include <utility>

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

void print(const Program& program, uint32_t line, const std::vector<ModeThere>& modes) {
  const Source& source = *program.source;
  const ModeSets start = ModeSets::started();
  std::cout << fmt::format("{}:{}: {}\n", source.path(), line, source.slice(source.line(line)));
  for (const ModeThere& there : modes) {
    if (!is_worth_showing(there)) continue;
    std::string place = places_of(there, program);
    if (place.empty() && there.known)
      place = there.may == start[there.mode] ? "as LinuxCNC starts" : "by the start-up code of the INI";
    std::cout << fmt::format("  {:<21}{:<12}", mode_name(there.mode), value_text(there))
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

/// By line: whether modes may be other ones behind it because of what it does, not because ways meet there.
std::vector<bool> lines_of_change(const Program& program) {
  std::vector<bool> acts(program.syntax.lines + 1, true);
  for (const Statement& s : program.syntax.statements) {
    if (s.kind == LineKind::kOWord && !s.calls()) acts[s.line] = false;
  }
  acts[0] = false;
  return acts;
}

/// Every line that changes modes, with what it changes.
void print_changes(const Program& program, const ModeMap& map, bool json) {
  Json out = Json::array();
  const Source& source = *program.source;
  const std::vector<bool> acts = lines_of_change(program);
  std::vector<uint32_t> lines(acts.size());
  std::iota(lines.begin(), lines.end(), 1);
  bool reached = true;  // the line before
  for (const flow::ModeStep& step : map.steps(lines)) {
    const uint32_t line = step.line - 1;
    if (std::exchange(reached, step.reached) != step.reached || !acts[line]) continue;
    if (json) {
      out.push_back({{"line", line}, {"changes", as_json(step.changed)}});
      continue;
    }
    std::vector<std::string> words;
    for (const ModeThere& there : step.changed) {
      if (!flow::is_inner(there.mode)) words.push_back(fmt::format("{} {}", mode_name(there.mode), value_text(there)));
    }
    if (words.empty()) continue;
    std::cout << fmt::format("{}:{}: {}\n  {}\n", source.path(), line, source.slice(source.line(line)),
                             joined(words, "and"));
  }
  if (json) std::cout << Json{{"file", source.path()}, {"lines", std::move(out)}}.dump(2) << '\n';
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
    print(program, at, *modes);
  } else {
    std::cout << fmt::format("{}:{}: no run gets to this line\n", source->path(), at);
  }
  return kClean;
}

}  // namespace owlint::cli
