#include "rules/driver/folding.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "analyzer/syntax/last_statement.h"
#include "rules/driver/stops.h"

namespace owlint::rules {
namespace {

constexpr size_t kNone = SIZE_MAX;

/// A finding about one line of a block: the opener, a part, the end, a jump.
struct Part {
  size_t finding = kNone;
  StatementId statement = kNoStatement;
};

class Folding {
 public:
  Folding(const Program& program, const FlowResult& flow, std::vector<Finding>& findings)
      : p_(program), flow_(flow), findings_(findings), into_(findings.size(), kNone) {
    for (size_t i = 0; i < findings.size(); ++i) {
      const StatementId id = block_line(findings[i]);
      if (id != kNoStatement) parts_.push_back({i, id});
    }
  }

  void run() {
    std::ranges::sort(parts_, {}, &Part::statement);
    for (const Part& part : parts_) choose(part);
    for (const Part& part : parts_) fold_unclosed(part);
    for (const Part& part : parts_) fold_unreached(part);
    fold_into_wrong_body();
    fold_clashes();
    fold_left_out();
    move_folded();
  }

 private:
  using Label = std::pair<RegionId, NameId>;
  Label label_of(StatementId id) const { return {p_.region_of[id], p_.at(id).label}; }
  const Finding& finding(const Part& part) const { return findings_[part.finding]; }
  static bool unreached(const Finding& f) { return !f.stops && !f.never_ends && f.reach == Reach::kNever; }

  StatementId statement_of(const Finding& f) const {
    return f.source == nullptr ? last_statement(p_.syntax, f.span.begin) : kNoStatement;
  }

  /// The line of a block that a finding is about; none for other findings.
  StatementId block_line(const Finding& f) const {
    const Group group = rule_of(f).group;
    if (f.source != nullptr || (group != Group::kAbortList && group != Group::kBlocks)) return kNoStatement;
    const StatementId id = last_statement(p_.syntax, f.span.begin);
    if (id == kNoStatement) return kNoStatement;
    const Statement& s = p_.at(id);
    const bool of_block = s.kind == LineKind::kOWord && !global_label(s.keyword) && s.label != kNoName;
    return of_block && f.span.begin < s.end() ? id : kNoStatement;
  }

  /// The block of which the line is the end, but for a wrong label.
  const Block* mistaken(StatementId id) const {
    const BlockId block = p_.block_of[id];
    return block != kNoBlock && p_.blocks[block].mistaken_end == id ? &p_.blocks[block] : nullptr;
  }

  /// The first stop at a label speaks for it, else the first finding.
  void choose(const Part& part) {
    const auto [known, added] = speaks_.emplace(label_of(part.statement), part);
    if (!added && !finding(known->second).stops && finding(part).stops) known->second = part;
    if (p_.block_of[part.statement] != kNoBlock && p_.blocks[p_.block_of[part.statement]].opener == part.statement)
      openers_.emplace(part.statement, part.finding);
  }

  /// A block that is not closed, and lines with the label that its end has by mistake: the first of these lines speaks
  /// for both if the interpreter stops there, else the block does.
  void fold_unclosed(const Part& part) {
    const Block* block = mistaken(part.statement);
    const auto opener = block == nullptr ? openers_.end() : openers_.find(block->opener);
    if (opener == openers_.end()) return;
    Part& speaker = speaks_.at(label_of(part.statement));
    if (speaker.finding == opener->second) return;
    if (finding(speaker).stops && speaker.statement > block->opener) {
      fold(opener->second, speaker.finding);
    } else if (unreached(finding(speaker)) && fold(speaker.finding, opener->second)) {
      speaker = {opener->second, block->opener};
    }
  }

  /// A stop at a label that another block has already.
  static bool label_reused(const Finding& f) { return f.stops && rule_of(f).label_reused; }

  /// One more block with a label at which a run stops, or that no run reaches, is the same mistake.
  void fold_unreached(const Part& part) {
    const Part& speaker = speaks_.at(label_of(part.statement));
    const bool same_label =
        label_reused(finding(speaker)) && (label_reused(finding(part)) || rule_of(finding(part)).label_shared);
    if (unreached(finding(part)) || same_label) fold(part.finding, speaker.finding);
  }

