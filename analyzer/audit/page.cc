#include "analyzer/audit/page.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <mutex>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/audit/assembly.h"
#include "analyzer/audit/hashes.h"
#include "analyzer/audit/history.h"
#include "analyzer/audit/packed.h"
#include "analyzer/audit/page_blocks.h"
#include "analyzer/audit/page_extents.h"
#include "analyzer/audit/page_lines.h"
#include "analyzer/audit/page_modes.h"
#include "analyzer/audit/page_template.h"
#include "analyzer/audit/reading.h"
#include "analyzer/audit/record.h"
#include "analyzer/audit/shown_paths.h"
#include "analyzer/findings/identity.h"
#include "analyzer/program/linker.h"
#include "analyzer/report/arc_drawing.h"
#include "analyzer/report/json.h"
#include "analyzer/report/pages.h"
#include "analyzer/report/report.h"
#include "analyzer/text/files.h"
#include "analyzer/text/parallel.h"
#include "analyzer/text/paths.h"

namespace owlint::audit {
namespace {

using Json = nlohmann::ordered_json;

/// The INIs of which something is said.
std::unordered_set<std::string> machine_inis(Store& store) {
  Records records;
  for (const std::string& record : machine_records(store)) records.add(record);
  std::unordered_set<std::string> paths;
  for (size_t i = 0; i < records.size(); ++i) {
    for (const FileReport& report : records.reports(i)) paths.insert(report.source->path());
  }
  return paths;
}

class Page {
 public:
  Page(std::ostream& out, Store& store, int64_t run, const checking::CheckRequest& line)
      : out_(out), store_(store), run_(run), line_(line), configuration_(disk(), line_), paths_(line.paths) {
    line_.absolute = true;
  }

  void write() {
    const std::string_view page = page_template();
    const size_t mark = page.find(kDataMark);
    out_ << page.substr(0, mark);
    programs_ = programs_of(store_, run_);
    for (size_t i = 0; i < programs_.size(); ++i) number_.emplace(programs_[i].path, i);
    kinds_.assign(programs_.size(), kProgram);
    reports_ = reports_of(store_, run_, false);
    const std::unordered_set<std::string> inis = machine_inis(store_);
    for (const FileReport& report : reports_) {
      const std::string& path = report.source->path();
      if (number_.contains(path)) continue;
      number_.emplace(path, programs_.size());
      programs_.push_back({path, "", 0, report.source->line_count(), ""});
      kinds_.push_back(inis.contains(path) ? kIni : kElsewhere);
      paths_.know(path);
    }
    part_.assign(programs_.size(), -1);
    linked_.assign(programs_.size(), 0);
    write_parts();
    write_element("owlint-index", index());
    out_ << page.substr(mark + kDataMark.size());
  }

 private:
  /// What findings are in: the programs of the run, INIs, and subs from elsewhere that the programs call.
  enum Kind { kProgram, kIni, kElsewhere };

  void write_element(const std::string& id, const Json& json) { write_packed(id, packed(json.dump())); }
  void write_packed(const std::string& id, const std::string& data) {
    out_ << "<script type=\"text/plain\" id=\"" << id << "\">" << data << "</script>\n";
  }

  /// Parts of the programs that have findings, then of the others as long as the page stays handy.
  void write_parts() {
    constexpr size_t kGroup = 192 << 10;         // bytes of programs in a part
    constexpr size_t kHandy = size_t{40} << 20;  // bytes of parts
    std::vector<size_t> order;
    std::unordered_map<size_t, const FileReport*> report_of;
    for (const FileReport& report : reports_) {
      const size_t i = number_.at(report.source->path());
      order.push_back(i);
      report_of.emplace(i, &report);
    }
    const size_t with_findings = order.size();
    for (size_t i = 0; i < programs_.size(); ++i) {
      if (!report_of.contains(i) && programs_[i].problem.empty()) order.push_back(i);
    }
    std::vector<std::shared_ptr<const checking::Settings>> settings(programs_.size());
    for (const size_t i : order) {
      std::string error;
      settings[i] = configuration_.shared_settings(programs_[i].path, &error);
    }
    std::vector<std::vector<size_t>> groups;
    size_t bytes = kGroup;
    for (size_t at = 0; at < order.size(); ++at) {
      if (bytes >= kGroup || at == with_findings) {
        groups.emplace_back();
        bytes = 0;
      }
      groups.back().push_back(order[at]);
      bytes += std::min<size_t>(programs_[order[at]].bytes + 500, 64 << 10);
    }
    size_t written = 0;
    size_t number = 0;
    for_each_in_order(
        groups.size(),
        [&](size_t g) {
          if (written > kHandy && !report_of.contains(groups[g].front())) return std::string();
          Json part = Json::object();
          for (const size_t i : groups[g]) {
            const auto report = report_of.find(i);
            part[std::to_string(i)] =
                details(i, report == report_of.end() ? nullptr : report->second, settings[i].get());
          }
          return packed(part.dump());
        },
        [&](size_t g, const std::string& data) {
          if (data.empty()) return;
          for (const size_t i : groups[g]) part_[i] = static_cast<int>(number);
          write_packed(fmt::format("owlint-part-{}", number++), data);
          written += data.size();
        });
  }

