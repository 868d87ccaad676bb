#include "analyzer/cli/audit.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <fmt/format.h>

#include "analyzer/audit/audit.h"
#include "analyzer/audit/history.h"
#include "analyzer/audit/merge.h"
#include "analyzer/audit/page.h"
#include "analyzer/audit/progress.h"
#include "analyzer/audit/reading.h"
#include "analyzer/audit/watch.h"
#include "analyzer/cli/commands.h"
#include "analyzer/report/formats.h"
#include "analyzer/text/files.h"
#include "analyzer/text/parallel.h"
#include "analyzer/text/terminal.h"
#include "rules/driver/stops.h"

namespace owlint::cli {
namespace {

using audit::Outcome;
using audit::Store;

std::atomic<bool> stopping = false;

/// The first Ctrl-C ends the run in order, the second one at once.
void stop_in_order(int signal) {
  stopping = true;
  ::signal(signal, SIG_DFL);
}

std::string grouped(size_t number) {
  std::string text = std::to_string(number);
  for (size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ',');
  return text;
}

std::string plural(size_t n, std::string_view what) {
  return fmt::format("{} {}{}", grouped(n), what, n == 1 ? "" : "s");
}

std::string counts(size_t errors, size_t warnings, size_t infos) {
  std::string text = plural(errors, "error") + ", " + plural(warnings, "warning");
  if (infos > 0) text += ", " + plural(infos, "info");
  return text;
}

/// How a report is to look on standard output, or in the file of --output.
ReportStyle style_of(const CommandLine& line) {
  std::error_code ignored;
  const int stream = line.output.empty() ? STDOUT_FILENO : -1;
  return {use_color(line.color, stream), std::filesystem::current_path(ignored).string(), columns_of(stream)};
}

size_t count_from(const std::vector<FileReport>& reports, Severity level) {
  size_t count = 0;
  for (const FileReport& report : reports)
    count += static_cast<size_t>(
        std::ranges::count_if(report.findings, [&](const Finding& f) { return f.severity >= level; }));
  return count;
}

/// The strictest level that holds for one of the audited folders.
Severity fail_on(const CommandLine& line) {
  Configuration configuration(disk(), line);
  Severity strictest = Severity::kError;
  for (const std::string& path : line.paths) {
    std::error_code ignored;
    strictest = std::min(
        strictest, configuration.fail_on(std::filesystem::is_directory(path, ignored) ? path + "/program.ngc" : path));
  }
  return line.paths.empty() ? configuration.fail_on(".") : strictest;
}

std::vector<int64_t> ids_of(const std::vector<audit::StoredFinding>& findings) {
  std::vector<int64_t> ids;
  ids.reserve(findings.size());
  for (const auto& f : findings) ids.push_back(f.id);
  return ids;
}

/// A heading and findings below it; as many as one reads.
void print_some(std::string_view heading, std::vector<FileReport> reports, const CommandLine& line) {
  constexpr size_t kMost = 50;
  const size_t all = count_from(reports, Severity::kInfo);
  if (all == 0) return;
  size_t left = kMost;
  for (FileReport& report : reports) {
    const size_t kept = std::min(left, report.findings.size());
    report.findings.resize(kept);
    left -= kept;
  }
  std::erase_if(reports, [](const FileReport& report) { return report.findings.empty(); });
  std::cout << fmt::format("{}: {}\n", heading, grouped(all));
  write_grouped(std::cout, reports, style_of(line));
  if (all > kMost) std::cout << fmt::format("and {} more\n", grouped(all - kMost));
}

/// Runs `work`, and says what is wrong with a store.
template <typename Work>
int guarded(const std::string& store, const Work& work) {
  try {
    return work();
  } catch (const audit::StoreProblem& problem) {
    complain(problem.what());
  } catch (const SQLite::Exception& problem) {
    complain(audit::words_of(problem, store));
  }
  return kUsage;
}

class AuditRun {
 public:
  explicit AuditRun(const AuditLine& line) : line_(line) {}

  int go() {
    if (!usage_is_right()) return kUsage;
    use_cores(line_.check.jobs);
    ::signal(SIGINT, stop_in_order);
    ::signal(SIGTERM, stop_in_order);
    std::optional<audit::Watch> watch;
    if (line_.watch) watch.emplace(line_.check.paths);
    Store store = Store::open(line_.store, Store::For::kWriting, line_.wait);
    int status = once(store);
    while (watch && !stopping.load()) {
      std::cout.flush();
      if (watch->wait(stopping)) status = once(store);
    }
    return status;
  }

 private:
  bool usage_is_right() {
    if (!line_.shard.empty() && !read_shard()) {
      complain(fmt::format("--shard: `{}` is not I/N, such as 1/4 for the first of four", line_.shard));
      return false;
    }
    if (!line_.report.empty() && !audit::has_page()) {
      complain("this owlint was built without npm, so it has no page for --report");
      return false;
    }
    for (const std::string& path : line_.check.paths) {
      std::error_code problem;
      // A server that is not mounted must not look like a shop without programs.
      if (!std::filesystem::exists(path, problem)) {
        const std::string near = rules::nearest(path, {"list", "show", "export", "diff", "merge"});
        complain(fmt::format("there is no {}{}", path,
                             near.empty() ? ": nothing was audited" : ", did you mean `owlint audit " + near + "`?"));
        return false;
      }
    }
    return true;
  }

