// Which parameters matter: those on which a condition, label, count, argument or value can depend. Only they are tracked: others
// would separate states that behave alike (slicing). All of it is known before the program runs.
#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/flow/facts/accesses.h"
#include "analyzer/flow/limits.h"
#include "analyzer/machine/predefined.h"
#include "analyzer/syntax/statement.h"

namespace owlint::flow {

class TrackedParameters {
 public:
  TrackedParameters(const Syntax& syntax, const Profile& profile, const Limits& limits);

  NameKind kind(NameId name) const { return kinds_[name]; }
  bool is_global(NameId name) const { return kinds_[name] != NameKind::kLocal; }
  /// The number of names; NameId is below.
  size_t names() const { return kinds_.size(); }
  /// Whether something depends on a parameter's value. `number`: 1 to kLastNumber.
  bool number_matters(long number) const { return number_matters_[static_cast<size_t>(number)]; }
  bool name_matters(NameId name) const { return name_matters_[name]; }
  /// Whether some line reads one of #1 to #30.
  bool is_read(long argument) const { return argument_is_read_[static_cast<size_t>(argument)]; }
  /// Whether some line assigns a name.
  bool is_assigned(NameId name) const { return assigned_[name]; }
  /// Whether EXISTS asks for a name anywhere.
  bool is_asked_for(NameId name) const { return asked_for_[name]; }

  /// Those of #1 to #30 whose value, or whether they were passed, matters.
  const std::vector<uint32_t>& arguments() const { return arguments_; }
  /// Global names that are assigned anywhere.
  const std::vector<NameId>& assigned_globals() const { return assigned_globals_; }
  /// Numbers that matter.
  const std::vector<uint32_t>& numbers() const { return numbers_; }
  /// Parameters for whose values an operation can fail, as often as they are in one.
  const std::vector<ParameterKey>& operands() const { return operands_; }
  /// A number to write to, or one to read from where the value matters, is computed.
  bool computes_targets() const { return computes_targets_; }
  bool computes_reads() const { return computes_reads_; }

  ParameterKey key_of_name(NameId name) const {
    return is_global(name) ? (kGlobalNames + name) | kGlobalKey : kLocalNames + name;
  }
  /// The key of a parameter that is alone on one side of a comparison; kComputedKey for anything else.
  ParameterKey key_of(ExprId side) const;
  /// The same, if it keeps its value until it is set again.
  ParameterKey lasting_key_of(ExprId side) const;

 private:
  void find_uses();
  void find_what_matters(const Limits& limits);
  bool spread();
  bool mark(ExprId id);
  bool mark_number(long number);
  void mark_operand(ExprId id);
  void mark_what_can_fail(ExprId id);

  const Syntax& syntax_;
  std::vector<NameKind> kinds_;  // by name
  std::vector<bool> number_matters_, name_matters_, argument_is_read_, assigned_, asked_for_;
  std::vector<uint32_t> arguments_, numbers_;
  std::vector<NameId> assigned_globals_;
  std::vector<ParameterKey> operands_;
  bool computes_targets_ = false;
  bool computes_reads_ = false;
};

}  // namespace owlint::flow
