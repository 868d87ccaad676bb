// What a state knows of the parameters: the product of the values of each, and the outcomes of conditions on them.
#pragma once

#include <cstdint>

#include "analyzer/flow/domain/known_values.h"
#include "analyzer/flow/domain/persistent_map.h"

namespace owlint::flow {

/// A condition, the same for all lines that test the same thing. While nothing that it reads is assigned, it has the
/// same outcome every time: two `if [#1 EQ 0]` in a row go the same way, and `if [#1 NE 0]` goes the other one.
struct ConditionId {
  uint32_t id = 0;       ///< 0: not tracked
  bool global = false;   ///< reads globals only; otherwise locals only
  bool negated = false;  ///< its outcome is the opposite of the one that is kept
};

/// Parameters as one state sees them. The order is that of values, parameter by parameter, the other way round for the outcomes,
/// of which fewer are less knowledge.
struct Parameters {
  PersistentMap locals;           ///< keys: 1-30, and kLocalNames + NameId
  PersistentMap globals;          ///< keys: number, and kGlobalNames + NameId
  PersistentMap local_outcomes;   ///< conditions on locals whose outcome is known: ConditionId::id -> 1 true, 2 false
  PersistentMap global_outcomes;  ///< the same for conditions on globals
  bool outside = false;           ///< an unknown sub has run: globals may have any value

  /// A fingerprint, mixed into `seed`: equal parameters have equal ones, and others have others but for the bet of State::hash().
  uint64_t hash(uint64_t seed) const;
};

/// The least parameters that hold both: values are joined one by one, and an outcome is kept if both sides have it. Commutative,
/// associative and idempotent. Ranges widen to their thresholds, and outcomes only become fewer, so chains come to rest.
Parameters join(const Parameters& a, const Parameters& b, KnownValues& values, PersistentMap::Pool& pool);

}  // namespace owlint::flow
