#include "analyzer/checking/fixing.h"

#include <algorithm>
#include <set>

#include "analyzer/findings/edits.h"
#include "analyzer/text/memory_files.h"
#include "analyzer/text/paths.h"

namespace owlint::checking {
namespace {

// A fix can make another finding possible; a chain longer than this never ends.
constexpr int kMaxRounds = 50;

class Fixer {
 public:
  Fixer(const Files& read, const std::vector<std::string>& files, const std::vector<const Settings*>& settings,
        bool unsafe)
      : files_(files),
        settings_(settings),
        texts_(read, [this](const std::string& path) { return fixed_text(path); }),
        unsafe_(unsafe) {
    for (size_t i = 0; i < files.size(); ++i) place_.emplace(file_key(files[i]), i);
  }

  FixResult run() {
    FixResult result;
    std::vector<size_t> all(files_.size());
    for (size_t i = 0; i < all.size(); ++i) all[i] = i;
    result.run = check(all);
    calls_ = result.run.calls;
    for (const auto& calls : calls_) {
      for (const std::string& path : calls) called_.insert(file_key(path));
    }
    std::set<size_t> changed = fix(result.run);
    for (int round = 1; !changed.empty() && round < kMaxRounds; ++round) changed = fix(check(with_callers(changed)));
    for (const size_t i : changed) {
      result.unfinished.push_back(files_[i]);
      fixed_.erase(i);
    }
    if (!fixed_.empty() || !changed.empty()) result.run = check(all);
    for (auto& [i, file] : fixed_) result.fixed.push_back(std::move(file));
    return result;
  }

 private:
  RunResult check(const std::vector<size_t>& which) {
    std::vector<std::string> files;
    std::vector<const Settings*> settings;
    const std::map<const MachineSetup*, std::shared_ptr<const MachineSetup>> machines = fixed_machines();
    std::vector<Settings> with_fixed;  // for files of machines whose INI was fixed
    with_fixed.reserve(which.size());
    for (const size_t i : which) {
      files.push_back(files_[i]);
      settings.push_back(settings_[i]);
      const auto fixed = settings_[i] == nullptr ? machines.end() : machines.find(settings_[i]->profile.setup.get());
      if (fixed == machines.end()) continue;
      with_fixed.push_back(*settings_[i]);
      with_fixed.back().profile.setup = fixed->second;
      settings.back() = &with_fixed.back();
    }
    Library library(texts_);
    return run_checks(files, settings, library, called_);
  }

  /// The machines whose INI was fixed, as it is now.
  std::map<const MachineSetup*, std::shared_ptr<const MachineSetup>> fixed_machines() const {
    std::map<const MachineSetup*, std::shared_ptr<const MachineSetup>> machines;
    for (const Settings* one : settings_) {
      const MachineSetup* setup = one == nullptr ? nullptr : one->profile.setup.get();
      if (setup == nullptr || machines.contains(setup) || fixed_text(setup->path) == nullptr) continue;
      std::string error;  // it could be read before
      machines.emplace(setup, read_setup(texts_, setup->path, &error, one->profile.sub_path));
    }
    return machines;
  }

  std::shared_ptr<const Source> fixed_text(const std::string& path) const {
    const auto known = place_.find(file_key(path));
    const auto fixed = known == place_.end() ? fixed_.end() : fixed_.find(known->second);
    return fixed == fixed_.end() ? nullptr : Source::own(fixed->second.before->path(), fixed->second.text);
  }

  /// Makes a round of fixes in each file; which ones changed.
  std::set<size_t> fix(const RunResult& run) {
    std::set<size_t> changed;
    for (const FileReport& report : run.reports) {
      const auto known = place_.find(file_key(report.source->path()));
      if (known == place_.end() || settings_[known->second] == nullptr) continue;
      const Round round = round_of_fixes(report.findings, unsafe_);
      if (round.made == 0) continue;
      FixedFile& file = fixed_[known->second];
      if (file.before == nullptr) {
        file.path = files_[known->second];
        file.before = report.source;
      }
      file.text = apply_edits(report.source->bytes(), round.edits);
      file.made += round.made;
      changed.insert(known->second);
    }
    return changed;
  }

  /// The files and the programs that call them: those may have other findings now.
  std::vector<size_t> with_callers(const std::set<size_t>& changed) const {
    std::set<size_t> out = changed;
    for (size_t i = 0; i < calls_.size(); ++i) {
      const bool calls = std::ranges::any_of(calls_[i], [&](const std::string& path) {
        const auto known = place_.find(file_key(path));
        return known != place_.end() && changed.contains(known->second);
      });
      if (calls) out.insert(i);
    }
    return {out.begin(), out.end()};
  }

  const std::vector<std::string>& files_;
  const std::vector<const Settings*>& settings_;
  UnsavedFiles texts_;
  bool unsafe_;
  std::map<std::string, size_t> place_;          // of a file, by its key
  std::map<size_t, FixedFile> fixed_;            // by place
  std::vector<std::vector<std::string>> calls_;  // by place
  std::set<std::string> called_;                 // keys of files that some program calls
};

}  // namespace

FixResult run_and_fix(const Files& read, const std::vector<std::string>& files,
                      const std::vector<const Settings*>& settings, bool unsafe) {
  return Fixer(read, files, settings, unsafe).run();
}

}  // namespace owlint::checking
