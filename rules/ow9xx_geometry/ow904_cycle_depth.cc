// OW904 cycle-depth: words of a drilling cycle that are missing or do not fit each other.
// Depends on: R, the depth, P, Q, I, J and K are kept from hole to hole of one cycle, not for another one and not behind G80, G0
// or another motion. Heights are those of the line or kept ones; in G91 the depth counts from R.
#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "rules/driver/positions.h"

namespace owlint::rules::ow904 {
namespace {

constexpr std::string_view kCycles = "G73 G74 G81 G82 G83 G84 G85 G86 G87 G88 G89 *";
constexpr std::string_view kNoDepth = " value unspecified in ";
constexpr std::string_view kBelow = "R less than ";
constexpr std::string_view kBoring = " word missing with g87";

constexpr std::array kSaid = {
    Said{"R clearance plane", kCycles, "drills without `R`, the height at which the feed begins",
         "write `R`; LinuxCNC keeps it from hole to hole, but not for another cycle or after `G80`, `G0` or `G1`"},
    Said{"zero repeats", "L", "drills no holes", "remove it, or skip the line with an `if`"},
    Said{kNoDepth, kCycles, "drills without its depth", ""},
    Said{kBelow, "R *", "", ""},
    Said{"Dwell time p word", kCycles, "waits at the bottom, but has no `P` with the time",
         "write `P` and the seconds"},
    Said{"Q word missing", kCycles, "drills in pecks, but has no `Q`", "write `Q` and the depth of one peck"},
    Said{"zero q value", "Q", "is not the depth of a peck", "write a depth above 0: `Q` has no sign"},
    Said{kBoring, kCycles, "bores from below, but a word for its way through the hole is missing", ""},
};

/// The letter at a place in the message, as it is written on a line.
std::string letter_at(const std::string& said, size_t at) { return capital(said[at]); }

/// `R2`, or the one of a line above that is kept.
struct Height {
  const WrittenWord* here;
  std::optional<Span> kept;
  std::string said;

