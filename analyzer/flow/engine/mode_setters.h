// Where the modes in effect have been set.
#pragma once

#include <span>
#include <vector>

#include "analyzer/flow/engine/iteration.h"

namespace owlint::flow {

/// A line of one of the files; null and 0 if no line has set the mode.
struct ModeSetter {
  const Program* file = nullptr;
  uint32_t line = 0;

  bool operator==(const ModeSetter&) const = default;
};

/// The last line on the way to a record that has set one of the modes. `next`: the statement to which that way leads.
ModeSetter last_setter(const Iteration& analysis, RecordId record, StatementId next, ModeMask modes);

/// The same on all ways. Of an analysis that has come to its end.
class ModeSetters {
 public:
  /// `analysis` must outlive it.
  explicit ModeSetters(const Iteration& analysis);

  /// In the order of their lines. Where there are too many ways, those of one.
  std::vector<ModeSetter> of(std::span<const RecordId> records, StatementId next, ModeMask modes) const;

 private:
  bool leads_past_call(RecordId from, RecordId to) const;

  const Iteration& analysis_;
};

}  // namespace owlint::flow
