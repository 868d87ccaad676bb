// What a sub, with everything that it calls, can change (data_flow.h: what it does by itself). Used when calls are
// analysed together: what the sub cannot have changed is taken from each caller.
#pragma once

#include <unordered_map>
#include <unordered_set>

#include "analyzer/flow/facts/mode_uses.h"
#include "analyzer/flow/limits.h"
#include "analyzer/program/program.h"

namespace owlint::flow {

struct Effects {
  bool everything = false;               ///< not known: an open block or computed label may lead anywhere
  bool any_global = false;               ///< assigns a parameter whose number is computed
  bool jumps = false;                    ///< has `break` or `continue`
  bool tests = false;                    ///< has `if`
  std::unordered_set<NameId> subs;       ///< subs that it may define, or whose labels it may define
  std::unordered_set<uint32_t> globals;  ///< keys of global parameters, as in Parameters
};

class EffectsOfSubs {
 public:
  /// `regular`: see Structure.
  EffectsOfSubs(const Program& program, bool regular, const ModeUses& modes, const Limits& limits);
  const Effects& of(NameId sub);

 private:
  const Program& program_;
  bool regular_;
  const ModeUses& modes_;
  size_t reached_subs_;
  Grouped regions_;  ///< by name of the sub
  std::unordered_map<NameId, Effects> known_;
  Grouped calls_;  ///< by region: indices into Program::calls
};

}  // namespace owlint::flow
