// OW707 word-unused: a word that no code on the line takes, nor the motion in effect.
// Depends on: the table of words and codes; axis words are OW709's, F, S and T need no code. P-1 and Q-1 count as none. A
// remapped code on the line switches the check off.
#include <algorithm>

#include <fmt/format.h>

#include "rules/driver/idioms.h"
#include "rules/driver/modes.h"

namespace owlint::rules::ow707 {
namespace {

/// The codes that take a word.
CodeSet takers(char letter, Release release) {
  CodeSet codes;
  for (const LineCheck& check : line_checks(release)) {
    const bool unused = check.kind == LineCheck::kUnused || check.kind == LineCheck::kUnusedUnlessMinusOne;
    if (unused && check.letters == letter_set({&letter, 1})) codes = codes | check.codes;
  }
  return codes;
}

/// `X1E5`, `#1=1e5`: no exponent, but a word.
bool is_exponent(const Source& source, const WordStop& at) {
  if (at.letter != 'e' || at.span.begin == 0) return false;
  const char before = source.slice({at.span.begin - 1, at.span.begin})[0];
  return (before >= '0' && before <= '9') || before == '.';
}

/// The number that the exponent belongs to, with it.
std::string number_with_exponent(const Source& source, const WordStop& at) {
  uint64_t from = at.span.begin;
  const auto byte = [&](uint64_t i) { return source.slice({i, i + 1})[0]; };
  while (from > 0 && ((byte(from - 1) >= '0' && byte(from - 1) <= '9') || byte(from - 1) == '.')) --from;
  if (from > 0 && byte(from - 1) == '-') --from;
  std::string number = shown(source, {from, at.span.end});
  std::erase(number, '+');
  return number;
}

void explain(const Source& source, const WordStop& at, bool of_call, Release release, Finding& f) {
  const std::string letter = capital(at.letter);
  if (f.interpreter.starts_with("Cannot put a")) {
    f.message = "`" + at.word + "` cannot be used in a drilling cycle" +
        (at.other_word.empty() ? ": one is in effect here" : ", `" + at.other_word + "`");
    f.help = "turn the axis on a line before it, with `G0`" +
        std::string(at.other_word.empty() ? ", or end the cycle with `G80`" : "");
  } else if (f.interpreter.starts_with("F word used")) {
    f.message = "`" + at.word + "` cannot be used in a thread, " +
        (at.other_word.empty() ? "and `G33` or `G33.1` is in effect" : "`" + at.other_word + "`");
    f.help = "remove it: the speed of the spindle and the pitch `K` are the feed";
  } else if (is_exponent(source, at)) {
    f.message = "`" + at.word + "` is a word of its own: numbers have no exponent";
    const std::string right = with_all_digits(number_with_exponent(source, at));
    f.help = right.empty() ? "write the number with all its digits" : "write `" + right + "`";
  } else if (at.letter == 0) {
    f.message = "a word on this line has no use";
    f.help = "remove it, or add the code that takes it";
  } else {
    f.message = "`" + at.word + "` has no use here: no code on this line takes it";
    if (of_call) {
      f.help = "remove it; to give the sub a value, set a parameter on the line before: `#1=5`";
      return;
    }
    f.help = fmt::format("remove it, or add its code: `{}` belongs to {}", letter,
                         spoken(takers(at.letter, release), release, "or"));
  }
}

/// The line that has begun the cycle or thread that is in effect.
void relate_motion(const Input& in, const FlowStop& stop, const WordStop& at, Finding& f) {
  const bool thread = stop.interpreter.starts_with("F word used");
  if ((!thread && !stop.interpreter.starts_with("Cannot put a")) || !at.other_word.empty()) return;
  const std::string_view codes = thread ? "G33 G33.1" : "G73 G74 G81 G82 G83 G84 G85 G86 G87 G88 G89";
  const std::optional<Setter> setter = setter_of(in, stop, codes, false);
  if (setter && !setter->restores()) relate_setter(in, f, setter, "is in effect from here on");
}

/// The first word of a line with one of the letters; null if there is none.
const WrittenWord* first_of(const std::vector<WrittenWord>& line, std::string_view letters) {
  const auto found = std::ranges::find_if(
      line, [&](const WrittenWord& word) { return letters.find(word.letter) != std::string_view::npos; });
  return found == line.end() ? nullptr : &*found;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const WordStop at = word_stop(in, stop);
    Finding& f = out.add(at.span, "");
    f.interpreter = stop.interpreter;
    const bool of_call = in.program.at(stop.statement).kind == LineKind::kM98;
    explain(*in.program.source, at, of_call, release_of(in.profile), f);
    const bool of_code = (at.letter == 'p' || at.letter == 'q') && at.find('g') != nullptr;
    if (std::optional<Habit> habit = of_code ? habit_of(in, stop.statement) : std::nullopt) {
      // Without the axes U and W, which most machines lack, LinuxCNC stops at those words first.
      const WrittenWord* const axis = in.profile.setup == nullptr ? first_of(at.line, "uvw") : nullptr;
      if (axis != nullptr) f.interpreter = fmt::format("Bad character '{}' used", axis->letter);
      f.message = std::move(habit->message);
      f.help = std::move(habit->help);
    }
    relate_word(f, at);
    relate_motion(in, stop, at, f);
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW707",
    .name = "word-unused",
    .summary = "a word that no code on the line takes",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A word without a code that takes it: `G1 X5 P2`, `H1` without `G43`, `R2` alone. An arc, a cycle or
another motion that is in effect from a line before also counts, but only if the line moves. Also a
word that a code refuses: `A`, `B` or `C` in a drilling cycle, `F` with `G33`.)",
            .why =
                R"(LinuxCNC stops with `P word with no G2 G3 G4 ... to use it` and the like. The lists in these messages are
not exact; owlint's come from runs of the interpreter, and docs/codes.md has them. Nothing of the line
is executed.

`F`, `S` and `T` need no code. `Q-1` counts as no `Q`.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2 F80
H1
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2 F80
G43 H1
G0 Z5
M2
)",
            .fix =
                R"(Remove the word, or write the code that is missing. In a modal cycle or arc, check that the mode is still
in effect: `G0` or `G80` between two holes ends it.)",
            .level_reason = "Error: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "H word with no G43 or G76 to use it",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow707
