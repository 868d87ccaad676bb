// The hazards that were found so far: each once, however many states show it.
#pragma once

#include <map>
#include <tuple>

#include "analyzer/flow/flow.h"

namespace owlint::flow {

/// A hazard at a line that shows at `other`.
inline Hazard hazard_at(HazardKind kind, StatementId statement, StatementId other = kNoStatement) {
  Hazard out;
  out.kind = kind;
  out.statement = statement;
  out.other = other;
  return out;
}

class Hazards {
 public:
  /// Adds a hazard. One of the same kind and places, and the same `detail`, is there already: it stays, and is proven if
  /// either is. `detail`: what else tells hazards apart.
  void add(Hazard hazard, uint32_t detail = 0) {
    const bool unproven = hazard.unproven;
    const auto [known, added] =
        found_.emplace(std::make_tuple(hazard.kind, hazard.statement, hazard.other, detail), std::move(hazard));
    if (!added) known->second.unproven = known->second.unproven && unproven;
  }
  bool has(HazardKind kind) const {
    const auto found = found_.lower_bound(std::make_tuple(kind, StatementId{0}, StatementId{0}, 0U));
    return found != found_.end() && found->second.kind == kind;
  }

  // In the order of kinds and places.
  auto begin() { return found_.begin(); }
  auto end() { return found_.end(); }

 private:
  std::map<std::tuple<HazardKind, StatementId, StatementId, uint32_t>, Hazard> found_;
};

}  // namespace owlint::flow
