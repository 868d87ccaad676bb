#include "rules/lint.h"

#include <algorithm>
#include <tuple>

#include "analyzer/flow/data_flow.h"
#include "analyzer/flow/known_calls.h"

namespace owlint {
namespace {

/// Length of the longest of `prefixes` that `code` begins with; -1 if none.
int longest_fit(std::string_view code, const std::vector<std::string>& prefixes) {
  int longest = -1;
  for (const std::string& prefix : prefixes) {
    if (code.starts_with(prefix)) longest = std::max(longest, static_cast<int>(prefix.size()));
  }
  return longest;
}

/// Whether a fix changes the number of lines in a program that asks for it.
bool moves_lines(const Program& program, const Fix& fix) {
  if (program.syntax.names.find("_line") == kNoName) return false;
  return std::ranges::any_of(fix.edits, [&](const Edit& edit) {
    return std::ranges::count(edit.text, '\n') != std::ranges::count(program.source->slice(edit.span), '\n');
  });
}

void run_rules(const Input& input, const LintOptions& options, const SeverityPolicy& policy, std::vector<Finding>& out) {
  for (const Rule* rule : catalogue()) {
    if (input.suppressions_applied && rule->group != Group::kLinter) continue;
    if (!selected(*rule, options)) continue;
    const size_t first = out.size();
    Reporter reporter(*rule, out);
    rule->check(input, reporter);
    for (size_t i = first; i < out.size(); ++i) {
      out[i].severity = decide_severity(out[i], rule->level, rule->group == Group::kAbortList, policy);
      for (Fix& fix : out[i].fixes) {
        if (moves_lines(input.program, fix)) fix.safe = false;
        if (fix.if_all_stop) fix.safe = fix.safe && out[i].stops && out[i].reach == Reach::kAlways;
      }
    }
  }
}

}  // namespace

bool selected(const Rule& rule, const LintOptions& options) {
  int wanted = rule.level == Severity::kInfo ? -1 : 0;
  if (options.select.empty() && options.extend_select.empty() && options.ignore.empty()) return wanted == 0;
  if (!options.select.empty()) wanted = longest_fit(rule.code, options.select);
  wanted = std::max(wanted, longest_fit(rule.code, options.extend_select));
  return wanted >= 0 && longest_fit(rule.code, options.ignore) < std::max(wanted, 1);
}

namespace {

SeverityPolicy policy_of(const Profile& profile, const LintOptions& options) { return {profile.warn_only(), options.severity}; }

std::vector<Suppression> suppressions_of(const Program& program) {
  std::vector<Suppression> suppressions;
  for (const Directive& directive : program.syntax.directives) {
    for (Suppression& s : parse_suppressions(*program.source, directive.span, directive.line, directive.own_line)) {
      suppressions.push_back(std::move(s));
    }
  }
  return suppressions;
}

using Place = std::tuple<uint64_t, uint64_t, std::string_view>;
Place place_of(const Finding& f) { return {f.span.begin, f.span.end, f.code}; }

void put_in_order(std::vector<Finding>& findings) {
  std::erase_if(findings, [](const Finding& f) { return f.severity == Severity::kOff; });
  const auto key = [](const Finding& f) { return std::tie(f.span.begin, f.span.end, f.code, f.message); };
  std::ranges::stable_sort(findings, [&](const Finding& a, const Finding& b) { return key(a) < key(b); });
}

/// One program under one version.
class Check {
 public:
  Check(const Profile& profile, const LintOptions& options, Library& library) : profile_(profile), options_(options), library_(library) {}

  ProgramReport run(const std::shared_ptr<const Program>& program) {
    Linked linked(program, profile_, library_, options_.notes_inputs);
    flow::KnownCalls* const known = options_.known_calls;
    if (known == nullptr) return report(program, linked, analyze_flow(linked, profile_, options_.detail));
    known->next_check();
    for (;;) {
      const std::vector<FlowResult> flow = analyze_flow(linked, profile_, options_.detail, known);
      ProgramReport out = report(program, linked, flow);
      if (remember(flow[0], *known)) return out;  // the second time at the latest: then nothing was known before
    }
  }

