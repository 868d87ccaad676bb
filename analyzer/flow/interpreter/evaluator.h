// The values of expressions in a state, and what the assignments of a line change: the interpreter's arithmetic over the domain
// of known values.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analyzer/flow/domain/known_parameters.h"
#include "analyzer/flow/facts/accesses.h"
#include "analyzer/flow/limits.h"
#include "analyzer/machine/predefined.h"
#include "analyzer/syntax/statement.h"

namespace owlint::flow {

/// The result of evaluating an expression in one state. A stop on some of the merged paths comes first: what comes after it
/// is known only when that stop has been handled.
struct Evaluation {
  ValueId value = kUnknown;
  StopKind fails = StopKind::kNone;     ///< evaluation always stops here
  StopKind may_fail = StopKind::kNone;  ///< on some of the merged paths it stops
  NameId name = kNoName;                ///< the undefined name
  const char* message = nullptr;        ///< the interpreter's words for a failing operation
  NameId read_only = kNoName;  ///< the line assigns this name; LinuxCNC notices after reading the whole line (measured)
};

/// What the evaluator notes about reads, besides the value.
struct ReadLog {
  uint32_t not_passed = 0;         ///< bit n: #n was read though the call did not pass it
  ValueId no_value = kUnassigned;  ///< `#<_value>` was read: kNotReturned, kCleared or kMaybeNotReturned
};

/// What the outcome of lines depends on, besides their text.
struct Dependence {
  std::vector<uint32_t> locals, globals;  ///< parameters that they read or assign, by their keys in Parameters
  std::string circumstances;              ///< what the evaluator tracks about them because of other lines
  bool global_facts = false;              ///< a condition on globals whose outcome is remembered
  bool known = true;                      ///< false: there are more values, and they are not known
};

class Evaluator {
 public:
  /// `limits` must outlive it.
  Evaluator(const Syntax& syntax, const Profile& profile, const Limits& limits, KnownValues& values,
            PersistentMap::Pool& pool);

  /// Evaluates `id`. `zero_when_unassigned`: numbered parameters that the program never set are 0, as in a
  /// newly started interpreter; used only to find out whether a value can fail. `defining`: while a sub definition is
  /// skipped, undefined names do not stop; with `zero_when_unassigned` they are 0 then.
  Evaluation evaluate(ExprId id, const Parameters& in, bool zero_when_unassigned, bool defining, ReadLog* log) const;

  void begin_name(NameId name, Parameters& p) const;
  /// Applies the assignments of a line, in order, after all its values were read.
  /// Returns the stop, if there is one.
  Evaluation assign(const Statement& s, Parameters& parameters, ReadLog* log) const;
  /// Whether the parameter of that number can be set, and the number as a whole one.
  Evaluation target(double value, long* number) const;

  /// From now on constants are only "assigned", and outcomes are not remembered: for very large programs.
  void set_coarse() { coarse_ = true; }
  NameKind kind(NameId name) const { return kinds_[name]; }
  /// Whether some line assigns a name.
  bool assigned(NameId name) const { return kept_[name]; }
  bool read_only(long number) const { return read_only_number(number, profile_.version); }
  /// Whether reading a global name cannot fail, whatever was assigned.
  bool always_there(NameId global) const;
  /// Whether a parameter can be read, and nothing is known of its value.
  bool is_plain(ParameterId p, const Parameters& in) const;
  /// Assigns something, on every way or only perhaps.
  void assign_unknown(ParameterId p, bool certain, Parameters& parameters) const;

  /// From now on nothing is known about global parameters: code that owlint does not follow may change them.
  void distrust_globals() { distrusts_globals_ = true; }

  Fact fact(ExprId condition) const;
  static int known(const Parameters& p, Fact fact);  ///< 0 not known, 1 true, 2 false
  void learn(Parameters& p, Fact fact, bool truth) const;
  /// Adds the operations of a line that may fail: `10/[#5-1]`, `SQRT[#5]`, `#[#5]`.
  void note_fallible(const Statement& s, std::vector<ExprId>& out) const;
  /// Whether one of them fails for these values.
  bool will_fail(std::span<const ExprId> operations, const Parameters& p) const;
  /// Adds the parameters that a condition reads, by their keys. Whether its outcomes are followed
  /// exactly: what it compares are parameters with numbers, and they keep their values.
  bool followed(ExprId condition, std::vector<ParameterKey>& reads) const;
  /// A name was read without a stop, or EXISTS has found it. If this run has not assigned it, an earlier run has, and that run
  /// assigned its other globals too.
  void assume_there(NameId name, Parameters& p) const;
  /// Applies what the outcome of a condition says about the parameters that it compares.
  void refine(Parameters& p, ExprId condition, bool truth) const;
  /// Forgets everything that an unknown sub may have changed.
  static void call_outside(Parameters& p);

