#include "analyzer/checking/run.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/text/parallel.h"
#include "analyzer/text/paths.h"

namespace owlint::checking {
namespace {

/// Of a file that some program of the run calls, what depends on the caller is known from there.
void drop_guesses(FileReport& report) {
  std::erase_if(report.findings, [](const Finding& f) { return f.unproven || rule_of(f).of_callers; });
}

/// Whether a file lies in a folder that its machine has for subs.
bool among_subs(const std::string& path, const Settings& settings) {
  const std::string file = file_key(path);
  const std::string_view folder = folder_of(file);
  if (std::ranges::any_of(settings.profile.sub_path, [&](const std::string& f) { return file_key(f) == folder; }))
    return true;
  return settings.profile.setup != nullptr &&
      std::ranges::any_of(settings.profile.setup->folders,
                          [&](const IniFolder& f) { return f.key == "SUBROUTINE_PATH" && file_key(f.path) == folder; });
}

/// What is true of a program only: a file that is called and lacks its sub is none either, nor is one of definitions
/// among the machine's subs.
void drop_ends(FileReport& report) {
  std::erase_if(report.findings, [](const Finding& f) { return rule_of(f).of_programs; });
}

}  // namespace

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

Checked check_file(const std::shared_ptr<const Source>& source, const Settings& settings, Library& library,
                   bool by_machine) {
  const auto program = library.load(source, settings.profile);
  Checked checked;
  checked.report =
      lint(program, settings.profile, settings.options, library, by_machine ? Role::kSubFile : Role::kByContent);
  if (checked.report.role_matters)
    checked.as_sub = lint(program, settings.profile, settings.options, library, Role::kSubFile);
  checked.among_subs = among_subs(source->path(), settings);
  return checked;
}

std::vector<FileReport> check_machines(const std::vector<const Settings*>& settings, Library& library) {
  std::vector<FileReport> reports;
  std::set<const MachineSetup*> machines;
  for (const Settings* s : settings) {
    if (s == nullptr || s->profile.setup == nullptr || !machines.insert(s->profile.setup.get()).second) continue;
    std::ranges::move(lint_setup(s->profile, s->options, library), std::back_inserter(reports));
  }
  return reports;
}

RunResult put_together(const std::vector<std::string>& files, std::vector<Checked> checked,
                       std::vector<FileReport> machines, std::set<std::string> called) {
  RunResult result;
  // Files that other files call are not programs, whatever else is in them.
  for (size_t i = 0; i < files.size(); ++i) {
    for (const std::string& path : checked[i].report.calls) {
      if (file_key(path) != file_key(files[i])) called.insert(file_key(path));
    }
  }
  std::map<std::string, size_t> place;  // of a file's report
  for (size_t i = 0; i < files.size(); ++i) {
    ProgramReport& program = checked[i].report;
    if (program.own.source != nullptr) {
      if (program.only_definitions && checked[i].among_subs) drop_ends(program.own);
      if (called.contains(file_key(files[i]))) {
        if (checked[i].as_sub) program = std::move(*checked[i].as_sub);
        program.sub_file ? drop_guesses(program.own) : drop_ends(program.own);
      }
      place.emplace(file_key(files[i]), result.reports.size());
      result.reports.push_back(std::move(program.own));
    }
    result.calls.push_back(std::move(program.calls));
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
  for (Checked& file : checked) {
    for (FileReport& report : file.report.called) add(std::move(report));
    python.insert(file.report.python.begin(), file.report.python.end());
  }
  for (FileReport& report : machines) add(std::move(report));
  for (auto& [key, report] : others) result.reports.push_back(std::move(report));
  if (!python.empty()) {
    result.notes.push_back(
        fmt::format("neither a sub nor a file, so assumed to be functions of the INI's [PYTHON] module: {}",
                    fmt::join(python, ", ")));
  }
  return result;
}

RunResult run_checks(const std::vector<std::string>& files, const std::vector<const Settings*>& settings,
                     Library& library, const std::set<std::string>& called_elsewhere,
                     const std::function<void(size_t done)>& checked) {
  library.name_files(files);
  std::vector<std::string> errors(files.size());
  const std::set<std::string> by_machines = called_by_machines(settings);
  std::vector<Checked> all(files.size());
  std::mutex telling;
  size_t done = 0;
  for_each(files.size(), [&](size_t i) {
    if (checked) {
      const std::lock_guard lock(telling);
      checked(done++);
    }
    if (settings[i] == nullptr) return;
    if (settings[i]->of_ini) {
      all[i].report.own.source = settings[i]->profile.setup->ini.source();  // what is found in it: check_machines()
    } else if (const auto source = library.files().read(files[i], &errors[i]))
      all[i] = check_file(source, *settings[i], library, by_machines.contains(file_key(files[i])));
  });
  RunResult result = put_together(files, std::move(all), check_machines(settings, library), called_elsewhere);
  result.errors = std::move(errors);
  return result;
}

}  // namespace owlint::checking
