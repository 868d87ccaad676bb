// What a run may still read of what a state knows of the parameters, through calls and returns: live variables of the whole
// program. States that differ only in the rest behave alike from there on.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analyzer/flow/domain/known_parameters.h"
#include "analyzer/flow/facts/accesses.h"
#include "analyzer/flow/facts/control_flow.h"
#include "analyzer/flow/facts/structured.h"
#include "analyzer/flow/interpreter/remembered_conditions.h"
#include "analyzer/flow/limits.h"
#include "analyzer/program/grouped.h"

namespace owlint::flow {

/// Numbers the variables of a state: its parameters, and the conditions whose outcomes it knows. Those whose values are in one
/// leaf of a map are one after the other, so that a leaf is compared with the live ones at once.
class Variables {
 public:
  /// The maps of Parameters.
  enum Map : uint8_t { kLocals, kGlobals, kLocalOutcomes, kGlobalOutcomes };
  static constexpr size_t kMaps = 4;
  static constexpr uint32_t kNone = UINT32_MAX;

  void add(Map map, uint32_t key);
  uint32_t number(Map map, uint32_t key) const;
  /// Calls `visit(map, key, number)` for all keys of the leaves that there are.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (size_t map = 0; map < kMaps; ++map) {
      for (uint32_t leaf = 0; leaf < leaf_[map].size(); ++leaf) {
        for (uint32_t i = 0; leaf_[map][leaf] != kNone && i < kLeaf; ++i)
          visit(static_cast<Map>(map), leaf * kLeaf + i, leaf_[map][leaf] * kLeaf + i);
      }
    }
  }
  size_t words() const { return leaves_ / kLeavesInWord + 1; }
  /// Of a set of variables those in one leaf, as bits.
  uint16_t in_leaf(const uint64_t* set, Map map, uint32_t leaf) const {
    if (leaf >= leaf_[map].size() || leaf_[map][leaf] == kNone) return 0;
    const uint32_t number = leaf_[map][leaf];
    return static_cast<uint16_t>(set[number / kLeavesInWord] >> (kLeaf * (number % kLeavesInWord)));
  }

 private:
  static constexpr uint32_t kLeaf = PersistentMap::kLeaf;
  static constexpr uint32_t kLeavesInWord = 64 / kLeaf;

  std::vector<uint32_t> leaf_[kMaps];  // by key / kLeaf
  uint32_t leaves_ = 0;
};

class LiveVariables {
 public:
  /// `outcomes`: the conditions that states remember. All must outlive it.
  LiveVariables(const Program& program, const Structure& structure, const RememberedConditions& outcomes,
                const Limits& limits);

  /// Forgets what no run reads that goes on with a line, in a call of the sub around it.
  void keep_before(StatementId line, Parameters& p, PersistentMap::Pool& pool) const;
  /// The same where a sub is called, and where its calls come back.
  void keep_at_entry(NameId sub, Parameters& p, PersistentMap::Pool& pool) const;
  void keep_at_exit(NameId sub, Parameters& p, PersistentMap::Pool& pool) const;

 private:
  using Set = std::vector<uint64_t>;
  struct Sub {
    ControlFlow flow;
    Accesses accesses;
    size_t first = 0;  ///< of its lines among those of all
    bool known = false;
    Set entry, exit;  ///< what is live where it is called, and where its calls come back
  };
  /// What is live before a line: what is read before it is assigned, whatever comes behind the sub, and what is if it is live
  /// behind the sub.
  struct Live {
    uint64_t* read;
    uint64_t* passed;
  };

  void find_subs(const Structure& structure);
  bool is_whole(RegionId region) const;
  void number_variables();
  void find_always_live();
  void add(ParameterKey key);
  void put(ParameterKey key, uint64_t* set) const;
  bool sweep(const Sub& sub);
  void come_from_next(const Sub& sub, NodeId node, Live out);
  void come_from_call(StatementId line, Live out);
  void read_line(const Sub& sub, NodeId node, Live out) const;
  bool may_mean_any(const Call& call) const;
  bool leads_anywhere(const Call& call) const;
  void find_exits();
  bool spread_exit(const Call& call);
  void finish();
  void keep(const uint64_t* live, Parameters& p, PersistentMap::Pool& pool) const;
  const Sub* only(NameId name) const;
  Live at(size_t line) { return {&read_[line * words_], &passed_[line * words_]}; }

  const Program& program_;
  const RememberedConditions& outcomes_;
  Grouped lines_;  ///< by region
  std::optional<AccessTable> table_;
  Grouped by_name_;                ///< regions by the name of their sub
  std::vector<uint32_t> call_at_;  ///< by statement: of Program::calls
  std::vector<Sub> subs_;          ///< by region
  Variables variables_;
  size_t words_ = 0;
  Set always_, globals_, numbers_;
  Set read_, passed_;              ///< by line, in the order of `lines_`; at the end the first one has all that is live
  std::vector<uint32_t> line_of_;  ///< by statement: in that order; empty if nothing is known
};

}  // namespace owlint::flow
