// What is known of parameters: nothing, one constant, or that something was assigned. Constants come from literals
// and arithmetic on them; everything else is unknown, so that both outcomes of a condition are followed.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "analyzer/flow/persistent_map.h"
#include "analyzer/syntax/statement.h"

namespace owlint::flow {

/// A value in a state's parameter maps. Constants are numbered from kFirstConstant.
using ValueId = uint32_t;
inline constexpr ValueId kUnassigned = 0;       ///< not assigned on any path so far
inline constexpr ValueId kUnknown = 1;          ///< assigned, value not known
inline constexpr ValueId kMaybeUnassigned = 2;  ///< assigned on some paths
inline constexpr ValueId kNotPassed = 3;        ///< #n of a sub whose call passes fewer arguments: reads 0
inline constexpr ValueId kFirstConstant = 4;

/// #1 to #30 belong to the sub that is executed, named ones without `_` too; the rest is global.
inline constexpr long kFirstGlobalNumber = 31;
inline constexpr long kLastNumber = 5601;
/// From here on positions, offsets, probe results, tool data: the machine changes these between two lines.
inline constexpr long kFirstVolatileNumber = 5061;

/// Keys of names in Parameters: these plus the NameId. Numbers are their own keys.
inline constexpr uint32_t kLocalNames = 32;
inline constexpr uint32_t kGlobalNames = 8192;

class Constants {
 public:
  ValueId intern(double value);
  bool is_constant(ValueId id) const { return id >= kFirstConstant; }
  double value(ValueId id) const { return values_[id - kFirstConstant]; }

 private:
  std::vector<double> values_;
  std::unordered_map<uint64_t, ValueId> ids_;
};

/// A condition, the same for all lines that test the same thing. While nothing that it reads is assigned, it has the
/// same outcome every time: two `if [#1 EQ 0]` in a row go the same way.
struct Fact {
  uint32_t id = 0;      ///< 0: not tracked
  bool global = false;  ///< reads globals only; otherwise locals only
};

/// A parameter by number or by name.
struct ParameterId {
  uint32_t id = 0;  ///< the number, or a NameId
  bool named = false;
};

/// What is known when two paths meet.
ValueId join_values(ValueId a, ValueId b);

/// Parameters as one state sees them.
struct Parameters {
  PersistentMap locals;   ///< keys: 1-30, and kLocalNames + NameId
  PersistentMap globals;  ///< keys: number, and kGlobalNames + NameId
  PersistentMap local_facts;   ///< conditions on locals whose outcome is known: FactId -> 1 true, 2 false
  PersistentMap global_facts;  ///< the same for conditions on globals
  bool outside = false;   ///< an unknown sub has run: globals may have any value
};

/// The result of evaluating an expression in one state.
struct Evaluation {
  ValueId value = kUnknown;
  StopKind fails = StopKind::kNone;      ///< evaluation always stops here
  StopKind may_fail = StopKind::kNone;   ///< on some of the merged paths it stops
  NameId name = kNoName;                 ///< the undefined name
  const char* message = nullptr;         ///< the interpreter's words for a failing operation
};

/// What the evaluator tells about reads, besides the value.
struct ReadLog {
  uint32_t not_passed = 0;  ///< bit n: #n was read though the call did not pass it
};

/// Whether a name is one that LinuxCNC predefines and that cannot be assigned.
bool predefined_name(std::string_view name);
/// Whether a numbered parameter cannot be assigned (#5400-#5413 and #5420-#5428, measured).
bool read_only_number(long number);

/// What the outcome of lines depends on, besides their text.
struct Dependence {
  std::vector<uint32_t> locals, globals;  ///< parameters that they read or assign, by their keys in Parameters
  std::string circumstances;  ///< what the evaluator tracks of these, because of other lines
  bool global_facts = false;  ///< a condition on globals whose outcome is remembered
  bool known = true;          ///< false: there is more that cannot be told
};

class Evaluator {
 public:
  Evaluator(const Syntax& syntax, Constants& constants, PersistentMap::Pool& pool);

