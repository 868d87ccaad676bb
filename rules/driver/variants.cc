#include "rules/driver/variants.h"

#include <algorithm>
#include <map>
#include <set>

namespace owlint {
namespace {

/// What one file's findings are in each of several runs of the rules.
using Lists = std::vector<std::vector<Finding>>;

/// Puts the reports of one program together. `join` makes one list of a file's findings from one list per report.
template <typename Join>
ProgramReport join_reports(std::vector<ProgramReport> reports, const Join& join) {
  ProgramReport out = std::move(reports.back());
  const size_t count = reports.size();
  Lists own(count);
  std::map<std::shared_ptr<const Source>, Lists> called;
  std::vector<std::shared_ptr<const Source>> order;
  for (size_t i = 0; i < count; ++i) {
    ProgramReport& r = i + 1 == count ? out : reports[i];
    own[i] = std::move(r.own.findings);
    for (FileReport& file : r.called) {
      Lists& lists = called[file.source];
      if (lists.empty()) order.push_back(file.source);
      lists.resize(count);
      lists[i] = std::move(file.findings);
    }
    if (&r == &out) continue;
    out.own.effort.steps += r.own.effort.steps;
    out.own.effort.merges += r.own.effort.merges;
    // What is asked may differ from one to the next.
    out.inputs.answers.insert(out.inputs.answers.end(), r.inputs.answers.begin(), r.inputs.answers.end());
    out.inputs.called.insert(out.inputs.called.end(), r.inputs.called.begin(), r.inputs.called.end());
    out.inputs.compared.merge(r.inputs.compared);
    out.calls.insert(out.calls.end(), r.calls.begin(), r.calls.end());
    out.python.insert(out.python.end(), r.python.begin(), r.python.end());
  }
  for (auto* names : {&out.calls, &out.python}) {
    std::set<std::string> known;
    std::erase_if(*names, [&](const std::string& name) { return !known.insert(name).second; });
  }
  out.own.findings = join(*out.own.source, std::move(own));
  out.called.clear();
  for (const auto& source : order) {
    FileReport& file = out.called.emplace_back();
    file.source = source;
    file.findings = join(*source, std::move(called[source]));
  }
  return out;
}

bool worse(const Finding& a, const Finding& b) {
  return a.severity > b.severity || (a.severity == b.severity && a.stops && !b.stops);
}
bool as_bad(const Finding& a, const Finding& b) { return a.severity == b.severity && a.stops == b.stops; }

}  // namespace

std::vector<Finding> join_versions(const Source&, Lists by_version) {
  std::vector<Finding> findings;
  std::vector<std::vector<size_t>> versions;
  std::map<FindingPlace, size_t> known;
  for (size_t version = 0; version < by_version.size(); ++version) {
    for (Finding& f : by_version[version]) {
      const auto [entry, added] = known.emplace(place_of(f), findings.size());
      if (added) {
        findings.push_back(std::move(f));
        versions.push_back({version});
        continue;
      }
      Finding& same = findings[entry->second];
      auto& in = versions[entry->second];
      if (worse(f, same)) {
        same = std::move(f);
        in = {version};
      } else if (as_bad(f, same) && in.back() != version) {
        in.push_back(version);
      }
    }
  }
  for (size_t i = 0; i < findings.size(); ++i) {
    if (versions[i].size() == by_version.size()) continue;
    for (const size_t version : versions[i]) findings[i].versions.emplace_back(version_text(kAllVersions[version]));
  }
  put_in_order(findings);
  return findings;
}

namespace {

bool on_deleted_line(const Source& source, const Finding& f) {
  const std::string_view bytes = source.bytes();
  const size_t feed = f.span.begin == 0 ? std::string_view::npos : bytes.rfind('\n', f.span.begin - 1);
  const size_t first = bytes.find_first_not_of(" \t", feed == std::string_view::npos ? 0 : feed + 1);
  return first != std::string_view::npos && bytes[first] == '/';
}

/// Whether one way of running the program is enough for the finding to be true. The others say that something never happens.
bool enough_once(const Finding& f) {
  return f.stops || f.further || f.never_ends || f.runs_other || rule_of(f).group == Group::kHazards;
}

void depends_on(Finding& f, bool on) {
  f.block_delete = on ? "on" : "off";
  if (f.reach == Reach::kAlways) f.reach = Reach::kMaybe;
  f.path.insert(f.path.begin(),
                {f.span,
                 on ? "when block delete is on, as when LinuxCNC starts (lines that begin with `/` are skipped)"
                    : "when block delete is off (lines that begin with `/` run)",
                 nullptr});
  // The fix is made of the lines that run in this case, and may be wrong in the other one. Another block's label on a part or an
  // end is, as a rule.
  if (rule_of(f).group == Group::kAbortList && f.code > "OW104") f.fixes.clear();
  for (Fix& fix : f.fixes) fix.safe = false;
}

/// What the same finding says of the other setting, where it stops in other ways.
void stops_also(Finding& f, const Finding& other) {
  const auto add = [&](const Consequence& stop) {
    const bool known = stop.interpreter.empty() || stop.interpreter == f.interpreter ||
        std::ranges::any_of(f.consequences, [&](const Consequence& c) {
                         return c.span == stop.span && c.interpreter == stop.interpreter;
                       });
    if (!known) f.consequences.push_back(stop);
  };
  if (other.stops) add({other.code, other.span, other.interpreter});
  for (const Consequence& stop : other.consequences) add(stop);
}

/// Puts together what is found with block delete off and on.
std::vector<Finding> join_settings(const Source& source, Lists on_and_off) {
  std::vector<Finding>& on = on_and_off[0];
  std::vector<Finding>& off = on_and_off[1];
  std::map<FindingPlace, Finding*> in_on;
  for (Finding& f : on) in_on.emplace(place_of(f), &f);
  std::vector<Finding> findings;
  for (Finding& f : off) {
    const auto found = in_on.find(place_of(f));
    if (found == in_on.end()) {
      if (!enough_once(f) && !on_deleted_line(source, f)) continue;
      if (enough_once(f)) depends_on(f, false);
      findings.push_back(std::move(f));
      continue;
    }
    Finding& other = *found->second;
    in_on.erase(found);
    if (as_bad(f, other)) {
      if (!enough_once(f) && f.message != other.message) continue;  // true every time here, false every time there
      if (f.reach != other.reach) f.reach = Reach::kMaybe;
      stops_also(f, other);
      findings.push_back(std::move(f));
    } else if (f.stops && other.stops) {  // surely in one case, perhaps in the other
      Finding& surer = worse(other, f) ? other : f;
      if (f.reach != other.reach) surer.reach = Reach::kMaybe;
      stops_also(surer, &surer == &f ? other : f);
      findings.push_back(std::move(surer));
    } else if (worse(other, f)) {
      depends_on(other, true);
      findings.push_back(std::move(other));
    } else {
      depends_on(f, false);
      findings.push_back(std::move(f));
    }
  }
  for (auto& [place, f] : in_on) {
    if (!enough_once(*f)) continue;
    depends_on(*f, true);
    findings.push_back(std::move(*f));
  }
  put_in_order(findings);
  return findings;
}

ProgramReport lint_both_settings(const std::shared_ptr<const Program>& program, const Profile& profile,
                                 const LintOptions& options, Library& library) {
  ProgramReport off = lint_one_way(program, profile, options, library);
  if (!off.deletes_lines) return off;
  Profile with = profile;
  with.block_delete = true;
  LintOptions others = options;
  others.known_calls = nullptr;  // it belongs to the program as it is now
  std::vector<ProgramReport> reports;
  reports.push_back(lint_one_way(program, with, others, library));
  reports.push_back(std::move(off));
  return join_reports(std::move(reports),
                      [](const Source& source, Lists lists) { return join_settings(source, std::move(lists)); });
}

}  // namespace

ProgramReport lint_all_ways(const std::shared_ptr<const Program>& program, const Profile& profile,
                            const LintOptions& options, Library& library) {
  if (!options.all_versions) return lint_both_settings(program, profile, options, library);
  std::vector<ProgramReport> reports;
  for (const Version version : kAllVersions) {
    Profile one = profile;
    one.version = version;
    one.version_given = true;
    reports.push_back(lint_both_settings(program, one, options, library));
  }
  return join_reports(std::move(reports), join_versions);
}

}  // namespace owlint
