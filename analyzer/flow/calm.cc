#include "analyzer/flow/calm.h"

#include <algorithm>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

/// What an expression may do, with every parameter unknown.
struct Look {
  bool safe = true;      ///< it cannot fail
  bool constant = false;
  double value = 0;
};

/// For each parameter, in which stretch it was last noted: forgets all of them by counting on.
class Marks {
 public:
  explicit Marks(size_t names) : numbers_(kLastNumber + 1), names_(names) {}
  uint32_t& operator[](ParameterId p) { return p.named ? names_[p.id] : numbers_[p.id]; }

 private:
  std::vector<uint32_t> numbers_, names_;
};

}  // namespace

class CalmStretches::Builder {
 public:
  Builder(CalmStretches& out, const Program& program, const Structure& structure, const Evaluator& evaluator)
      : out_(out), program_(program), structure_(structure), evaluator_(evaluator), read_(program.syntax.names.size()),
        written_(program.syntax.names.size()), assigned_(program.syntax.names.size()) {}

  void run() {
    const auto count = static_cast<StatementId>(program_.size());
    find_jumps();
    // Harmless lines, counted, so that a block can be asked for all of its lines at once.
    std::vector<uint32_t> harmful(count + 1);
    for (StatementId id = 0; id < count; ++id) harmful[id + 1] = harmful[id] + (harmless(id) ? 0 : 1);
    find_escapes();
    const auto calm_until = [&](StatementId id) {  // the end of the line, or of the block that it opens; id: not calm
      if (harmful[id + 1] != harmful[id]) return id;
      if (program_.at(id).kind == LineKind::kWords) return id + 1;
      const BlockId block = program_.block_of[id];
      if (program_.blocks[block].opener != id) return id;  // a part of a block that is not calm as a whole
      const StatementId end = program_.blocks[block].end + 1;
      return harmful[end] == harmful[id] && jumps_to_[block] >= id ? end : id;
    };
    for (StatementId id = 0; id < count;) {
      StatementId last = id;
      for (StatementId next = id; last < count && (next = calm_until(last)) != last;) last = next;
      if (last - id > 1) add(id, last);
      id = last + 1;
    }
    out_.stretches_.push_back({count, count, false, static_cast<uint32_t>(out_.reads_.size()), static_cast<uint32_t>(out_.writes_.size())});
  }

 private:
  /// `break` and `do` together leave flags behind (OW501, OW509): calm is only one of them, everywhere.
  void find_jumps() {
    for (const Statement& s : program_.syntax.statements) {
      jumps_ = jumps_ || s.is(Keyword::kBreak) || s.is(Keyword::kContinue);
      do_loops_ = do_loops_ || s.is(Keyword::kDo);
    }
  }

