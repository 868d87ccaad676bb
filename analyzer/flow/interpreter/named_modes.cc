// The modes that a program reads under names: `#<_metric>` is 1 behind a G21, and where `if [#<_feed> EQ 0]` is false, a feed is
// set. Before the program has set a mode, it may be any: the machine may have run another program before.
#include "analyzer/flow/facts/conditions.h"
#include "analyzer/flow/interpreter/mode_access.h"
#include "analyzer/flow/interpreter/new_machine.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

bool ModeAccess::has_said(const Parameters& p, Mode mode) const {
  return p.globals.get(said_key(mode)) == values_.intern(1);
}

void ModeAccess::say(Parameters& p, ModeMask modes) {
  for (ModeMask set = modes & uses_.named(); set != 0; set &= set - 1)
    p.globals.set(pool_, said_key(static_cast<Mode>(std::countr_zero(set))), values_.intern(1));
}

std::optional<Range> ModeAccess::shown(const Parameters& p, const std::optional<ModeName>& shown) const {
  if (!shown || (uses_.named() & mask_of(shown->mode())) == 0) return std::nullopt;
  const Mode mode = shown->mode();
  const ValueSet may =
      has_said(p, mode) ? mode_values(values_, mode, p.globals.get(mode_key(mode))).may : all_values(mode);
  const auto numbers = shown->numbers(may);
  return numbers ? std::optional(Range{numbers->least, numbers->greatest}) : std::nullopt;
}

std::optional<Range> ModeAccess::shown(const Parameters& p, const std::optional<PlaceName>& shown) const {
  if (!shown || !uses_.follows_place() || p.outside) return std::nullopt;
  const auto surely = [&](Mode mode, uint8_t value) {
    if (!uses_.follows(mode)) return uses_.others()[mode] == value_bit(value);
    return mode_values(values_, mode, p.globals.get(mode_key(mode))).may == value_bit(value);
  };
  // In diameter mode X is read as one, and on a compensated path nobody knows where the tool is.
  const bool as_it_is =
      !shown->axis() || (surely(Mode::kDiameter, modes::kG8) && surely(Mode::kCompensation, modes::kG40));
  if (!as_it_is) return std::nullopt;
  const ValueId before = p.globals.get(kReadPlaceKey);
  const auto number =
      shown->number(KnownValues::is_place(before) ? values_.place(before) : place(p), is_on_new_machine(p));
  return number ? std::optional(Range::of(*number)) : std::nullopt;
}

std::optional<Range> ModeAccess::named(const Parameters& p, std::string_view name) const {
  const auto mode = shown(p, ModeName::find(name));
  return mode ? mode : shown(p, PlaceName::find(name));
}

std::optional<Range> ModeAccess::numbered(const Parameters& p, long number) const {
  const auto mode = shown(p, ModeName::find(number));
  return mode ? mode : shown(p, PlaceName::find(number));
}

bool ModeAccess::learn(Parameters& p, const Syntax& syntax, ExprId condition, bool truth) {
  if (uses_.named() == 0) return true;
  bool possible = true;
  const auto visit = [&](ExprId side, Operator op, ExprId other, bool outcome) {
    double number = 0;
    const auto shown = ModeName::read_by(syntax, syntax.exprs[side]);
    if (!shown || (uses_.named() & mask_of(shown->mode())) == 0) return;
    if (other != kNoExpr && !literal_value(syntax.exprs, other, &number)) return;
    const Mode mode = shown->mode();
    const bool said = has_said(p, mode);
    ModeValues values =
        said ? mode_values(values_, mode, p.globals.get(mode_key(mode))) : ModeValues{all_values(mode), true};
    const ValueSet left = shown->with(values.may, op, number, outcome);
    possible = possible && left != 0;
    if (left == 0 || left == values.may) return;
    values.may = left;
    p.globals.set(pool_, mode_key(mode), mode_value(values_, mode, values));
    say(p, mask_of(mode));
  };
  for_known_comparisons(syntax.exprs, condition, truth, visit);
  if (truth && syntax.exprs[condition].op == Operator::kNamed) visit(condition, Operator::kNe, kNoExpr, true);
  return possible;
}

}  // namespace owlint::flow
