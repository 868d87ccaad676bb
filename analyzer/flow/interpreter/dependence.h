// What the outcome of lines depends on: the parameters in them, and what is tracked of these because of lines elsewhere.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/flow/interpreter/refinement.h"
#include "analyzer/flow/interpreter/remembered_conditions.h"
#include "analyzer/flow/interpreter/tracked_parameters.h"

namespace owlint::flow {

/// What the outcome of lines depends on, besides their text.
struct Dependence {
  std::vector<uint32_t> locals, globals;  ///< parameters that they read or assign, by their keys in Parameters
  std::string circumstances;              ///< what is tracked about them because of other lines
  bool global_outcomes = false;           ///< a condition on globals whose outcome is remembered
  bool known = true;                      ///< false: there are more values, and they are not known
};

class Dependences {
 public:
  /// All must outlive it.
  Dependences(const Syntax& syntax, const TrackedParameters& tracked, const RememberedConditions& remembered,
              const Refinement& refinement)
      : syntax_(syntax), tracked_(tracked), remembered_(remembered), refinement_(refinement) {}

  /// Adds what the value of an expression depends on; of a condition, also whether its outcome is remembered.
  void note(ExprId id, Dependence& out) const;
  /// The same for a line of assignments and words. False if it may assign a global parameter.
  bool note_assignments(const Statement& s, Dependence& out) const;

 private:
  void note_number(long number, Dependence& out) const;
  void note_name(NameId name, Dependence& out) const;

  const Syntax& syntax_;
  const TrackedParameters& tracked_;
  const RememberedConditions& remembered_;
  const Refinement& refinement_;
};

}  // namespace owlint::flow
