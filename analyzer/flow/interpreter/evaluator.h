// The values of expressions in a state, and what the assignments of a line change: the interpreter's arithmetic over the domain
// of known values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analyzer/flow/domain/known_parameters.h"
#include "analyzer/flow/interpreter/mode_access.h"
#include "analyzer/flow/interpreter/remembered_conditions.h"
#include "analyzer/flow/interpreter/tracked_parameters.h"

namespace owlint::flow {

/// The result of evaluating an expression in one state. A stop on some of the joined paths comes first: what comes after it
/// is known only when that stop has been handled.
struct Evaluation {
  ValueId value = kUnknown;
  StopKind fails = StopKind::kNone;     ///< evaluation always stops here
  StopKind may_fail = StopKind::kNone;  ///< on some of the joined paths it stops
  NameId name = kNoName;                ///< the undefined name
  const char* message = nullptr;        ///< the interpreter's words for a failing operation
  NameId read_only = kNoName;  ///< the line assigns this name; LinuxCNC notices after reading the whole line (measured)
  uint8_t item = kNoWord;  ///< of a number that its word may not have: the word, by its place among the line's items
};

/// What the evaluator notes about reads, besides the value.
struct ReadLog {
  uint32_t not_passed = 0;         ///< bit n: #n was read though the call did not pass it
  ValueId no_value = kUnassigned;  ///< `#<_value>` was read: kNotReturned, kCleared or kMaybeNotReturned
};

/// What a numbered parameter is that the program has not set. kZero: as in a newly started interpreter, which only serves to
/// find out whether a value can fail.
enum class Unset : uint8_t { kAny, kZero };
/// What an undefined name does. kPasses: while a sub definition is skipped; with Unset::kZero its value is 0 then.
enum class Undefined : uint8_t { kStops, kPasses };

/// How an expression is read.
struct Reading {
  Unset unset = Unset::kAny;
  Undefined undefined = Undefined::kStops;
  ReadLog* log = nullptr;  ///< null where nobody asks
};

class Evaluator {
 public:
  /// All must outlive it.
  Evaluator(const Syntax& syntax, const Profile& profile, const TrackedParameters& tracked,
            RememberedConditions& remembered, KnownValues& values, PersistentMap::Pool& pool);

  // --- reading ---

  Evaluation evaluate(ExprId id, const Parameters& in, const Reading& how = {});
  /// Whether one of some operations fails for these values.
  bool will_fail(std::span<const ExprId> operations, const Parameters& p);
  /// Whether the parameter of that number can be set, and the number as a whole one.
  Evaluation target(double value, long* number) const;
  bool read_only(long number) const { return read_only_number(number, profile_.version); }
  /// Whether reading a global name cannot fail, whatever was assigned.
  bool always_there(NameId global) const;
  /// Whether a parameter can be read, and nothing is known of its value.
  bool is_plain(ParameterId p, const Parameters& in) const;

  // --- assigning ---

  /// Applies the assignments of a line, in order, after all its values were read.
  /// Returns the stop, if there is one.
  Evaluation assign(const Statement& s, Parameters& parameters, ReadLog* log);
  void begin_name(NameId name, Parameters& p);
  void set_number(Parameters& p, long number, ValueId value);
  void set_name(Parameters& p, NameId name, ValueId value);
  /// Assigns something, on every way or only perhaps.
  void assign_unknown(ParameterId p, bool certain, Parameters& parameters);
  /// A name was read without a stop, or EXISTS has found it. If this run has not assigned it, an earlier run has, and that run
  /// assigned its other globals too.
  void assume_there(NameId name, Parameters& p);

  // --- calls ---

  /// A call passes its arguments to a sub that has no parameters yet.
  void pass(Parameters& p, std::span<const ValueId> arguments);
  /// M98 shares #1 to #30 with its sub, but not names: `names` with the numbers of `numbers`.
  PersistentMap share_numbers(PersistentMap names, const PersistentMap& numbers);
  /// What a sub that is called from elsewhere finds: its arguments, and names that a remap passes.
  void expect_from_outside(std::string_view sub, Parameters& p);
  /// Python runs before the sub of a remap: it may give the sub any name and argument.
  void expect_from_prolog(Parameters& p);
  /// Python code in the program's comments may give any global a value, or none.
  void expect_from_python(Parameters& p);
  /// A sub returns, or its definition is skipped: sets `#<_value>` and `#<_value_returned>`. `value`: null without
  /// one; `never`: the sub has no line that returns a value.
  void come_back(Parameters& p, const ValueId* value, bool never);
  /// Forgets everything that an unknown sub may have changed.
  static void call_outside(Parameters& p);
  /// Keys of `#<_value>` and `#<_value_returned>`, as far as anything reads them.
  std::vector<uint32_t> result_keys() const;

  // --- for the whole program ---

  /// From now on constants are only "assigned": for very large programs.
  void set_coarse() { coarse_ = true; }
  /// From now on nothing is known about global parameters: code that owlint does not follow may change them.
  void distrust_globals() { distrusts_globals_ = true; }
  bool distrusts_globals() const { return distrusts_globals_; }
  /// Whether the position may be read is asked of these modes.
  void set_modes(const ModeAccess* modes) { modes_ = modes; }
  /// The effect of the machine's INI on the names that depend on it, as a number.
  uint64_t machine_values() const;
  KnownValues& values() { return values_; }
  const KnownValues& values() const { return values_; }

 private:
  void forget_numbers(Parameters& p);
  void assume_assigned(NameId name, Parameters& p);
  ValueId read_number(long number, const Parameters& in) const;
  Evaluation read_name(NameId name, const Parameters& in, const Reading& how);
  Evaluation exists(const Expr& expr, const Parameters& in);

  const Syntax& syntax_;
  const Profile& profile_;
  const TrackedParameters& tracked_;
  RememberedConditions& remembered_;
  KnownValues& values_;
  PersistentMap::Pool& pool_;
  NameId value_name_;  // `#<_value>`; kNoName where nothing reads it
  NameId value_returned_name_;
  bool coarse_ = false;
  bool distrusts_globals_ = false;
  const ModeAccess* modes_ = nullptr;
  std::optional<std::vector<NameId>> read_locals_;  // local names that are read; found when somebody asks
};

}  // namespace owlint::flow
