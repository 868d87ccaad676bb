// OW854 probe-unchecked: the result of G38.3, G38.5 or a wait with M66 is used, and nothing looks at whether it came.
// Depends on: without contact G38.3 and G38.5 go on, and #5061 to #5069 are the end of the move, while G38.2 and G38.4 stop the
// program; M66 goes on when its time is over.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "rules/driver/lines_behind.h"
#include "rules/driver/modes.h"
#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow854 {
namespace {

constexpr uint32_t kFirstPoint = 5061, kLastPoint = 5069;
constexpr uint32_t kTouched = 5070;
constexpr uint32_t kInput = 5399;
constexpr uint32_t kFirstPosition = 5420, kLastPosition = 5428;
constexpr std::string_view kGoesOn = "G38.3 G38.5";

/// Whether this file, or one that it calls, looks at a parameter: in an expression, or in a comment that shows it. Python code
/// may.
bool looked_at(const Input& in, uint32_t number) {
  const auto looks = [&](const LinkedFile& file) {
    const Syntax& syntax = file.program->syntax;
    return syntax.runs_python || std::ranges::any_of(syntax.exprs, [&](const Expr& expr) {
             if (expr.op != Operator::kParameter || expr.target) return false;
             const Expr& of = syntax.exprs[expr.left()];
             return of.op == Operator::kNumber && of.value() == number;
           });
  };
  return std::ranges::any_of(in.linked.files(), looks) ||
      std::ranges::any_of(in.data.shown(), [&](const flow::Shown& shown) {
           return shown.local.empty() && shown.key == (number | flow::kGlobalKey);
         });
}

/// Where a probed point or position is used.
struct Use {
  Span span;
  StatementId statement = kNoStatement;  ///< if the line has one
  std::string sets;                      ///< the code that sets an offset from the position; empty: the point is used
};

/// Follows a probed point through the lines behind its probe move, also where a parameter holds it.
class Point {
 public:
  /// `measures`: the program measures with such moves only. Where others of its moves probe, G38.3 is often a move to a place
  /// that stops if something is in the way.
  Point(const Input& in, uint32_t line, const std::vector<WrittenWord>& probe, bool measures)
      : p_(in.program), line_(line), lines_(p_, line), probe_(probe), measures_(measures) {}