  Json details(size_t number, const FileReport* report, const checking::Settings* settings) {
    const ProgramRow& row = programs_[number];
    static const std::vector<Finding> kNone;
    const std::vector<Finding>& findings = report == nullptr ? kNone : report->findings;
    Json json{{"lineCount", row.lines}, {"source", Json::array()}, {"findings", Json::array()},
              {"modes", nullptr},       {"blocks", nullptr},       {"extents", nullptr}};
    for (const Finding& f : findings) json["findings"].push_back(shown(*report->source, f));
    std::string error;
    const auto source = disk().read(row.path, &error);
    const bool same = source != nullptr && !row.hash.empty() && hash_of(source->bytes()) == row.hash;
    if (!same || settings == nullptr) {
      if (report != nullptr) json["source"] = kept_lines(*report->source, findings);
      return json;
    }
    const auto program = library_.load(source);
    json["source"] = shown_lines(*program, findings);
    const Linked linked(program, settings->profile, library_);
    const auto number_of_path = [this](const std::string& path) { return number_of(path); };
    json["modes"] = modes_json(linked, settings->profile, json["source"], number_of_path);
    if (kinds_[number] == kProgram) json["extents"] = page_extents(source, settings->profile, number_of_path);
    if (program->blocks.empty() && program->calls.empty() && program->regions.size() < 2) return json;
    constexpr size_t kMost = 2000;  // more than that nobody can look at
    note_calls(number, linked);
    if (program->blocks.size() + program->regions.size() + program->calls.size() > kMost) return json;
    json["blocks"] = blocks_json(linked, number_of_path);
    return json;
  }

  /// The page's number of a file; -1 for one that is not in it.
  int number_of(const std::string& path) const {
    const auto at = number_.find(file_key(path));
    return at == number_.end() ? -1 : static_cast<int>(at->second);
  }

  /// A finding whose paths are those of the page.
  Json shown(const Source& source, Finding f) const {
    for (std::string* words : {&f.message, &f.help, &f.interpreter}) *words = paths_.text(*words);
    for (Related& place : f.related) place.message = paths_.text(place.message);
    for (Related& place : f.path) place.message = paths_.text(place.message);
    for (Fix& fix : f.fixes) fix.title = paths_.text(fix.title);
    for (Consequence& c : f.consequences) c.interpreter = paths_.text(c.interpreter);
    Json json = finding_json(source, f);
    json["pathFrom"] = f.related.size();
    if (f.arc != nullptr) json["arc"] = {{"words", arc_sentence(*f.arc)}, {"drawing", arc_svg(*f.arc)}};
    size_t at = 0;
    for (const auto* places : {&f.related, &f.path}) {
      for (const Related& place : *places) {
        const std::string& path = place.source == nullptr ? source.path() : place.source->path();
        json["related"][at]["path"] = printable(paths_.path(path));
        json["related"][at++]["file"] = number_of(path);
      }
    }
    return json;
  }

  Json index() {
    Json index{{"schema", "owlint-page-2"},
               {"tool", {{"name", kToolName}, {"version", kToolVersion}}},
               {"made", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))}};
    for (const std::string& root : paths_.roots()) index["roots"].push_back(printable(root));
    for (const RunRow& run : runs_of(store_)) {
      if (run.state != "complete" || run.id > run_) continue;
      index["runs"].push_back({{"id", run.id},
                               {"started", run.started},
                               {"seconds", run.seconds},
                               {"version", run.version},
                               {"files", run.files},
                               {"checked", run.analysed},
                               {"errors", run.errors},
                               {"warnings", run.warnings},
                               {"infos", run.infos},
                               {"new", run.fresh},
                               {"gone", run.gone}});
    }
    Json rules = Json::array();
    Json found;
    Json lost;
    findings(found, rules);
    gone(lost, rules);
    index["rules"] = std::move(rules);
    index["files"] = files();
    index["findings"] = std::move(found);
    index["gone"] = std::move(lost);
    index["calls"] = calls();
    return index;
  }

  Json files() const {
    Json json;
    for (const char* column : {"path", "kind", "lines", "bytes", "part", "problem"}) json[column] = Json::array();
    for (size_t i = 0; i < programs_.size(); ++i) {
      json["path"].push_back(printable(paths_.path(programs_[i].path)));
      json["kind"].push_back(kinds_[i]);
      json["lines"].push_back(programs_[i].lines);
      json["bytes"].push_back(programs_[i].bytes);
      json["part"].push_back(part_[i]);
      json["problem"].push_back(printable(paths_.text(programs_[i].problem)));
    }
    return json;
  }

