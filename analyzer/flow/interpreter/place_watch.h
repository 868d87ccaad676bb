// Those who want to see where the lines of a program go on the way.
#pragma once

#include "analyzer/flow/domain/state.h"
#include "analyzer/syntax/moves.h"

namespace owlint::flow {

class PlaceWatch : public MoveVisitor {
 public:
  /// What is told next is about runs in this state, at a statement or on the lines behind it.
  virtual void begin(const State& at, StatementId line) = 0;
  /// Whether it has to be told of every move: then no stretch of lines is one step.
  virtual bool sees_all() const { return false; }
};

}  // namespace owlint::flow
