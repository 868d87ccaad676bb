// Those who want to see which modes are in effect on the way.
#pragma once

#include "analyzer/flow/domain/state.h"

namespace owlint::flow {

class ModeWatch {
 public:
  virtual ~ModeWatch() = default;
  /// A run leaves `line` for the lines behind it.
  virtual void left(const State& at, StatementId line) = 0;
  /// A call that was made in the state `caller` has come back.
  virtual void came_back(const State& caller, const State& back) = 0;
};

}  // namespace owlint::flow
