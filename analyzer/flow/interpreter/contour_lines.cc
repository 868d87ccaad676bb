// The sub of a lathe contour as the line that cuts it will read it: where that is known before it is called.
#include <algorithm>

#include "analyzer/flow/interpreter/step.h"
#include "analyzer/syntax/questions.h"
#include "analyzer/syntax/word_reader.h"

namespace owlint::flow {
namespace {

/// More than people write by hand.
constexpr uint64_t kMostBytes = 1'000'000;
constexpr size_t kMostWords = 200'000;

/// Whether a statement within the sub is nothing but words and settings. `passes`: for its error.
template <typename Passes>
bool is_plain(const Syntax& syntax, const Statement& s, const Passes& passes) {
  if (s.block_delete) return false;
  if (s.kind == LineKind::kModeLine || s.kind == LineKind::kAbort) return true;
  if (s.kind == LineKind::kMachineCheck) return passes(syntax.errors[s.first]);
  if (s.kind == LineKind::kProgramEnd) return s.item_count == 0 && !s.has_error();
  if (s.kind != LineKind::kWords) return false;
  const LineError* const error = syntax.error(s);
  return error == nullptr || passes(*error);
}

}  // namespace

/// The lines of the sub that the contour of this line calls; nothing if they may be others, or compute what is not known.
std::optional<ContourSub> AbstractMachine::Step::contour_sub() const {
  StatementId cut = here + 1;
  while (cut < m.program_.size() && on_one_line(m.program_.at(cut), s) && m.program_.at(cut).kind != LineKind::kContour)
    ++cut;
  if (cut >= m.program_.size() || !on_one_line(m.program_.at(cut), s)) return std::nullopt;
  const Statement& line = m.program_.at(cut);
  const auto sets = [](const Item& item) { return item.target != kNoExpr || item.target_name != kNoName; };
  if (line.label == kNoName || std::ranges::any_of(m.program_.syntax.items_of(line), sets)) return std::nullopt;
  const StatementId opener = contour_opener(line.label);
  if (opener == kNoStatement) return std::nullopt;
  const Region& region = m.program_.regions[m.program_.region_of[opener]];
  if (region.opener != opener || region.end == kNoStatement || region.early_end != kNoStatement) return std::nullopt;
  if (m.program_.at(region.end).has_error()) return std::nullopt;  // it stops there before anything is cut
  for (StatementId id = opener + 1; id < region.end; ++id) {
    if (!is_plain(m.program_.syntax, m.program_.at(id), passes_in_contour)) return std::nullopt;
  }
  const Source& source = m.linked_.source_of(opener);
  const uint64_t begin = m.program_.at(opener).end() + 1, end = m.program_.at(region.end).offset;
  if (begin > end || end - begin > kMostBytes) return std::nullopt;
  ContourSub sub;
  Parameters inside = state.parameters;
  inside.local_outcomes = {};
  inside.locals = {};
  m.evaluator_.pass(inside, {});
  StatementId first = opener + 1;
  const std::string_view text = source.slice({begin, end});
  for (size_t from = 0; from < text.size();) {
    const size_t to = std::min(text.find('\n', from), text.size());
    StatementId behind = first;
    while (behind < region.end && m.program_.at(behind).offset < begin + to) ++behind;
    if (!contour_line(text.substr(from, to - from), {first, behind}, inside, &sub)) return std::nullopt;
    first = behind;
    from = to + 1;
  }
  return sub;
}

/// Adds the words of a line, whose statements are those, and sets its parameters. False if something of it is not known.
bool AbstractMachine::Step::contour_line(std::string_view text, std::pair<StatementId, StatementId> statements,
                                         Parameters& inside, ContourSub* sub) const {
  if (text.find_first_not_of(" \t\r") == std::string_view::npos) {
    sub->add_blank_line();
    return sub->words.size() <= kMostWords;
  }
  std::vector<ContourWord> computed;
  for (StatementId id = statements.first; id < statements.second; ++id) {
    if (m.program_.at(id).kind != LineKind::kWords) continue;
    for (const Item& item : m.program_.syntax.items_of(m.program_.at(id))) {
      if (item.letter == 0) continue;
      const ValueId value = m.evaluator_.evaluate(item.value, inside).value;
      if (!KnownValues::is_constant(value)) return false;
      computed.push_back({item.letter, m.values_.value(value)});
    }
  }
  size_t used = 0;
  WordReader reader(text, 0);
  while (const std::optional<WrittenWord> word = reader.next()) {
    const bool computes = used < computed.size() && computed[used].letter == word->letter;
    if (!word->value && !computes) return false;
    sub->words.push_back({word->letter, word->value ? *word->value : computed[used].value});
    if (computes) ++used;
  }
  sub->ends.push_back(sub->words.size());
  for (StatementId id = statements.first; id < statements.second; ++id) {
    if (m.program_.at(id).kind != LineKind::kWords) continue;
    const Evaluation set = m.evaluator_.assign(m.program_.at(id), inside, nullptr);
    if (set.fails != StopKind::kNone || set.may_fail != StopKind::kNone) return false;
  }
  return used == computed.size() && !reader.lost();
}

/// The definition that a call of this sub runs; none if there are several.
StatementId AbstractMachine::Step::contour_opener(NameId sub) const {
  const Definers::Set set = m.definers_.get(state.table.get(m.full_label(kGlobalScope, sub)));
  if (set.lines.size() > 1 || (set.undefined && !set.lines.empty())) return kNoStatement;
  if (!set.lines.empty()) return m.program_.at(set.lines.front()).is(Keyword::kSub) ? set.lines.front() : kNoStatement;
  if (!set.undefined || sub >= m.program_.by_label.size()) return kNoStatement;
  StatementId found = kNoStatement;
  for (const StatementId id : m.program_.by_label[sub]) {
    if (!m.program_.at(id).opens_sub()) continue;
    if (found != kNoStatement || !m.program_.at(id).is(Keyword::kSub)) return kNoStatement;
    found = id;
  }
  return found;
}

}  // namespace owlint::flow