  bool read_shard() {
    const size_t slash = line_.shard.find('/');
    if (slash == std::string::npos) return false;
    const char* const begin = line_.shard.data();
    const char* const end = begin + line_.shard.size();
    const auto index = std::from_chars(begin, begin + slash, shard_.index);
    const auto count = std::from_chars(begin + slash + 1, end, shard_.count);
    return index.ptr == begin + slash && count.ptr == end && index.ec == std::errc() && count.ec == std::errc() &&
        shard_.index >= 1 && shard_.index <= shard_.count;
  }

  int once(Store& store) {
    audit::Progress progress(line_.check.quiet);
    CommandLine check = line_.check;
    check.absolute = true;
    const audit::Job job{check, shard_, [&](size_t done, size_t total) { progress.tell(done, total); }, &stopping};
    const Outcome outcome = audit::run_audit(job, store);
    progress.finish();
    for (const std::string& problem : outcome.problems) complain(problem);
    if (!line_.check.quiet) {
      for (const std::string& note : outcome.notes) complain(note);
    }
    if (outcome.run == 0) return kUsage;
    if (outcome.interrupted) return tell_interrupted(outcome);
    const size_t failing = tell(store, outcome);
    if (!line_.report.empty() && !write_report(store, outcome.run)) return kUsage;
    if (!outcome.problems.empty()) return kUsage;
    return failing > 0 ? kFindings : kClean;
  }

  int tell_interrupted(const Outcome& outcome) const {
    std::cerr << fmt::format("stopped: {} of this run are in the store; the next run goes on from there\n",
                             plural(outcome.analysed, "program"));
    if (line_.watch) return kClean;
    std::cout.flush();
    ::signal(SIGINT, SIG_DFL);
    ::raise(SIGINT);  // so that what started owlint knows why it ended
    return kUsage;
  }

  /// What there is, and what is new; how many findings make the audit fail.
  size_t tell(Store& store, const Outcome& outcome) {
    if (!line_.check.quiet) {
      std::cerr << fmt::format("run {}: {}, {} analysed, {}in {}\n", outcome.run, plural(outcome.files, "program"),
                               outcome.analysed == outcome.files ? "all" : grouped(outcome.analysed),
                               outcome.seconds < 1 ? "" : fmt::format("{:.1f} s, ", outcome.seconds), line_.store);
      std::cerr << counts(outcome.errors, outcome.warnings, outcome.infos);
      if (outcome.previous != 0)
        std::cerr << fmt::format("; {} new, {} gone since run {}", grouped(outcome.fresh), grouped(outcome.gone),
                                 outcome.previous);
      std::cerr << '\n';
    }
    const Severity level = fail_on(line_.check);
    const size_t failing = outcome.errors + (level <= Severity::kWarning ? outcome.warnings : 0) +
        (level <= Severity::kInfo ? outcome.infos : 0);
    if (outcome.previous == 0) {
      if (!line_.check.quiet && outcome.errors + outcome.warnings + outcome.infos > 0)
        std::cerr << fmt::format("`owlint audit show{}` lists them\n",
                                 line_.store == AuditLine().store ? "" : " --store " + line_.store);
      return line_.fail_on_new ? 0 : failing;
    }
    if (outcome.fresh == 0 && outcome.gone == 0) return line_.fail_on_new ? 0 : failing;
    const audit::Difference difference = audit::difference(store, outcome.previous, store, outcome.run);
    const std::vector<FileReport> fresh = reports_of(store, ids_of(difference.fresh));
    if (!line_.check.quiet) {
      print_some("new", fresh, line_.check);
      print_some("gone", reports_of(store, ids_of(difference.gone)), line_.check);
    }
    return line_.fail_on_new ? count_from(fresh, level) : failing;
  }

  bool write_report(Store& store, int64_t run) {
    const std::string unfinished = line_.report + ".part";
    std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
    if (file) audit::write_page(file, store, run, line_.check);
    file.close();
    std::error_code problem;
    if (file) std::filesystem::rename(unfinished, line_.report, problem);
    if (!file || problem) {
      std::filesystem::remove(unfinished, problem);
      complain("cannot write " + line_.report);
      return false;
    }
    if (!line_.check.quiet) std::cerr << "the page is " << line_.report << '\n';
    return true;
  }

