// Stretches of lines in which nothing can go wrong, whatever the outcome of their conditions: they cannot stop, never
// end, jump out, call, or leave anything behind but assigned parameters. Most lines of a large program are in one.
// Where the analysis does not tell constants apart any more (kCoarse), it passes over such a stretch in one step.
#pragma once

#include <span>
#include <vector>

#include "analyzer/flow/structured.h"
#include "analyzer/flow/values.h"

namespace owlint::flow {

struct CalmStretch {
  StatementId first = 0;
  StatementId last = 0;  ///< one past the last line
  bool tests = false;    ///< has an `if`: afterwards, "a branch has been taken"
  // Into CalmStretches' lists, up to those of the next stretch.
  uint32_t reads = 0;
  uint32_t writes = 0;
};

class CalmStretches {
 public:
  struct Write {
    ParameterId parameter;
    bool certain = false;  ///< on every way through the stretch
  };

  /// `warn_only`: under FEATURE 0x20 nothing is calm.
  CalmStretches(const Program& program, const Structure& structure, const Evaluator& evaluator, bool warn_only);

  /// The stretch that begins at a statement; null if none does.
  const CalmStretch* at(StatementId id) const { return begins_[id] == kNone ? nullptr : &stretches_[begins_[id]]; }
  /// What is read before the stretch itself has assigned it.
  std::span<const ParameterId> reads(const CalmStretch& s) const { return {reads_.data() + s.reads, reads_.data() + (&s + 1)->reads}; }
  std::span<const Write> writes(const CalmStretch& s) const { return {writes_.data() + s.writes, writes_.data() + (&s + 1)->writes}; }

 private:
  class Builder;
  static constexpr uint32_t kNone = UINT32_MAX;

  std::vector<uint32_t> begins_;        // by statement: index of the stretch
  std::vector<CalmStretch> stretches_;  // the last one is only an end
  std::vector<ParameterId> reads_;
  std::vector<Write> writes_;
};

}  // namespace owlint::flow
