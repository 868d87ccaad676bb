// OW706 codes-conflict: two codes that cannot be on one line.
// Depends on: one code of each modal group, the same one twice included; G80 gives way to every other motion. Four M codes at
// most. G4 beside G2 or G3, G53 without G0 or G1 or in G91, a motion before G5.3.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "rules/driver/modes.h"

namespace owlint::rules::ow706 {
namespace {

const WrittenWord* word_at(const WordStop& at, uint64_t byte) {
  const auto found = std::ranges::find(at.line, byte, [](const WrittenWord& w) { return w.span.begin; });
  return found == at.line.end() ? nullptr : &*found;
}

/// What two codes of one group have to do with each other.
std::string_view reason(const WordStop& at) {
  const WrittenWord* other = word_at(at, at.other.begin);
  if (other == nullptr || !other->value || !at.value) return "they are of one modal group";
  constexpr double kTenths = 10;
  if (at.letter == 'g') {
    const GCode* code = g_code(static_cast<int>(std::lround(*other->value * kTenths)), Release::k2_10);
    return code == nullptr ? "they are of one modal group" : what_both_do(code->group);
  }
  const MCode* code = m_code(static_cast<int>(std::lround(*other->value)));
  return code == nullptr ? "they are of one modal group" : what_both_do(code->group);
}

/// Whether a motion is written twice, each time with axis words behind it.
bool moves_twice(const WordStop& at) {
  constexpr double kTenths = 10;
  const GCode* code = at.value ? g_code(static_cast<int>(std::lround(*at.value * kTenths)), Release::k2_10) : nullptr;
  if (at.letter != 'g' || code == nullptr || code->group != GGroup::kMotion) return false;
  const auto has_axis = [&](uint64_t from, uint64_t to) {
    return std::ranges::any_of(at.line, [&](const WrittenWord& word) {
      return word.span.begin > from && word.span.begin < to && (letter_set({&word.letter, 1}) & kAxisLetters) != 0;
    });
  };
  return has_axis(at.other.begin, at.span.begin) && has_axis(at.span.begin, UINT64_MAX);
}

/// `G53 G28 Z0`: the place that G28 and G30 go to is a machine position already.
bool beside_g53(const Program& p, const FlowStop& stop, const WordStop& at, Finding& f) {
  const WrittenWord* const g53 = find_word(at.line, "G53");
  const WrittenWord* const stored = find_word(at.line, "G28 G30");
  if (g53 == nullptr || stored == nullptr) return false;
  const std::string code = shown(*p.source, stored->span);
  f.message = fmt::format("`G53` and `{}` cannot be on one line: `{}` goes to a stored machine position", code, code);
  f.help = "remove `G53`; or remove `" + code + "`, and write `G53 G0` with the machine position";
  f.fixes.push_back(without_word(p, p.at(stop.statement), g53->span, "G53"));
  f.fixes.back().safe = false;  // the axis words may be meant as a machine position
  return true;
}

void one_group(const Program& p, const FlowStop& stop, const WordStop& at, Finding& f) {
  if (at.word == at.other_word) {
    f.message = "`" + at.word + "` is written twice on this line";
    f.help = "remove one of them";
    if (moves_twice(at)) {
      f.help = "write two lines: a line feed may be missing";
      Fix two_lines = split_line(p, p.at(stop.statement), at.span.begin, "write two lines");
      two_lines.safe = false;  // or one move was meant
      f.fixes.push_back(std::move(two_lines));
      return;
    }
    f.fixes.push_back(without_word(p, p.at(stop.statement), at.span, at.word));
    return;
  }
  if (beside_g53(p, stop, at, f)) return;
  const std::string other = at.other_word.empty() ? "another code of its group" : "`" + at.other_word + "`";
  f.message = fmt::format("{} and `{}` cannot be on one line: {}", other, at.word, reason(at));
  const bool both_on =
      reason(at) == what_both_do(MGroup::kCoolant) && !at.word.ends_with('9') && !other.ends_with("9`");
  f.help =
      both_on ? "write two lines; after `M7` and `M8` both are on" : "remove one of them, or write them on two lines";
}

void with_g53(const WordStop& at, Finding& f) {
  const bool incremental = f.interpreter.ends_with("incremental");
  if (incremental) {
    f.message = at.other_word.empty() ? "`G53` cannot move while `G91` is in effect: its positions are absolute"
                                      : "`G53` and `G91` cannot be on one line: positions of `G53` are absolute";
    f.help = at.other_word.empty() ? "write `G90` on this line or before it" : "write `G90`";
  } else if (at.other_word.empty()) {
    f.message = "`G53` needs `G0` or `G1`";
    f.help = "write `G53 G0` and the axis words on this line, or remove `G53`, which counts for its line only";
  } else {
    f.message = "`G53` and `" + at.other_word + "` cannot be on one line: `G53` moves with `G0` or `G1` only";
    f.help = "write `G0` or `G1`, or remove `G53`";
  }
}

void explain(const Input& in, const FlowStop& stop, const WordStop& at, Finding& f) {
  const std::string& said = f.interpreter;
  if (said.starts_with("Two ")) return one_group(in.program, stop, at, f);
  if (said.find("g53") != std::string::npos) return with_g53(at, f);
  if (said.starts_with("Too many m codes")) {
    f.message = "`" + at.word + "` is the fifth M code on this line; LinuxCNC takes four";
    f.help = "write it on a line of its own";
  } else if (said.starts_with("G4 not allowed")) {
    const std::string arc = at.other_word.empty() ? "an arc" : "`" + at.other_word + "`";
    f.message = "`G4` and " + arc + " cannot be on one line: both take `P`";
    f.help = "write `G4` on a line of its own";
  } else if (said.starts_with("Between G5.2")) {
    f.message = fmt::format("`G5.3` ends the curve, and {} on its line is another motion",
                            at.other_word.empty() ? "there" : "`" + at.other_word + "`");
    f.help = "write `G5.3` on a line of its own";
  } else if (said.starts_with("Bug bad g code")) {
    f.message = "`G6.3` has no `G5.2` or `G6.2` on its line";
    f.help = "end the curve with `G5.3`";
  } else if (said.starts_with("R word is ambiguous")) {
    f.message = "`" + at.word + "` could belong to `G64` or to `M19`";
    f.help = "write them on two lines";
  } else {
    f.message = "`" + at.word + "` cannot be on one line with the other codes";
    f.help = "write it on a line of its own";
  }
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const WordStop at = word_stop(in, stop);
    Finding& f = out.add(at.span, "");
    f.interpreter = stop.interpreter;
    explain(in, stop, at, f);
    relate_word(f, at);
    if (stop.interpreter.ends_with("g53 incremental") && at.other_word.empty())
      relate_setter(in, f, setter_of(in, stop, "G91", false));
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW706",
    .name = "codes-conflict",
    .summary = "two codes that cannot be on one line, or more M codes than LinuxCNC takes",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(Two G or two M codes of one modal group on a line: `G1 G2`, `G90 G91`, `M3 M5`, `M7 M8`. The same code
twice counts too. A fifth M code. `G4` beside an arc; `G53` without `G0` or `G1`, or in `G91`.)",
            .why =
                R"(Codes of one group exclude each other, so LinuxCNC does not guess which one is meant. It stops with `Two
g codes used from same modal group`, `Two m codes used from same modal group` or `Too many m codes on
line`. Nothing of the line is executed. docs/codes.md has the group of every code.

`G80` is the exception: beside another motion it has no effect. `G90` and `G90.1`, or `G92` and `G92.1`,
are of different groups.)",
            .bad = R"(G21 G90
G0 G1 X10 Y10 F200
M2
)",
            .good = R"(G21 G90
G1 X10 Y10 F200
M2
)",
            .fix = R"(Remove the code that you did not mean, or write two lines. Mist and flood together are `M7` on one
line and `M8` on the next. `--fix` removes a code that is written twice.)",
            .level_reason = "Error: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "Two g codes used from same modal group",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow706