 private:
  ProgramReport report(const std::shared_ptr<const Program>& program, const Linked& linked, const std::vector<FlowResult>& flow) const {
    ProgramReport out;
    out.sub_file = program->sub_file;
    out.only_definitions = program->regions.size() > 1 && does_nothing(*program);
    out.role_matters = !program->sub_file && defines_own_name(*program);
    out.own = check_file(program, flow[0], linked, true);
    out.own.statistics = flow[0].statistics;
    for (size_t i = 1; i < linked.files().size(); ++i) {
      const LinkedFile& file = linked.files()[i];
      out.calls.push_back(file.program->source->path());
      if (flow[i].stops.empty() && flow[i].hazards.empty()) continue;
      FileReport called = check_file(file.program, flow[i], linked, false);
      if (!called.findings.empty()) out.called.push_back(std::move(called));
    }
    if (profile_.may_be_python()) out.python = unknown_names(linked);
    if (options_.notes_inputs) out.inputs = inputs_of(linked);
    return out;
  }

  static Inputs inputs_of(const Linked& linked) {
    const Answers& answers = linked.search_path();
    Inputs inputs{answers.path(), answers.noted(), {}, answers.compared()};
    for (size_t i = 1; i < linked.files().size(); ++i) inputs.called.push_back(linked.files()[i].program->source);
    return inputs;
  }

  FileReport check_file(const std::shared_ptr<const Program>& program, const FlowResult& flow, const Linked& linked, bool own) const {
    FileReport report;
    report.source = program->source;
    std::vector<Suppression> suppressions = suppressions_of(*program);
    const Index index(*program, flow);
    const flow::DataFlow data(*program, flow.structure);
    const SeverityPolicy policy = policy_of(profile_, options_);
    run_rules({*program, flow, profile_, linked, suppressions, index, data, false}, options_, policy, report.findings);
    if (!own) {
      // Of a called file only what this program's calls lead to; the rest is reported when the file itself is checked.
      std::erase_if(report.findings, [](const Finding& f) {
        return !f.stops && !f.never_ends && find_rule(f.code)->group != Group::kHazards;
      });
    }
    apply_suppressions(*program->source, suppressions, report.findings);
    if (own) run_rules({*program, flow, profile_, linked, suppressions, index, data, true}, options_, policy, report.findings);
    for (Finding& f : report.findings) {
      if (f.source == nullptr) f.scope = scope_of(*program, f.span.begin);
    }
    put_in_order(report.findings);
    return report;
  }

  /// The sub and the block that a place belongs to.
  static std::string scope_of(const Program& p, uint64_t offset) {
    const auto after = std::ranges::upper_bound(p.syntax.statements, offset, {}, &Statement::offset);
    if (after == p.syntax.statements.begin()) return {};
    const auto id = static_cast<StatementId>(after - p.syntax.statements.begin() - 1);
    const Region& region = p.regions[p.region_of[id]];
    const bool on_line = offset <= p.at(id).end();
    std::string scope = region.name == kNoName || (region.end == id && !on_line) ? std::string() : p.label_text(region.name);
    if (on_line && p.block_of[id] != kNoBlock) scope += (scope.empty() ? "" : " ") + p.label_text(p.blocks[p.block_of[id]].label);
    return scope;
  }

