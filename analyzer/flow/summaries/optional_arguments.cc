#include "analyzer/flow/summaries/optional_arguments.h"

#include <algorithm>

#include "analyzer/flow/domain/parameters.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

OptionalArguments::OptionalArguments(const Program& program)
    : program_(program), count_(program.syntax.names.find("n_args")) {
  const Syntax& syntax = program.syntax;
  for (StatementId id = 0; id < program.size(); ++id) {
    const Statement& s = program.at(id);
    const RegionId region = program.region_of[id];
    const bool condition = s.is(Keyword::kIf) || s.is(Keyword::kElseif) || s.is(Keyword::kWhile);
    for (const ExprId value : syntax.values_of(s)) note(region, value, condition);
    for (const Item& item : syntax.items_of(s)) {
      note(region, item.value, false);
      if (item.target != kNoExpr) note(region, item.target, false);
    }
  }
}

// Depth is bounded by the length of a line, here and below.
void OptionalArguments::note(RegionId region, ExprId value, bool condition) {
  const Expr& expr = program_.syntax.exprs[value];
  if (expr.op == Operator::kNumber) return;
  if (expr.op == Operator::kNamed || expr.op == Operator::kExistsNamed) {
    read_.insert(key(region, expr.name()));
    const bool global = is_global_name(program_.name(expr.name()));
    if (condition && expr.op == Operator::kNamed) tested_.insert(key(global ? kMainRegion : region, expr.name()));
    return;
  }
  double number = 0;
  if ((condition && expr.op == Operator::kParameter) || expr.op == Operator::kExistsNumbered) {
    if (literal_value(program_.syntax.exprs, expr.left(), &number) && number > 0 && number < kFirstGlobalNumber)
      tested_numbers_.insert(key(region, static_cast<uint32_t>(number)));
  }
  for_each_operand(expr, [&](ExprId operand) { note(region, operand, condition); });
}

bool OptionalArguments::reads(ExprId value, uint32_t number) const {
  const Expr& expr = program_.syntax.exprs[value];
  double index = 0;
  if (expr.op == Operator::kParameter && literal_value(program_.syntax.exprs, expr.left(), &index))
    return index == number;
  return any_operand(expr, [&](ExprId operand) { return reads(operand, number); });
}

/// Whether all that a line does with #number is to copy it into a name that a condition tests, or that its sub never reads.
bool OptionalArguments::copies(StatementId line, uint32_t number) const {
  const Statement& s = program_.at(line);
  if (s.kind != LineKind::kWords) return false;
  const RegionId region = program_.region_of[line];
  bool copied = false;
  for (const Item& item : program_.syntax.items_of(s)) {
    if (!reads(item.value, number)) continue;
    if (item.target_name == kNoName || program_.syntax.exprs[item.value].op != Operator::kParameter) return false;
    const bool global = is_global_name(program_.name(item.target_name));
    const bool unread = !global && !read_.contains(key(region, item.target_name));
    if (!unread && !tested_.contains(key(global ? kMainRegion : region, item.target_name))) return false;
    copied = true;
  }
  return copied;
}

/// Whether more of the sub's calls are without #number than with it, and at least two: then that is how the sub is used. A sub
/// to which no call passes it reads a 0 that nobody meant.
bool OptionalArguments::mostly_left_out(RegionId region, uint32_t number) const {
  const NameId sub = program_.regions[region].name;
  if (sub == kNoName) return false;
  size_t with = 0;
  size_t without = 0;
  for (const StatementId id : program_.by_label[sub]) {
    if (program_.at(id).is(Keyword::kCall)) ++(program_.at(id).value_count >= number ? with : without);
  }
  return with > 0 && without > std::max<size_t>(with, 1);
}

bool OptionalArguments::optional(StatementId line, uint32_t number) const {
  const RegionId region = program_.region_of[line];
  if (count_ != kNoName && read_.contains(key(region, count_))) return true;
  return tested_numbers_.contains(key(region, number)) || copies(line, number) || mostly_left_out(region, number);
}

}  // namespace owlint::flow
