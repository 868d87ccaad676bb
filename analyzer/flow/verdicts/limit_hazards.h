// Moves that end beyond a limit of the machine, where the flow decides where the machine stands. Of the lines before that the
// scanner has found them.
#pragma once

#include <map>
#include <tuple>

#include "analyzer/flow/interpreter/place_watch.h"
#include "analyzer/flow/verdicts/hazards.h"

namespace owlint::flow {

class LimitHazards final : public PlaceWatch {
 public:
  /// `machine` must outlive it.
  explicit LimitHazards(const MachineWords& machine) : machine_(machine) {}

  void begin(const State& at, StatementId line) override;
  bool visit(const Moves& moves) override;
  void lose(uint32_t, AxisSet) override {}
  /// When all runs have been followed.
  void find(Hazards& hazards);

 private:
  const MachineWords& machine_;
  StatementId statement_ = kNoStatement;
  bool unproven_ = false;
  std::map<std::tuple<StatementId, uint8_t, bool>, Hazard> found_;  // by statement, axis and direction
};

}  // namespace owlint::flow
