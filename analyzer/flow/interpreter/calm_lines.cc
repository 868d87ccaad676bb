#include "analyzer/flow/interpreter/calm_lines.h"

#include <algorithm>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/questions.h"

namespace owlint::flow {

CalmLines::CalmLines(const Program& program, const Structure& structure, const TrackedParameters& tracked,
                     const Evaluator& evaluator)
    : program_(program), structure_(structure), tracked_(tracked), evaluator_(evaluator) {
  for (const Statement& s : program_.syntax.statements) {
    jumps_ = jumps_ || s.is(Keyword::kBreak) || s.is(Keyword::kContinue);
    do_loops_ = do_loops_ || s.is(Keyword::kDo);
  }
  find_escapes();
}

void CalmLines::find_escapes() {
  jumps_to_.assign(program_.blocks.size(), static_cast<StatementId>(program_.size()));
  if (!jumps_) return;
  std::vector<BlockId> open;
  for (StatementId id = 0; id < program_.size(); ++id) {
    const Statement& s = program_.at(id);
    const BlockId block = program_.block_of[id];
    if (s.kind != LineKind::kOWord || block == kNoBlock || !structure_.structured[block]) continue;
    if (program_.blocks[block].opener == id) {
      open.push_back(block);
    } else if (program_.blocks[block].end == id) {
      open.pop_back();
      if (!open.empty()) jumps_to_[open.back()] = std::min(jumps_to_[open.back()], jumps_to_[block]);
    } else if (!open.empty() && (s.is(Keyword::kBreak) || s.is(Keyword::kContinue))) {
      jumps_to_[open.back()] = std::min(jumps_to_[open.back()], program_.blocks[block].opener);
    }
  }
}

bool CalmLines::harmless(StatementId id) const {
  const Statement& s = program_.at(id);
  if (s.has_error()) return false;
  if (s.kind == LineKind::kWords) return harmless_words(s);
  if (s.kind != LineKind::kOWord || s.label == kNoName) return false;
  const BlockId block = program_.block_of[id];
  if (block == kNoBlock || !structure_.structured[block]) return false;
  switch (s.keyword) {
    case Keyword::kIf:
    case Keyword::kElseif:
    case Keyword::kWhile:
    case Keyword::kRepeat: {
      if (s.value_count != 1) return false;
      const Look condition = look(program_.syntax.values_of(s).front());
      return condition.safe && !condition.constant;
    }
    case Keyword::kElse:
    case Keyword::kEndif:
    case Keyword::kEndwhile:
    case Keyword::kEndrepeat: return true;
    case Keyword::kDo: return !jumps_;
    case Keyword::kBreak:
    case Keyword::kContinue: {
      const Block& loop = program_.blocks[block];
      return !do_loops_ && loop.kind == Keyword::kWhile && loop.opener < id && id < loop.end;
    }
    default: return false;
  }
}

bool CalmLines::stop_when_skipped(StatementId id) const {
  const Statement& s = program_.at(id);
  if (s.kind == LineKind::kPercent || s.kind == LineKind::kFileEnd || s.kind == LineKind::kM98) return true;
  if (s.kind == LineKind::kMachineCheck) return asks_about_call(program_.syntax, id);
  return s.has_error() && program_.syntax.errors[s.error].kind < StopKind::kKeywordUnknown;
}

bool CalmLines::harmless_words(const Statement& s) const {
  for (const Item& item : program_.syntax.items_of(s)) {
    if (!look(item.value).safe) return false;
    if (item.target_name != kNoName && tracked_.kind(item.target_name) == NameKind::kPredefined) return false;
    if (item.target != kNoExpr) {
      const Look target = look(item.target);
      long number = 0;
      if (!target.safe || !target.constant || !to_integer(target.value, &number)) return false;
      if (number < 1 || number > kLastNumber || evaluator_.read_only(number)) return false;
    }
  }
  return true;
}

// Depth is bounded by the length of a line.
Look CalmLines::look(ExprId id) const {
  const Expr& expr = program_.syntax.exprs[id];
  switch (expr.op) {
    case Operator::kNumber: return {true, true, expr.value()};
    case Operator::kNamed:
      return {tracked_.kind(expr.name()) == NameKind::kLocal || evaluator_.always_there(expr.name()), false, 0};
    case Operator::kExistsNamed:
    case Operator::kExistsNumbered: return {false, false, 0};
    case Operator::kParameter: {
      const Look index = look(expr.left());
      long number = 0;
      const bool known = index.safe && index.constant && to_integer(index.value, &number);
      return {known && number >= 1 && number <= kLastNumber && !is_position(number), false, 0};
    }
    default: break;
  }
  const Look left = look(expr.left());
  const Look right = expr.right() == kNoExpr ? left : look(expr.right());
  Look out{left.safe && right.safe, left.constant && right.constant, 0};
  if (out.constant) {
    out.safe = out.safe && apply(expr.op, left.value, right.value, &out.value) == nullptr;
  } else if (left.constant || right.constant) {
    // One known side may decide or fail by itself: left to the evaluator.
    const double known = left.constant ? left.value : right.value;
    if (expr.op == Operator::kAnd || expr.op == Operator::kOr) out.safe = false;
    if (expr.op == Operator::kDivide && right.constant && known == 0) out.safe = false;
  }
  return out;
}

uint32_t CalmLines::number_of(ExprId index) const {
  long number = 0;
  to_integer(look(index).value, &number);
  return static_cast<uint32_t>(number);
}

}  // namespace owlint::flow