  /// The finding that is left of those that `i` is folded into; the ways there get shorter.
  size_t speaker_for(size_t i) {
    for (; into_[i] != kNone; i = into_[i]) {
      if (into_[into_[i]] != kNone) into_[i] = into_[into_[i]];
    }
    return i;
  }

  /// Folds a finding into another one, once, and never in a circle: of blocks that end each other by mistake, one is left.
  bool fold(size_t from, size_t into) {
    const size_t to = speaker_for(into);
    if (into_[from] != kNone || to == from) return false;
    into_[from] = to;
    return true;
  }

  /// Where another sub's lines run than those that are written, labels that do not fit are no mistakes of their own.
  void fold_into_wrong_body() {
    const auto wrong_body = std::ranges::find_if(findings_, &Finding::runs_other);
    if (wrong_body == findings_.end()) return;
    for (const Part& part : parts_) {
      const bool follows = finding(part).unproven && rule_of(finding(part)).group == Group::kAbortList;
      if (follows && into_[part.finding] == kNone)
        into_[part.finding] = static_cast<size_t>(wrong_body - findings_.begin());
    }
  }

  /// A call that runs another file's sub, where this file has its own inside another sub: to move that out corrects both.
  void fold_clashes() {
    std::map<NameId, size_t> inner;  // findings, by label
    for (size_t i = 0; i < findings_.size(); ++i) {
      const StatementId id = rule_of(findings_[i]).inner_sub ? statement_of(findings_[i]) : kNoStatement;
      if (id != kNoStatement && p_.at(id).opens_sub()) inner.emplace(p_.at(id).label, i);
    }
    if (inner.empty()) return;
    for (size_t i = 0; i < findings_.size(); ++i) {
      const StatementId id = rule_of(findings_[i]).helper_clash ? statement_of(findings_[i]) : kNoStatement;
      const auto found = id == kNoStatement ? inner.end() : inner.find(p_.at(id).label);
      if (found == inner.end() || !fold(i, found->second)) continue;
      Finding& speaker = findings_[speaker_for(found->second)];
      const Finding& clash = findings_[i];
      speaker.related.push_back({clash.span, clash.message, nullptr});
      for (const Related& related : clash.related) {
        if (related.span.begin != speaker.span.begin || related.source != nullptr) speaker.related.push_back(related);
      }
      speaker.unproven = speaker.unproven && clash.unproven;
      speaker.severity = std::max(speaker.severity, clash.severity);
    }
  }

  /// The line behind which no run goes on to `id`: a program end, a `return`, a condition that is never true. None where a stop
  /// is the reason, or where other programs may call the sub: there each mistake counts.
  StatementId left_out_behind(StatementId id, const std::vector<StatementId>& last) const {
    const RegionId region = p_.region_of[id];
    const StatementId opener = p_.regions[region].opener;
    StatementId behind = last[id];
    if (flow_.executed[id]) behind = id;  // the finding is about a line of words behind it
    if (region != kMainRegion && !flow_.executed[opener]) behind = last[opener];
    if (behind == kNoStatement || (region != kMainRegion && behind == opener)) return kNoStatement;
    const Statement& s = p_.at(behind);
    const bool stopped = s.is(Keyword::kCall) || s.kind == LineKind::kM98 ||
        std::ranges::binary_search(flow_.stops, behind, {}, &FlowStop::statement);
    return stopped ? kNoStatement : behind;
  }