  /// The first use; nothing if a comparison comes before it, which may be the program's way to find out.
  std::optional<Use> first_use() {
    while (lines_.next()) {
      std::optional<Use> use;
      for (const Statement& s : lines_.statements()) {
        if (s.kind == LineKind::kOWord ? compares(s) : takes(s, &use)) return std::nullopt;
      }
      if (!use) use = sets_offset();
      if (use) return use;
      if (find_word(lines_.words(), "G38.2 G38.3 G38.4 G38.5") != nullptr) fresh_ = false;
      if (find_word(lines_.words(), "*") != nullptr) moved_ = true;
      if (!fresh_ && held_.empty()) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  struct Reading {
    bool point = false;
    bool compared = false;
  };

  /// Whether no sub may have probed before, either.
  bool measures() const {
    return measures_ &&
        std::ranges::none_of(p_.calls, [&](const Call& call) { return p_.at(call.statement).line < line_; });
  }

  // Depth is bounded by the length of a line.
  void read(ExprId id, bool comparison, Reading& out) const {
    const Expr& expr = p_.syntax.exprs[id];
    const bool named = expr.op == Operator::kNamed;
    if (named || expr.op == Operator::kParameter) {
      const flow::ParameterKey key =
          named ? flow::key_of_name(p_.syntax, expr.name()) : flow::key_of_number(p_.syntax, expr.left());
      const flow::ParameterId read = flow::parameter_of(key);
      const bool point = fresh_ && !read.named && read.id >= kFirstPoint && read.id <= kLastPoint;
      const bool position = !moved_ && !read.named && read.id >= kFirstPosition && read.id <= kLastPosition;
      if (key != flow::kComputedKey) {
        out.point = out.point || point || held_.contains(key);
        out.compared = out.compared || (comparison && (point || position || held_.contains(key)));
        return;
      }
    }
    const bool compares = comparison || (expr.op >= Operator::kEq && expr.op <= Operator::kLe);
    for_each_operand(expr, [&](ExprId operand) { read(operand, compares, out); });
  }

  /// An O-word whose values ask something of the point, or hand it on.
  bool compares(const Statement& s) const {
    Reading reading;
    for (const ExprId value : p_.syntax.values_of(s)) read(value, true, reading);
    return reading.point || reading.compared;
  }

  /// Takes in a line of words. True if it compares.
  bool takes(const Statement& s, std::optional<Use>* use) {
    std::vector<std::pair<flow::ParameterKey, bool>> assigned;
    for (const Item& item : p_.syntax.items_of(s)) {
      Reading reading;
      if (item.value != kNoExpr) read(item.value, false, reading);
      if (reading.compared) return true;
      if (flow::assigns(item))
        assigned.emplace_back(flow::key_of_target(p_.syntax, item), reading.point);
      else if (reading.point && !*use)
        *use = {s.span(item.from, item.to), static_cast<StatementId>(&s - p_.syntax.statements.data()), ""};
    }
    for (const auto& [key, holds] : assigned) {
      held_.erase(key);
      if (holds && key != flow::kComputedKey) held_.insert(key);
    }
    return false;
  }

  /// G92, or G10 that makes the position the zero, with an axis that was probed.
  std::optional<Use> sets_offset() const {
    if (!fresh_ || moved_) return std::nullopt;
    const std::vector<WrittenWord>& words = lines_.words();
    const WrittenWord* code = find_word(words, "G92");
    if (code == nullptr && find_word(words, "L20 L10 L11") != nullptr) code = find_word(words, "G10");
    if (code == nullptr || !measures()) return std::nullopt;
    for (const std::string_view axis : {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"}) {
      if (find_word(words, axis) != nullptr && find_word(probe_, axis) != nullptr)
        return Use{code->span, kNoStatement, shown(*p_.source, code->span)};
    }
    return std::nullopt;
  }

  const Program& p_;
  const uint32_t line_;
  LinesBehind lines_;
  const std::vector<WrittenWord>& probe_;
  const bool measures_;
  bool fresh_ = true;   // #5061 to #5069 are of this move
  bool moved_ = false;  // the position is another one by now
  std::set<flow::ParameterKey> held_;
};

bool check_probe(const Input& in, Reporter& out, uint32_t line, bool measures) {
  const Source& source = *in.program.source;
  const std::vector<WrittenWord> words = words_of(source, source.line(line));
  const WrittenWord* probe = find_word(words, kGoesOn);
  const std::optional<Use> use = Point(in, line, words, measures).first_use();
  if (!use) return false;
  const std::string code = shown(source, probe->span);
  const std::string what =
      use->sets.empty() ? "the probed point is used here" : "`" + use->sets + "` takes this position as probed";
  Finding& f =
      out.add(use->span, what + ", but nothing tests `#5070`: if the probe touches nothing, `" + code + "` goes on");
  f.related.push_back({probe->span, "`" + code + "` is here", nullptr});
  const bool away = find_word({*probe}, "G38.5") != nullptr;
  f.help = fmt::format("test `#5070` after `{}`, or write `{}`, which stops the program by itself", code,
                       away ? "G38.4" : "G38.2");
  if (use->statement != kNoStatement) f.reach = in.flow.reach(use->statement);
  return true;
}

/// Whether a line waits until an input is on or off, for a time after which a program has to ask. Edges are what buttons give,
/// and a very long time is written for none at all.
bool waits(const std::vector<WrittenWord>& words) {
  constexpr double kForever = 600;  // seconds
  const WrittenWord* time = find_word(words, "Q");
  return find_word(words, "M66") != nullptr && find_word(words, "L3 L4") != nullptr && time != nullptr &&
      time->value.value_or(0) < kForever;
}

/// Whether the machine does something behind the line.
bool goes_on(const Program& p, uint32_t line, const std::vector<WrittenWord>& words) {
  constexpr std::string_view kActs = "* M3 M4 M6";
  if (find_word(words, kActs) != nullptr) return true;
  LinesBehind behind(p, line);
  while (behind.next()) {
    const auto calls = [](const Statement& s) {
      return s.calls() || s.kind == LineKind::kUserCode || s.kind == LineKind::kRemap;
    };
    if (find_word(behind.words(), kActs) != nullptr || std::ranges::any_of(behind.statements(), calls)) return true;
  }
  return false;
}

/// `M190 P2` and then `M66 P3 L3 Q1`: how programs for QtPlasmaC change the material. The machine itself sees to it that the
/// input comes.
bool changes_material(const Source& source, uint32_t line, const std::vector<WrittenWord>& words) {
  if (find_word(words, "P3") == nullptr || find_word(words, "L3") == nullptr) return false;
  constexpr uint32_t kMostLines = 3;
  for (uint32_t above = line; above > 1 && above + kMostLines > line;) {
    if (find_word(words_of(source, source.line(--above)), "M190") != nullptr) return true;
  }
  return false;
}

bool check_wait(const Input& in, Reporter& out, uint32_t line) {
  const Source& source = *in.program.source;
  const std::vector<WrittenWord> words = words_of(source, source.line(line));
  if (changes_material(source, line, words)) return false;
  if (!goes_on(in.program, line, words)) return false;
  const WrittenWord* code = find_word(words, "M66");
  Finding& f = out.add(
      code->span, "`" + shown(source, code->span) + "` also goes on when its time is over, but nothing tests `#5399`");
  f.help = "test `#5399` after it: it is -1 if the input did not come";
  return true;
}

/// `G91 G38.3 Z.0001`: a move of nearly nothing, which only takes the position into #5061 to #5069.
bool reads_position(const Source& source, uint32_t line, const std::vector<WrittenWord>& words) {
  constexpr double kNothing = 0.005;
  bool moves = false;
  for (const std::string_view axis : {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"}) {
    const WrittenWord* word = find_word(words, axis);
    if (word == nullptr) continue;
    if (std::abs(word->value.value_or(1)) > kNothing) return false;
    moves = true;
  }
  constexpr uint32_t kMostLines = 20;
  for (uint32_t above = line; moves && above > 0 && above + kMostLines > line; --above) {
    const std::vector<WrittenWord> other = words_of(source, source.line(above));
    if (find_word(other, "G91") != nullptr) return true;
    if (find_word(other, "G90") != nullptr) return false;
  }
  return false;
}

void check(const Input& in, Reporter& out) {
  const Source& source = *in.program.source;
  std::vector<uint32_t> probes;
  std::vector<uint32_t> inputs;
  bool measures = true;
  for (const uint32_t line : in.program.syntax.input_lines) {
    const std::vector<WrittenWord> words = words_of(source, source.line(line));
    if (find_word(words, kGoesOn) != nullptr && !reads_position(source, line, words)) probes.push_back(line);
    if (find_word(words, "G38.2 G38.4") != nullptr) measures = false;
    if (waits(words)) inputs.push_back(line);
  }
  // What nothing looks at, nothing looks at behind the other lines either: that is one mistake.
  if (!probes.empty() && looked_at(in, kTouched)) probes.clear();
  if (!inputs.empty() && looked_at(in, kInput)) inputs.clear();
  for (const uint32_t line : probes) {
    if (check_probe(in, out, line, measures)) break;
  }
  for (const uint32_t line : inputs) {
    if (check_wait(in, out, line)) break;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW854",
    .name = "probe-unchecked",
    .summary = "the result of a probe or of a wait for an input is used without a test",
    .group = Group::kModes,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(After `G38.3` or `G38.5`, a line uses the probed point (`#5061` to `#5069`), perhaps through another
parameter, and no line of the file, or of a file that it calls, tests `#5070`. The same for `G92` and
`G10 L20` right after such a move.

`M66` waits some seconds for an input (`L3`, `L4`), moves follow, and no line tests `#5399`.

owlint does not report a program that compares the point or the position with something: it has its own
way to find out. Nor does it report `G38.3` as a safe move to a place, where `G38.2` or a sub then does the
probing; nor `M66 P3 L3` behind `M190`, with which programs for QtPlasmaC change the material.)",
            .why =
                R"(`G38.2` and `G38.4` stop the program if the probe touches nothing. `G38.3` and `G38.5` do not: then `#5070`
is 0, and `#5061` to `#5069` are the end of the move. In the first program below, the plate or the probe's
wire may be missing: then the zero is set in the air, and the next move goes 10 mm too deep.

When the time `Q` is over, `M66` goes on with -1 in `#5399`: the clamp that it waits for may be open.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
G10 L2 P1 Z#5063
G0 Z15
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G10 L2 P1 Z#5063
o100 endif
G0 Z15
M2
)",
            .fix =
                R"(Write `G38.2` if the program cannot go on without contact. Otherwise test `#5070` after `G38.3`, and `#5399`
after `M66`. Suppress the finding where the end of the move is as good as a probed point.)",
            .level_reason = "Warning: the program is right as long as the probe touches something and the input comes.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow854