  /// Evaluates `id`. `zero_when_unassigned`: numbered parameters that the program never set read 0, as they do
  /// in a freshly started interpreter; used only to tell whether a value can fail. `defining`: while a sub
  /// definition is passed over, undefined names do not stop.
  Evaluation evaluate(ExprId id, const Parameters& in, bool zero_when_unassigned, bool defining, ReadLog* log) const;

  /// Applies the assignments of a line, in order, after all its values were read.
  /// Returns what stops it, if anything does.
  Evaluation assign(const Statement& s, Parameters& parameters, ReadLog* log) const;

  /// From now on constants are only "assigned", and outcomes are not remembered: for very large programs.
  void set_coarse() { coarse_ = true; }
  /// Whether reading a global name cannot fail, whatever was assigned.
  bool always_there(NameId global) const;
  /// Whether a parameter can be read, and nothing is known of its value.
  bool is_plain(ParameterId p, const Parameters& in) const;
  /// Assigns something, on every way or only perhaps.
  void assign_unknown(ParameterId p, bool certain, Parameters& parameters) const;

  /// From now on nothing is known of global parameters: code that is not read as O-words may change them.
  void distrust_globals() { distrusts_globals_ = true; }

  Fact fact(ExprId condition) const;
  static int known(const Parameters& p, Fact fact);  ///< 0 not known, 1 true, 2 false
  void learn(Parameters& p, Fact fact, bool truth) const;
  /// Forgets all that an unknown sub may have changed.
  static void call_outside(Parameters& p);

  /// Adds what the value of an expression depends on; of a condition, also whether its outcome is remembered.
  void note(ExprId id, Dependence& out) const;
  /// The same for a line of assignments and words. False if it may assign a global parameter.
  bool note_assignments(const Statement& s, Dependence& out) const;
  bool distrusts_globals() const { return distrusts_globals_; }

  Constants& constants() const { return constants_; }
  void set_number(Parameters& p, long number, ValueId value) const;
  /// M98 shares #1 to #30 with its sub, but not names: `names` with the numbers of `numbers`.
  PersistentMap share_numbers(PersistentMap names, const PersistentMap& numbers) const;
  /// What a sub that is called from elsewhere finds: its arguments, and names that a remap passes.
  void expect_from_outside(Parameters& p) const;
  void set_name(Parameters& p, NameId name, ValueId value) const;

 private:
  void find_relevant();
  void find_facts();
  void forget_facts(Parameters& p, uint32_t key, bool global) const;
  bool mark(ExprId id);
  void note_number(long number, Dependence& out) const;
  void note_name(NameId name, Dependence& out) const;
  ValueId read_number(long number, const Parameters& in) const;
  Evaluation read_name(NameId name, const Parameters& in, bool defining) const;
  Evaluation exists(const Expr& expr, const Parameters& in) const;
  void forget_numbers(Parameters& p) const;

  const Syntax& syntax_;
  Constants& constants_;
  PersistentMap::Pool& pool_;
  // Only parameters on which a condition, label, count, argument or value can depend are tracked: others would
  // tell states apart that behave alike.
  std::vector<bool> relevant_number_;
  std::vector<bool> relevant_name_;
  std::vector<bool> read_argument_;  // #1 to #30 that are read anywhere
  std::vector<bool> kept_;           // names that are assigned, or asked for by EXISTS, anywhere
  std::vector<uint32_t> tracked_numbers_;
  std::vector<Fact> facts_;                                          // by condition, as far as there are any
  std::unordered_map<uint32_t, std::vector<uint32_t>> facts_of_[2];  // by parameter key: local, global
  bool computed_targets_ = false;
  bool coarse_ = false;
  bool distrusts_globals_ = false;
};

}  // namespace owlint::flow