  const AuditLine& line_;
  audit::Shard shard_;
};

/// A run as the command line names it: `3`, `last-1`, or `STORE` or `STORE:3` for one of another store.
struct NamedRun {
  Store store;
  int64_t run;
};

NamedRun open_run(const std::string& text, const std::string& store) {
  std::string path = store;
  std::string run = text;
  std::error_code ignored;
  if (std::filesystem::exists(text, ignored)) {
    path = text;
    run = "last";
  } else if (const size_t colon = text.rfind(':'); colon != std::string::npos) {
    path = text.substr(0, colon);
    run = text.substr(colon + 1);
  }
  Store opened = Store::open(path, Store::For::kReading);
  const auto found = audit::find_run(opened, run);
  if (!found)
    throw audit::StoreProblem(fmt::format(
        "{} has no complete run `{}`: use a number from `owlint audit list`, `last`, `last-1`, or STORE:RUN", path,
        run));
  return {std::move(opened), *found};
}

}  // namespace

int audit_command(const AuditLine& line) {
  return guarded(line.store, [&] { return AuditRun(line).go(); });
}

int audit_list_command(const AuditLine& line) {
  return guarded(line.store, [&] {
    Store store = Store::open(line.store, Store::For::kReading);
    std::cout << fmt::format("{:>4}  {:<20}  {:>9}  {:>9}  {:>8}  {:>8}  {:>6}  {:>6}  {:>8}\n", "run", "started (UTC)",
                             "programs", "analysed", "errors", "warnings", "new", "gone", "seconds");
    for (const audit::RunRow& run : audit::runs_of(store)) {
      const std::string kind = run.state == "complete" ? (run.shard.empty() ? "" : "shard " + run.shard) : run.state;
      std::string row =
          fmt::format("{:>4}  {:<20}  {:>9}  {:>9}  {:>8}  {:>8}  {:>6}  {:>6}  {:>8.1f}  {}", run.id, run.started,
                      run.files, run.analysed, run.errors, run.warnings, run.fresh, run.gone, run.seconds, kind);
      row.erase(row.find_last_not_of(' ') + 1);
      std::cout << row << '\n';
    }
    return kClean;
  });
}

int audit_show_command(const AuditLine& line) {
  return guarded(line.store, [&] {
    NamedRun named = open_run(line.run, line.store);
    const Format& format = *find_format(line.check.format);
    const std::vector<FileReport> reports = audit::reports_of(named.store, named.run, !format.for_people);
    std::ofstream file;
    if (!line.check.output.empty()) {
      file.open(line.check.output, std::ios::binary | std::ios::trunc);
      if (!file) {
        complain(fmt::format("cannot write {}: {}", line.check.output, std::strerror(errno)));
        return kUsage;
      }
    }
    std::ostream& out = line.check.output.empty() ? std::cout : file;
    format.write(out, reports, style_of(line.check));
    file.close();
    if (!line.check.output.empty() && !file) {
      complain(fmt::format("cannot write {}: {}", line.check.output, std::strerror(errno)));
      return kUsage;
    }
    if (format.for_people && !line.check.quiet) {
      const Totals totals = totals_of(reports);
      std::cerr << fmt::format("run {}: {} in {} with findings\n", named.run,
                               counts(totals.errors, totals.warnings, totals.infos), plural(totals.files, "program"));
    }
    return kClean;
  });
}

int audit_diff_command(const AuditLine& line) {
  return guarded(line.store, [&] {
    NamedRun a = open_run(line.from, line.store);
    NamedRun b = open_run(line.to, line.store);
    const audit::Difference difference = audit::difference(a.store, a.run, b.store, b.run);
    const std::vector<FileReport> fresh = audit::reports_of(b.store, ids_of(difference.fresh));
    const std::vector<FileReport> gone = audit::reports_of(a.store, ids_of(difference.gone));
    const ReportStyle style = style_of(line.check);
    const auto list = [&](std::string_view heading, const std::vector<FileReport>& reports, size_t count) {
      if (count == 0) return;
      std::cout << fmt::format("{}: {}\n", heading, grouped(count));
      write_grouped(std::cout, reports, style);
    };
    list("new", fresh, difference.fresh.size());
    list("gone", gone, difference.gone.size());
    std::cout.flush();
    if (!line.check.quiet)
      std::cerr << fmt::format("{} new, {} gone\n", grouped(difference.fresh.size()), grouped(difference.gone.size()));
    return count_from(fresh, fail_on(line.check)) > 0 ? kFindings : kClean;
  });
}

int audit_merge_command(const AuditLine& line) {
  return guarded(line.store, [&] {
    Store store = Store::open(line.store, Store::For::kWriting, line.wait);
    const Outcome outcome = audit::merge(store, line.stores);
    if (!line.check.quiet) {
      std::cerr << fmt::format("run {}: {} from {}, in {}\n{}", outcome.run, plural(outcome.files, "program"),
                               plural(line.stores.size(), "store"), line.store,
                               counts(outcome.errors, outcome.warnings, outcome.infos));
      if (outcome.previous != 0)
        std::cerr << fmt::format("; {} new, {} gone since run {}", grouped(outcome.fresh), grouped(outcome.gone),
                                 outcome.previous);
      std::cerr << '\n';
    }
    return kClean;
  });
}

}  // namespace owlint::cli
