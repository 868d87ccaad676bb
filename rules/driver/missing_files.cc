#include "rules/driver/missing_files.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/text/paths.h"
#include "rules/driver/machine_rules.h"

namespace owlint::rules {

std::string path_beside(const SetupInput& in, std::string_view value) {
  return normal_path(joined_path(folder_of(in.setup.path), value.substr(0, value.find_first_of(" \t"))));
}

namespace {

constexpr size_t kFewest = 2;       // one file that is not here is a wrong name
constexpr size_t kMostNamed = 100;  // that are looked for; no machine has so many HAL files
constexpr size_t kShown = 3;        // in a message

/// Where the file of a value is looked for; empty if that is not beside the INI: on the machine, or in LinuxCNC's own folders.
std::string place_beside(const SetupInput& in, std::string_view value) {
  if (value.empty() || value.starts_with('/') || value.starts_with('~') || value.starts_with("LIB:")) return {};
  return path_beside(in, value);
}

struct NamedFile {
  const IniLine* line;
  std::string path;
};

/// The files beside the INI without which LinuxCNC does not start.
std::vector<NamedFile> needed_files(const SetupInput& in) {
  const IniText& text = in.setup.text;
  std::vector<const IniLine*> lines;
  for (const IniLine* line : lines_of(text, "HAL")) {
    const std::string_view key = text.name(*line);
    if (line->kind == IniLine::Kind::kKey && (key == "HALFILE" || key == "POSTGUI_HALFILE")) lines.push_back(line);
  }
  lines.push_back(find_line(text, "PYTHON", "TOPLEVEL"));
  lines.push_back(find_line(text, "EMCIO", "TOOL_TABLE"));
  std::vector<NamedFile> files;
  for (const IniLine* line : lines) {
    if (line == nullptr || files.size() == kMostNamed) continue;
    if (std::string path = place_beside(in, text.value(*line)); !path.empty()) files.push_back({line, std::move(path)});
  }
  return files;
}

/// The files of needed_files() if none of them is here; nor is the file of parameters, which LinuxCNC itself writes.
std::vector<NamedFile> files_elsewhere(const SetupInput& in) {
  const Files& files = in.library.files();
  std::vector<NamedFile> needed = needed_files(in);
  const IniLine* parameters = find_line(in.setup.text, "RS274NGC", "PARAMETER_FILE");
  if (parameters != nullptr && files.is_file(place_beside(in, in.setup.text.value(*parameters)))) return {};
  const bool here = std::ranges::any_of(needed, [&](const NamedFile& file) { return files.is_file(file.path); });
  if (here || needed.size() < kFewest) needed.clear();
  return needed;
}

std::string listed(const std::vector<std::string>& names) {
  const size_t shown = std::min(names.size(), kShown);
  std::string text =
      fmt::format("`{}`", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), "`, `"));
  if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

/// Which findings are folded into others.
using Folded = std::vector<bool>;

/// LinuxCNC does not start without the file.
bool is_about_python(const Finding& f) { return f.code == "OW423" && f.stops; }

/// The finding that speaks for the others: if there is one, that about Python; one about a HAL file only alone.
Finding* speaker_of(std::vector<Finding>& findings) {
  Finding* best = nullptr;
  const auto rank = [](const Finding& f) { return is_about_python(f) ? 0 : f.code == "OW415" ? 2 : 1; };
  for (Finding& f : findings) {
    if (!f.missing.empty() && (best == nullptr || rank(f) < rank(*best))) best = &f;
  }
  return best;
}

/// The first of the findings speaks for all, and for the files that LinuxCNC needs.
Folded say_part(const SetupInput& in, const std::vector<NamedFile>& elsewhere, std::vector<Finding>& findings,
                bool speaks_for_calls) {
  Folded folded(findings.size());
  Finding* const speaker = speaker_of(findings);
  std::vector<std::string> names;
  const auto add = [&](std::string name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  };
  for (size_t i = 0; i < findings.size(); ++i) {
    Finding& f = findings[i];
    if (f.missing.empty()) continue;
    add(f.missing);
    if (&f == speaker) continue;
    folded[i] = true;
    if (f.code == "OW415") continue;  // named below
    speaker->consequences.push_back({f.code, f.span, f.interpreter});
    speaker->stops = speaker->stops || f.stops;
    speaker->weight = std::min(speaker->weight, f.weight);
  }
  for (const NamedFile& file : elsewhere) {
    const std::string_view value = in.setup.text.value(*file.line);
    const auto& source = in.setup.text.source(*file.line);
    add(std::string(value.substr(0, value.find_first_of(" \t"))));
    speaker->related.push_back(
        {file.line->value, "this file is not here", source->path() == in.setup.path ? nullptr : source});
  }
  speaker->message =
      fmt::format("{} files and folders that this INI names are not here: {}", names.size(), listed(names));
  if (is_about_python(*speaker))
    speaker->message += fmt::format("; LinuxCNC does not start without `{}`", speaker->missing);
  speaker->help =
      "correct the names; if this folder has only a part of the configuration, check the INI on the machine";
  if (speaks_for_calls && speaker->code == "OW208") {  // most of them are called by no program
    speaker->code = "OW407";
    speaker->rule = find_rule(speaker->code)->name;
  }
  speaker->reach = Reach::kMaybe;
  speaker->unproven = true;
  speaker->group = "part of a configuration";
  speaker->habit_severity = Severity::kInfo;
  return folded;
}

/// Of one rule's findings the first one that stops, else the first one, names the files of the others.
Folded join_names(std::vector<Finding>& findings) {
  Folded folded(findings.size());
  std::map<std::string_view, size_t> speaks;  // by code
  for (size_t i = 0; i < findings.size(); ++i) {
    if (findings[i].missing.empty()) continue;
    const auto [known, added] = speaks.emplace(findings[i].code, i);
    if (!added && findings[i].stops && !findings[known->second].stops) known->second = i;
  }
  std::map<size_t, std::vector<std::string>> names;  // of the others, by the one that speaks
  for (size_t i = 0; i < findings.size(); ++i) {
    if (findings[i].missing.empty()) continue;
    const size_t speaker = speaks.at(findings[i].code);
    if (speaker == i) continue;
    folded[i] = true;
    Finding& f = findings[speaker];
    f.related.push_back({findings[i].span, "`" + findings[i].missing + "` is not here either", nullptr});
    std::vector<std::string>& others = names[speaker];
    const bool known =
        findings[i].missing == f.missing || std::ranges::find(others, findings[i].missing) != others.end();
    if (!known) others.push_back(findings[i].missing);
  }
  for (const auto& of_speaker : names) {
    if (!of_speaker.second.empty()) findings[of_speaker.first].message += "; nor is there " + listed(of_speaker.second);
  }
  return folded;
}

}  // namespace

void fold_missing_files(const SetupInput& in, std::vector<Finding>& findings, bool names_folders) {
  if (std::ranges::all_of(findings, [](const Finding& f) { return f.missing.empty(); })) return;
  const std::vector<NamedFile> elsewhere = files_elsewhere(in);
  const Folded folded = elsewhere.empty() ? join_names(findings) : say_part(in, elsewhere, findings, names_folders);
  size_t at = 0;
  std::erase_if(findings, [&](const Finding&) { return folded[at++]; });
}

}  // namespace owlint::rules
