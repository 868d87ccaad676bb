#include "analyzer/flow/verdicts/limit_hazards.h"

#include <cmath>

namespace owlint::flow {
namespace {

/// Whether a fault says more than one that is known: it is certain, or goes further.
bool says_more(const Hazard& fault, const Hazard& known) {
  const auto doubt = [](const Hazard& of) { return std::pair(of.unproven, of.limit->needs); };
  if (doubt(fault) != doubt(known)) return doubt(fault) < doubt(known);
  const auto beyond = [](const LimitFault& limit) { return std::abs(limit.furthest - limit.limit); };
  return beyond(*fault.limit) > beyond(*known.limit);
}

}  // namespace

void LimitHazards::begin(const State& at, StatementId line) {
  statement_ = line;
  unproven_ = at.mixed;
}

bool LimitHazards::visit(const Moves& moves) {
  if (moves.compensated) return false;
  for (size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((moves.axes & axis_set(axis)) == 0 || machine_.limits[axis] == AxisLimits{}) continue;
    const MachineWay way = machine_way(moves, axis, machine_.units_per_mm);
    for (const bool greatest : {false, true}) {
      const auto fault = beyond_limit(machine_, moves, axis, way, greatest);
      if (!fault) continue;
      Hazard hazard = hazard_at(HazardKind::kLimitExceeded, statement_);
      hazard.unproven = unproven_;
      hazard.limit = std::make_shared<LimitFault>(*fault);
      const auto [known, added] = found_.try_emplace({statement_, fault->axis, greatest}, hazard);
      if (!added && says_more(hazard, known->second)) known->second = std::move(hazard);
    }
  }
  return false;
}

void LimitHazards::find(Hazards& hazards) {
  for (auto& [key, hazard] : found_) {
    const uint32_t detail = static_cast<uint32_t>(hazard.limit->axis) * 2 + (hazard.limit->greatest ? 1 : 0);
    hazards.add(std::move(hazard), detail);
  }
}

}  // namespace owlint::flow