  /// Adds what the value of an expression depends on; of a condition, also whether its outcome is remembered.
  void note(ExprId id, Dependence& out) const;
  /// The same for a line of assignments and words. False if it may assign a global parameter.
  bool note_assignments(const Statement& s, Dependence& out) const;
  bool distrusts_globals() const { return distrusts_globals_; }
  /// The effect of the machine's INI on the names that depend on it, as a number.
  uint64_t machine_values() const;

  KnownValues& values() const { return values_; }
  /// Keys of `#<_value>` and `#<_value_returned>`, as far as anything reads them.
  std::vector<uint32_t> result_keys() const;
  void set_number(Parameters& p, long number, ValueId value) const;
  /// A sub returns, or its definition is skipped: sets `#<_value>` and `#<_value_returned>`. `value`: null without
  /// one; `never`: the sub has no line that returns a value.
  void come_back(Parameters& p, const ValueId* value, bool never) const;
  /// A call passes its arguments to a sub that has no parameters yet.
  void pass(Parameters& p, std::span<const ValueId> arguments) const;
  /// M98 shares #1 to #30 with its sub, but not names: `names` with the numbers of `numbers`.
  PersistentMap share_numbers(PersistentMap names, const PersistentMap& numbers) const;
  /// What a sub that is called from elsewhere finds: its arguments, and names that a remap passes.
  void expect_from_outside(std::string_view sub, Parameters& p) const;
  void set_name(Parameters& p, NameId name, ValueId value) const;

 private:
  bool global_name(NameId name) const { return kinds_[name] != NameKind::kLocal; }
  void find_relevant();
  void find_facts();
  void forget_facts(Parameters& p, ParameterKey key) const;
  void find_compared();
  void count_comparisons(ExprId id, bool of_while, std::vector<double>& thresholds);
  bool tells_existence(const Expr& comparison, bool truth, NameId* name) const;
  ParameterKey key_of(ExprId side) const;
  ParameterKey key_if_kept(ExprId side) const;
  ParameterKey key_of_name(NameId name) const {
    return global_name(name) ? (kGlobalNames + name) | kGlobalKey : kLocalNames + name;
  }
  uint8_t* compared(ParameterKey key);
  bool is_compared(ParameterKey key) const {
    return std::ranges::binary_search(compared_, key, {}, &std::pair<ParameterKey, uint8_t>::first);
  }
  void assume_assigned(NameId name, Parameters& p) const;
  void find_existing(Parameters& p, ExprId condition, bool truth) const;
  void narrow(Parameters& p, ExprId side, Operator op, ExprId other, bool truth) const;
  bool mark(ExprId id);
  bool mark_number(long number);
  void mark_operand(ExprId id);
  void note_fallible(ExprId id, std::vector<ExprId>& out) const;
  void mark_what_can_fail(ExprId id);
  void note_number(long number, Dependence& out) const;
  void note_name(NameId name, Dependence& out) const;
  ValueId read_number(long number, const Parameters& in) const;
  Evaluation read_name(NameId name, const Parameters& in, bool zero_when_unassigned, bool defining, ReadLog* log) const;
  Evaluation exists(const Expr& expr, const Parameters& in) const;
  void forget_numbers(Parameters& p) const;

  const Syntax& syntax_;
  const Profile& profile_;
  const Limits& limits_;
  KnownValues& values_;
  PersistentMap::Pool& pool_;
  std::vector<NameKind> kinds_;  // by name
  // Only parameters on which a condition, label, count, argument or value can depend are tracked: others would
  // separate states that behave alike.
  std::vector<bool> relevant_number_;
  std::vector<bool> relevant_name_;
  std::vector<bool> read_argument_;  // #1 to #30 that are read anywhere
  std::vector<uint32_t> arguments_;  // those whose value, or whether they were passed, matters
  std::vector<bool> kept_;           // names that are assigned anywhere
  std::vector<NameId> globals_;      // global names that are assigned anywhere
  std::vector<bool> asked_for_;      // names that EXISTS asks for anywhere
  std::vector<uint32_t> tracked_numbers_;
  /// How a parameter is compared: once, more than once, in the condition of a `while`; and that it is set to something that is
  /// no plain number, so that it may count, or that an operation can fail for its value.
  enum Comparison : uint8_t { kOnce = 1, kMoreThanOnce = 2, kByLoop = 4, kComputed = 8, kCanFail = 16 };
  std::vector<std::pair<ParameterKey, uint8_t>> compared_;  // sorted, each parameter once
  NameId value_name_;                                       // `#<_value>`; kNoName where nothing reads it
  NameId value_returned_name_;
  std::vector<Fact> facts_;  // by condition, as far as there are any
  std::unordered_map<ParameterKey, std::vector<uint32_t>> facts_of_;
  bool computed_targets_ = false;
  bool computed_reads_ = false;  // `#[#1]`, where the value matters
  bool coarse_ = false;
  bool distrusts_globals_ = false;
};

}  // namespace owlint::flow
