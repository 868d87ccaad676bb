#include "analyzer/syntax/place_names.h"

#include "analyzer/syntax/line_parser.h"

namespace owlint {

std::optional<PlaceName> PlaceName::find(long number) {
  constexpr long kTool = 5400, kFirst = 5420;
  if (number == kTool) return PlaceName(std::nullopt);
  if (number < kFirst || number >= kFirst + static_cast<long>(kAxisCount)) return std::nullopt;
  return PlaceName(static_cast<Axis>(number - kFirst));
}

std::optional<PlaceName> PlaceName::find(std::string_view name) {
  if (name == "_current_tool") return PlaceName(std::nullopt);
  if (name.size() != 2 || name[0] != '_') return std::nullopt;
  const size_t axis = std::string_view(kAxisOrder).find(name[1]);
  return axis == std::string_view::npos ? std::nullopt : std::optional(PlaceName(static_cast<Axis>(axis)));
}

std::optional<PlaceName> PlaceName::read_by(const Syntax& syntax, const Expr& expr) {
  if (expr.target) return std::nullopt;
  if (expr.op == Operator::kNamed) return find(syntax.names.text(expr.name()));
  if (expr.op != Operator::kParameter) return std::nullopt;
  const std::optional<long> number = literal_integer(syntax.exprs, expr.left());
  return number ? find(*number) : std::nullopt;
}

std::optional<double> PlaceName::number(const Place& place, bool started) const {
  if (!axis_) return place.loaded_tool > 0 ? std::optional<double>(place.loaded_tool) : std::nullopt;
  const Coordinate at = place.at[*axis_];
  const bool known = started ? !at.is_unknown() : at.is_known();
  return known ? std::optional(at.value) : std::nullopt;
}

}  // namespace owlint
