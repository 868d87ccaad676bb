// Lines that are written as another controller has them, although LinuxCNC knows their codes: what was meant.
#include <algorithm>

#include <fmt/format.h>

#include "rules/driver/modes.h"

namespace owlint::rules {
namespace {

constexpr std::string_view kAnyAxis = "*";

std::string of_word(const Source& source, const WrittenWord& word) { return "`" + shown(source, word.span) + "`"; }

/// `G05.1 Q1`, `G5 P10000`, `G08 P1`: nothing but the code and one word.
std::optional<Habit> look_ahead(const Source& source, const std::vector<WrittenWord>& line) {
  const WrittenWord* const code = find_word(line, "G5.1 G5 G8");
  if (code == nullptr || !code->value || find_word(line, kAnyAxis) != nullptr) return std::nullopt;
  constexpr double kG5 = 5, kG8 = 8, kHighSpeed = 10'000;
  const WrittenWord* const word = find_word(line, *code->value == kG5 || *code->value == kG8 ? "P" : "Q");
  if (word == nullptr || !word->value) return std::nullopt;
  if (std::ranges::any_of(line, [&](const WrittenWord& w) { return &w != code && &w != word && w.letter != 'n'; }))
    return std::nullopt;
  const bool switches = *word->value == 0 || *word->value == 1 || *word->value == kHighSpeed;
  if (!switches) return std::nullopt;
  const char* const here = *code->value == kG8 ? "makes `X` a radius" : "is a curve, a spline";
  return Habit{fmt::format("{} with {} is look-ahead on Fanuc; in LinuxCNC `{}` {}", of_word(source, *code),
                           of_word(source, *word),
                           *code->value == kG8       ? "G8"
                               : *code->value == kG5 ? "G5"
                                                     : "G5.1",
                           here),
               "remove the line: LinuxCNC always looks ahead; `G64 P0.01` lets it round corners within a tolerance"};
}

/// `G4 X2`: the time is X, U, F or S on other controllers.
std::optional<Habit> dwell(const Source& source, const std::vector<WrittenWord>& line) {
  constexpr double kLong = 100, kThousand = 1000;
  const WrittenWord* const code = find_word(line, "G4");
  const WrittenWord* const time = find_word(line, find_word(line, "M3 M4") == nullptr ? "X U F S" : "X U F");
  if (code == nullptr || time == nullptr || find_word(line, "P") != nullptr) return std::nullopt;
  std::string value = shown(source, {time->span.begin + 1, time->span.end});
  const bool milliseconds = time->value && *time->value >= kLong && value.find('.') == std::string::npos;
  if (milliseconds) value = fmt::format("{}", *time->value / kThousand);
  return Habit{fmt::format("{} needs the time as `P`", of_word(source, *code)),
               fmt::format("write `P{}` in place of {}, if these are {}", value, of_word(source, *time),
                           milliseconds ? "milliseconds" : "seconds")};
}

/// A code that other controllers have with a word that LinuxCNC does not take there.
struct Pair {
  std::string_view codes, word;
  std::string_view without;  ///< words that none of may be on the line
  std::string_view what;
  std::string_view help;  ///< `{}`: the value of the word
};
constexpr Pair kPairs[] = {
    {"G92 G50", "S", kAnyAxis, "limits the speed of the spindle on Fanuc",
     "write `D{}` on the line of `G96`: it limits the speed there"},
    {"G92", "E", kAnyAxis, "is about the extruder of a 3D printer", "remove the line"},
    {"G54", "P", "G10 G4", "is a further coordinate system on other controllers", kNineSystems},
};

/// `G92 S3000`, `G92 E0`, `G54 P1`.
std::optional<Habit> pair(const Source& source, const std::vector<WrittenWord>& line) {
  for (const Pair& row : kPairs) {
    const WrittenWord* const code = find_word(line, row.codes);
    const WrittenWord* const word = find_word(line, row.word);
    if (code == nullptr || word == nullptr || find_word(line, row.without) != nullptr) continue;
    const std::string value = shown(source, {word->span.begin + 1, word->span.end});
    return Habit{fmt::format("{} with {} {}", of_word(source, *code), of_word(source, *word), row.what),
                 fmt::format(fmt::runtime(row.help), value)};
  }
  return std::nullopt;
}

constexpr std::string_view kContourAsSub =
    "write the contour as a sub, and name it as `Q`: `G71 Q100 X50 Z2 D1 I0.2 R0.5`";

/// `G71 U2`, `G71 U2 R1`, `G73 U5 W5 R3`: the first line of two.
std::optional<Habit> first_of_cycle(const Source& source, const std::vector<WrittenWord>& line) {
  const WrittenWord* const code = find_word(line, "G71 G72 G73");
  const WrittenWord* const depth = find_word(line, "U W");
  const WrittenWord* const retract = find_word(line, "R");
  const bool alone =
      std::ranges::all_of(line, [&](const WrittenWord& w) { return &w == code || &w == depth || w.letter == 'n'; });
  if (code == nullptr || depth == nullptr || (retract == nullptr && !alone) || find_word(line, "P") != nullptr ||
      find_word(line, "Q") != nullptr || find_word(line, "X") != nullptr || find_word(line, "Z") != nullptr)
    return std::nullopt;
  return Habit{
      fmt::format("{} with {}{} is the first of two lines on Fanuc, and not LinuxCNC's", of_word(source, *code),
                  of_word(source, *depth), retract == nullptr ? "" : " and " + of_word(source, *retract)),
      std::string(kContourAsSub)};
}

/// `G71 P10 Q20 U0.5`: the contour is between two line numbers. `G76 P010060 Q100 R50`: the first line of two.
std::optional<Habit> turning_cycle(const Source& source, const std::vector<WrittenWord>& line) {
  const WrittenWord* const contour = find_word(line, "G70 G71 G72 G73");
  const WrittenWord* const thread = find_word(line, "G76");
  if (find_word(line, "G70") != nullptr && find_word(line, "X Z D E") != nullptr) return std::nullopt;
  const WrittenWord* const from = find_word(line, "P");
  const WrittenWord* const to = find_word(line, "Q");
  if (from == nullptr || to == nullptr || (contour == nullptr) == (thread == nullptr)) return std::nullopt;
  if (thread != nullptr) {
    if (find_word(line, kAnyAxis) != nullptr) return std::nullopt;
    return Habit{
        fmt::format("{} with {} and without an end is the first of two lines on Fanuc", of_word(source, *thread),
                    of_word(source, *from)),
        "write one line: `G76 P1.5 Z-20 I-1 J0.1 R1.5 K0.9 Q29.5` has the pitch as `P`, the end as `Z`, and the "
        "depth as `K`"};
  }
  return Habit{fmt::format("{} with {} and {} is a cycle of Fanuc: the contour stands between these two line numbers",
                           of_word(source, *contour), of_word(source, *from), of_word(source, *to)),
               std::string(kContourAsSub)};
}

/// `G76 X10 Y10 Z-5 R2 Q0.2`: a cycle of mills.
std::optional<Habit> fine_boring(const Source& source, const std::vector<WrittenWord>& line) {
  const WrittenWord* const code = find_word(line, "G76");
  const WrittenWord* const depth = find_word(line, "Z");
  const WrittenWord* const retract = find_word(line, "R");
  if (code == nullptr || depth == nullptr || retract == nullptr || find_word(line, "P J K") != nullptr)
    return std::nullopt;
  // A thread of a lathe has X, and no Y.
  if (find_word(line, "X") != nullptr && find_word(line, "Y") == nullptr) return std::nullopt;
  return Habit{fmt::format("{} with {} and {} bores on Fanuc; in LinuxCNC it cuts a thread", of_word(source, *code),
                           of_word(source, *depth), of_word(source, *retract)),
               "bore with `G85`, `G86` or `G89`: LinuxCNC has no cycle that draws the tool away from the wall"};
}

/// The nearest line above with words of places: the code on it that counts for its own line only, if it has one.
std::optional<Habit> behind_spline(const Input& in, StatementId statement) {
  constexpr uint32_t kMostLines = 50;
  const Source& source = *in.program.source;
  const uint32_t first = in.program.at(statement).line;
  for (uint32_t line = first - 1; line > 0 && line + kMostLines > first; --line) {
    const std::vector<WrittenWord> words = words_of(source, source.line(line));
    if (find_word(words, "X Y Z") == nullptr) continue;
    const WrittenWord* const code = find_word(words, "G5 G5.1 G6 G6.1");
    if (code == nullptr) return std::nullopt;
    const std::string name = shown(source, code->span);
    return Habit{fmt::format("`{}` on line {} counts for its own line only", name, line),
                 fmt::format("write `{}` on this line, too", name)};
  }
  return std::nullopt;
}

}  // namespace

bool is_angle_for_power(const Source& source, Span word, const std::vector<WrittenWord>& line) {
  if (word.begin == 0 || word.end <= word.begin || source.slice({word.begin, word.begin + 1}) != "^") return false;
  const char before = source.slice({word.begin - 1, word.begin})[0];
  const bool value = (before >= '0' && before <= '9') || before == ']' || before == '>' || before == '.';
  // `G1@10^45` is a polar position, and so is `G1^45`.
  return value && std::ranges::none_of(line, [&](const WrittenWord& w) {
           return w.letter == '@' || ((w.letter == 'g' || w.letter == 'n') && w.span.end == word.begin);
         });
}

std::optional<Habit> habit_of(const Input& in, StatementId statement) {
  const Source& source = *in.program.source;
  const std::vector<WrittenWord> line = words_of(source, in.program.at(statement).whole());
  if (std::optional<Habit> found = look_ahead(source, line)) return found;
  for (const auto& habit : {dwell, pair, first_of_cycle, turning_cycle, fine_boring}) {
    if (std::optional<Habit> found = habit(source, line)) return found;
  }
  if (find_word(line, "G") != nullptr) return std::nullopt;
  return behind_spline(in, statement);
}

}  // namespace owlint::rules
