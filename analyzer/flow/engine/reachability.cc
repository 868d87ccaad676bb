#include "analyzer/flow/engine/reachability.h"

namespace owlint::flow {

bool Reachability::asked(StatementId first, StatementId last) const {
  const auto found = answers_.lower_bound(first);
  return found != answers_.end() && found->first < last;
}

Reach Reachability::reach(StatementId statement) {
  missed_ = missed_ || trace_->is_left_out(statement);
  if (const auto known = answers_.find(statement); known != answers_.end()) return known->second;
  const std::vector<bool>& executed = trace_->executed();
  const bool reached = statement < executed.size() && executed[statement];
  Reach answer = reached ? Reach::kMaybe : Reach::kNever;
  work_ += reached ? trace_->size() : 0;
  if (reached && work_ <= reach_records_ && !trace_->avoidable(statement)) answer = Reach::kAlways;
  answers_.emplace(statement, answer);
  return answer;
}

}  // namespace owlint::flow
