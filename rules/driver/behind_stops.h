// Lines that no run gets to only because every run stops before them: once that mistake is corrected, they run.
#pragma once

#include <string>
#include <vector>

#include "analyzer/findings/finding.h"
#include "analyzer/flow/flow.h"
#include "analyzer/program/program.h"

namespace owlint::rules {

/// The stop that ends every run; null if there is none.
const FlowStop* stop_that_ends_all(const FlowResult& flow);
/// Its line; kNoStatement if there is none.
StatementId stop_of_every_run(const FlowResult& flow);

/// The group of a finding about a line that no run gets to: places of one mistake are one finding. What the interpreter says is
/// not enough, since several mistakes have one message; what to do about it tells them apart.
std::string group_behind(const Finding& finding, const FlowStop& stop);

class BehindStops {
 public:
  /// Both must outlive it. Takes time in proportion to the program; made only where something asks.
  BehindStops(const Program& program, const FlowResult& flow);

  /// Whether the statement would run if no line before it stopped. Lines behind the end of the program do not.
  bool contains(StatementId statement) const { return !behind_.empty() && behind_[statement]; }
  /// The same of a line at an offset, which need not have a statement.
  bool contains_line(uint64_t offset) const;

 private:
  void follow_lines();
  void follow_calls();

  const Program& program_;
  const FlowResult& flow_;
  const StatementId stop_;    // where every run stops
  std::vector<bool> behind_;  // by statement; empty if there is no such stop
};

}  // namespace owlint::rules
