// OW805 compensation-conflict: a code that is not allowed while cutter compensation is on, or that cannot start it.
// Depends on: G41, G42, G41.1 and G42.1 switch it on, also with a tool without a diameter; only G40 and the program's end
// switch it off. Behind a path with compensation, the first move must be straight. Paths that do not fit the tool are other
// rules' business.
#include <array>

#include "rules/driver/modes.h"

namespace owlint::rules::ow805 {
namespace {

constexpr std::string_view kStarts = "G41 G42 G41.1 G42.1";

/// What begins compensation, or cannot stand behind it.
constexpr std::array kEntry = {
    Said{"allowed only in XY, XZ planes", kStarts, "works only in the XY or XZ plane, and another plane is in effect",
         "write `G17` or `G18` on this line or before it"},
    Said{"comp on when on", kStarts, "switches cutter compensation on, but it is already on",
         "write `G40` on a line before it, even to change the side"},
    Said{"with no D word", kStarts, "needs the diameter of the tool as `D`",
         "write `D` and the diameter, or `G41` or `G42`, which take it from the tool table"},
    Said{"with L word, but plane is not G18", "L",
         "is the orientation of a lathe tool, but the XZ plane is not in effect",
         "remove it, or write `G18` on this line"},
    Said{"requires D word to be a whole number", "D", "is not a tool number",
         "write the tool's number; `G41.1` and `G42.1` take a diameter as `D`"},
    Said{"with lathe tool, but plane is not G18", kStarts, "takes a lathe tool, but the XZ plane is not in effect",
         "write `G18` on this line, or set the orientation of the tool to 0 in the tool table"},
    Said{"must be straight, not an arc", "G2 G3 * I J K R",
         "is an arc, and it is the first move after cutter compensation",
         "write a straight move, such as `G1`, between `G40` and the arc"},
};

/// What it forbids while it is on: what the word does.
constexpr std::array kForbidden = {
    Said{"Cannot change planes", "G17 G18 G19", "changes the plane", ""},
    Said{"Cannot change tool offset", "G43 G43.1 G43.2 G49", "sets the tool length offset", ""},
    Said{"Cannot change coordinate systems", "G54 G55 G56 G57 G58 G59 G59.1 G59.2 G59.3", "chooses a coordinate system",
         ""},
    Said{"Cannot change control mode", "G61 G61.1 G64", "sets how exactly the machine follows the path", ""},
    Said{"Cannot change retract mode", "G98 G99", "sets how far cycles retract", ""},
    Said{"Cannot change the active coordinate system", "G10", "changes the coordinate system that is in effect", ""},
    Said{"Cannot change axis offsets", "G52 G92", "changes the offset of the axes", ""},
    Said{"Cannot change tools", "M6", "changes the tool", ""},
    Said{"Cannot use g28 or g30", "G28 G30", "goes to a stored position", ""},
    Said{"Cannot set reference point", "G28.1 G30.1", "stores the position", ""},
    Said{"Cannot use g53", "G53", "moves in machine coordinates", ""},
    Said{"Cannot probe", "G38.2 G38.3 G38.4 G38.5 *", "probes", ""},
    Said{"Cannot convert spline", "G5 G5.1", "is a spline", ""},
    Said{"Cannot use canned cycles", "G73 G74 G81 G82 G83 G84 G85 G86 G87 G88 G89 *", "drills", ""},
    Said{"threading cycle with cutter", "G76 *", "cuts a thread", ""},
    Said{"Bug code not g0 or g1", "G33 G33.1 G76 *", "cuts a thread", ""},
    Said{"cannot be used with cutter compensation", "G71 G71.1 G71.2 G72 G72.1 G72.2", "turns a contour", ""},
    Said{"Cannot enable overrides", "M48 M50 M51 M52 M53", "allows overrides", ""},
    Said{"Cannot disable overrides", "M49 M50 M51 M52 M53", "forbids overrides", ""},
    Said{"Cannot set ", "M62 M63 M64 M65 M67 M68", "sets an output", ""},
    Said{"Cannot wait for ", "M66", "reads an input", ""},
    Said{"lane ", "*", "moves in a plane of `U`, `V` or `W`", ""},  // `BUG: Invalid plane`, `BUG: Unsupported plane`
};

/// The first of #5420 to #5428 on a line; all of it if their number is computed.
Span position_read(const Source& source, Span line) {
  constexpr std::string_view kFirst = "#542";
  const std::string_view text = source.slice(line);
  for (size_t at = text.find(kFirst); at != std::string_view::npos; at = text.find(kFirst, at + 1)) {
    const size_t last = at + kFirst.size();
    if (last < text.size() && text[last] >= '0' && text[last] <= '8') return {line.begin + at, line.begin + last + 1};
  }
  return line;
}

/// A line of any kind that reads the position.
Finding& add_read(const Input& in, Reporter& out, const FlowStop& stop) {
  const Statement& s = in.program.at(stop.statement);
  const Span line = s.kind == LineKind::kOWord ? s.head_span() : s.whole();
  const Span span = position_read(*in.program.source, s.whole());
  const bool computed = span.begin == s.whole().begin && span.end == s.whole().end;
  Finding& f = out.add(computed ? line : span,
                       (computed ? "this line" : "`" + shown(*in.program.source, span) + "`") +
                           " reads the position while cutter compensation is on");
  f.help = "copy the position to another parameter before compensation begins, or read `#<_x>` to `#<_w>`";
  f.interpreter = stop.interpreter;
  return f;
}

Finding* explain(const Input& in, Reporter& out, const FlowStop& stop) {
  if (said_of(kEntry, stop.interpreter) != nullptr) {
    Finding& f = add_said(in, out, stop, kEntry);
    const bool plane = stop.interpreter.find("plane") != std::string::npos;
    const bool behind = stop.interpreter.find("straight") != std::string::npos;
    if (plane) {
      relate_setter(in, f, setter_of(in, stop, "G17 G18 G19 G17.1 G18.1 G19.1"));
    } else if (behind) {
      relate_setter(in, f, setter_of(in, stop, "G40"), "ends cutter compensation here");
    } else if (stop.other == stop.statement) {
      f.message += ": by this line itself, in an earlier pass of the loop";
    } else {
      relate_setter(in, f, setter_of(in, stop, kStarts, false), "switches it on here");
    }
    return &f;
  }
  const bool reads = stop.interpreter.starts_with("Cannot read current position");
  Finding& f = reads ? add_read(in, out, stop) : add_said(in, out, stop, kForbidden);
  const std::optional<Setter> setter = setter_of(in, stop, kStarts);
  if (!reads) {
    if (said_of(kForbidden, stop.interpreter) != nullptr) f.message += " while cutter compensation is on";
    const std::string start = setter && !setter->restores() ? "`" + setter->word + "`" : "`G41` or `G42`";
    f.help = "write it before " + start + ", or after `G40`";
  }
  relate_setter(in, f, setter, "switches it on here");
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) { return explain(in, out, stop); });
}

}  // namespace

