// What each sub, and the main program, does with parameters: which arguments and globals it reads, what it assigns, whether
// it returns a value, which assignments nothing reads, and which conditions are always the same. This is worked out for each
// sub from its own lines, without its calls, so it is true for every caller (effects.h: with its calls, for the engine).
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "analyzer/flow/facts/shown.h"
#include "analyzer/flow/summaries/fixed_conditions.h"
#include "analyzer/flow/summaries/lazy.h"
#include "analyzer/flow/summaries/liveness.h"

namespace owlint::flow {

/// `#5`, `#<name>`: as written.
std::string parameter_text(const Program& program, ParameterId parameter);

/// How a sub returns: never with a value, on some paths, on every path.
enum class Returns : uint8_t { kNothing, kSometimes, kValue };

struct Summary {
  bool known = false;               ///< otherwise nothing below is valid
  uint32_t arguments = 0;           ///< bit n: the value that #n has at the call may be read
  bool any_number = false;          ///< reads a parameter whose number is computed: it may be any argument
  std::vector<ParameterId> reads;   ///< globals, in the order of their first line
  std::vector<ParameterId> writes;  ///< globals that it may assign itself, in the order of their first line
  Returns returns = Returns::kNothing;

  /// The highest argument that is read; 0 for none.
  int last_argument() const;
};

/// An assignment whose value nothing reads.
struct UnusedValue {
  StatementId statement = kNoStatement;
  uint32_t item = 0;  ///< of the statement's items
  ParameterId parameter;
  StatementId overwritten = kNoStatement;  ///< the next line, if that assigns it again; else nothing reads it
  uint32_t argument = 0;  ///< the number of an argument that is read for this value and for nothing else
};

class DataFlow {
 public:
  /// `structure`: the program's, if it is already known. Of programs that are too large for `limits` nothing is known.
  explicit DataFlow(const Program& program, std::shared_ptr<const Structure> structure = nullptr,
                    const Limits& limits = {});

  const Summary& of(RegionId region) const;
  /// Whether a sub reads #n and never assigns it; that needs no further analysis.
  bool surely_reads(RegionId region, uint32_t number) const;
  /// The numbers (as bits) to which the sub assigned a value that nothing has read when it returns.
  uint32_t left_behind(RegionId region) const;
  /// The last line of a sub that assigns #n.
  StatementId last_assignment(RegionId region, uint32_t number) const;
  /// Whether a region reads #n after one of its calls, and never assigns it.
  bool expects_from_call(StatementId call, uint32_t number) const;
  /// Whether some run reads a parameter after a line before the region assigns it again.
  bool reads_after(StatementId line, ParameterKey key) const;
  /// Whether a region may have assigned a parameter when a run comes to statement `place`, or would come to a line above it: in
  /// lines above, or in a loop around it.
  bool assigned_before(RegionId region, StatementId place, ParameterKey key) const;
  /// Whether a line of a region above statement `place` reads a parameter.
  bool read_above(RegionId region, StatementId place, ParameterKey key) const;
  /// The first line of a region that assigns a parameter.
  StatementId first_assignment(RegionId region, ParameterKey key) const;
  /// What each line of a region reads and assigns; the lines are those of lines_of().
  const Accesses& accesses_of(RegionId region) const;
  std::span<const StatementId> lines_of(RegionId region) const;
  /// What comments show.
  const std::vector<Shown>& shown() const;
  bool too_large() const { return too_large_; }
  const std::vector<UnusedValue>& unused() const;
  /// What the lines of a region read, in their order.
  std::span<const ParameterKey> reads_of(RegionId region) const;
  const std::vector<FixedCondition>& fixed() const;
  const Structure& structure() const;

 private:
  using Assignment = std::pair<ParameterKey, StatementId>;

  // Everything is made when first needed: for most programs nothing is.
  struct Sub {
    Accesses accesses;
    Lazy<ControlFlow> flow;
    Lazy<Liveness> live;
    Lazy<Summary> summary;
    Lazy<std::vector<Assignment>> assignments;  ///< sorted
  };
  struct Lines {
    Grouped by_region;
    AccessTable table;      ///< in the order of `by_region`
    std::vector<Sub> subs;  ///< by region
  };

  const Lines& lines() const;
  Lines make_lines() const;
  const Sub& look(RegionId region) const { return lines().subs[region]; }
  const ControlFlow& flow_of(RegionId region) const;
  const Liveness& live_in(RegionId region) const;
  Summary summarize(RegionId region) const;
  void find_unused(RegionId region, std::vector<UnusedValue>& out) const;
  void find_fixed(std::vector<FixedCondition>& out) const;
  std::span<const Assignment> assignments(RegionId region, ParameterKey key) const;

  const Program& program_;
  Limits limits_;
  bool too_large_;
  std::shared_ptr<const Structure> structure_;  ///< null: not known before
  Lazy<Structure> own_structure_;
  Lazy<Lines> lines_;
  Lazy<std::vector<UnusedValue>> unused_;
  Lazy<std::vector<FixedCondition>> fixed_;
  Lazy<std::vector<Shown>> shown_;
};

}  // namespace owlint::flow
