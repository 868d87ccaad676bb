#include "analyzer/flow/engine/known_calls.h"

namespace owlint::flow {

void KnownCalls::next_check() {
  if (++check_ % remembered_checks_ != 0) return;
  std::erase_if(calls_, [&](const auto& known) { return known.second.used + remembered_checks_ < check_; });
}

const CallOutcome* KnownCalls::find(const std::string& key) {
  const auto found = calls_.find(key);
  if (found == calls_.end()) return nullptr;
  found->second.used = check_;
  return &found->second.outcome;
}

void KnownCalls::learn(LearnedCall call) {
  calls_.insert_or_assign(std::move(call.key), Known{std::move(call.outcome), check_});
}

}  // namespace owlint::flow