extern const Rule kRule{
    .code = "OW805",
    .name = "compensation-conflict",
    .summary = "a code that is not allowed while cutter compensation is on, or that cannot start it",
    .group = Group::kModes,
    .level = Severity::kError,
    .page =
        {
            .what = R"(While cutter compensation (`G41`, `G42`) is on: another plane, tool, tool length offset or
coordinate system, `G28`, `G53`, `G92`, a probe move, a cycle, an input or output, and others. A
second `G41` without a `G40` between them. A `G41` in the YZ plane, or without the `D` that it
needs. An arc as the first move after `G40`.)",
            .why =
                R"(LinuxCNC stops with `Cannot change tool offset with cutter radius compensation on`, `Cannot turn cutter
radius comp on when on` and the like. Compensation stays on until `G40` or the end of the program, even
after the end of the sub that switched it on.

For most of these it makes no difference if the tool has no diameter in the tool table, or if no tool is in
the spindle: compensation is on all the same. Speeds and feeds, coolant, `G20`, `G21`, `G90`, `G91` and `M0`
are allowed. `G92.1` to `G92.3` do nothing then, and give no message.)",
            .bad = R"(G21 G90 G17
T1 M6
G0 X0 Y0
G41 D1
G1 X10 F200
G43 H1
G1 X20
G40
M2
)",
            .good = R"(G21 G90 G17
T1 M6
G43 H1
G0 X0 Y0
G41 D1
G1 X10 F200
G1 X20
G40
M2
)",
            .fix =
                R"(Move the code before `G41` or after `G40`. After `G40`, write a straight move before the first arc.)",
            .level_reason = "Error if a run gets here with compensation on: the program stops. owlint reports nothing "
                            "on lines that no run reaches.",
            .interpreter = "Cannot change tool offset with cutter radius compensation on",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow805
