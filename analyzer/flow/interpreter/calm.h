// Stretches of lines in which nothing can go wrong, whatever their conditions are: they cannot stop, run for ever or jump
// out, and their only effects are assigned parameters and defined subs. Most lines of a large program are in one. When
// the analysis joins constants (the last level of Limits), such a stretch is one step.
#pragma once

#include <span>
#include <vector>

#include "analyzer/flow/facts/mode_uses.h"
#include "analyzer/flow/facts/structured.h"
#include "analyzer/flow/interpreter/evaluator.h"

namespace owlint::flow {

struct CalmWrite {
  ParameterId parameter;
  bool certain = false;  ///< on every path through the stretch
};

struct CalmStretch {
  StatementId first = 0;
  StatementId last = 0;  ///< one past the last line
  bool tests = false;    ///< has an `if`: afterwards, "a branch has been taken"
  bool calls = false;
  bool ends_defining = false;  ///< a definition comes after the last call
  // Into the lists of CalmStretches, up to those of the next stretch.
  uint32_t reads = 0;
  uint32_t writes = 0;
  uint32_t called = 0;
  uint32_t defined = 0;
  uint32_t changing = 0;
};

class CalmStretches {
 public:
  /// `warn_only`: under FEATURE 0x20 nothing is calm.
  CalmStretches(const Program& program, const Structure& structure, const TrackedParameters& tracked,
                const Evaluator& evaluator, const ModeUses& modes, const Limits& limits, bool warn_only);

  /// The stretch that begins at a statement; null if none does.
  const CalmStretch* at(StatementId id) const { return begins_[id] == kNone ? nullptr : &stretches_[begins_[id]]; }
  /// Parameters that are read before the stretch assigns them.
  std::span<const ParameterId> reads(const CalmStretch& s) const {
    return {reads_.data() + s.reads, reads_.data() + (&s + 1)->reads};
  }
  std::span<const CalmWrite> writes(const CalmStretch& s) const {
    return {writes_.data() + s.writes, writes_.data() + (&s + 1)->writes};
  }
  /// The first lines of the subs that the stretch calls, directly or not. They must be known, unless it defines them itself.
  std::span<const StatementId> called(const CalmStretch& s) const {
    return {called_.data() + s.called, called_.data() + (&s + 1)->called};
  }
  /// The first lines of the subs that it defines, and that must not be known yet.
  std::span<const StatementId> defined(const CalmStretch& s) const {
    return {defined_.data() + s.defined, defined_.data() + (&s + 1)->defined};
  }
  /// Its lines behind which the modes that are followed change, or the place.
  std::span<const StatementId> changing(const CalmStretch& s) const {
    return {changing_.data() + s.changing, changing_.data() + (&s + 1)->changing};
  }

 private:
  friend class CalmBuilder;
  static constexpr uint32_t kNone = UINT32_MAX;

  std::vector<uint32_t> begins_;        // by statement: index of the stretch
  std::vector<CalmStretch> stretches_;  // the last one is only an end
  std::vector<ParameterId> reads_;
  std::vector<CalmWrite> writes_;
  std::vector<StatementId> called_, defined_;
  std::vector<StatementId> changing_;
};

}  // namespace owlint::flow
