// OW908 contour-malformed: a lathe contour, spline, NURBS curve or thread whose words do not make one.
// Depends on: G5 and G5.1 need their control points in XY; the points of G5.2 belong to one curve until G5.3; G76 cuts from J to
// K; G70 to G72.2 read the sub that Q names, and what they make of its lines (geometry/contour.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "rules/driver/mode_hazards.h"
#include "rules/driver/positions.h"

namespace owlint::rules::ow908 {
namespace {

constexpr std::string_view kCurve =
    "write the three together: `G5.2` with `X`, `Y` and the weight `P` for each control point";
constexpr std::string_view kFirst = "write it on the first line with `G6.2`";

/// What begins and ends a curve, and the motions that leave one most often.
constexpr std::string_view kSetters = "G5.2 G5.3 G6.2 G0 G1 G2 G3 G33 G80 G81 G38.2";

constexpr std::string_view kContours = "G70 G71 G71.1 G71.2 G72 G72.1 G72.2";

constexpr std::array kSaid = {
    Said{"requires a Q word", kContours, "has no `Q`", "write `Q` and the number of the sub with the contour"},
    Said{"Not monotonic", kContours, "cuts a contour that turns back",
         "let Z go in one direction from line to line, with `G72` X; no arc may pass its leftmost or rightmost point, "
         "with `G72` its highest or lowest one"},
    Said{"Cannot intersect parallel lines", kContours,
         "moves the contour aside, and two lines in one direction do not meet then", "write the two lines as one"},
    Said{"x too large in straight dive", kContours, "finds no way down to the next layer of the contour",
         "begin the contour at its side, or choose another depth `I` or allowance `D`"},
    Said{"How did we get here", kContours, "loses its way along the contour",
         "let the contour begin and end outside of its pockets"},
    Said{"I must be greater than zero", "I", "is no depth of a layer", "write an `I` above 0"},
    Said{"both R and I or K", kContours, "cuts a contour with an arc that has both a radius and a center",
         "write either `R`, or `I` and `K`, in the sub"},
    Said{"either I or K must be present", kContours,
         "cuts a contour with an arc that has neither a radius nor a center", "write `I` and `K`, or `R`, in the sub"},
    Said{"Both A and C parameters", kContours, "cuts a contour with both a fillet and a chamfer at one corner",
         "write either `A` or `C` in the sub"},
    Said{"in incremental mode (G91)", kContours, "cuts a contour with `U` or `W` while `G91` is in effect",
         "write `X` and `Z` in the sub: in `G91` they are steps as well"},
    Said{"in the same block", kContours,
         "cuts a contour with a line that names one axis twice, as a place and as a step",
         "write either `X` or `U`, and either `Z` or `W`, in the sub"},
    Said{"Radius to end of arc differs", kContours,
         "cuts a contour with an arc whose ends are not equally far from its center",
         "correct `I`, `K` or the end of the arc in the sub"},
    Said{"Zero-radius arc", kContours, "cuts a contour with an arc that has its center at one of its ends",
         "correct `I`, `K` or the end of the arc in the sub"},
    Said{"Splines may not have motion", "Z A B C", "cannot be in a spline: a spline moves only X and Y",
         "move this axis on another line"},
    Said{"both I and J with G5.1", "G5.1 G6.1", "needs both `I` and `J` for its control point",
         "write the missing one, even if it is 0"},
    Said{"both I and J, or neither", "G5 I J", "has only one of `I` and `J`",
         "write both, even a 0; without both, the curve continues in the direction of the `G5` before it"},
    Said{"both P and Q with G5", "G5 P Q", "needs both `P` and `Q` for its second control point",
         "write the missing one, even if it is 0"},
    Said{"You must specify both", "X Y Z", "is only half of a control point", "write both words of the plane"},
    Said{"P without X and Y", "P", "has no control point, although the curve has begun",
         "write `X` and `Y`; a weight alone is for the start of a curve. A curve that was not ended with `G5.3` goes "
         "on"},
    Said{"positive weight P", "P G5.2 *", "gives a control point a weight that is not above 0", kCurve},
    Said{"without G5.2 first", "G5.3", "ends a curve, but no curve has begun", "write the curve with `G5.2` before it"},
    Said{"number of control points", "G5.3", "ends a curve with too few control points",
         "write at least as many points, with the start, as the order `L`, which is 3 if there is no `L`"},
    Said{"I must not be 0", "I", "does not say where the crest of the thread is",
         "write how far the crest is from the drive line: negative for an external thread"},
    Said{"J must be greater than 0", "J", "is not the depth of a cut", "write a first depth above 0: `J` has no sign"},
    Said{"K must be greater than J", "K", "is the full depth, but is not greater than the first cut, `J`",
         "write a `K` greater than `J`"},
    Said{"rotary axes with G76", "A B C U V W", "moves an axis that `G76` cannot move: a thread has only X, Y and Z",
         "move it on a line before"},
    Said{"order P in the first block", "G6.2", "has no `P` with the order", kFirst},
    Said{"order P number", "P", "is not a whole number", "write the order of the curve as a whole number"},
    Said{"Q value (1,2,3)", "Q G6.2", "has no `Q` with the kind of curve", kFirst},
    Said{"not in range 1 to 3", "Q", "is not a kind of curve", "write `Q1`, `Q2` or `Q3`"},
    Said{"Q number is not an integer", "Q", "is not a whole number", "write `Q1`, `Q2` or `Q3`"},
    Said{"nurbs weight R", "R *", "gives a control point a weight that is not above 0", "write `R` and the weight"},
    Said{"K number for every", "G6.2 *", "is a control point without a `K` for its knot",
         "write `K` and the number of the knot"},
    Said{"K number is not", "K", "is not a whole number", "write the number of the knot as a whole number"},
};

/// No message of the interpreter, but a program that comes to no end.
void tell_of_lost_contour(const Input& in, const FlowStop& stop, Finding& f) {
  if (!stop.interpreter.empty()) return;
  f.message = subject(word_stop(in, stop, kContours)) +
      " cuts a contour on which LinuxCNC loses its way: it crashes or never ends, without a message";
  f.help = "let the contour begin and end outside of the part, and end with a line instead of an arc";
  f.never_ends = true;
}

/// `G70` or `G71` that cuts nothing: where other controllers have it, it chooses the unit.
void doubt_unit(const Input& in, const FlowStop& stop, Finding& f) {
  const WordStop at = word_stop(in, stop, "G70 G71");
  const bool inches = at.word == "G70";
  if (!stop.interpreter.ends_with("requires a Q word") || (!inches && at.word != "G71")) return;
  if (find_word(at.line, "* D I R P E") != nullptr) return;
  f.message = fmt::format("`{}` is a lathe cycle in LinuxCNC, and the line has nothing of one", at.word);
  f.help = fmt::format("other controllers choose {} with `{}`: write `{}`, or remove it where that is there",
                       inches ? "inches" : "millimeters", at.word, inches ? "G20" : "G21");
}

/// `G71 U2 R1`: the first of two lines on Fanuc.
void tell_of_two_lines(const Input& in, const FlowStop& stop, Finding& f) {
  if (!stop.interpreter.ends_with("requires a Q word")) return;
  const std::optional<Habit> habit = habit_of(in, stop.statement);
  if (!habit) return;
  f.message = habit->message;
  f.help = habit->help;
}

/// An arc in the sub of a contour whose `R` does not reach its end: the interpreter says of it that the contour turns back.
struct SmallArc {
  uint32_t line = 0;
  Span radius;
  double least = 0;
};
std::optional<SmallArc> small_arc(const Input& in, StatementId cycle) {
  const Program& p = in.program;
  const uint64_t offset = p.at(cycle).offset;
  while (cycle + 1 < p.size() && p.at(cycle).kind != LineKind::kContour && p.at(cycle + 1).offset == offset) ++cycle;
  const Statement& s = p.at(cycle);
  if (s.kind != LineKind::kContour || s.label == kNoName) return std::nullopt;
  const auto lines = p.by_label[s.label];
  const auto sub = std::ranges::find_if(lines, [&](StatementId id) { return p.at(id).opens_sub(); });
  const auto end = std::ranges::find_if(lines, [&](StatementId id) { return p.at(id).is(Keyword::kEndsub); });
  if (sub == lines.end() || end == lines.end()) return std::nullopt;
  // In diameter mode, X counts half: where the program may be in it, only half the way surely is.
  const auto diameter = [&](const WrittenWord& w) { return w.letter == 'g' && w.value && *w.value == 7; };
  const Source& source = *p.source;
  bool halves = false;
  for (uint32_t line = 1; line < s.line && !halves; ++line)
    halves = std::ranges::any_of(words_of(source, source.line(line)), diameter);
  std::optional<double> x, z;
  for (uint32_t line = p.at(*sub).line + 1; line < p.at(*end).line; ++line) {
    const std::vector<WrittenWord> words = words_of(source, source.line(line));
    if (find_word(words, "U W") != nullptr) return std::nullopt;
    const WrittenWord* const to_x = find_word(words, "X");
    const WrittenWord* const to_z = find_word(words, "Z");
    const std::optional<double> from_x = x, from_z = z;
    if (to_x != nullptr) x = to_x->value;
    if (to_z != nullptr) z = to_z->value;
    const WrittenWord* const radius = find_word(words, "R");
    if (radius == nullptr || find_word(words, "G2 G3") == nullptr || !radius->value || !from_x || !from_z || !x || !z)
      continue;
    const double least = std::hypot((*x - *from_x) / (halves ? 2 : 1), *z - *from_z) / 2;
    constexpr double kRounded = 1e-4;
    if (std::abs(*radius->value) < least - kRounded) return SmallArc{line, radius->span, least};
  }
  return std::nullopt;
}

void doubt_radius(const Input& in, const FlowStop& stop, Finding& f) {
  if (!stop.interpreter.ends_with("Not monotonic")) return;
  const std::optional<SmallArc> arc = small_arc(in, stop.statement);
  if (!arc) return;
  const std::string radius = shown(*in.program.source, arc->radius);
  f.message = fmt::format("`{}` cuts a contour with an arc whose `{}` on line {} does not reach its end",
                          word_stop(in, stop, kContours).word, radius, arc->line);
  f.help = fmt::format("correct the radius, which is at least {}, or the end of the arc", number_text(arc->least));
  f.related.push_back({arc->radius, "the radius is here", nullptr});
}

/// The last curve that lines before a stop have dropped; null if none has.
const DroppedCurve* dropped_before(const Input& in, const FlowStop& stop) {
  const std::vector<DroppedCurve>& curves = in.program.syntax.dropped_curves;
  const auto behind = std::ranges::upper_bound(curves, in.program.at(stop.statement).line, {}, &DroppedCurve::dropped);
  return behind == curves.begin() ? nullptr : &*(behind - 1);
}

/// `G5.3`, or a further point, behind a line that has left the curve: that is the mistake. Returns that curve.
const DroppedCurve* tell_of_left_curve(const Input& in, const FlowStop& stop, Finding& f) {
  constexpr std::string_view kOfCurves[] = {"without G5.2 first", "number of control points", "P without X and Y",
                                            "positive weight P"};
  const auto says = [&](std::string_view words) { return stop.interpreter.find(words) != std::string::npos; };
  const DroppedCurve* const curve = std::ranges::any_of(kOfCurves, says) ? dropped_before(in, stop) : nullptr;
  if (curve == nullptr) return nullptr;
  const Source& source = *in.program.source;
  const std::string line = std::to_string(curve->dropped);
  if (says(kOfCurves[0])) {
    f.message = fmt::format("`G5.3` ends no curve: LinuxCNC has dropped that of line {} on line {}", curve->line, line);
    f.help = "write `G5.3` before line " + line;
  }
  f.related.push_back({source.line(curve->line), "the curve begins here", nullptr});
  f.related.push_back({source.line(curve->dropped), "the curve is dropped here", nullptr});
  return curve;
}

/// Whether runs get to a curve, and to where it is dropped.
Reach reach_of(const Input& in, const DroppedCurve& curve) {
  const bool first = curve.after == kNoStatement;
  const uint32_t begin = first ? 0 : in.program.at(curve.after).line;
  const bool stops = std::ranges::any_of(in.flow.stops, [&](const FlowStop& stop) {
    const uint32_t line = stop.statement == kNoStatement ? 0 : in.program.at(stop.statement).line;
    return stop.reach == Reach::kAlways && line >= begin && line <= curve.dropped && line > 0;
  });
  if (stops || (!first && in.program.at(curve.after).kind == LineKind::kProgramEnd)) return Reach::kNever;
  return first ? Reach::kAlways : in.flow.reach(curve.after);
}

/// A curve that is never cut, and no message of LinuxCNC.
void check_dropped(const Input& in, Reporter& out, const std::set<const DroppedCurve*>& told) {
  const Source& source = *in.program.source;
  for (const DroppedCurve& curve : in.program.syntax.dropped_curves) {
    const Reach reach = reach_of(in, curve);
    if (reach == Reach::kNever || told.contains(&curve)) continue;
    Finding& f = out.add(word_of_line(in.program, curve.line, "G5.2"),
                         "the curve that begins here is never cut: no `G5.3` ends it, and LinuxCNC drops it");
    f.related.push_back({source.line(curve.dropped), "the curve is dropped here", nullptr});
    f.help = "write `G5.3` before line " + std::to_string(curve.dropped);
    f.reach = reach;
  }
}

void check(const Input& in, Reporter& out) {
  std::set<const DroppedCurve*> told;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    doubt_unit(in, stop, f);
    tell_of_two_lines(in, stop, f);
    doubt_radius(in, stop, f);
    tell_of_lost_contour(in, stop, f);
    if (const DroppedCurve* const curve = tell_of_left_curve(in, stop, f)) {
      told.insert(curve);
    } else {
      const std::optional<Setter> setter = setter_of(in, stop, kSetters, false);
      const bool of_curve = setter && (setter->word.starts_with("G5.") || setter->word.starts_with("G6."));
      relate_setter(in, f, setter, of_curve ? "is here" : "sets another motion");
    }
    note_start(stop, f);
    return &f;
  });
  check_dropped(in, out, told);
}

}  // namespace