  /// As a subject.
  std::string begins() const { return kept ? said + "," : said; }
};
Height height_of(const Input& in, const FlowStop& stop, const std::vector<WrittenWord>& line, char letter,
                 std::string_view kept) {
  const auto found = std::ranges::find(line, letter, &WrittenWord::letter);
  Height height{found == line.end() ? nullptr : &*found, std::nullopt, std::string(kept)};
  const Source& source = *in.program.source;
  if (height.here != nullptr) {
    height.said = "`" + shown(source, height.here->span) + "`";
  } else if ((height.kept = words_above(in, stop.statement, {&letter, 1}))) {
    height.said += ", `" + shown(source, *height.kept) + "`";
  }
  return height;
}

void explain_height(const Input& in, const FlowStop& stop, Finding& f) {
  const char axis = stop.interpreter[kBelow.size()];
  const std::vector<WrittenWord> line = word_stop(in, stop, "R *").line;
  const std::string depth = capital(axis);
  const Height r = height_of(in, stop, line, 'r', "the `R` that is kept");
  const Height bottom = height_of(in, stop, line, static_cast<char>(std::tolower(axis)), "the depth that is kept");
  const WrittenWord* const at = r.here != nullptr ? r.here : bottom.here;
  if (at != nullptr) f.span = at->span;
  if (r.here != nullptr && bottom.here != nullptr)
    f.related.push_back({bottom.here->span, bottom.said + " is here", nullptr});
  for (const Height* height : {&r, &bottom}) {
    if (height->kept) f.related.push_back({*height->kept, "this is kept", nullptr});
  }
  if (relate_distance(in, stop, f)) {
    f.message = bottom.begins() + " is above `R`, because in `G91` it counts from `R`: the cycle would drill upward";
    if (bottom.here != nullptr) f.span = bottom.here->span;
    f.help = fmt::format("write a negative `{}`", depth);
  } else {
    f.message = r.begins() + " is below " + bottom.said + ": the cycle would drill upward";
    f.help = "write an `R` above the bottom of the hole";
  }
}

/// A depth that is not Z: the plane was probably forgotten.
void explain_plane(const Input& in, const FlowStop& stop, const Setter& plane, Finding& f) {
  const std::string depth = letter_at(stop.interpreter, 0);
  f.message = fmt::format("{} drills along {} here, as `{}` {} says, and has no `{}`",
                          subject(word_stop(in, stop, kCycles)), depth, plane.word, where(in, plane), depth);
  f.help = fmt::format("write `G17` before it, to drill along Z; in `{}`, the depth is `{}`", plane.word, depth);
}

/// Of a word that is there, but with a value that stands for none.
void tell_negative(const Input& in, const FlowStop& stop, Finding& f) {
  const bool peck = stop.interpreter.starts_with("Q word missing");
  if (!peck && stop.interpreter.find("p word missing") == std::string::npos) return;
  const std::vector<WrittenWord> line = words_of(*in.program.source, in.program.at(stop.statement).whole());
  const WrittenWord* const word = find_word(line, peck ? "Q" : "P");
  if (word == nullptr || !word->value || *word->value >= 0) return;
  const std::string text = shown(*in.program.source, word->span);
  f.help = fmt::format("`{}` counts as no `{}`: {}", text, text[0], f.help);
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    const std::string& said = stop.interpreter;
    if (said.starts_with(kBelow)) {
      explain_height(in, stop, f);
    } else if (said.find(kNoDepth) != std::string::npos) {
      f.help = fmt::format("write `{}` on this line: LinuxCNC keeps it only from hole to hole of one cycle",
                           letter_at(said, 0));
      const std::optional<Setter> plane = setter_of(in, stop, "G18 G19 G17");
      if (plane && !plane->restores() && said[0] != 'Z') explain_plane(in, stop, *plane, f);
      relate_setter(in, f, plane);
    } else if (said.find(kBoring) != std::string::npos) {
      f.help = fmt::format(
          "write `{}`: `I` and `J` are the way to the side of the hole, `K` the height to which the bore reaches",
          letter_at(said, 0));
    }
    tell_negative(in, stop, f);
    note_start(stop, f);
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW904",
    .name = "cycle-depth",
    .summary = "words of a drilling cycle that are missing or do not fit each other",
    .group = Group::kGeometry,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A drilling cycle (`G73`, `G74`, `G81` to `G89`) without `R` or without its depth, with an `R` below the
depth, with `L0`, without the `P` of `G82`, `G86`, `G88` and `G89`, without the `Q` of `G73` and `G83` or with
one that is not above 0, without `I`, `J` or `K` of `G87`.)",
            .why =
                R"(LinuxCNC keeps these words from hole to hole, so the lines after the first may have only `X` and `Y`. It
keeps them for the same code only: `G82` after `G81` needs its own `R` and `Z`, and so does `G81` after
`G80` or a `G0`. It stops with `R clearance plane unspecified in cycle`, `Z value unspecified in xy plane
canned cycle`, `R less than z in cycle in xy plane` and the like.

The depth is `Z` in XY (`G17`), `Y` in XZ (`G18`) and `X` in YZ (`G19`). In `G91`, `R` counts from where the
tool is, and the depth from `R`.)",
            .bad = R"(G21 G90 G17
G0 X10 Y10 Z10
G81 X10 Y10 Z-5 R2 F80
G0 X20 Y20
G81 X30 Y20
G80
M2
)",
            .good = R"(G21 G90 G17
G0 X10 Y10 Z10
G81 X10 Y10 Z-5 R2 F80
X20 Y20
X30 Y20
G80
M2
)",
            .fix =
                R"(Write the missing words on the first line of each cycle. To move around a clamp, use `G98` and a high
start instead of `G0` in the middle of a cycle, or write the cycle again with all its words.)",
            .level_reason =
                "Error if a run gets here: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "R clearance plane unspecified in cycle",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow904
