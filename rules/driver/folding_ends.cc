// A block whose first line LinuxCNC does not read: what is wrong with its other lines is the same mistake, or comes of it.
#include <algorithm>
#include <string>

#include "analyzer/program/meant.h"
#include "analyzer/syntax/last_statement.h"
#include "analyzer/text/characters.h"
#include "rules/driver/folding.h"
#include "rules/driver/stops.h"

namespace owlint::rules {
namespace {

enum class Side : uint8_t { kNone, kOpens, kDivides, kEnds };

/// What a line is meant to be in a block.
struct Role {
  Side side = Side::kNone;
  Keyword kind = Keyword::kUnknown;  ///< the keyword that begins the block; kUnknown: a `FOR`, or any
  std::string label;                 ///< without its `o`; empty if it has none
  bool labelled = false;             ///< LinuxCNC reads the label
};

/// A line in small letters, without blanks, without what comes before its words and behind a `;`.
std::string plain_line(const Program& p, const Statement& s) {
  std::string text = small_letters(p.source->slice(s.whole()).substr(0, kLineLimit));
  text.erase(std::min(text.find(';'), text.size()));
  std::erase_if(text, [](char c) { return is_blank(c) || c == '\r'; });
  if (text.starts_with('/')) text.erase(0, 1);
  if (text.size() > 1 && text[0] == 'n' && is_digit(text[1]))
    text.erase(0, std::min(text.find_first_not_of("0123456789", 1), text.size()));
  return text;
}

Role role_of(Keyword keyword) {
  Role role;
  if (opens_block(keyword) || keyword == Keyword::kSub) {
    role.side = Side::kOpens;
    role.kind = keyword;
  } else if (ends_block(keyword) || keyword == Keyword::kEndsub) {
    role.side = Side::kEnds;
    role.kind = keyword == Keyword::kEndsub ? Keyword::kSub : opener_of(keyword);
  } else if (keyword == Keyword::kElse || keyword == Keyword::kElseif) {
    role.side = Side::kDivides;
    role.kind = Keyword::kIf;
  }
  return role;
}

Role role_of(const Program& p, StatementId id) {
  const Statement& s = p.at(id);
  const std::string text = plain_line(p, s);
  const LineError* const error = p.syntax.error(s);
  if (error != nullptr && text.starts_with("for") && text.size() > 3 && (text[3] == '#' || text[3] == '['))
    return {Side::kOpens, Keyword::kUnknown, "", false};
  if (error != nullptr && text.starts_with("next")) return {Side::kEnds, Keyword::kUnknown, "", false};
  if (text.size() == 4 && text.starts_with("end") && is_digit(text[3]))
    return {Side::kEnds, Keyword::kWhile, "", false};  // `END1`
  const bool misread = s.keyword == Keyword::kUnknown || s.keyword == Keyword::kBare;
  const Meant meant = misread ? meant_by(p, id) : Meant{};
  Role role = role_of(misread ? meant.keyword : s.keyword);
  role.labelled = s.kind == LineKind::kOWord && s.label != kNoName &&
      (error == nullptr || (error->kind != StopKind::kLabelForgotten && error->kind != StopKind::kLetterForgotten));
  if (error == nullptr || error->kind != StopKind::kLabelForgotten)
    role.label = s.kind == LineKind::kOWord && s.label != kNoName ? p.name(s.label) : meant.name;
  if (role.side == Side::kNone && role.labelled && text.ends_with("end")) role.side = Side::kEnds;  // `o100 end`
  return role;
}

/// The O-word behind a complete one on its line, `o2 if [1]` of `o1 if [1] o2 if [1]`, if it begins a block.
Role second_role(const Program& p, const Statement& s) {
  const LineError* const error = p.syntax.error(s);
  if (error == nullptr || error->kind != StopKind::kTrailingText || s.kind != LineKind::kOWord) return {};
  std::string text = small_letters(p.source->slice(s.rest_span()));
  std::erase_if(text, is_blank);
  if (text.size() < 2 || text[0] != 'o') return {};
  const bool named = text[1] == '<';
  const size_t from = named ? 2 : std::min(text.find_first_not_of('0', 1), text.size());
  const size_t to = std::min(named ? text.find('>') : text.find_first_not_of("0123456789", from), text.size());
  Role role = role_of(keyword_of(std::string_view(text).substr(std::min(named ? to + 1 : to, text.size()))));
  if (role.side != Side::kOpens || role.kind == Keyword::kSub || to == from) return {};
  role.label = text.substr(from, to - from);
  role.labelled = true;
  return role;
}

/// A finding about the first line of a block.
struct Opened {
  size_t finding = 0;
  StatementId statement = kNoStatement;
  Role role;
  bool second = false;  ///< the block of an O-word behind another one
};

class Ends {
 public:
  Ends(const Program& program, std::vector<Finding>& findings) : p_(program), findings_(findings) {}

  void run() {
    std::vector<size_t> order;
    for (size_t i = 0; i < findings_.size(); ++i) {
      // Habits of writing are no mistakes of the block.
      if (findings_[i].source == nullptr && rule_of(findings_[i]).level == Severity::kError) order.push_back(i);
    }
    std::ranges::stable_sort(order, {}, [&](size_t i) { return findings_[i].span.begin; });
    std::vector<bool> folded(findings_.size());
    for (const size_t i : order) folded[i] = look_at(i);
    size_t at = 0;
    std::erase_if(findings_, [&](const Finding&) { return folded[at++]; });
  }

