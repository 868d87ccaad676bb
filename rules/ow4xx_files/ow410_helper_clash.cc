// OW410 helper-clash: a call runs a sub of another file, although its own file has a sub with that label.
// Depends on: all files share one table of subs. The first `sub` line that is read enters its label, for the whole run.
#include <map>
#include <set>

#include "rules/driver/stops.h"

namespace owlint::rules::ow410 {
namespace {

/// The line on which this file defines the sub that a call was meant for.
StatementId own_sub(const Program& p, NameId sub) {
  for (const StatementId id : p.by_label[sub]) {
    if (p.at(id).opens_sub()) return id;
  }
  return kNoStatement;
}

/// The lines of a sub, without blanks and empty lines.
std::string body(const Program& p, StatementId opener) {
  const Region& region = p.regions[p.region_of[opener]];
  if (region.opener != opener || region.end == kNoStatement) return {};
  std::string text = small_letters(p.source->slice({p.at(opener).offset, p.at(region.end).end()}));
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
  text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == '\n' && b == '\n'; }), text.end());
  return text;
}

/// Whether the sub that runs does what the one in this file does.
bool is_copy(const Program& p, StatementId call, const Elsewhere& runs) {
  const NameId label = p.at(call).label;
  const StatementId own = label == kNoName ? kNoStatement : own_sub(p, label);
  if (own == kNoStatement) return false;
  const std::string text = body(p, own);
  return !text.empty() && text == body(*runs.program, runs.statement);
}

/// A call that may run one of several subs, all of other files, is one finding; so are all calls of one label.
void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::vector<Finding> findings;
  std::map<std::string, size_t> by_label;
  std::set<StatementId> calls;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kOtherHelper || h.other_elsewhere.program == nullptr) continue;
    const Elsewhere& runs = h.other_elsewhere;
    if (is_copy(p, h.statement, runs)) continue;
    const bool first_place = calls.insert(h.statement).second;
    const auto [known, added] = by_label.emplace(runs.program->head(runs.statement), findings.size());
    if (!added) {
      Finding& f = findings[known->second];
      f.unproven = f.unproven && (h.unproven || h.not_always);
      if (first_place) relate(f, p, h.statement, "so does this call");
      continue;
    }
    const Statement& s = p.at(h.statement);
    Finding& f = findings.emplace_back();
    f.span = s.head_span();
    f.message = "`" + p.head(h.statement) + (h.not_always ? "` may run `" : "` runs `") +
        runs.program->head(runs.statement) + "` of " + file_name(*runs.program->source) + ", not the sub in this file";
    // A file is looked for if the call comes before the sub of its own file.
    const bool by_name = s.label != kNoName && own_sub(p, s.label) > h.statement && runs.program->sub_file &&
        runs.program->name(runs.program->entry) == p.name(s.label);
    relate(in, f, runs,
           by_name            ? "this sub runs: LinuxCNC has not read the one of this file yet"
               : h.not_always ? "this sub runs if LinuxCNC has read it first"
                              : "this sub runs: LinuxCNC read it first");
    if (s.label != kNoName)
      relate(f, p, own_sub(p, s.label), h.not_always ? "this sub runs otherwise" : "this sub does not run");
    f.help = "give the sub in this file a name that no other file uses, or move it to a file of its own";
    f.reach = h.reach;
    f.runs_other = true;
    f.unproven = h.unproven || h.not_always;
  }
  for (Finding& f : findings) {
    Finding& added = out.add(f.span, std::move(f.message));
    f.code = added.code;
    f.rule = added.rule;
    f.message = std::move(added.message);
    added = std::move(f);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW410",
    .name = "helper-clash",
    .summary = "two files have a helper sub with the same label: LinuxCNC always calls the first one",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A file calls a helper sub that it defines itself, but another file of the same run has a sub with
the same label.)",
            .why = R"(LinuxCNC has one table of subs for the whole run, not one for each file. The first `o500 sub` that
it reads goes into the table. Every later `o500 call`, from any file, runs that one. In the example
the machine moves to X1 twice and never to X9. There is no message, and each of the two files works
when it is used alone.

LinuxCNC 2.10 does not accept helpers in called files (OW403), but it still runs a sub of the main
program with the same label.)",
            .bad = R"(G21 G90
o<probe_left> call
o<probe_right> call
M2
; file: probe_left.ngc
o<probe_left> sub
  o500 call
o<probe_left> endsub
o500 sub
  G0 X1
o500 endsub
; file: probe_right.ngc
o<probe_right> sub
  o500 call
o<probe_right> endsub
o500 sub
  G0 X9
o500 endsub
)",
            .good = R"(G21 G90
o<probe_left> call
o<probe_right> call
M2
; file: probe_left.ngc
o<probe_left> sub
  o<go_left> call
o<probe_left> endsub
; file: go_left.ngc
o<go_left> sub
  G0 X1
o<go_left> endsub
; file: probe_right.ngc
o<probe_right> sub
  o<go_right> call
o<probe_right> endsub
; file: go_right.ngc
o<go_right> sub
  G0 X9
o<go_right> endsub
)",
            .fix = R"(Move each helper to a file of its own, with the helper's name, or at least give it a label that no
other file uses, such as `o<probe_right_500>`.)",
            .level_reason = "Error if every run that makes the call gets to the other sub: other lines run than "
                            "intended. Warning if some runs get to the right one, or owlint is not sure.",
            .interpreter = "",
            .options = "",
            .moves = "X1",
            .moves_good = "X9",
        },
    .check = check,
    .helper_clash = true,
};

}  // namespace owlint::rules::ow410
