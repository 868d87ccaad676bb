#include "analyzer/cli/run.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/text/parallel.h"

namespace owlint::cli {
namespace {

namespace fs = std::filesystem;

/// The files that machines call without any program: remaps, ngcgui, buttons, the start.
std::set<std::string> called_by_machines(const std::vector<const Settings*>& settings) {
  std::set<const MachineSetup*> machines;
  for (const Settings* s : settings) {
    if (s != nullptr && s->profile.setup != nullptr) machines.insert(s->profile.setup.get());
  }
  std::set<std::string> files;
  for (const MachineSetup* machine : machines) {
    for (const IniCall& call : machine->calls) {
      for (const std::string& name : called_names(call.code)) {
        if (const auto file = machine->search_path->find(name)) files.insert(file_key(file->path));
      }
    }
  }
  return files;
}

/// Of a file that some program of the run calls, what depends on the caller is known from there.
void drop_guesses(FileReport& report) {
  // How deep its calls are nested is known from there as well.
  std::erase_if(report.findings, [](const Finding& f) { return f.unproven || f.code == "OW210"; });
}

/// Whether a file lies in a folder that its machine has for subs.
bool among_subs(const std::string& path, const Settings& settings) {
  if (settings.profile.setup == nullptr) return false;
  const std::string folder = fs::path(file_key(path)).parent_path().string();
  return std::ranges::any_of(settings.profile.setup->folders, [&](const IniFolder& f) {
    return f.key == "SUBROUTINE_PATH" && file_key(f.path) == folder;
  });
}

/// What is true of a program only: a file that is called and lacks its sub is none either, nor is one of definitions
/// among the machine's subs.
void drop_ends(FileReport& report) {
  std::erase_if(report.findings, [](const Finding& f) { return f.code == "OW315" || f.code == "OW316"; });
}

}  // namespace

RunResult run_checks(const std::vector<std::string>& files, const std::vector<const Settings*>& settings,
                     const std::function<std::shared_ptr<const Source>(const std::string& path, std::string* error)>& read,
                     Library& library, const std::set<std::string>& called_elsewhere,
                     const std::function<void(size_t done)>& checked) {
  RunResult result;
  result.errors.resize(files.size());
  const std::set<std::string> by_machines = called_by_machines(settings);
  std::vector<ProgramReport> programs(files.size());
  const auto check = [&](size_t i, Role role) {
    const auto source = read(files[i], &result.errors[i]);
    if (source == nullptr) return;
    programs[i] = lint(library.load(source), settings[i]->profile, settings[i]->options, library, role);
  };
  std::mutex telling;
  size_t done = 0;
  for_each(files.size(), [&](size_t i) {
    if (checked) {
      const std::lock_guard lock(telling);
      checked(done++);
    }
    if (settings[i] != nullptr) check(i, by_machines.contains(file_key(files[i])) ? Role::kSubFile : Role::kByContent);
  });

  // Files that others turned out to call are no programs, whatever else stands in them.
  std::set<std::string> called = called_elsewhere;
  for (size_t i = 0; i < files.size(); ++i) {
    for (const std::string& path : programs[i].calls) {
      if (file_key(path) != file_key(files[i])) called.insert(file_key(path));
    }
  }
  for (size_t i = 0; i < files.size(); ++i) {
    if (programs[i].only_definitions && among_subs(files[i], *settings[i])) drop_ends(programs[i].own);
  }
  std::vector<size_t> again;
  for (size_t i = 0; i < files.size(); ++i) {
    if (programs[i].own.source == nullptr || !called.contains(file_key(files[i]))) continue;
    if (programs[i].sub_file) {
      drop_guesses(programs[i].own);
    } else {
      again.push_back(i);
    }
  }
  for_each(again.size(), [&](size_t i) {
    check(again[i], Role::kSubFile);
    ProgramReport& program = programs[again[i]];
    program.sub_file ? drop_guesses(program.own) : drop_ends(program.own);
  });

  for (ProgramReport& program : programs) result.calls.push_back(program.calls);

  std::map<std::string, size_t> place;  // of a file's report
  for (size_t i = 0; i < files.size(); ++i) {
    if (programs[i].own.source == nullptr) continue;
    place.emplace(file_key(files[i]), result.reports.size());
    result.reports.push_back(std::move(programs[i].own));
  }
  std::map<std::string, FileReport> others;
  const auto add = [&](FileReport report) {
    const std::string key = file_key(report.source->path());
    const auto known = place.find(key);
    FileReport& into = known != place.end() ? result.reports[known->second] : others[key];
    if (into.source == nullptr) into.source = report.source;
    merge_findings(into, std::move(report.findings));
  };
  std::set<std::string> python;
  for (ProgramReport& program : programs) {
    for (FileReport& report : program.called) add(std::move(report));
    python.insert(program.python.begin(), program.python.end());
  }
  std::set<const MachineSetup*> machines;
  for (const Settings* s : settings) {
    if (s == nullptr || s->profile.setup == nullptr || !machines.insert(s->profile.setup.get()).second) continue;
    for (FileReport& report : lint_setup(s->profile, s->options, library)) add(std::move(report));
  }
  for (auto& [key, report] : others) result.reports.push_back(std::move(report));
  if (!python.empty()) {
    result.notes.push_back(fmt::format("not found as subs or files, and taken for functions of the INI's [PYTHON] module: {}", fmt::join(python, ", ")));
  }
  return result;
}

}  // namespace owlint::cli