 private:
  /// Whether the finding is folded into another one.
  bool look_at(size_t i) {
    const Finding& f = findings_[i];
    const StatementId id = last_statement(p_.syntax, f.span.begin);
    if (id == kNoStatement || f.span.begin >= p_.at(id).end()) return false;
    const Role role = role_of(p_, id);
    const bool unmet = f.group.starts_with(kBehind) || (!f.stops && !f.never_ends && f.reach == Reach::kNever);
    if (unmet && !open_.empty() && fold(i, id, role)) return true;
    if (!p_.at(id).has_error() || (!open_.empty() && open_.back().statement == id)) return false;
    if (role.side == Side::kOpens) open_.push_back({i, id, role, false});
    if (const Role second = second_role(p_, p_.at(id)); second.side == Side::kOpens)
      open_.push_back({i, id, second, true});
    return false;
  }

  bool fold(size_t i, StatementId id, const Role& role) {
    const auto found = std::find_if(open_.rbegin(), open_.rend(), [&](const Opened& o) { return fits(o, id, role); });
    if (found == open_.rend() || p_.region_of[found->statement] != p_.region_of[id]) return false;
    constexpr size_t kMostPlaces = 6;
    Finding& speaker = findings_[found->finding];
    const Finding& f = findings_[i];
    const bool of_do = found->role.kind == Keyword::kDo && found->role.labelled;
    const std::string words = of_do ? "a `do` ends with `" + p_.label_at(found->statement) + " while [...]`"
        : found->role.labelled      ? "this belongs to it"
                                    : "the same mistake here";
    if (speaker.related.size() < kMostPlaces) {
      speaker.related.push_back({f.span, words, nullptr});
    } else {
      speaker.consequences.push_back({f.code, f.span, ""});
    }
    std::ranges::copy(f.consequences, std::back_inserter(speaker.consequences));
    if (!f.fixes.empty() && !speaker.fixes.empty() && f.code == speaker.code) add_edits(f.fixes[0], speaker.fixes[0]);
    if (role.side != Side::kDivides) open_.erase(std::prev(found.base()), open_.end());
    return true;
  }

  /// Both lines are corrected together.
  static void add_edits(const Fix& from, Fix& into) {
    for (const Edit& edit : from.edits) {
      const bool apart = std::ranges::all_of(into.edits, [&](const Edit& other) {
        return edit.span.begin > other.span.end || edit.span.end < other.span.begin;
      });
      if (apart) into.edits.push_back(edit);
    }
  }

  bool fits(const Opened& opened, StatementId id, const Role& role) const {
    const bool ends_do = role.side == Side::kOpens && role.kind == Keyword::kWhile && opened.role.kind == Keyword::kDo;
    if (role.side == Side::kNone || (role.side == Side::kOpens && !ends_do)) return false;
    if (opened.second) return role.labelled && role.label == opened.role.label && role.kind == opened.role.kind;
    // `do while [...]` … `endwhile`, `do` … `end`.
    if (opened.role.labelled)
      return opened.role.kind == Keyword::kDo && role.labelled && role.label == opened.role.label &&
          role.side == Side::kEnds && (role.kind == Keyword::kWhile || role.kind == Keyword::kUnknown);
    if (role.labelled || (role.kind != opened.role.kind && !ends_do)) return false;
    // The end of a block that LinuxCNC knows.
    const BlockId block = p_.block_of[id];
    const bool known =
        block != kNoBlock && p_.blocks[block].mistaken_end == id && !p_.at(p_.blocks[block].opener).has_error();
    return !known && (role.label.empty() || opened.role.label.empty() || role.label == opened.role.label);
  }

  const Program& p_;
  std::vector<Finding>& findings_;
  std::vector<Opened> open_;
};

/// A line outside of the sub of a called file that sets what the sub reads: that the line never runs is the reason.
void fold_left_out_values(const Program& p, std::vector<Finding>& findings) {
  const auto is_outside = [&](const Related& r) {
    const StatementId id = r.source == nullptr ? last_statement(p.syntax, r.span.begin) : kNoStatement;
    return id != kNoStatement && p.region_of[id] == kMainRegion;
  };
  const auto is_reason = [&](const Finding& left_out) {
    if (!rule_of(left_out).leaves_out || left_out.source != nullptr) return false;
    return std::ranges::any_of(findings, [&](const Finding& f) {
      return f.stops && rule_of(f).group == Group::kDataFlow && std::ranges::any_of(f.related, [&](const Related& r) {
               return r.span.begin >= left_out.span.begin && r.span.begin <= left_out.span.end && is_outside(r);
             });
    });
  };
  std::vector<bool> folded(findings.size());
  for (size_t i = 0; i < findings.size(); ++i) folded[i] = is_reason(findings[i]);
  size_t at = 0;
  std::erase_if(findings, [&](const Finding&) { return folded[at++]; });
}

}  // namespace

void fold_ends(const Program& program, std::vector<Finding>& findings) {
  if (findings.size() > 1) Ends(program, findings).run();
  if (program.sub_file && findings.size() > 1) fold_left_out_values(program, findings);
}

}  // namespace owlint::rules
