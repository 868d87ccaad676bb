#include "analyzer/checking/groups.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "analyzer/text/paths.h"

namespace owlint::checking {
namespace {

constexpr size_t kHabit = 3;        // from so many places on, in several files, something is a habit
constexpr size_t kMaxPlaces = 100;  // that a finding lists; the number in its message is that of all

/// Whether a file, by its key, lies below a folder.
bool is_below(std::string_view file, std::string_view folder) {
  return file.starts_with(folder) && (folder.ends_with('/') || file.substr(folder.size()).starts_with('/'));
}

/// How many characters two paths have in common from the beginning.
size_t common(std::string_view a, std::string_view b) {
  const auto differ = std::ranges::mismatch(a, b);
  return static_cast<size_t>(differ.in1 - a.begin());
}

/// The code or name that a message begins with: "`M110`", "`#<depth>`". Empty if it begins with anything else.
std::string_view subject_of(std::string_view message) {
  const bool code = message.starts_with("`M") || message.starts_with("`G");
  if (!code && !message.starts_with("`#<")) return {};
  const size_t end = code ? message.find_first_not_of("0123456789.", 2) : message.find('`', 1);
  const bool is_subject = end != std::string_view::npos && end > 2 && message[end] == '`';
  return is_subject ? message.substr(0, end + 1) : std::string_view();
}

/// How many places, and what else a group is about: " (2 places)", " (also `M102` and 3 more; 4 places in 2 files)".
std::string extent(const std::vector<std::string>& subjects, size_t places, size_t files) {
  constexpr size_t kNamed = 2;
  std::string out;
  if (subjects.size() > 1) {
    const size_t named = std::min(subjects.size() - 1, kNamed);
    const size_t more = subjects.size() - 1 - named;
    const auto* const first = subjects.data() + 1;
    out = fmt::format("also {}", fmt::join(first, first + named, more == 0 ? " and " : ", "));
    if (more > 0) out += fmt::format(" and {} more", more);
  }
  if (places > 1) {
    if (!out.empty()) out += "; ";
    out += files == 1 ? fmt::format("{} places", places) : fmt::format("{} places in {} files", places, files);
  }
  return out.empty() ? out : " (" + out + ")";
}

/// What is left out, or called, in many places.
struct Habit {
  size_t places = 0;
  std::set<const Source*> files;
};

struct Group {
  size_t report;
  size_t finding;
  size_t places = 1;
  Severity worst;
  std::set<const Source*> files;
  std::vector<Related> others;
  std::vector<std::string> subjects;  ///< of the messages, each once
  std::string found_in;               ///< the folder of the file that may be meant; empty: there is none
  const Habit* habit = nullptr;
};

class CommonFaults {
 public:
  CommonFaults(std::span<FileReport> reports, const Tree& tree) : reports_(reports), folders_(tree.folders) {
    for (const std::string& path : tree.files) by_name_[path.substr(path.rfind('/') + 1)].push_back(&path);
  }

  void run() {
    fold_said_of_lines();
    for (size_t r = 0; r < reports_.size(); ++r) {
      std::vector<Finding>& findings = reports_[r].findings;
      if (std::ranges::all_of(findings, [](const Finding& f) { return f.group.empty(); })) continue;
      std::vector<Finding> kept;
      for (Finding& f : findings) {
        if (f.group.empty() || !joins(r, kept.size(), f)) kept.push_back(std::move(f));
      }
      findings = std::move(kept);
    }
    for (auto& [key, group] : groups_) word(group);
    fold_by_folder();
    fold_partial();
  }

 private:
  /// What a program stops with for a line of the INI, where its finding names that line, is no second finding of the line.
  void fold_said_of_lines() {
    using Place = std::tuple<std::string, uint32_t, std::string>;  // path, line, what LinuxCNC says
    const auto is_ini = [](const FileReport& report) {
      return small_letters(ending_of(report.source->path())) == ".ini";
    };
    const auto place_in = [](const FileReport& report, const Finding& f) {
      return Place(report.source->path(), report.source->position(f.span.begin).line, f.interpreter);
    };
    std::map<Place, bool> said;
    for (const FileReport& report : reports_) {
      if (!is_ini(report)) continue;
      for (const Finding& f : report.findings) {
        if (!f.stops && !f.interpreter.empty()) said.emplace(place_in(report, f), false);
      }
    }
    if (said.empty()) return;
    for (const FileReport& report : reports_) {
      for (const Finding& f : report.findings) {
        if (!f.stops) continue;
        for (const Related& related : f.related) {
          if (related.source == nullptr) continue;
          const auto found =
              said.find({related.source->path(), related.source->position(related.span.begin).line, f.interpreter});
          if (found != said.end()) found->second = true;
        }
      }
    }
    for (FileReport& report : reports_) {
      if (!is_ini(report)) continue;
      std::erase_if(report.findings, [&](const Finding& f) {
        const auto found = f.stops ? said.end() : said.find(place_in(report, f));
        return found != said.end() && found->second;
      });
    }
  }

