// OW613 comparison-chained: a comparison of the result of another comparison, as `[0 LT #1 LT 5]`.
// Depends on: comparisons have one precedence and are computed from the left; their result is 0 or 1 (measured).
#include <algorithm>
#include <array>
#include <optional>

#include "rules/driver/idioms.h"
#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow613 {
namespace {

bool is_comparison(Operator op) { return op >= Operator::kEq && op <= Operator::kLe; }

/// Whether the left side of a comparison is a comparison without brackets of its own.
// Depth is bounded by the length of a line.
bool chains(const Program& p, ExprId id) {
  const Expr& expr = p.syntax.exprs[id];
  if (is_comparison(expr.op)) {
    const Expr& left = p.syntax.exprs[expr.left()];
    if (is_comparison(left.op) && !left.complete) return true;
  }
  return any_operand(expr, [&](ExprId operand) { return chains(p, operand); });
}

/// Three values with two comparisons between them.
struct Chain {
  std::array<std::string, 3> values;
  std::array<std::string, 2> comparisons;
  Span span;
};

/// Finds the chain on a line.
class Search {
 public:
  Search(const Source& source, const Statement& s) : source_(source) {
    line_.assign(source.slice(s.whole()), s.offset);
    at_ = line_.text().find('[');
  }

  std::optional<Chain> run() {
    bracket();
    return std::move(found_);
  }

 private:
  /// Reads a pair of brackets, and what is in it.
  // Depth is bounded by the length of a line.
  void bracket() {
    ++at_;
    std::array<size_t, 3> begins{at_, 0, 0};
    std::array<size_t, 2> signs{};
    size_t count = 0;
    const auto end_part = [&] {
      if (count == 2 && !found_) take(begins, signs, at_);
      count = 0;
    };
    while (at_ < line_.size() && line_[at_] != ']' && line_[at_] != ';') {
      if (line_[at_] == '[') {
        bracket();
        continue;
      }
      if (line_[at_] == '<') at_ = std::min(line_.text().find('>', at_), line_.size() - 1);
      const std::string_view rest = line_.text().substr(at_);
      constexpr std::array<std::string_view, 3> kJoints = {"and", "xor", "or"};
      constexpr std::array<std::string_view, 6> kComparisons = {"eq", "ne", "gt", "ge", "lt", "le"};
      const auto begins_with = [&](std::string_view word) { return rest.starts_with(word); };
      if (const auto* const joint = std::ranges::find_if(kJoints, begins_with); joint != kJoints.end()) {
        end_part();
        at_ += joint->size();
        begins[0] = at_;
      } else if (std::ranges::any_of(kComparisons, begins_with)) {
        if (count < 2) {
          signs[count] = at_;
          begins[++count] = at_ + 2;
        } else if (!found_) {  // the first two of several
          take(begins, signs, at_);
        }
        at_ += 2;
      } else {
        ++at_;
      }
    }
    end_part();
    if (at_ < line_.size()) ++at_;
  }

  void take(const std::array<size_t, 3>& begins, const std::array<size_t, 2>& signs, size_t end) {
    Chain chain;
    const auto text = [&](size_t from, size_t to) { return std::string(source_.slice(line_.span(from, to))); };
    chain.values = {text(begins[0], signs[0]), text(begins[1], signs[1]), text(begins[2], end)};
    chain.comparisons = {text(signs[0], signs[0] + 2), text(signs[1], signs[1] + 2)};
    chain.span = line_.span(begins[0], end);
    found_ = std::move(chain);
  }

  const Source& source_;
  LineText line_;
  size_t at_ = 0;
  std::optional<Chain> found_;
};

/// Whether both comparisons go in one direction, so that they are meant as one of three values.
bool same_direction(const Chain& chain) {
  const std::string first = small_letters(chain.comparisons[0]);
  const std::string second = small_letters(chain.comparisons[1]);
  return first[0] == second[0] && first != "ne" && second != "ne" && (first != "eq" || second == "eq");
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const StatementId id : in.index.tests) {
    const Statement& s = p.at(id);
    if (s.length > kLineLimit || !chains(p, p.syntax.values_of(s).front())) continue;
    const std::optional<Chain> chain = Search(*p.source, s).run();
    if (!chain) continue;
    const auto& [first, second, third] = chain->values;
    const auto& [one, two] = chain->comparisons;
    const std::string sign = small_letters(two);
    // `[#1 LT 5 EQ 0]` asks whether the comparison is false.
    if ((sign == "eq" || sign == "ne") && (third == "0" || third == "1")) continue;
    const std::string left = first + " " + one + " " + second;
    Finding& f =
        out.add(chain->span, "this compares the result of `" + left + "`, which is 0 or 1, with `" + third + "`");
    f.reach = in.flow.reach(id);
    f.help = "write brackets around what belongs together";
    if (!same_direction(*chain)) continue;
    const std::string right = "[" + left + "] AND [" + second + " " + two + " " + third + "]";
    f.help = "write `[" + right + "]`";
    f.fixes.push_back({f.help, false, {{chain->span, right}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW613",
    .name = "comparison-chained",
    .summary = "a comparison of the result of another comparison",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A condition with two comparisons in a row and no brackets or `AND` between them, as one writes a
range on paper: `[0 LT #1 LT 5]`.)",
            .why = R"(LinuxCNC computes comparisons from the left. The result of `0 LT #1` is 0 or 1, and that is less
than 5, whatever `#1` is: the condition is always true. There is no message.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
            .bad = R"(G21 G90
G0 X0 Y0 Z5
#1 = 9
o100 if [0 LT #1 LT 5]
  G0 X10
o100 endif
M2
)",
            .good = R"(G21 G90
G0 X0 Y0 Z5
#1 = 9
o100 if [[0 LT #1] AND [#1 LT 5]]
  G0 X10
o100 endif
M2
)",
            .fix =
                R"(Write two comparisons and join them with `AND`. Write brackets if the result of a comparison is meant
to be compared.)",
            .level_reason = "Warning: the program runs, but the condition is not the one that was meant.",
            .interpreter = "",
            .options = "",
            .moves = "X10",
            .moves_good = "X0",
        },
    .check = check,
};

}  // namespace owlint::rules::ow613
