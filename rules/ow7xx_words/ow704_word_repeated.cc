// OW704 word-repeated: one letter twice on a line.
// Depends on: every letter but G, M, @ and ^ counts once; a second P or Q is refused only if the first is above -1. The
// letter is refused before its value is read.
#include <algorithm>

#include "rules/driver/modes.h"

namespace owlint::rules::ow704 {
namespace {

constexpr std::string_view kTakesP = "G4 G5 G5.2 G10 G64 G76 G82 G86 G88 G89 M19 M50 M51 M52 M53 M62 M63 M64 M65 M66";

/// `G64 P0.1 M52 P1`: the code before each P takes it. The second code; null if it is not so.
const WrittenWord* second_taker(const WordStop& at) {
  if (at.letter != 'p') return nullptr;
  const WrittenWord* before = nullptr;
  const WrittenWord* first = nullptr;
  for (const WrittenWord& word : at.line) {
    if (word.span.begin == at.span.begin) return first != nullptr && first != before ? before : nullptr;
    if (word.letter == 'p') first = before;
    if (find_word({word}, kTakesP) != nullptr) before = &word;
  }
  return nullptr;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const WordStop at = word_stop(in, stop);
    const std::string letter = at.word.substr(0, 1);
    const bool same = at.word == at.other_word && at.word.size() > 1;
    Finding& f = out.add(at.span, "`" + (same ? at.word : letter) + "` is written twice on this line");
    relate_word(f, at);
    if (const WrittenWord* const code = second_taker(at)) {
      f.help = "write `" + std::string(p.source->slice({code->span.begin, at.span.end})) + "` on a line of its own";
      f.fixes.push_back(split_line(p, p.at(stop.statement), code->span.begin, "write two lines"));
      f.fixes.back().safe = false;  // codes of one line run in an order of their own
    } else if (same) {
      f.help = "remove one of them";
      f.fixes.push_back(without_word(p, p.at(stop.statement), at.span, at.word));
    } else if (std::string_view("xyzabcuvw").find(at.letter) != std::string_view::npos) {
      f.help = "write two moves on two lines, or remove one of the words";
    } else {
      f.help = "remove one of them";
    }
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW704",
    .name = "word-repeated",
    .summary = "one letter twice on a line",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A letter that is twice on one line, such as `G1 X10 X20`. Often a line feed was lost, or one of the
two should be another letter. `G` and `M` may be repeated: see OW706.)",
            .why =
                R"(LinuxCNC stops with `Multiple x words on one line`, before it reads the second value. Nothing of the
line is executed.

A second `P` or `Q` is accepted if the first is -1 or less, and the last one counts. The same goes
for `@` and `^`, whatever their values.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G1 X20 X30 F80
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G1 X20 F80
X30
G0 Z5
M2
)",
            .fix =
                R"(Remove one of the words, or write two lines. `--fix` removes a word that is written twice with the same
value.)",
            .level_reason = "Error: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "Multiple x words on one line",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow704