  static std::vector<std::string> unknown_names(const Linked& linked) {
    std::vector<std::string> names;
    for (const LinkedFile& file : linked.files()) {
      const Program& p = *file.program;
      for (const Call& call : p.calls) {
        if (call.callee == kNoName || call.target != UINT32_MAX) continue;
        if (linked.target(p.name(call.callee)).file == CallTarget::kNotFound) names.push_back(p.label_text(call.callee));
      }
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
  }

  const Profile& profile_;
  const LintOptions& options_;
  Library& library_;
};

/// Puts together what the versions say of one file: a finding is reported once, with the versions in which it is worst.
void join_versions(std::vector<Finding>& findings, std::vector<std::pair<Version, std::vector<Finding>>> by_version) {
  std::vector<std::vector<Version>> versions;
  std::map<Place, size_t> known;
  for (auto& [version, found] : by_version) {
    for (Finding& f : found) {
      const auto [entry, added] = known.emplace(place_of(f), findings.size());
      if (added) {
        findings.push_back(std::move(f));
        versions.push_back({version});
        continue;
      }
      Finding* same = &findings[entry->second];
      auto& in = versions[entry->second];
      if (f.severity > same->severity || (f.severity == same->severity && f.stops && !same->stops)) {
        *same = std::move(f);
        in = {version};
      } else if (f.severity == same->severity && f.stops == same->stops) {
        if (in.back() != version) in.push_back(version);
      }
    }
  }
  for (size_t i = 0; i < findings.size(); ++i) {
    if (versions[i].size() == std::size(kAllVersions)) continue;
    for (const Version version : versions[i]) findings[i].versions.emplace_back(version_text(version));
  }
  put_in_order(findings);
}

ProgramReport check_all_versions(const std::shared_ptr<const Program>& program, const Profile& profile, const LintOptions& options, Library& library) {
  ProgramReport report;
  std::vector<std::pair<Version, std::vector<Finding>>> own;
  std::map<std::shared_ptr<const Source>, std::vector<std::pair<Version, std::vector<Finding>>>> called;
  std::vector<std::shared_ptr<const Source>> order;
  for (const Version version : kAllVersions) {
    Profile one = profile;
    one.version = version;
    one.version_given = true;
    ProgramReport r = Check(one, options, library).run(program);
    own.emplace_back(version, std::move(r.own.findings));
    for (FileReport& file : r.called) {
      auto& list = called[file.source];
      if (list.empty()) order.push_back(file.source);
      list.emplace_back(version, std::move(file.findings));
    }
    report.own.source = r.own.source;
    report.own.statistics.steps += r.own.statistics.steps;
    report.own.statistics.merges += r.own.statistics.merges;
    report.calls = std::move(r.calls);
    report.python = std::move(r.python);
    report.sub_file = r.sub_file;
    report.only_definitions = r.only_definitions;
    report.role_matters = r.role_matters;
    // What is asked may differ from version to version.
    auto& answers = report.inputs.answers;
    answers.insert(answers.end(), r.inputs.answers.begin(), r.inputs.answers.end());
    report.inputs.search_path = r.inputs.search_path;
    report.inputs.called.insert(report.inputs.called.end(), r.inputs.called.begin(), r.inputs.called.end());
    report.inputs.compared.merge(r.inputs.compared);
  }
  join_versions(report.own.findings, std::move(own));
  for (const auto& source : order) {
    FileReport& file = report.called.emplace_back();
    file.source = source;
    join_versions(file.findings, std::move(called[source]));
  }
  return report;
}

}  // namespace

ProgramReport lint(const std::shared_ptr<const Program>& program, const Profile& profile, const LintOptions& options,
                   Library& library, Role role) {
  std::shared_ptr<const Program> checked = program;
  if (role == Role::kSubFile && !program->sub_file && defines_own_name(*program)) {
    std::shared_ptr<Program> copy = build_program(program->source);
    treat_as_sub_file(*copy);
    checked = std::move(copy);
  }
  if (options.all_versions) return check_all_versions(checked, profile, options, library);
  return Check(profile, options, library).run(checked);
}

FileReport lint(std::shared_ptr<const Source> source, const Profile& profile, const LintOptions& options) {
  Library library;
  return lint(library.load(std::move(source)), profile, options, library).own;
}

std::vector<FileReport> lint_setup(const Profile& profile, const LintOptions& options, Library& library) {
  std::vector<Finding> findings;
  const SeverityPolicy policy = policy_of(profile, options);
  for (const Rule* rule : catalogue()) {
    if (rule->check_setup == nullptr || !selected(*rule, options)) continue;
    const size_t first = findings.size();
    Reporter reporter(*rule, findings);
    rule->check_setup({*profile.setup, profile, library}, reporter);
    for (size_t i = first; i < findings.size(); ++i) findings[i].severity = decide_severity(findings[i], rule->level, false, policy);
  }
  std::vector<FileReport> reports;
  for (Finding& f : findings) {
    auto file = std::ranges::find(reports, f.source, &FileReport::source);
    if (file == reports.end()) file = reports.insert(reports.end(), {f.source, {}, {}});
    file->findings.push_back(std::move(f));
  }
  for (FileReport& report : reports) put_in_order(report.findings);
  return reports;
}

void merge_findings(FileReport& into, std::vector<Finding> findings) {
  constexpr size_t kMaxCalls = 4;  // more places of calls are no help
  std::map<Place, size_t> places;
  for (size_t i = 0; i < into.findings.size(); ++i) places.emplace(place_of(into.findings[i]), i);
  for (Finding& f : findings) {
    const auto [entry, added] = places.emplace(place_of(f), into.findings.size());
    if (added) {
      into.findings.push_back(std::move(f));
      continue;
    }
    Finding* same = &into.findings[entry->second];
    if (f.severity > same->severity) std::swap(f, *same);
    for (Related& related : f.related) {
      if (related.source == nullptr || same->related.size() >= kMaxCalls) continue;
      const bool known = std::ranges::any_of(same->related, [&](const Related& r) {
        return r.source != nullptr && r.source->path() == related.source->path() && r.span == related.span;
      });
      if (!known) same->related.push_back(std::move(related));
    }
  }
  put_in_order(into.findings);
}

}  // namespace owlint
