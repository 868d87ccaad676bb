// A graph of what the flow analysis did, with one record for each state. Afterwards it answers whether every run or some
// run gets to a stop, by which branches, and where a run never ends. Reachability asks it about lines.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "analyzer/flow/domain/state.h"
#include "analyzer/flow/flow.h"
#include "analyzer/flow/limits.h"

namespace owlint::flow {

class Trace {
 public:
  struct Record {
    RecordId parent = kNoRecord;
    StatementId statement = kNoStatement;
    Branch branch = Branch::kNone;  ///< of the step that led here
    bool executed = false;          ///< not only skipped
    bool after_call = false;        ///< a call has come back here; come_back() adds the edge
  };
  struct Link {
    RecordId from = kNoRecord;
    RecordId to = kNoRecord;
    Branch branch = Branch::kNone;
  };

  /// For a program of so many statements.
  Trace(const Limits& limits, size_t statements)
      : path_records_(limits.path_records), path_decisions_(limits.path_decisions), executed_(statements) {}

  RecordId add(Record record) {
    records_.push_back(record);
    return static_cast<RecordId>(records_.size() - 1);
  }
  /// A state is equal to an earlier one at the same line.
  void link(RecordId from, RecordId to, Branch branch = Branch::kNone) { links_.push_back({from, to, branch}); }
  /// The call made at the record `call` has come back at `after`, a record made for that with `after_call`.
  void come_back(RecordId call, RecordId after) { calls_.push_back({call, after}); }
  /// A run ends here; `key` is the kind of end (0: a program end without error).
  /// `unsure`: the record stands for several runs, and only some of them end here.
  void terminate(RecordId at, uint32_t key, bool unsure = false) {
    terminals_.emplace_back(at, key);
    if (unsure) unsure_.insert(at);
  }

  /// Some run executes a statement, and does not only skip it.
  void mark_executed(StatementId statement) { executed_[statement] = true; }
  /// By statement.
  const std::vector<bool>& executed() const { return executed_; }

  const Record& at(RecordId id) const { return records_[id]; }
  size_t size() const { return records_.size(); }

  /// Lines that were not analysed, because the outcomes of calls of their sub were known.
  void leave_out(StatementId first, StatementId last) { left_out_.emplace_back(first, last); }
  bool leaves_out() const { return !left_out_.empty(); }
  /// A question cannot be answered without these lines.
  void miss_left_out() { missed_ = true; }
  /// Whether there was such a question.
  bool missed() const { return missed_; }
  bool is_left_out(StatementId statement) const;

  /// Must be called once, after the last record and before the questions below.
  void finish();

  /// Whether every run that ends, ends with `key`.
  bool only_end(uint32_t key) const;
  /// Whether a run can end, or never end, without executing the statement. Looks at records until it finds one that does.
  bool avoidable(StatementId statement) const;
  /// Whether some run ends at all.
  bool ends() const { return !terminals_.empty(); }
  /// The conditions on the way to `stop` without which a run does not get to an end with `key`.
  std::vector<Decision> path(RecordId stop, uint32_t key) const;
  /// Records from which no end can be reached.
  const std::vector<bool>& hanging() const { return hanging_; }
  /// Goes back from a record to the nearest one whose statement satisfies `wanted`.
  template <typename Wanted>
  StatementId nearest(RecordId from, const Wanted& wanted) const {
    for (RecordId id = from; id != kNoRecord; id = records_[id].parent) {
      if (records_[id].statement != kNoStatement && wanted(records_[id].statement)) return records_[id].statement;
    }
    return kNoStatement;
  }
  /// Edges besides those from a record's parent to it, for the search of endless loops.
  const std::vector<Link>& links() const { return links_; }
  /// Cycles that need no condition to be true (as the cycles of loops do), so that nothing ends them: by record, the number
  /// of its group of such cycles, or 0.
  std::vector<uint32_t> idle_cycles() const;
  /// All cycles, numbered in the same way.
  std::vector<uint32_t> cycles() const { return ways_round(next_first_, next_); }
  /// Cycles without an exit, numbered in the same way; `removed` edges do not count.
  std::vector<uint32_t> closed_cycles(const std::function<bool(RecordId from, RecordId to)>& removed) const;
  /// Calls `each` with all edges: from, to.
  template <typename Each>
  void for_edges(const Each& each) const {
    for (RecordId id = 0; id < records_.size(); ++id) {
      for (uint32_t i = next_first_[id]; i < next_first_[id + 1]; ++i) each(id, next_[i]);
    }
  }

  /// The records that lead to one. After finish().
  std::span<const RecordId> previous(RecordId record) const {
    return std::span(previous_).subspan(previous_first_[record], previous_first_[record + 1] - previous_first_[record]);
  }

 private:
  static std::vector<uint32_t> ways_round(const std::vector<uint32_t>& first, const std::vector<uint32_t>& next);
  bool has_cycle(const std::vector<bool>& within) const;
  std::vector<bool> backward_from(const std::vector<RecordId>& goals) const;

  size_t path_records_, path_decisions_;  // see Limits
  std::vector<Record> records_;
  std::vector<Link> links_;
  std::vector<std::pair<RecordId, RecordId>> calls_;
  std::unordered_set<RecordId> unsure_;
  std::vector<std::pair<RecordId, uint32_t>> terminals_;
  // Successors and predecessors, packed: those of record i are [first[i], first[i + 1]).
  std::vector<uint32_t> next_first_, next_, previous_first_, previous_;
  std::vector<bool> ends_at_;  ///< by record: some run ends there
  std::vector<bool> hanging_;
  std::vector<bool> executed_;
  std::vector<std::pair<StatementId, StatementId>> left_out_;
  bool missed_ = false;
};

}  // namespace owlint::flow