  /// How far out the jumps in each block lead: a block that a `break` of a loop around it leaves is not calm.
  void find_escapes() {
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

  bool harmless(StatementId id) {
    const Statement& s = program_.at(id);
    if (s.error != UINT32_MAX) return false;
    if (s.kind == LineKind::kWords) return harmless_words(s);
    if (s.kind != LineKind::kOWord || s.label == kNoName) return false;
    const BlockId block = program_.block_of[id];
    if (block == kNoBlock || !structure_.structured[block]) return false;
    switch (s.keyword) {
      case Keyword::kIf: case Keyword::kElseif: case Keyword::kWhile: case Keyword::kRepeat: {
        if (s.value_count != 1) return false;
        const Look condition = look(program_.syntax.values[s.first]);
        return condition.safe && !condition.constant;
      }
      case Keyword::kElse: case Keyword::kEndif: case Keyword::kEndwhile: case Keyword::kEndrepeat:
        return true;
      case Keyword::kDo:
        return !jumps_;
      case Keyword::kBreak: case Keyword::kContinue: {
        const Block& loop = program_.blocks[block];
        return !do_loops_ && loop.kind == Keyword::kWhile && loop.opener < id && id < loop.end;
      }
      default:
        return false;
    }
  }

  bool harmless_words(const Statement& s) {
    for (uint32_t i = 0; i < s.item_count; ++i) {
      const Item& item = program_.syntax.items[s.first + i];
      if (!look(item.value).safe) return false;
      if (item.target_name != kNoName && predefined_name(program_.name(item.target_name))) return false;
      if (item.target != kNoExpr) {
        const Look target = look(item.target);
        long number = 0;
        if (!target.safe || !target.constant || !to_integer(target.value, &number)) return false;
        if (number < 1 || number > kLastNumber || read_only_number(number)) return false;
      }
    }
    return true;
  }

  // Depth is bounded by the length of a line, here and in note_reads().
  Look look(ExprId id) const {
    const Expr& expr = program_.syntax.exprs[id];
    switch (expr.op) {
      case Operator::kNumber: return {true, true, expr.value()};
      case Operator::kNamed: return {!program_.name(expr.name()).starts_with("_") || evaluator_.always_there(expr.name()), false, 0};
      case Operator::kExistsNamed: case Operator::kExistsNumbered: return {false, false, 0};
      case Operator::kParameter: {
        const Look index = look(expr.left());
        long number = 0;
        const bool known = index.safe && index.constant && to_integer(index.value, &number);
        return {known && number >= 1 && number <= kLastNumber, false, 0};
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

  void note_read(ParameterId p) {
    if (assigned_[p] == stretch_ || read_[p] == stretch_) return;
    read_[p] = stretch_;
    out_.reads_.push_back(p);
  }

  void note_reads(ExprId id) {
    const Expr& expr = program_.syntax.exprs[id];
    if (expr.op == Operator::kNamed) return note_read({expr.name(), true});
    if (expr.op == Operator::kParameter) return note_read({number_of(expr.left()), false});
    if (expr.left() != kNoExpr) note_reads(expr.left());
    if (expr.right() != kNoExpr) note_reads(expr.right());
  }

  uint32_t number_of(ExprId index) const {
    long number = 0;
    to_integer(look(index).value, &number);
    return static_cast<uint32_t>(number);
  }

  void note_write(ParameterId p, bool certain) {
    if (assigned_[p] != stretch_) {
      assigned_[p] = stretch_;
      undo_.push_back(p);
    }
    if (written_[p] == stretch_ && !certain) return;
    // Noted again where it turns out to be certain: then the later entry counts.
    written_[p] = stretch_;
    out_.writes_.push_back({p, certain});
  }

  /// What was assigned in a branch is not certain any more behind it.
  void leave_branch() {
    for (; undo_.size() > branches_.back(); undo_.pop_back()) assigned_[undo_.back()] = 0;
  }

  void add(StatementId first, StatementId last) {
    ++stretch_;
    out_.begins_[first] = static_cast<uint32_t>(out_.stretches_.size());
    CalmStretch& stretch = out_.stretches_.emplace_back();
    stretch = {first, last, false, static_cast<uint32_t>(out_.reads_.size()), static_cast<uint32_t>(out_.writes_.size())};
    undo_.clear();
    branches_.clear();
    for (StatementId id = first; id < last; ++id) {
      const Statement& s = program_.at(id);
      if (s.kind == LineKind::kWords) {
        for (uint32_t i = 0; i < s.item_count; ++i) note_reads(program_.syntax.items[s.first + i].value);
        for (uint32_t i = 0; i < s.item_count; ++i) {
          const Item& item = program_.syntax.items[s.first + i];
          if (item.target_name != kNoName) note_write({item.target_name, true}, branches_.empty());
          if (item.target != kNoExpr) note_write({number_of(item.target), false}, branches_.empty());
        }
        continue;
      }
      const Block& block = program_.blocks[program_.block_of[id]];
      if (s.is(Keyword::kElse) || s.is(Keyword::kElseif)) leave_branch();
      if (s.is(Keyword::kIf)) stretch.tests = true;
      if (s.value_count > 0) note_reads(program_.syntax.values[s.first]);
      if (block.opener == id) {
        branches_.push_back(undo_.size());
      } else if (block.end == id) {
        leave_branch();
        branches_.pop_back();
      }
    }
  }

  CalmStretches& out_;
  const Program& program_;
  const Structure& structure_;
  const Evaluator& evaluator_;
  bool jumps_ = false;
  bool do_loops_ = false;
  std::vector<StatementId> jumps_to_;  // by block: the foremost opener of a loop that a line in it leaves or goes on with
  uint32_t stretch_ = 0;            // number of the stretch being noted, from 1
  Marks read_, written_;            // by parameter: the last stretch that reads, writes it
  Marks assigned_;                  // the same: assigned on every way to the line that is looked at
  std::vector<ParameterId> undo_;   // in the order in which they were assigned
  std::vector<size_t> branches_;    // size of `undo_` where each open branch began
};

CalmStretches::CalmStretches(const Program& program, const Structure& structure, const Evaluator& evaluator, bool warn_only)
    : begins_(program.size(), kNone) {
  if (!warn_only) Builder(*this, program, structure, evaluator).run();
}

}  // namespace owlint::flow