  /// The folder of the run that a file lies in, or "".
  std::string_view folder_of_run(const std::string& file) const {
    std::string_view longest;
    for (const std::string& folder : folders_) {
      if (folder.size() > longest.size() && is_below(file, folder)) longest = folder;
    }
    return longest;
  }

  /// Whether a finding is one more place of a group.
  bool joins(size_t report, size_t place, Finding& f) {
    const std::shared_ptr<const Source>& source = reports_[report].source;
    const std::string folder(folder_of_run(file_key(source->path())));
    Habit& habit = habits_[{folder, std::string(f.code), f.group}];
    ++habit.places;
    habit.files.insert(source.get());
    // Of what an INI lacks each finding has its own words: only copies are one.
    std::string same = f.group;
    if (!f.missing.empty()) same = fmt::format("{}\n{}\n{}\n{}", f.group, severity_text(f.severity), f.message, f.help);
    const auto [entry, first] = groups_.try_emplace({folder, std::string(f.code), std::move(same)},
                                                    Group{report, place, 1, f.severity, {}, {}, {}, {}, &habit});
    Group& group = entry->second;
    group.files.insert(source.get());
    const std::string_view subject = subject_of(f.message);
    if (!subject.empty() && std::ranges::find(group.subjects, subject) == group.subjects.end())
      group.subjects.emplace_back(subject);
    if (first) return false;
    ++group.places;
    group.worst = std::max(group.worst, f.severity);
    const bool same_subject = subject.empty() || subject == group.subjects.front();
    if (group.others.size() < kMaxPlaces)
      group.others.push_back({f.span, same_subject ? "here as well" : fmt::format("{} here", subject), source});
    return true;
  }

  /// Says of a group's first finding what is known now that all are.
  void word(Group& group) {
    FileReport& report = reports_[group.report];
    Finding& f = report.findings[group.finding];
    f.severity = group.worst;
    if (group.habit->places >= kHabit && group.habit->files.size() > 1 && f.habit_severity)
      f.severity = *f.habit_severity;
    f.message += extent(group.subjects, group.places, group.files.size());
    for (Related& other : group.others) {
      if (other.source == report.source) other.source = nullptr;
      f.related.push_back(std::move(other));
    }
    if (const std::string* file = nearest_file(f.group, report.source->path())) {
      const std::string folder = file->substr(0, file->rfind('/') + 1);
      const std::string shown = folder.size() > 1 ? folder.substr(0, folder.size() - 1) : folder.empty() ? "." : folder;
      group.found_in = shown;
      f.help = fmt::format(
          "if `{}` is meant, say `--sub-path {}`, or `sub-path = [\"{}\"]` in owlint.toml, or `--ini FILE` with the "
          "machine's INI",
          *file, shown, shown);
    }
  }