extern const Rule kRule{
    .code = "OW908",
    .name = "contour-malformed",
    .summary = "a lathe contour, spline, curve or thread with missing or wrong words",
    .group = Group::kGeometry,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `G70` to `G72.2` without `Q`, or with a sub whose lines do not make a contour that can be cut; a spline
(`G5`, `G5.1`) without its control points, or with an axis other than X and Y; a NURBS curve (`G5.2`, `G5.3`)
with points that lack a word, with too few of them, or without its `G5.3`; a `G76` whose `I`, `J` and `K` do not make a thread.)",
            .why =
                R"(LinuxCNC stops with `Must specify both P and Q with G5`, `You must specify a number of control points at
least equal to the order L = 3`, `In G76, K must be greater than J` and the like.

`G5` and `G5.1` do not stay in effect: on a next line with only axis words, the motion from before
the spline is in effect again. LinuxCNC keeps the points of `G5.2` until `G5.3`; before 2.10, even
after the end of the program. The curve is cut at the `G5.3`: if another motion or the end of the program
comes first, it is never cut, and LinuxCNC has no message for that.

`G71` cuts from the right to the left, layer by layer: its contour may not turn back in Z (`G7X error: Not
monotonic`), that of `G72` not in X. Whether an arc in the sub fits is found only when it is cut. LinuxCNC
prints the last line of the sub below the message, whichever line it is about. With some contours it
crashes, or repeats one move for ever; it has no message for that.)",
            .bad = R"(G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G5 X10 Y0 I3 J3 P-3
G0 Z5
M2
)",
            .good = R"(G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G5 X10 Y0 I3 J3 P-3 Q3
G0 Z5
M2
)",
            .fix = R"(Write the missing words, even if they are 0.)",
            .level_reason = "Error if a run gets here: the program stops. Warning if it stops at an earlier line "
                            "first, or if it runs "
                            "on and a curve is never cut.",
            .interpreter = "Must specify both P and Q with G5",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow908
