#include "rules/driver/lint.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "analyzer/flow/engine/known_calls.h"
#include "analyzer/flow/summaries/data_flow.h"
#include "analyzer/flow/verdicts/analyze.h"
#include "analyzer/program/machine_words.h"
#include "analyzer/syntax/last_statement.h"
#include "analyzer/text/memory_files.h"
#include "rules/driver/folding.h"
#include "rules/driver/stops.h"
#include "rules/driver/unreached.h"
#include "rules/driver/variants.h"

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

/// How much a rule's findings in a file matter: little if the file is no LinuxCNC program, which one rule reports.
Weight weight_of(const Rule& rule, const Nature& nature) {
  if (nature.kind == Nature::kProgram || rule.group == Group::kLinter) return Weight::kFull;
  if (nature.kind == Nature::kOtherController) return rule.other_controller ? Weight::kFull : Weight::kAside;
  return rule.any_file ? Weight::kFull : Weight::kRemark;
}

void run_rules(const Input& input, const LintOptions& options, const SeverityPolicy& policy,
               std::vector<Finding>& out) {
  std::optional<rules::Unreached> unreached;
  for (const Rule* rule : catalogue()) {
    if (input.suppressions_applied && rule->group != Group::kLinter) continue;
    if (!selected(*rule, options)) continue;
    const size_t first = out.size();
    Reporter reporter(*rule, out);
    rule->check(input, reporter);
    const Weight weight = weight_of(*rule, input.index.nature);
    for (size_t i = first; i < out.size(); ++i) {
      out[i].weight = std::max(out[i].weight, weight);
      out[i].severity = decide_severity(out[i], rule->level, rule->group == Group::kAbortList, policy);
      if (out[i].habit_severity) {
        const Weight full = std::exchange(out[i].weight, Weight::kAside);
        out[i].habit_severity = decide_severity(out[i], rule->level, rule->group == Group::kAbortList, policy);
        out[i].weight = full;
      }
      if (out[i].reach == Reach::kNever && rule->level == Severity::kError && out[i].source == nullptr) {
        if (!unreached) unreached.emplace(input);
        if (auto reason = unreached->reason(out[i].span.begin)) out[i].path.push_back(std::move(*reason));
      }
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

SeverityPolicy policy_of(const Profile& profile, const LintOptions& options) {
  SeverityPolicy policy{profile.warn_only(), options.severity, options.select};
  policy.selected.insert(policy.selected.end(), options.extend_select.begin(), options.extend_select.end());
  return policy;
}

namespace {

std::vector<Suppression> suppressions_of(const Program& program) {
  std::vector<Suppression> suppressions;
  for (const Directive& directive : program.syntax.directives) {
    for (Suppression& s :
         parse_suppressions(*program.source, directive.span, directive.line, directive.own_line, suppressed_code)) {
      suppressions.push_back(std::move(s));
    }
  }
  return suppressions;
}

/// What is behind a stop that is suppressed or not selected: its author says that the line runs, so those behind it do as well.
void raise_behind_suppressed(const SeverityPolicy& policy, std::vector<Finding>& findings) {
  if (std::ranges::any_of(findings, rules::stops_every_run)) return;
  for (Finding& f : findings) {
    if (!f.group.starts_with(rules::kBehind)) continue;
    f.stops = true;
    f.reach = Reach::kMaybe;
    f.path.clear();
    const Rule& rule = rule_of(f);
    f.severity = decide_severity(f, rule.level, rule.group == Group::kAbortList, policy);
  }
}

}  // namespace

void put_in_order(std::vector<Finding>& findings) {
  std::erase_if(findings, [](const Finding& f) { return f.severity == Severity::kOff; });
  const auto key = [](const Finding& f) {
    return std::tuple(f.span.begin, f.span.end, f.code, std::string_view(f.message));
  };
  std::ranges::stable_sort(findings, [&](const Finding& a, const Finding& b) { return key(a) < key(b); });
  // In a file for another controller that is said first.
  std::stable_partition(findings.begin(), findings.end(), [](const Finding& f) { return rule_of(f).other_controller; });
}

namespace {

/// One program under one version and one setting of block delete.
class Check {
 public:
  Check(const Profile& profile, const LintOptions& options, Library& library)
      : profile_(profile), options_(options), library_(library) {}

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
  ProgramReport report(const std::shared_ptr<const Program>& program, const Linked& linked,
                       const std::vector<FlowResult>& flow) const {
    ProgramReport out;
    out.deletes_lines = linked.deletes_lines();
    out.sub_file = program->sub_file;
    out.only_definitions = program->regions.size() > 1 && does_nothing(*program);
    out.role_matters = !program->sub_file && defines_own_name(*program);
    out.own = check_file(linked.files()[0].program, flow[0], linked, true);
    const FlowStatistics& statistics = flow[0].statistics;
    out.own.effort = {statistics.steps, statistics.merges, statistics.recalled};
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

  FileReport check_file(const std::shared_ptr<const Program>& program, const FlowResult& flow, const Linked& linked,
                        bool own) const {
    FileReport report;
    report.source = program->source;
    std::vector<Suppression> suppressions = suppressions_of(*program);
    const WordsOfMachine machine(profile_);
    const Index index(*program, flow, machine.words, own && !program->sub_file);
    const flow::DataFlow data(*program, flow.structure);
    std::unordered_set<long> given_numbers;
    const SeverityPolicy policy = policy_of(profile_, options_);
    run_rules({*program, flow, profile_, linked, suppressions, index, data, given_numbers, false}, options_, policy,
              report.findings);
    if (!own) {
      // Of a called file only what this program's calls lead to; the rest is reported when the file itself is checked.
      std::erase_if(report.findings, [](const Finding& f) {
        return !f.stops && !f.further && !f.never_ends && !f.runs_other && rule_of(f).group != Group::kHazards;
      });
    }
    apply_suppressions(*program->source, suppressions, report.findings);
    raise_behind_suppressed(policy, report.findings);
    rules::fold_consequences(*program, flow, report.findings);
    if (own)
      run_rules({*program, flow, profile_, linked, suppressions, index, data, given_numbers, true}, options_, policy,
                report.findings);
    for (Finding& f : report.findings) {
      if (f.source == nullptr) f.scope = scope_of(*program, f.span.begin);
    }
    put_in_order(report.findings);
    return report;
  }

  /// The sub and the block that a place belongs to.
  static std::string scope_of(const Program& p, uint64_t offset) {
    const StatementId id = last_statement(p.syntax, offset);
    if (id == kNoStatement) return {};
    const Region& region = p.regions[p.region_of[id]];
    const bool on_line = offset <= p.at(id).end();
    std::string scope =
        region.name == kNoName || (region.end == id && !on_line) ? std::string() : p.label_text(region.name);
    if (on_line && p.block_of[id] != kNoBlock)
      scope += (scope.empty() ? "" : " ") + p.label_text(p.blocks[p.block_of[id]].label);
    return scope;
  }

  static std::vector<std::string> unknown_names(const Linked& linked) {
    std::vector<std::string> names;
    for (const LinkedFile& file : linked.files()) {
      const Program& p = *file.program;
      for (const Call& call : p.calls) {
        if (call.callee == kNoName || call.target != kNoRegion) continue;
        if (linked.target(p.name(call.callee)).file == CallTarget::kNotFound)
          names.push_back(p.label_text(call.callee));
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

}  // namespace

ProgramReport lint(const std::shared_ptr<const Program>& program, const Profile& profile, const LintOptions& options,
                   Library& library, Role role) {
  std::shared_ptr<const Program> checked = program;
  if (role == Role::kSubFile && !program->sub_file && defines_own_name(*program)) {
    const WordsOfMachine machine(profile);
    std::shared_ptr<Program> copy = build_program(program->source, machine.words);
    treat_as_sub_file(*copy);
    checked = std::move(copy);
  }
  return lint_all_ways(checked, profile, options, library);
}

ProgramReport lint_one_way(const std::shared_ptr<const Program>& program, const Profile& profile,
                           const LintOptions& options, Library& library) {
  return Check(profile, options, library).run(program);
}

FileReport lint(std::shared_ptr<const Source> source, const Profile& profile, const LintOptions& options) {
  static const MemoryFiles none;
  Library library(none);
  return lint(library.load(std::move(source), profile), profile, options, library).own;
}

void merge_findings(FileReport& into, std::vector<Finding> findings) {
  constexpr size_t kMaxCalls = 4;  // more places of calls are no help
  std::map<FindingPlace, size_t> places;
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
