// With what a run begins.
#include <algorithm>

#include "analyzer/flow/interpreter/evaluator.h"
#include "analyzer/machine/remap_names.h"

namespace owlint::flow {

void Evaluator::expect_from_outside(std::string_view sub, Parameters& p) {
  for (long n = 1; n < kFirstGlobalNumber; ++n) set_number(p, n, kUnknown);
  // A remap passes named parameters: those that the file reads before any of its lines assigns them. Expressions
  // are in the order of the lines, so the ones before an assignment's own value come earlier.
  std::vector<ExprId> assigned(syntax_.names.size(), kNoExpr);
  for (const Item& item : syntax_.items) {
    if (item.target_name != kNoName) assigned[item.target_name] = std::min(assigned[item.target_name], item.value);
  }
  for (ExprId id = 0; id < syntax_.exprs.size(); ++id) {
    const Expr& expr = syntax_.exprs[id];
    if (expr.op != Operator::kNamed || expr.target || id >= assigned[expr.name()]) continue;
    if (is_ini_text(syntax_.names.text(expr.name()), profile_)) continue;  // nobody can assign it
    // Without an INI, a name that some line assigns may be one that Python gives the sub.
    const bool may_be_python = profile_.setup == nullptr && tracked_.is_assigned(expr.name());
    if (tracked_.is_global(expr.name()) || may_be_python ||
        remap_gives(syntax_.names.text(expr.name()), sub, profile_)) {
      // A word that the author asks for may be left out where the code is used.
      set_name(p, expr.name(),
               tracked_.is_asked_for(expr.name()) && !tracked_.is_global(expr.name()) ? kMaybeUnassigned : kUnknown);
    }
  }
}

void Evaluator::expect_from_prolog(Parameters& p) {
  if (!read_locals_) {
    std::vector<bool> read(syntax_.names.size());
    read_locals_.emplace();
    for (const Expr& expr : syntax_.exprs) {
      if (expr.op != Operator::kNamed || expr.target || tracked_.is_global(expr.name()) || read[expr.name()]) continue;
      read[expr.name()] = true;
      read_locals_->push_back(expr.name());
    }
  }
  for (long n = 1; n < kFirstGlobalNumber; ++n) set_number(p, n, kUnknown);
  for (const NameId name : *read_locals_) set_name(p, name, tracked_.is_asked_for(name) ? kMaybeUnassigned : kUnknown);
}

void Evaluator::expect_from_python(Parameters& p) {
  for (const Expr& expr : syntax_.exprs) {
    if (expr.op == Operator::kNamed && !expr.target && tracked_.is_global(expr.name()))
      set_name(p, expr.name(), kMaybeUnassigned);
  }
}

}  // namespace owlint::flow
