#include "analyzer/flow/interpreter/calm.h"

#include <algorithm>

#include "analyzer/flow/interpreter/calm_lines.h"

namespace owlint::flow {
namespace {

/// For each parameter, in which stretch it was last noted: forgets all of them by counting on.
class Marks {
 public:
  explicit Marks(size_t names) : numbers_(kLastNumber + 1), names_(names) {}
  uint32_t& operator[](ParameterId p) { return p.named ? names_[p.id] : numbers_[p.id]; }

 private:
  std::vector<uint32_t> numbers_, names_;
};

/// A part of a list that many share.
struct Piece {
  uint32_t first = 0;
  uint32_t count = 0;

  template <typename T>
  std::span<const T> of(const std::vector<T>& list) const {
    return std::span(list).subspan(first, count);
  }
};

/// What a calm sub does to its caller.
struct CalmSub {
  bool calm_definition = false;  ///< skipping it only defines it
  bool calm = false;             ///< so is a call of it
  bool tests = false;
  uint32_t arguments = 0;  ///< the highest of #1 to #30 that it reads
  Piece reads, writes;     ///< global parameters
  Piece called;            ///< the subs that it calls, and those that they call, by their openers
};

}  // namespace

class CalmBuilder {
 public:
  CalmBuilder(CalmStretches& out, const Program& program, const Structure& structure, const TrackedParameters& tracked,
              const Evaluator& evaluator, const ModeUses& modes, const Limits& limits)
      : out_(out),
        program_(program),
        structure_(structure),
        modes_(modes),
        limits_(limits),
        lines_(program, structure, tracked, evaluator),
        read_(program.syntax.names.size()),
        written_(program.syntax.names.size()),
        assigned_(program.syntax.names.size()),
        subs_(program.regions.size()),
        noted_(program.regions.size()) {}

  void run() {
    const auto count = static_cast<StatementId>(program_.size());
    find_definitions();
    // Harmful lines, counted, so that a block or a sub can be asked for all of its lines at once.
    harmful_.resize(count + 1);
    stopping_.resize(count + 1);
    call_ = program_.calls.begin();
    auto call = program_.calls.begin();
    for (StatementId id = 0; id < count; ++id) {
      const RegionId region = program_.region_of[id];
      if (region != kMainRegion && program_.regions[region].end == id) look_at_sub(region);
      while (call != program_.calls.end() && call->statement < id) ++call;
      const bool calls = call != program_.calls.end() && call->statement == id;
      stopping_[id + 1] = stopping_[id] + (lines_.stop_when_skipped(id) ? 1 : 0);
      const bool harmful = (calls ? !harmless_call(*call) : !lines_.harmless(id)) || changes_on_one_way(id);
      harmful_[id + 1] = harmful_[id] + (harmful ? 1 : 0);
    }
    for (StatementId id = 0; id < count;) {
      StatementId last = id;
      for (StatementId next = id;
           last < count && last - id < limits_.stretch_lines && (next = calm_until(last)) != last;)
        last = next;
      if (last - id > 1) add(id, last);
      id = std::max(last, id + 1);
    }
    out_.stretches_.emplace_back();
    end_lists(out_.stretches_.back());
  }

 private:
  struct Branches {
    size_t undo;    ///< size of `undo_` where the branch began
    size_t in_all;  ///< size of `in_all_` where the block began
    bool first = true;
    bool has_else = false;
  };

  void find_definitions() {
    std::vector<bool> defined(program_.syntax.names.size());
    defined_again_.resize(defined.size());
    for (const Statement& s : program_.syntax.statements) {
      if (!s.opens_sub() || s.label == kNoName) continue;
      if (defined[s.label]) defined_again_[s.label] = true;
      defined[s.label] = true;
    }
  }

  /// The end of the line, block or definition that begins at `id`; `id` if it is not calm.
  StatementId calm_until(StatementId id) const {
    const Statement& s = program_.at(id);
    if (s.is(Keyword::kSub)) {
      const RegionId region = program_.region_of[id];
      return program_.regions[region].opener == id && subs_[region].calm_definition ? program_.regions[region].end + 1
                                                                                    : id;
    }
    if (harmful_[id + 1] != harmful_[id]) return id;
    if (s.kind == LineKind::kWords || s.is(Keyword::kCall)) return id + 1;
    const BlockId block = program_.block_of[id];
    if (program_.blocks[block].opener != id) return id;  // a part of a block that is not calm as a whole
    const StatementId end = program_.blocks[block].end + 1;
    return harmful_[end] == harmful_[id] && lines_.jumps_to(block) >= id ? end : id;
  }

