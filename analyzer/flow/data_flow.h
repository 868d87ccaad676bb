// What each sub, and the main program, does with parameters: what it reads of what it is given, what it assigns, whether it
// returns a value; which assignments nothing reads; which conditions come out the same every time whatever is passed.
// Found sub by sub, from the lines alone, whatever the calls: so it holds for every caller.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analyzer/flow/fixed_conditions.h"
#include "analyzer/flow/liveness.h"

namespace owlint::flow {

/// `#5`, `#<name>`: as it is written.
std::string parameter_text(const Program& program, ParameterId parameter);

/// How a sub comes back: never with a value, on some ways only, on every way.
enum class Returns : uint8_t { kNothing, kSometimes, kValue };

struct Summary {
  bool known = false;       ///< otherwise nothing below holds
  uint32_t arguments = 0;   ///< bit n: the value that #n has at the call may be read
  bool any_number = false;  ///< reads a parameter whose number is computed: it may be any argument
  std::vector<ParameterId> reads;   ///< globals, in the order of their first place
  std::vector<ParameterId> writes;  ///< globals that it may assign itself, in the order of their first place
  Returns returns = Returns::kNothing;

  /// The highest argument that is read; 0 for none.
  int last_argument() const;
};

/// An assignment whose value nothing reads.
struct UnusedValue {
  StatementId statement = kNoStatement;
  uint32_t item = 0;  ///< of the statement's items
  ParameterId parameter;
  StatementId overwritten = kNoStatement;  ///< the next line, if it is assigned again there; else nothing reads it
};

class DataFlow {
 public:
  /// Programs with more statements are not gone through: nothing is known of them.
  static constexpr size_t kTooLarge = 50'000;

  /// `structure`: the program's, if it is known already.
  explicit DataFlow(const Program& program, std::shared_ptr<const Structure> structure = nullptr);
  ~DataFlow();

  const Summary& of(RegionId region) const;
  /// Whether a sub reads #n and never assigns it: nothing more has to be found out then.
  bool surely_reads(RegionId region, uint32_t number) const;
  /// The numbers (by bits) that have a value of the sub's own when it comes back, which nothing reads.
  uint32_t left_behind(RegionId region) const;
  /// The last line of a sub that assigns #n.
  StatementId last_assignment(RegionId region, uint32_t number) const;
  /// The highest argument that `(debug, #1)` and the like print; 0 for none.
  int last_printed_argument() const;
  /// Whether a region reads #n behind one of its calls, and never assigns it.
  bool expects_from_call(StatementId call, uint32_t number) const;
  const std::vector<UnusedValue>& unused() const;
  const std::vector<FixedCondition>& fixed() const;
  const Structure& structure() const;

 private:
  struct Sub;
  Sub& look(RegionId region) const;
  const ControlFlow& flow_of(RegionId region) const;
  const Liveness& live_in(RegionId region) const;
  void summarize(Sub& sub, RegionId region) const;
  void find_unused(RegionId region, std::vector<UnusedValue>& out) const;
  bool printed(ParameterKey key) const;
  const std::vector<ParameterKey>& printed() const;

  // All of it is made when it is first asked for: most programs have nothing to ask.
  const Program& program_;
  bool too_large_;
  mutable std::shared_ptr<const Structure> structure_;
  mutable Grouped statements_;  ///< by region
  mutable std::optional<AccessTable> table_;  ///< in the order of `statements_`
  mutable std::vector<Sub> subs_;
  mutable std::optional<std::vector<UnusedValue>> unused_;
  mutable std::optional<std::vector<FixedCondition>> fixed_;
  mutable std::optional<std::vector<ParameterKey>> printed_;  ///< parameters that comments print, sorted
};

}  // namespace owlint::flow