  size_t rule_number(std::string_view code, Json& rules) {
    const auto [at, added] = rules_.emplace(code, rules_.size());
    if (added) {
      const Rule* rule = find_rule(code);
      rules.push_back(
          {{"code", rule->code}, {"name", rule->name}, {"summary", rule->summary}, {"markdown", rule_page(*rule)}});
    }
    return at->second;
  }

  static int level(Severity severity) { return static_cast<int>(severity) - 1; }

  void findings(Json& json, Json& rules) {
    for (const char* column : {"file", "rule", "severity", "line", "column", "message", "fix", "isNew"})
      json[column] = Json::array();
    const int64_t before = run_before(store_, run_);
    std::map<std::string, size_t> fresh;  // how often a fingerprint is new
    if (before != 0) {
      difference_ = difference(store_, before, store_, run_);
      for (const StoredFinding& f : difference_.fresh) ++fresh[f.path + '\n' + f.fingerprint];
    }
    for (const FileReport& report : reports_) {
      const std::vector<std::string> prints = fingerprints(*report.source, report.findings);
      for (size_t i = 0; i < prints.size(); ++i) {
        const Finding& f = report.findings[i];
        const Position at = report.source->position(f.span.begin);
        json["file"].push_back(number_.at(report.source->path()));
        json["rule"].push_back(rule_number(f.code, rules));
        json["severity"].push_back(level(f.severity));
        json["line"].push_back(at.line);
        json["column"].push_back(at.column);
        json["message"].push_back(printable(paths_.text(f.message)));
        json["fix"].push_back(f.fixes.empty() ? 0 : std::ranges::any_of(f.fixes, &Fix::safe) ? 2 : 1);
        const auto is_new = fresh.find(report.source->path() + '\n' + prints[i]);
        json["isNew"].push_back(is_new != fresh.end() && is_new->second > 0 && is_new->second-- > 0 ? 1 : 0);
      }
    }
  }

  void gone(Json& json, Json& rules) {
    for (const char* column : {"path", "rule", "severity", "line", "message"}) json[column] = Json::array();
    std::vector<int64_t> ids;
    for (const StoredFinding& f : difference_.gone) ids.push_back(f.id);
    for (const FileReport& report : reports_of(store_, ids)) {
      for (const Finding& f : report.findings) {
        json["path"].push_back(printable(paths_.path(report.source->path())));
        json["rule"].push_back(rule_number(f.code, rules));
        json["severity"].push_back(level(f.severity));
        json["line"].push_back(report.source->position(f.span.begin).line);
        json["message"].push_back(printable(paths_.text(f.message)));
      }
    }
  }

  /// Which program calls which: as it was seen when the details were made, for the others with everything that is called from
  /// there too, because their analyses depend on it.
  Json calls() {
    Json json{{"from", Json::array()}, {"to", Json::array()}};
    const auto add = [&](size_t from, size_t to) {
      json["from"].push_back(from);
      json["to"].push_back(to);
    };
    for (const auto& [from, to] : direct_) add(from, to);
    SQLite::Statement all(store_.db(),
                          "SELECT file.path, fact.subject FROM rests_on JOIN fact ON fact.id = rests_on.fact JOIN file "
                          "ON file.id = rests_on.file WHERE fact.kind = 4 ORDER BY 1, 2");
    while (all.executeStep()) {
      const auto from = number_.find(all.getColumn(0).getString());
      const auto to = number_.find(all.getColumn(1).getString());
      if (from == number_.end() || to == number_.end() || from == to || linked_[from->second] != 0) continue;
      add(from->second, to->second);
    }
    return json;
  }

  /// The calls that are in the program itself.
  void note_calls(size_t from, const Linked& linked) {
    const Program& p = *linked.files()[0].program;
    std::set<size_t> called;
    for (const Call& call : p.calls) {
      if (call.callee == kNoName || call.target != kNoRegion) continue;
      const CallTarget target = linked.target(p.name(call.callee));
      if (target.file == CallTarget::kNotFound) continue;
      const auto to = number_.find(file_key(linked.files()[target.file].program->source->path()));
      if (to != number_.end() && to->second != from) called.insert(to->second);
    }
    const std::lock_guard lock(noting_);
    linked_[from] = 1;
    for (const size_t to : called) direct_.emplace(from, to);
  }

  std::ostream& out_;
  Store& store_;
  int64_t run_;
  checking::CheckRequest line_;
  checking::Configuration configuration_;
  ShownPaths paths_;
  Library library_{disk()};
  std::vector<ProgramRow> programs_;
  std::vector<Kind> kinds_;
  std::unordered_map<std::string, size_t> number_;
  std::vector<FileReport> reports_;
  std::vector<int> part_;
  std::mutex noting_;
  std::set<std::pair<size_t, size_t>> direct_;  // caller, called
  std::vector<char> linked_;                    // whose calls are in direct_
  std::map<std::string_view, size_t> rules_;
  Difference difference_;
};

}  // namespace

bool has_page() { return !page_template().empty(); }

void write_page(std::ostream& out, Store& store, int64_t run, const checking::CheckRequest& line) {
  Page(out, store, run, line).write();
}

}  // namespace owlint::audit