  /// Mistakes in lines that every run leaves out are one: nobody looks at them as the program stands.
  void fold_left_out() {
    std::vector<size_t> candidates;
    for (size_t i = 0; i < findings_.size(); ++i) {
      const Finding& f = findings_[i];
      if (f.source == nullptr && into_[i] == kNone && unreached(f) && f.weight == Weight::kFull)
        candidates.push_back(i);
    }
    if (candidates.size() < 2) return;
    std::vector<StatementId> last(p_.size(),
                                  kNoStatement);  // by statement: the last executed one before it, in its region
    std::vector<StatementId> executed(p_.regions.size(), kNoStatement);
    for (StatementId id = 0; id < p_.size(); ++id) {
      const RegionId region = p_.region_of[id];
      last[id] = executed[region != kMainRegion && p_.regions[region].opener == id ? kMainRegion : region];
      if (flow_.executed[id]) executed[region] = id;
    }
    std::ranges::sort(candidates, {}, [&](size_t i) {
      return std::tuple(!rule_of(findings_[i]).leaves_out, findings_[i].span.begin, i);
    });
    std::map<StatementId, size_t> speaks;
    for (const size_t i : candidates) {
      const StatementId id = last_statement(p_.syntax, findings_[i].span.begin);
      const StatementId behind = id == kNoStatement ? kNoStatement : left_out_behind(id, last);
      if (behind == kNoStatement) continue;
      const auto [known, first] = speaks.emplace(behind, i);
      if (!first) fold(i, known->second);
    }
  }

  void move_folded() {
    for (size_t i = 0; i < findings_.size(); ++i) {
      if (into_[i] == kNone) continue;
      const size_t to = speaker_for(i);
      const Finding& f = findings_[i];
      findings_[to].consequences.push_back({f.code, f.span, f.interpreter});
      std::ranges::copy(f.consequences, std::back_inserter(findings_[to].consequences));
    }
    size_t at = 0;
    std::erase_if(findings_, [&](const Finding&) { return into_[at++] != kNone; });
  }

  const Program& p_;
  const FlowResult& flow_;
  std::vector<Finding>& findings_;
  std::vector<Part> parts_;
  std::map<Label, Part> speaks_;
  std::map<StatementId, size_t> openers_;
  std::vector<size_t> into_;  ///< by finding: the one that speaks for it
};

/// In a program for another controller: what no run reaches is part of the finding that says so. What else is wrong with its
/// line is left out: that finding has the message, and advice how to write the line for LinuxCNC is no help.
void fold_into_other_controller(const Source& source, std::vector<Finding>& findings) {
  const auto controller = std::ranges::find_if(findings, [](const Finding& f) { return rule_of(f).other_controller; });
  if (controller == findings.end()) return;
  const Span line = source.line(source.position(controller->span.begin).line);
  const auto is_here = [&](const Finding& f) {
    return f.source == nullptr && f.span.begin >= line.begin && f.span.begin <= line.end;
  };
  const auto follows = [&](const Finding& f) {
    return f.weight == Weight::kAside && (is_here(f) || (!f.stops && f.reach == Reach::kNever));
  };
  for (const Finding& f : findings) {
    if (follows(f) && !is_here(f)) controller->consequences.push_back({f.code, f.span, ""});
  }
  std::erase_if(findings, follows);
}

/// The same mistake as the one at which every run stops, further down: more places of it.
void fold_repeated(std::vector<Finding>& findings) {
  constexpr size_t kMostPlaces = 4;
  const auto stop = std::ranges::find_if(findings, stops_every_run);
  if (stop == findings.end()) return;
  const auto repeats = [code = stop->code, message = stop->message](const Finding& f) {
    return f.group.starts_with(kBehind) && f.code == code && f.message == message;
  };
  size_t more = 0;
  for (const Finding& f : findings) {
    if (!repeats(f)) continue;
    if (stop->related.size() < kMostPlaces) {
      stop->related.push_back({f.span, "the same mistake further down", nullptr});
    } else {
      ++more;
    }
  }
  if (more > 0) stop->related.back().message += fmt::format(", and {} times more", more);
  std::erase_if(findings, repeats);
}

}  // namespace

bool stops_every_run(const Finding& f) { return f.stops && f.reach == Reach::kAlways && f.source == nullptr; }

void fold_consequences(const Program& program, const FlowResult& flow, std::vector<Finding>& findings) {
  fold_into_other_controller(*program.source, findings);
  fold_repeated(findings);
  fold_ends(program, findings);
  if (findings.size() > 1) Folding(program, flow, findings).run();
}

}  // namespace owlint::rules