  /// Whether the line, or the lines behind it, change modes on some ways only, or in a sub. A stretch knows what it leaves in
  /// effect, whatever was before it.
  bool changes_on_one_way(StatementId id) {
    const BlockId block = program_.block_of[id];
    const bool part = program_.at(id).kind == LineKind::kOWord && block != kNoBlock;
    if (part && program_.blocks[block].opener == id) ++open_blocks_;
    if (part && program_.blocks[block].end == id && open_blocks_ > 0) --open_blocks_;
    return modes_.changed_at(id) != 0 && (open_blocks_ > 0 || program_.region_of[id] != kMainRegion);
  }

  bool harmless_call(const Call& call) {
    const Statement& s = program_.at(call.statement);
    if (!s.is(Keyword::kCall) || s.has_error() || call.target == kNoRegion || !structure_.shallow_calls) return false;
    const CalmSub& sub = subs_[call.target];  // of a later one nothing is known yet
    if (!sub.calm || sub.arguments > s.value_count) return false;
    return std::ranges::all_of(program_.syntax.values_of(s), [this](ExprId value) { return lines_.look(value).safe; });
  }

  void note_read(ParameterId p) {
    if (assigned_[p] == stretch_ || read_[p] == stretch_) return;
    read_[p] = stretch_;
    out_.reads_.push_back(p);
  }