  /// Names that are all in one folder lack one setting: the first speaks for them.
  void fold_by_folder() {
    std::map<std::tuple<std::string, std::string, std::string>, std::vector<std::pair<std::string, Group*>>>
        missing;  // by folder of the run, code, folder
    for (auto& [key, group] : groups_) {
      const Finding& f = reports_[group.report].findings[group.finding];
      std::string where = group.found_in;
      // Nobody knows where the files of one program are: the search path is the cause.
      if (where.empty() && f.code == "OW208" && f.habit_severity && group.files.size() == 1)
        where = fmt::format("\n{}", group.report);
      if (!where.empty()) missing[{std::get<0>(key), std::get<1>(key), where}].emplace_back(std::get<2>(key), &group);
    }
    std::map<size_t, std::set<size_t>> folded;  // findings, by report
    for (auto& [key, groups] : missing) {
      const bool known = !std::get<2>(key).starts_with('\n');
      if (groups.size() == 1 || (!known && groups.size() < kHabit)) continue;
      std::ranges::sort(groups, {},
                        [](const auto& named) { return std::pair(named.second->report, named.second->finding); });
      const Group& first = *groups[0].second;
      Finding& f = reports_[first.report].findings[first.finding];
      constexpr size_t kNamed = 3;
      std::vector<std::string> names;
      for (size_t i = 1; i < groups.size(); ++i) {
        const Group& other = *groups[i].second;
        const Finding& moved = reports_[other.report].findings[other.finding];
        if (!known) f.severity = std::max(f.severity, moved.severity);
        if (names.size() < kNamed) names.push_back("`" + groups[i].first + "`");
        if (f.related.size() < kMaxPlaces)
          f.related.push_back({moved.span, "`" + groups[i].first + "` is called here",
                               other.report == first.report ? nullptr : reports_[other.report].source});
        folded[other.report].insert(other.finding);
      }
      const size_t more = groups.size() - 1 - names.size();
      f.message += fmt::format("; nor {}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
      if (known) f.message += fmt::format(": all are in `{}`", std::get<2>(key));
    }
    for (const auto& of_report : folded) {
      size_t at = 0;
      std::erase_if(reports_[of_report.first].findings,
                    [&](const Finding&) { return of_report.second.contains(at++); });
    }
  }

  /// INIs without all the files that they name are one fact about a folder, such as that it has only the programs.
  void fold_partial() {
    struct First {
      Finding* finding;
      const Source* source;
      size_t others = 0;
    };
    std::map<std::pair<std::string, std::string_view>, First> of_folder;  // by folder of the run, code
    const auto is_partial = [](const Finding& f) { return !f.missing.empty() && f.severity == Severity::kInfo; };
    for (FileReport& report : reports_) {
      if (std::ranges::none_of(report.findings, is_partial)) continue;
      const std::string folder(folder_of_run(file_key(report.source->path())));
      std::vector<Finding> kept;
      kept.reserve(report.findings.size());  // what `of_folder` refers to stays where it is
      for (Finding& f : report.findings) {
        First* const first =
            is_partial(f) ? &of_folder.try_emplace({folder, f.code}, First{nullptr, nullptr}).first->second : nullptr;
        if (first != nullptr && first->finding != nullptr) {
          ++first->others;
          if (first->finding->related.size() < kMaxPlaces)
            first->finding->related.push_back({f.span, "files are missing here, too",
                                               first->source == report.source.get() ? nullptr : report.source});
          continue;
        }
        kept.push_back(std::move(f));
        if (first != nullptr) *first = {&kept.back(), report.source.get()};
      }
      report.findings = std::move(kept);
    }
    for (auto& [key, first] : of_folder) {
      if (first.others > 0)
        first.finding->message +=
            fmt::format("; files are missing in {} other place{}, too", first.others, first.others > 1 ? "s" : "");
    }
  }

  /// The checked file that a call of `name` would find if its folder were searched; of several, the nearest.
  const std::string* nearest_file(const std::string& name, const std::string& caller) const {
    const auto found = by_name_.find(name + ".ngc");
    if (found == by_name_.end()) return nullptr;
    return *std::ranges::max_element(found->second, {}, [&](const std::string* path) { return common(*path, caller); });
  }

  std::span<FileReport> reports_;
  const std::vector<std::string>& folders_;
  std::map<std::string, std::vector<const std::string*>, std::less<>> by_name_;  // paths, by file name
  std::map<std::tuple<std::string, std::string, std::string>, Habit> habits_;    // by folder, code, group
  std::map<std::tuple<std::string, std::string, std::string>, Group> groups_;    // by folder, code, group
};

}  // namespace

std::vector<std::string> folders_of(const Files& files, const std::vector<std::string>& paths) {
  std::vector<std::string> folders;
  for (const std::string& path : paths) {
    const std::string key = file_key(path);
    folders.push_back(files.is_folder(path) ? key : std::string(folder_of(key)));
  }
  return folders;
}

void fold_groups(std::span<FileReport> reports, const Tree& tree) { CommonFaults(reports, tree).run(); }

}  // namespace owlint::checking
