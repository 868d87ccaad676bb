#include "analyzer/flow/facts/accesses.h"

#include <algorithm>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
ParameterKey key_of_name(const Syntax& syntax, NameId name) {
  return is_global_name(syntax.names.text(name)) ? (kGlobalNames + name) | kGlobalKey : kLocalNames + name;
}

ParameterKey key_of_number(const Syntax& syntax, ExprId number) {
  const Expr& expr = syntax.exprs[number];
  double value = expr.op == Operator::kNumber ? expr.value() : 0;
  long index = 0;
  if (expr.op != Operator::kNumber && !literal_value(syntax.exprs, number, &value)) return kComputedKey;
  if (!to_integer(value, &index) || index < 0 || index > kLastNumber) return kComputedKey;
  return static_cast<uint64_t>(index) | (index >= kFirstGlobalNumber ? kGlobalKey : 0);
}

ParameterKey key_of_target(const Syntax& syntax, const Item& item) {
  return item.target_name != kNoName ? key_of_name(syntax, item.target_name) : key_of_number(syntax, item.target);
}

ParameterId parameter_of(ParameterKey key) {
  const auto plain = static_cast<uint32_t>(key);
  const uint32_t names = is_global(key) ? kGlobalNames : kLocalNames;
  return plain >= names ? ParameterId{plain - names, true} : ParameterId{plain, false};
}

AccessTable::AccessTable(const Program& program, std::span<const uint32_t> statements,
                         std::span<const ShownRead> shown) {
  any_.reserve(statements.size());
  first_read_.reserve(statements.size() + 1);
  first_write_.reserve(statements.size() + 1);
  reads_.reserve(statements.size());
  writes_.reserve(std::min(statements.size(), program.syntax.items.size()));
  first_read_.push_back(0);
  first_write_.push_back(0);
  for (const StatementId id : statements) {
    add(program, id);
    add_shown(shown, id);
    first_read_.push_back(static_cast<uint32_t>(reads_.size()));
    first_write_.push_back(static_cast<uint32_t>(writes_.size()));
  }
}

Accesses AccessTable::lines(size_t first, size_t count) const {
  Accesses out;
  out.first_read_ = first_read_.data() + first;
  out.first_write_ = first_write_.data() + first;
  out.reads_ = std::span(reads_).subspan(first_read_[first], first_read_[first + count] - first_read_[first]);
  out.writes_ = std::span(writes_).subspan(first_write_[first], first_write_[first + count] - first_write_[first]);
  out.any_ = std::span(any_).subspan(first, count);
  out.reads_any_ = std::ranges::count(out.any_, 1) > 0;
  out.writes_any_ = std::ranges::count(out.writes_, kComputedKey, &Write::key) > 0;
  return out;
}

// Depth is bounded by the length of a line.
void AccessTable::read(const Syntax& syntax, ExprId id) {
  const Expr& expr = syntax.exprs[id];
  switch (expr.op) {
    case Operator::kNumber: return;
    case Operator::kNamed:
    case Operator::kExistsNamed: reads_.push_back(key_of_name(syntax, expr.name())); return;
    case Operator::kParameter:
    case Operator::kExistsNumbered:
      if (const ParameterKey key = key_of_number(syntax, expr.left()); key != kComputedKey) {
        reads_.push_back(key);
        return;
      }
      any_.back() = 1;
      break;
    default: break;
  }
  for_each_operand(expr, [&](ExprId operand) { read(syntax, operand); });
}

void AccessTable::add(const Program& program, StatementId id) {
  const Syntax& syntax = program.syntax;
  const Statement& s = program.at(id);
  any_.push_back(0);
  if (s.label_expr != kNoExpr) read(syntax, s.label_expr);
  for (const ExprId value : syntax.values_of(s)) read(syntax, value);
  const std::span<const Item> items = syntax.items_of(s);
  for (uint32_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    read(syntax, item.value);
    if (!assigns(item)) continue;
    writes_.push_back({key_of_target(syntax, item), i});
    if (item.target != kNoExpr) read(syntax, item.target);
  }
  const LineError* error = syntax.error(s);
  for (ExprId at = error == nullptr ? 0 : error->read_from; error != nullptr && at < error->read_to; ++at) {
    if (!syntax.exprs[at].target) read(syntax, at);
  }
}

void AccessTable::add_shown(std::span<const ShownRead> shown, StatementId id) {
  for (auto read = std::ranges::lower_bound(shown, id, {}, &ShownRead::statement);
       read != shown.end() && read->statement == id; ++read)
    reads_.push_back(read->key);
}

}  // namespace owlint::flow
