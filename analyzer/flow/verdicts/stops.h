// The stops that were found so far: each once, however many states stop there. In the trace each is an end of runs with a key
// of its own. What code a stop has as a finding is decided in rules/driver/stops.h.
#pragma once

#include <compare>
#include <map>
#include <string>

#include "analyzer/flow/engine/trace.h"
#include "analyzer/program/linker.h"

namespace owlint::flow {

/// The key of a program end without an error among the ends of runs.
inline constexpr uint32_t kNormalEnd = 0;

class Stops {
 public:
  struct Key {
    StatementId statement;
    StopKind kind;
    std::string detail;
    uint32_t file;  ///< for stops without a statement
    auto operator<=>(const Key&) const = default;
  };
  struct Found {
    uint32_t key;     ///< of the end in the trace
    RecordId record;  ///< one that stops there; a proven one if there is one
    FlowStop stop;
  };

  /// Both must outlive it.
  Stops(const Linked& linked, Trace& trace) : linked_(linked), trace_(trace) {}

  /// A run stops at `record`. Returns the key of the end.
  uint32_t add(RecordId record, FlowStop stop);
  /// A run ends at `record` in a way of its own, which is no stop.
  void end_otherwise(RecordId record) { trace_.terminate(record, next_key_++); }

  // In the order of their lines.
  auto begin() { return found_.begin(); }
  auto end() { return found_.end(); }

 private:
  const Linked& linked_;
  Trace& trace_;
  std::map<Key, Found> found_;
  uint32_t next_key_ = kNormalEnd + 1;
};

/// LinuxCNC cuts its messages off (measured).
std::string as_printed(std::string message);

}  // namespace owlint::flow
