// OW711 order-on-line: what a line does first is not what is written first.
// Depends on: the words of a line act in a fixed order, whatever their order on the line: outputs, tool change, spindle,
// coolant, the machine's own M codes, dwell, units, coordinate system, distance mode, move, stop.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "rules/driver/words.h"

namespace owlint::rules::ow711 {
namespace {

constexpr int kUserFirst = 100;
constexpr int kUserLast = 199;

/// What a code does, if it matters whether it does it before or after the move.
std::string what_m(int number) {
  switch (number) {
    case code::kM3:
    case code::kM4: return "starts the spindle";
    case code::kM5: return "stops the spindle";
    case code::kM19: return "turns the spindle to its angle";
    case code::kM6: return "changes the tool";
    case code::kM9: return "switches the coolant off";
    case code::kM64:
    case code::kM65: return "switches the output";
    case code::kM66: return "waits for the input";
    case code::kM68: return "sets the output";
    default: return number >= kUserFirst && number <= kUserLast ? "runs the machine's program" : "";
  }
}

std::string what_g(int tenths) {
  const GCode* code = g_code(tenths, Release::k2_10);
  if (code == nullptr) return "";
  switch (code->group) {
    case GGroup::kDistance:
    case GGroup::kUnits: return "acts";
    case GGroup::kCoordinateSystem: return "chooses the coordinate system";
    default: return tenths == code::kG4 ? "waits" : "";
  }
}

bool is_stop(int number) {
  const MCode* code = m_code(number);
  return code != nullptr && code->group == MGroup::kStop && number != code::kM99;
}

/// A line's words, and which of them are its move.
struct Line {
  std::vector<WrittenWord> words;
  size_t first = SIZE_MAX;  ///< word of the move
  size_t last = 0;
  size_t dwell = SIZE_MAX;

  static int number(const WrittenWord& word) {
    constexpr double kMost = 1000;
    if (!word.value || *word.value < 0 || *word.value > kMost) return -1;
    return static_cast<int>(std::lround(*word.value * (word.letter == 'g' ? 10 : 1)));
  }

  explicit Line(std::vector<WrittenWord> all) : words(std::move(all)) {
    bool sets = false;  // G10, G52, G92: their axis words are no move
    bool axes = false;
    const auto part = [&](size_t i) {
      first = std::min(first, i);
      last = i;
    };
    for (size_t i = 0; i < words.size(); ++i) {
      const WrittenWord& word = words[i];
      if (std::string_view("xyzabcuvw@^").find(word.letter) != std::string_view::npos) {
        axes = true;
        part(i);
      } else if (word.letter == 'g') {
        const int tenths = number(word);
        const GCode* code = g_code(tenths, Release::k2_10);
        if (code == nullptr) continue;
        sets = sets || tenths == code::kG10 || tenths == code::kG52 || tenths == code::kG92 || tenths == code::kG80 ||
            tenths == code::kG43_1;
        if (tenths == code::kG4) dwell = i;
        if (code->motion != Motion::kNone && code->motion != Motion::kG80) part(i);
        if (tenths == code::kG28 || tenths == code::kG30) {
          axes = true;
          part(i);
        }
      }
    }
    if (sets || !axes) first = SIZE_MAX;
  }
  bool moves() const { return first != SIZE_MAX; }
};

void report(const Source& source, const Line& line, Reporter& out) {
  for (size_t i = 0; i < line.words.size(); ++i) {
    const WrittenWord& word = line.words[i];
    if (word.letter != 'g' && word.letter != 'm') continue;
    const int number = Line::number(word);
    const std::string what = word.letter == 'm' ? what_m(number) : what_g(number);
    const std::string written = shown(source, word.span);
    std::string message;
    size_t other = line.last;
    if (line.moves() && i > line.last && !what.empty()) {
      message = fmt::format("`{}` {} before the move, although it is written after it", written, what);
    } else if (line.moves() && i < line.first && word.letter == 'm' && is_stop(number)) {
      message = fmt::format("`{}` {} the program after the move, although it is written before it", written,
                            number == code::kM2 || number == code::kM30 ? "ends" : "pauses");
      other = line.first;
    } else if (line.dwell < i && word.letter == 'm' && !what.empty()) {
      message = fmt::format("`{}` {} before `G4` waits, although it is written after it", written, what);
      other = line.dwell;
    } else {
      continue;
    }
    Finding& f = out.add(word.span, std::move(message));
    f.help = "write two lines, in the order that you want";
    f.related.push_back({line.words[other].span, "`" + shown(source, line.words[other].span) + "` is here", nullptr});
    return;  // one finding says enough about a line
  }
}

/// Lines of motion have no statement: they are read again here, which takes time only where the rule is selected.
void check(const Input& in, Reporter& out) {
  const Source& source = *in.program.source;
  const std::string_view text = source.bytes();
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    const Span span{begin, end};
    begin = end + 1;
    const size_t first = std::min(line.find_first_not_of(" \t/"), line.size());
    if (first == line.size() || std::string_view("oO;(%#").find(line[first]) != std::string_view::npos) continue;
    if (line.find_first_of("gGmM", first + 1) == std::string_view::npos) continue;
    report(source, Line(words_of(source, span)), out);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW711",
    .name = "order-on-line",
    .summary = "words that act in another order than they are written",
    .group = Group::kWords,
    .level = Severity::kInfo,
    .page =
        {
            .what =
                R"(A code that acts before the move of its line, although it is written after it: `G0 X10 M5`, `G1 X10 G4
P1`, `G0 X10 G91`. A pause that is written before the move and comes after it: `M0 G0 X10`. A dwell that
is written before a spindle or output code: `G4 P1 M3`.

`F`, `S` and `T`, and codes that people commonly write after a move (coolant on, tool length), are
not reported.)",
            .why =
                R"(The order of the words on a line means nothing. LinuxCNC always does: feed and speed, outputs, tool
change, spindle, coolant, the machine's M codes, dwell, plane, units, cutter compensation, tool length,
coordinate system, `G90` or `G91`, the move, and then `M0`, `M1`, `M2`, `M30`. So `G1 X10 M5` stops the
spindle before the cut.)",
            .bad = R"(G21 G90
M3 S1000
G1 X10 F200 M5
M2
)",
            .good = R"(G21 G90
M3 S1000
G1 X10 F200
M5
M2
)",
            .fix =
                R"(Write two lines. If the line does what you want, suppress the finding, or write the words in the order in
which they act.)",
            .level_reason = "Info: the program runs as documented.",
            .interpreter = "",
            .options = "--extend-select OW711",
        },
    .check = check,
};

}  // namespace owlint::rules::ow711
