// What is odd about modes though it runs: calls that come back in another one, moves that mean something else by the way to them,
// and moves in a mode that the program has left as it was.
#pragma once

#include <map>
#include <vector>

#include "analyzer/flow/engine/mode_setters.h"
#include "analyzer/flow/interpreter/mode_watch.h"
#include "analyzer/flow/verdicts/hazards.h"

namespace owlint::flow {

class ModeHazards final : public ModeWatch {
 public:
  /// `analysis` must outlive it.
  explicit ModeHazards(const Iteration& analysis)
      : analysis_(analysis), program_(analysis.linked().program()), seen_(program_.syntax.mode_needs.size()) {}

  void left(const State& at, StatementId line) override;
  void came_back(const State& caller, const State& back) override;
  /// When all runs have been followed.
  void find(Hazards& hazards) const;

 private:
  /// A value that a mode had, and a record of a run in which it had it.
  struct Had {
    uint8_t value;
    RecordId record;
  };
  struct Leak {
    uint8_t from, to;
    RecordId record;
  };
  using Leaks = std::map<std::pair<StatementId, Mode>, Leak>;

  ModeValues values(const State& state, Mode mode) const;
  void find_leaks(Hazards& hazards) const;
  void find_different(Hazards& hazards) const;
  void find_assumed(Hazards& hazards) const;
  void find_unused(Hazards& hazards) const;
  const ModeNeed* needed_in(RegionId region, StatementId from, Mode mode, int depth) const;
  const ModeNeed* needed_behind(StatementId call, Mode mode) const;
  bool uses_before(StatementId call, Mode mode) const;

  const Iteration& analysis_;
  const Program& program_;
  std::vector<std::vector<Had>> seen_;  // by ModeNeed
  Leaks leaks_;
};

}  // namespace owlint::flow