  // Depth is bounded by the length of a line.
  void note_reads(ExprId id) {
    const Expr& expr = program_.syntax.exprs[id];
    if (expr.op == Operator::kNamed) return note_read({expr.name(), true});
    if (expr.op == Operator::kParameter) return note_read({lines_.number_of(expr.left()), false});
    for_each_operand(expr, [this](ExprId operand) { note_reads(operand); });
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

  /// After a branch its assignments are no longer certain, unless all branches make them.
  void leave_branch() {
    Branches& open = branches_.back();
    if (open.first) {
      in_all_.insert(in_all_.end(), undo_.begin() + static_cast<std::ptrdiff_t>(open.undo), undo_.end());
    } else {
      const auto kept = std::remove_if(in_all_.begin() + static_cast<std::ptrdiff_t>(open.in_all), in_all_.end(),
                                       [&](ParameterId p) { return assigned_[p] != stretch_; });
      in_all_.erase(kept, in_all_.end());
    }
    open.first = false;
    for (; undo_.size() > open.undo; undo_.pop_back()) assigned_[undo_.back()] = 0;
  }

  void leave_block() {
    leave_branch();
    const Branches left = branches_.back();
    branches_.pop_back();
    const auto first = in_all_.begin() + static_cast<std::ptrdiff_t>(left.in_all);
    if (left.has_else) std::for_each(first, in_all_.end(), [&](ParameterId p) { note_write(p, branches_.empty()); });
    in_all_.erase(first, in_all_.end());
  }

  void end_lists(CalmStretch& stretch) const {
    stretch.reads = static_cast<uint32_t>(out_.reads_.size());
    stretch.writes = static_cast<uint32_t>(out_.writes_.size());
    stretch.called = static_cast<uint32_t>(out_.called_.size());
    stretch.defined = static_cast<uint32_t>(out_.defined_.size());
    stretch.changing = static_cast<uint32_t>(out_.changing_.size());
  }

  void add(StatementId first, StatementId last) {
    out_.begins_[first] = static_cast<uint32_t>(out_.stretches_.size());
    CalmStretch stretch{.first = first, .last = last};
    end_lists(stretch);
    go_through(first, last, &stretch);
    out_.stretches_.push_back(stretch);
  }

  /// Notes what the lines read, write, call and define, after what is in the lists of `out_`.
  void go_through(StatementId first, StatementId last, CalmStretch* stretch) {
    ++stretch_;
    undo_.clear();
    branches_.clear();
    in_all_.clear();
    for (StatementId id = first; id < last; ++id) {
      const Statement& s = program_.at(id);
      if (s.kind == LineKind::kWords) {
        note_words(s);
        note_modes(id);
        continue;
      }
      if (!s.is(Keyword::kElseif)) {
        for (const ExprId value : program_.syntax.values_of(s)) note_reads(value);
      }
      if (s.is(Keyword::kSub)) {
        out_.defined_.push_back(id);
        stretch->ends_defining = true;
        id = program_.regions[program_.region_of[id]].end;
      } else if (s.is(Keyword::kCall)) {
        note_call(id, stretch);
      } else {
        note_block(id, stretch);
      }
      note_modes(id);  // of a definition its end, for it is passed over
    }
  }

  void note_modes(StatementId id) {
    if (modes_.changed_at(id) != 0) out_.changing_.push_back(id);
  }

  void note_words(const Statement& s) {
    for (const Item& item : program_.syntax.items_of(s)) note_reads(item.value);
    for (const Item& item : program_.syntax.items_of(s)) {
      if (item.target_name != kNoName) note_write({item.target_name, true}, branches_.empty());
      if (item.target != kNoExpr) note_write({lines_.number_of(item.target), false}, branches_.empty());
    }
  }

  void note_block(StatementId id, CalmStretch* stretch) {
    const Statement& s = program_.at(id);
    const Block& block = program_.blocks[program_.block_of[id]];
    if (block.kind == Keyword::kDo) return;  // it runs at least once, as if it were no block
    if (s.is(Keyword::kElse) || s.is(Keyword::kElseif)) leave_branch();
    if (s.is(Keyword::kElse)) branches_.back().has_else = true;
    if (s.is(Keyword::kElseif)) note_reads(program_.syntax.values_of(s).front());
    if (s.is(Keyword::kIf)) stretch->tests = true;
    if (block.opener == id) {
      branches_.push_back({undo_.size(), in_all_.size()});
    } else if (block.end == id) {
      leave_block();
    }
  }

  void note_sub(RegionId region) {
    if (noted_[region] == stretch_) return;
    noted_[region] = stretch_;
    out_.called_.push_back(program_.regions[region].opener);
  }

  void note_call(StatementId id, CalmStretch* stretch) {
    // Stretches are looked at in the order of their lines, but bodies of subs before, out of turn.
    if (call_ == program_.calls.end() || call_->statement > id) call_ = program_.calls.begin();
    call_ = std::ranges::lower_bound(call_, program_.calls.end(), id, {}, &Call::statement);
    const CalmSub& sub = subs_[call_->target];
    note_sub(call_->target);
    for (const StatementId opener : sub.called.of(sub_called_)) note_sub(program_.region_of[opener]);
    for (const ParameterId p : sub.reads.of(sub_reads_)) note_read(p);
    for (const CalmWrite& write : sub.writes.of(sub_writes_))
      note_write(write.parameter, write.certain && branches_.empty());
    stretch->tests = stretch->tests || sub.tests;
    stretch->calls = true;
    stretch->ends_defining = false;
  }

  template <typename T>
  static Piece keep(std::vector<T>& list, std::span<const T> items) {
    const Piece piece{static_cast<uint32_t>(list.size()), static_cast<uint32_t>(items.size())};
    list.insert(list.end(), items.begin(), items.end());
    return piece;
  }

  static bool is_local(const Program& program, ParameterId p) {
    return p.named ? !is_global_name(program.name(p.id)) : p.id < static_cast<uint32_t>(kFirstGlobalNumber);
  }

  /// Whether skipping a definition only defines the sub.
  bool is_calm_definition(const Region& region) const {
    if (!structure_.regular || region.opener == kNoStatement || region.enclosing != kNoBlock ||
        region.name >= program_.by_label.size())
      return false;
    if (defined_again_[region.name]) return false;
    const Statement& opener = program_.at(region.opener);
    const Statement& end = program_.at(region.end);
    if (opener.has_error() || end.has_error() || !end.is(Keyword::kEndsub)) return false;
    if (stopping_[region.end] != stopping_[region.opener] || program_.name(region.name).find('/') != std::string::npos)
      return false;
    // Other lines with its label are looked at on the way.
    const auto lines = program_.by_label[region.name];
    const auto own = std::ranges::lower_bound(lines, region.opener);
    if (own == lines.end() || own + 1 == lines.end() || own[1] != region.end) return false;
    // The value is computed when the definition is skipped too: harmless if nothing is computed.
    if (end.value_count == 0) return true;
    const Operator op = program_.syntax.exprs[program_.syntax.values[end.first]].op;
    return (op == Operator::kNumber || op == Operator::kNamed || op == Operator::kParameter) &&
        lines_.look(program_.syntax.values[end.first]).safe;
  }

  /// Looks at the sub whose end has been reached: its definition, and what a call of it does.
  void look_at_sub(RegionId number) {
    const Region& region = program_.regions[number];
    subs_[number].calm_definition = is_calm_definition(region);
    if (!subs_[number].calm_definition || harmful_[region.end] != harmful_[region.opener + 1]) return;
    if (modes_.changed_at(region.opener) != 0) return;
    const Statement& end = program_.at(region.end);
    CalmStretch body;
    end_lists(body);
    go_through(region.opener + 1, region.end, &body);
    if (end.value_count > 0) note_reads(program_.syntax.values[end.first]);
    std::vector<ParameterId> reads;
    std::vector<CalmWrite> writes;
    CalmSub sub;
    sub.calm_definition = sub.calm = true;
    sub.tests = body.tests;
    for (size_t i = body.reads; i < out_.reads_.size(); ++i) {
      const ParameterId p = out_.reads_[i];
      if (!is_local(program_, p)) {
        reads.push_back(p);
      } else if (p.named) {
        sub.calm = false;  // it is not assigned in the sub
      } else {
        sub.arguments = std::max(sub.arguments, p.id);
      }
    }
    for (size_t i = body.writes; i < out_.writes_.size(); ++i) {
      if (!is_local(program_, out_.writes_[i].parameter)) writes.push_back(out_.writes_[i]);
    }
    const std::span<const StatementId> called = std::span(out_.called_).subspan(body.called);
    if (sub.calm && reads.size() + writes.size() + called.size() <= limits_.stretch_accesses) {
      sub.reads = keep(sub_reads_, std::span<const ParameterId>(reads));
      sub.writes = keep(sub_writes_, std::span<const CalmWrite>(writes));
      sub.called = keep(sub_called_, called);
      subs_[number] = sub;
    }
    out_.reads_.resize(body.reads);
    out_.writes_.resize(body.writes);
    out_.called_.resize(body.called);
    out_.defined_.resize(body.defined);
  }

  CalmStretches& out_;
  const Program& program_;
  const Structure& structure_;
  const ModeUses& modes_;
  const Limits& limits_;
  CalmLines lines_;
  std::vector<uint32_t> harmful_;    // by statement: how many harmful lines come before it
  std::vector<uint32_t> stopping_;   // the same for lines that matter even where they are skipped
  uint32_t stretch_ = 0;             // number of the stretch or sub being noted, from 1
  Marks read_, written_;             // by parameter: the last stretch that reads, writes it
  Marks assigned_;                   // the same: assigned on every way to the line that is looked at
  std::vector<ParameterId> undo_;    // in the order in which they were assigned
  std::vector<Branches> branches_;   // of the open blocks
  std::vector<ParameterId> in_all_;  // by open block: what all its branches so far assign
  std::vector<bool> defined_again_;  // by name: there are several definitions
  std::vector<CalmSub> subs_;        // by region
  std::vector<ParameterId> sub_reads_;
  std::vector<CalmWrite> sub_writes_;
  std::vector<StatementId> sub_called_;
  std::vector<uint32_t> noted_;  // by region: the last stretch that calls it
  std::vector<Call>::const_iterator call_;
  int open_blocks_ = 0;  // around the line that is looked at
};

CalmStretches::CalmStretches(const Program& program, const Structure& structure, const TrackedParameters& tracked,
                             const Evaluator& evaluator, const ModeUses& modes, const Limits& limits, bool warn_only)
    : begins_(program.size(), kNone) {
  if (!warn_only) CalmBuilder(*this, program, structure, tracked, evaluator, modes, limits).run();
}

}  // namespace owlint::flow
