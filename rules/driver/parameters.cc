#include "rules/driver/parameters.h"

#include <cmath>

namespace owlint::rules {

std::string parameter_words(const Program& program, flow::ParameterId parameter) {
  return "`" + flow::parameter_text(program, parameter) + "`";
}

std::string returning_sub(const Elsewhere& line, std::string_view otherwise) {
  const bool known = line.program != nullptr && line.program->at(line.statement).label != kNoName;
  return known ? "`" + line.program->label_at(line.statement) + "`" : std::string(otherwise);
}

Span item_span(const Program& program, StatementId statement, uint32_t item) {
  const Statement& s = program.at(statement);
  const Item& place = program.syntax.items[s.first + item];
  return place.from < place.to ? s.span(place.from, place.to) : s.whole();
}

std::string region_words(const Program& program, RegionId region) {
  return region == kMainRegion ? "the main program" : "`" + program.label_text(program.regions[region].name) + "`";
}

std::string argument_words(uint32_t bits) {
  std::vector<std::string> names;
  for (int n = 1; n < 32; ++n) {
    if ((bits >> n & 1) != 0) names.push_back("`#" + std::to_string(n) + "`");
  }
  std::string out;
  for (size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

// Depth is bounded by the length of a line.
bool computes_fraction(const Program& p, ExprId id) {
  const Expr& expr = p.syntax.exprs[id];
  const auto fraction = [&](ExprId operand) {
    const Expr& number = p.syntax.exprs[operand];
    return number.op == Operator::kNumber && number.value() != std::floor(number.value());
  };
  switch (expr.op) {
    case Operator::kNumber:
    case Operator::kExistsNamed:
    case Operator::kExistsNumbered:
    case Operator::kNamed:
    case Operator::kParameter:
    case Operator::kFix:
    case Operator::kFup:
    case Operator::kRound: return false;
    case Operator::kDivide:
    case Operator::kSqrt:
    case Operator::kSin:
    case Operator::kCos:
    case Operator::kTan:
    case Operator::kAsin:
    case Operator::kAcos:
    case Operator::kAtan:
    case Operator::kExp:
    case Operator::kLn: return true;
    case Operator::kPlus:
    case Operator::kMinus:
    case Operator::kTimes:
      if (fraction(expr.left()) || fraction(expr.right())) return true;
      break;
    default: break;
  }
  return computes_fraction(p, expr.left()) || (expr.right() != kNoExpr && computes_fraction(p, expr.right()));
}

}  // namespace owlint::rules
