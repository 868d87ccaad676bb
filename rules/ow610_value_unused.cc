// OW610 value-unused: a parameter that is assigned and never read, or assigned again on the next line.
// Rests on: names without `_` are the sub's own; a line's values are read before it assigns.
#include <algorithm>

#include "rules/parameters.h"

namespace owlint::rules {
namespace {

std::string sorted(std::string text) {
  std::ranges::sort(text);
  return text;
}

/// The name that was probably meant: one that is read, with a letter more or less, or the same letters. Names that differ in
/// one letter are often those of two axes.
std::string meant(const Program& p, NameId name) {
  const std::string& text = p.name(name);
  const std::string letters = sorted(text);
  std::vector<std::string> names;
  for (const Expr& expr : p.syntax.exprs) {
    if (expr.op != Operator::kNamed || expr.target) continue;
    const std::string& other = p.name(expr.name());
    if (other.size() != text.size() || sorted(other) == letters) names.push_back(other);
  }
  return nearest(text, names, 2);
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  constexpr size_t kMaxSuggestions = 20;  // each goes through all names
  size_t suggestions = 0;
  for (const flow::UnusedValue& u : in.data.unused()) {
    const std::string words = parameter_words(p, u.parameter);
    const std::string where = region_words(p, p.region_of[u.statement]);
    if (u.overwritten != kNoStatement) {
      Finding& f = out.add(item_span(p, u.statement, u.item), words + " is assigned again before anything reads this value");
      relate(f, p, u.overwritten, "assigned again here");
      f.help = "remove one of the two lines, or assign to another parameter";
      f.reach = in.flow.reach(u.statement);
      continue;
    }
    Finding& f = out.add(item_span(p, u.statement, u.item), words + " is assigned here and never read in " + where);
    const std::string near = suggestions++ < kMaxSuggestions ? meant(p, u.parameter.id) : std::string();
    f.help = (near.empty() ? "remove the line" : "did you mean `#<" + near + ">`") + "; a name without `_` can be read only in the sub that assigns it";
    f.reach = in.flow.reach(u.statement);
  }
}

}  // namespace

extern const Rule kOw610{
    .code = "OW610",
    .name = "value-unused",
    .summary = "a parameter assigned and overwritten or never read",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A name that a sub or the main program assigns and nowhere reads: often another name is spelt almost
alike. Or a value that the next line overwrites. A name that `(debug, …)`, `(print, …)` or `(log, …)`
prints counts as read; one that only gives a name to another parameter (`#<feed> = #3`) is not reported;
global names and numbers above `#30` may be read by other programs.)",
        .why = R"(LinuxCNC makes a new parameter of every name that it has not met, so a slip of the pen sets one that
nothing reads, and the one that is meant keeps its old value. No message: in the first program below
the machine goes to X10.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
#<width> = 10
G0 Z5 Y#<width>
#<widht> = 60
G0 X#<width>
M2
)",
        .good = R"(G21 G90
#<width> = 10
G0 Z5 Y#<width>
#<width> = 60
G0 X#<width>
M2
)",
        .fix = R"(Correct the name, or remove the line.)",
        .interpreter = "",
        .options = "",
        .moves = "X10",
        .moves_good = "X60",
    },
    .check = check,
};

}  // namespace owlint::rules
