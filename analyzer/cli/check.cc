// `owlint check`: reads, lints in parallel, fixes if asked to, reports in the order of the paths.
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include <fmt/format.h>

#include "analyzer/checking/diff.h"
#include "analyzer/checking/fixing.h"
#include "analyzer/checking/groups.h"
#include "analyzer/checking/walk.h"
#include "analyzer/cli/changed.h"
#include "analyzer/cli/commands.h"
#include "analyzer/findings/baseline.h"
#include "analyzer/findings/edits.h"
#include "analyzer/findings/suppression.h"
#include "analyzer/report/formats.h"
#include "analyzer/text/memory_files.h"
#include "analyzer/text/parallel.h"
#include "analyzer/text/paths.h"
#include "analyzer/text/replace.h"
#include "analyzer/text/terminal.h"

namespace owlint::cli {
namespace {

std::string counted(size_t n, std::string_view what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

class Check {
 public:
  explicit Check(const CommandLine& line)
      : line_(line), configuration_(files_on_hand_, line), library_(files_on_hand_) {}

  int run() {
    if (!usage_is_right() || !find_files()) return kUsage;
    use_cores(line_.jobs);
    const bool fixes = line_.fix || line_.diff || line_.fix_only;
    if (fixes) {
      FixResult result = run_and_fix(files_on_hand_, files_, wanted_, line_.unsafe);
      result_ = std::move(result.run);
      for (const std::string& path : result.unfinished)
        trouble(fmt::format("{} was not changed: each fix leads to another one", path));
      if (line_.diff) return print_diffs(result.fixed);
      if (!write_fixed(result.fixed)) result_ = run_checks(files_, wanted_, library_);
    } else {
      result_ = run_checks(files_, wanted_, library_);
    }
    for (size_t i = 0; i < files_.size(); ++i) {
      if (!result_.errors[i].empty()) trouble(fmt::format("cannot read {}: {}", files_[i], result_.errors[i]));
    }
    if (line_.fix_only) return status_;
    if (line_.add_suppressions) return suppress_all();
    if (!take_baseline()) return kUsage;
    fold_groups(result_.reports, {files_, folders_of(files_on_hand_, line_.paths)});
    if (!line_.quiet) tell_notes();
    if (!write_report()) return kUsage;
    if (line_.statistics) write_statistics(std::cerr, result_.reports, library_);
    if (status_ != kClean) return status_;
    return fails() ? kFindings : kClean;
  }

 private:
  void trouble(const std::string& message) {
    complain(message);
    status_ = kUsage;
  }

  bool usage_is_right() {
    const auto wrong = [](bool is, const char* message) {
      if (is) complain(message);
      return is;
    };
    return !wrong(line_.unsafe && !line_.fix && !line_.diff && !line_.fix_only,
                  "--unsafe goes with --fix, --fix-only or --diff") &&
        !wrong(line_.update_baseline && line_.baseline.empty(), "--update-baseline needs --baseline FILE") &&
        !wrong(line_.add_suppressions && line_.reason.empty(),
               "--add-suppressions needs --reason TEXT, which is written into each comment") &&
        !wrong(!line_.add_suppressions && !line_.reason.empty(), "--reason goes with --add-suppressions") &&
        !wrong(line_.add_suppressions && line_.reason.find('\n') != std::string::npos, "--reason is one line");
  }

  /// Files and their settings.
  bool find_files() {
    Walk found = walk(files_on_hand_, line_.paths, line_.walk,
                      [this](const std::string& folder) { return configuration_.patterns_in(folder); });
    for (const std::string& problem : found.problems) trouble(problem);
    for (WalkedFile& file : found.files) files_.push_back(std::move(file.path));
    without_ini_ = std::move(found.without_ini);
    configuration_.know_without_ini(without_ini_);
    if (const auto input = std::ranges::find(files_, "-"); input != files_.end()) {
      *input = line_.stdin_filename;
      stdin_ = Source::own(line_.stdin_filename, std::string{std::istreambuf_iterator<char>(std::cin), {}});
    }
    if (!line_.since.empty()) {
      std::set<std::string> changed;
      std::string error;
      if (!changed_since(line_.since, &changed, &error)) {
        complain(error);
        return false;
      }
      std::erase_if(files_, [&](const std::string& path) {
        std::error_code problem;
        const std::string real = std::filesystem::canonical(path, problem).string();
        return !changed.contains(problem ? file_key(path) : real) && !changed.contains(file_key(path));
      });
    }
    settings_.resize(files_.size());
    std::string last_error;
    for (size_t i = 0; i < files_.size(); ++i) {
      std::string error;
      const bool usable = configuration_.settings_for(files_[i], &settings_[i], &error);
      wanted_.push_back(usable ? &settings_[i] : nullptr);
      if (!usable && error != last_error) trouble(error);  // once, not for every file below it
      last_error = usable ? last_error : error;
    }
    return true;
  }

  int print_diffs(const std::vector<FixedFile>& fixed) const {
    for (const FixedFile& file : fixed) std::cout << unified_diff(file.path, file.before->bytes(), file.text);
    std::cout.flush();
    return status_ != kClean ? status_ : fixed.empty() ? kClean : kFindings;
  }

  /// The fixed programs; one from standard input goes to standard output. False where one could not be written, and what was
  /// found in it is still there.
  bool write_fixed(const std::vector<FixedFile>& fixed) {
    size_t made = 0;
    size_t files = 0;
    for (const FixedFile& file : fixed) {
      std::string error;
      if (stdin_ != nullptr && file.path == line_.stdin_filename) {
        stdin_ = Source::own(file.path, file.text);
      } else if (!replace_unchanged(file.path, file.before->bytes(), file.text, &error)) {
        trouble(fmt::format("cannot write {}: {}", file.path, error));
        continue;
      }
      made += file.made;
      ++files;
    }
    if (stdin_ != nullptr) std::cout << stdin_->bytes();
    const bool whole = files == fixed.size();
    if (!line_.quiet && (whole || files > 0))
      std::cerr << (files == 0 ? "nothing fixed\n"
                               : fmt::format("fixed {} in {}\n", counted(made, "finding"), counted(files, "file")));
    return whole;
  }

  int suppress_all() {
    size_t suppressed = 0;
    std::string standard(stdin_ == nullptr ? std::string_view() : stdin_->bytes());
    for (const FileReport& report : result_.reports) {
      // What is found in other files than those that were named is not written into them.
      if (report.findings.empty() || !is_checked(report.source->path())) continue;
      const std::vector<Edit> edits = suppression_comments(*report.source, report.findings, line_.reason);
      std::string error;
      std::string text = apply_edits(report.source->bytes(), edits);
      if (stdin_ != nullptr && report.source->path() == line_.stdin_filename) {
        standard = std::move(text);
      } else if (!replace_unchanged(report.source->path(), report.source->bytes(), text, &error)) {
        trouble(fmt::format("cannot write {}: {}", report.source->path(), error));
        continue;
      }
      suppressed += report.findings.size();
    }
    std::cout << standard;
    if (!line_.quiet) std::cerr << "suppressed " << counted(suppressed, "finding") << '\n';
    return status_;
  }

  bool take_baseline() {
    if (line_.baseline.empty()) return true;
    std::string error;
    if (line_.update_baseline) {
      Baseline fresh;
      for (FileReport& report : result_.reports) {
        fresh.add(*report.source, report.findings);
        hidden_ += report.findings.size();
        report.findings.clear();
      }
      std::ostringstream text;
      fresh.write(text);
      if (!write_text_file(line_.baseline, text.str(), &error)) {
        complain(fmt::format("cannot write {}: {}", line_.baseline, error));
        return false;
      }
      if (!line_.quiet)
        std::cerr << fmt::format("recorded {} in {}\n", counted(hidden_, "known finding"), line_.baseline);
      return true;
    }
    Baseline baseline;
    std::ifstream file(line_.baseline, std::ios::binary);  // may be a pipe
    if (!file) error = fmt::format("cannot read the baseline {}", line_.baseline);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!error.empty() || !baseline.parse(text, line_.baseline, &error)) {
      complain(error);
      return false;
    }
    for (FileReport& report : result_.reports) hidden_ += baseline.take_out(*report.source, report.findings);
    if (line_.quiet) return true;
    if (hidden_ > 0)
      std::cerr << fmt::format("{} not shown (listed in {})\n", counted(hidden_, "known finding"), line_.baseline);
    if (const size_t gone = baseline.gone(); gone > 0)
      std::cerr << fmt::format("{} of {} no longer there; `--update-baseline` removes them\n", counted(gone, "finding"),
                               line_.baseline);
    return true;
  }

  void tell_notes() const {
    constexpr size_t kMaxNotes = 4;
    const std::vector<std::string>& notes = configuration_.notes();
    for (size_t i = 0; i < std::min(notes.size(), kMaxNotes); ++i) complain(notes[i]);
    if (notes.size() > kMaxNotes) complain(std::to_string(notes.size() - kMaxNotes) + " more notes like these");
    for (const std::string& note : result_.notes) complain(note);
  }

  bool write_report() const {
    std::ofstream file;
    if (!line_.output.empty()) {
      file.open(line_.output, std::ios::binary | std::ios::trunc);
      if (!file) {
        complain(fmt::format("cannot write {}: {}", line_.output, std::strerror(errno)));
        return false;
      }
    }
    // Where the fixed program goes to standard output, what is left goes beside it.
    const bool program_is_out = stdin_ != nullptr && line_.fix;
    std::ostream& out = !line_.output.empty() ? file : program_is_out ? std::cerr : std::cout;
    const int stream = !line_.output.empty() ? -1 : program_is_out ? STDERR_FILENO : STDOUT_FILENO;
    std::error_code ignored;
    const Format& format = *find_format(line_.format);
    format.write(out, result_.reports,
                 {use_color(line_.color, stream), std::filesystem::current_path(ignored).string(), columns_of(stream)});
    file.close();
    if (!line_.output.empty() && !file) {
      complain(fmt::format("cannot write {}: {}", line_.output, std::strerror(errno)));
      return false;
    }
    Totals totals = totals_of(result_.reports);
    totals.hidden = hidden_;
    if (!format.for_people || line_.quiet || totals.files == 0) return true;
    std::cerr << totals_text(totals) << '\n';
    tell_fixable();
    return true;
  }

  /// Fixes are made in the files that were named; in others, such as those that they call, only when these are named.
  void tell_fixable() const {
    Fixable fixable;
    for (const FileReport& report : result_.reports) {
      if (!is_checked(report.source->path())) continue;
      const Fixable one = count_fixable(report.findings);
      fixable.safe += one.safe;
      fixable.unsafe += one.unsafe;
    }
    if (fixable.safe > 0) std::cerr << fmt::format("{} can be fixed with --fix\n", fixable.safe);
    if (fixable.unsafe > 0)
      std::cerr << fmt::format("{} can be fixed with --fix --unsafe, which may change what the program does\n",
                               fixable.unsafe);
    constexpr size_t kMostFiles = 4;
    size_t files = 0;
    for (const FileReport& report : result_.reports) {
      if (is_checked(report.source->path())) continue;
      const Fixable one = count_fixable(report.findings);
      if (one.safe + one.unsafe == 0 || ++files > kMostFiles) continue;
      std::cerr << fmt::format("{} in {}, which was not named, can be fixed with --fix{} {}\n", one.safe + one.unsafe,
                               report.source->path(), one.safe > 0 ? "" : " --unsafe", report.source->path());
    }
    if (files > kMostFiles)
      std::cerr << fmt::format("so can findings in {} more\n", counted(files - kMostFiles, "file"));
  }

  bool is_checked(const std::string& path) const { return std::ranges::find(files_, path) != files_.end(); }

  bool fails() {
    return std::ranges::any_of(result_.reports, [&](const FileReport& report) {
      if (report.findings.empty()) return false;
      const Severity level = configuration_.fail_on(report.source->path());
      return std::ranges::any_of(report.findings, [&](const Finding& f) { return f.severity >= level; });
    });
  }

  const CommandLine& line_;
  UnsavedFiles files_on_hand_{disk(), [this](const std::string& path) {  // with what came by standard input
                                return path == line_.stdin_filename ? stdin_ : nullptr;
                              }};
  std::unordered_set<std::string> without_ini_;
  Configuration configuration_;
  int status_ = kClean;
  std::vector<std::string> files_;
  std::shared_ptr<const Source> stdin_;
  std::vector<Settings> settings_;
  std::vector<const Settings*> wanted_;
  Library library_;
  RunResult result_;
  size_t hidden_ = 0;  // findings that the baseline lists
};

}  // namespace

int check_command(const CommandLine& line) { return Check(line).run(); }

}  // namespace owlint::cli
