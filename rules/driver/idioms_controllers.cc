// Codes and words of other controllers, and units behind numbers: what LinuxCNC has in place of them.
#include <algorithm>
#include <array>

#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// A word of another controller. Longer ones come before their beginnings.
struct ControllersWord {
  std::string_view word;  ///< small, without blanks
  std::string_view shown;
  std::string_view controller;
  std::string_view instead;
};

constexpr std::array kWords = std::to_array<ControllersWord>({
    {"fmax", "FMAX", "Heidenhain", "a move at the rapid rate is `G0`"},
    {"calllbl", "CALL LBL", "Heidenhain", "call a sub: `o1 call`"},
    {"lbl", "LBL", "Heidenhain", "a sub begins with `o1 sub` and ends with `o1 endsub`"},
    {"toolcall", "TOOL CALL", "Heidenhain", "change the tool with `T1 M6`, and write the speed as `S`"},
    {"tooldef", "TOOL DEF", "Heidenhain", "the length and radius of a tool are in the tool table"},
    {"cycldef", "CYCL DEF", "Heidenhain", "the drilling cycles are `G81` to `G89`"},
    {"cyclcall", "CYCL CALL", "Heidenhain", "a cycle such as `G81` drills on its own line, and on each line behind it"},
    {"blkform", "BLK FORM", "Heidenhain", "remove the line: LinuxCNC knows nothing of the blank"},
    {"beginpgm", "BEGIN PGM", "Heidenhain", "remove the line: a program needs no head"},
    {"endpgm", "END PGM", "Heidenhain", "end the program with `M2`"},
    {"atrans", "ATRANS", "Siemens", "shift the coordinate system with `G52 X10`, or set it with `G10 L2 P1 X10`"},
    {"trans", "TRANS", "Siemens", "shift the coordinate system with `G52 X10`, or set it with `G10 L2 P1 X10`"},
    {"arot", "AROT", "Siemens", "rotate the coordinate system with `G10 L2 P0 R30`"},
    {"rot", "ROT", "Siemens", "rotate the coordinate system with `G10 L2 P0 R30`"},
    {"supa", "SUPA", "Siemens", "write `G53` for a move in machine coordinates"},
    {"stopre", "STOPRE", "Siemens", "remove it; `G4 P0` waits until the machine stands"},
    {"mcall", "MCALL", "Siemens", "call the sub on each line: `o1 call`"},
    {"diamon", "DIAMON", "Siemens", "write `G7`: X is a diameter"},
    {"diamof", "DIAMOF", "Siemens", "write `G8`: X is a radius"},
});

/// Whether a text ends at a place of the line: a blank, a digit or a sign follows.
bool ends_at(const RefusedLine& line, size_t at) {
  return at >= line.end || line.apart(at) || !is_small_letter(line.text[at]);
}

/// Codes of printers that text follows.
struct TextCode {
  std::string_view code;
  std::string_view instead;  ///< empty: the text as a message
};
constexpr TextCode kTextCodes[] = {
    {"m117", {}},
    {"m118", {}},
    {"m23", "open the program on LinuxCNC's screen"},
    {"m28", "remove the line"},
    {"m32", "call the program as a sub: `o<name> call`"},
};

struct Unit {
  std::string_view text;
  std::string_view help;
};
// Longer ones first.
constexpr Unit kUnits[] = {
    {"mm/min", "remove it: with `G21`, `F` is in millimeters per minute"},
    {"mm/rev", "remove it: with `G95` and `G21`, `F` is in millimeters per revolution"},
    {"in/min", "remove it: with `G20`, `F` is in inches per minute"},
    {"ipm", "remove it: with `G20`, `F` is in inches per minute"},
    {"mm", "remove it: `G21` says that lengths are in millimeters"},
    {"inches", "remove it: `G20` says that lengths are in inches"},
    {"inch", "remove it: `G20` says that lengths are in inches"},
    {"in", "remove it: `G20` says that lengths are in inches"},
    {"deg", "remove it: angles are in degrees"},
    {"rpm", "remove it: `S` is in revolutions per minute"},
    {"sec", "remove it: times are in seconds"},
};

}  // namespace

/// `M117 Hello`.
bool prints_text(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kWordUnreadable && line.kind() != StopKind::kNumberMissing) return false;
  std::string_view before = line.before();
  if (before.starts_with('/')) before.remove_prefix(1);
  if (before.starts_with('n')) before.remove_prefix(std::min(before.find_first_not_of("0123456789", 1), before.size()));
  const auto* const code = std::ranges::find(kTextCodes, before, &TextCode::code);
  if (code == std::end(kTextCodes)) return false;
  const size_t from = line.at - code->code.size();
  f.message = "`" + line.written(from, line.at) + "` with text is a code of 3D printers";
  if (!code->instead.empty()) {
    f.help = code->instead;
    return true;
  }
  const std::string right = "(MSG, " + line.written(line.at, line.end) + ")";
  f.help = "write `" + right + "`";
  if (line.end == line.text.size()) line.propose(f, f.help, {line.put(from, line.end, right)}, false);
  return true;
}

/// `#1 = 5mm`, `F100mm/min`.
bool has_unit(const RefusedLine& line, Finding& f) {
  const bool inside =
      line.kind() == StopKind::kExpression && line.error.message.starts_with("Unknown operation");  // `SIN[30deg]`
  if ((!inside && line.kind() != StopKind::kWordUnreadable && line.kind() != StopKind::kNumberMissing) || line.at == 0)
    return false;
  const char before = line.text[line.at - 1];
  if (!is_digit(before) && before != '.' && before != '>' && before != ']') return false;
  const auto* const unit = std::ranges::find_if(
      kUnits, [&](const Unit& u) { return line.rest().starts_with(u.text) && ends_at(line, line.at + u.text.size()); });
  if (unit == std::end(kUnits)) return false;
  const size_t behind = line.at + unit->text.size();
  // `S5000 MM3`, `N105 MM30`: a letter that is written twice.
  const std::string_view text = line.text.text();
  const size_t letter = line.before().find_last_not_of("0123456789.");
  const bool other_word = letter != std::string_view::npos && (text[letter] == 'n' || text[letter] == 't');
  if (!inside && (other_word || (behind < text.size() && is_digit(text[behind]) && !line.apart(behind)))) return false;
  f.message = "`" + line.written(line.at, behind) + "` is a unit: LinuxCNC reads numbers only";
  f.help = unit->help;
  const uint64_t from = line.text.offset(line.at - 1) + 1;
  line.propose(f, "remove `" + line.written(line.at, behind) + "`", {{{from, line.text.span(line.at, behind).end}, ""}},
               false);
  return true;
}

/// `TRANS X10`, `G0 X10 FMAX`, `CALL LBL 1`.
bool is_other_controllers_word(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kWordUnreadable && line.kind() != StopKind::kNumberMissing) return false;
  const auto* const word = std::ranges::find_if(kWords, [&](const ControllersWord& w) {
    return line.rest().starts_with(w.word) && ends_at(line, line.at + w.word.size());
  });
  if (word == kWords.end()) return false;
  f.message = "`" + std::string(word->shown) + "` is a word of " + std::string(word->controller) +
      ", which LinuxCNC does not have";
  f.help = word->instead;
  return true;
}

/// `L X+10 Y+5 FMAX`.
bool moves_as_heidenhain(const RefusedLine& line, Finding& f) {
  const std::string_view rest = line.rest();
  const size_t first = line.statement.block_delete ? 1 : 0;
  const bool axis = rest.size() > 2 && std::string_view("xyzabcuvw").find(rest[1]) != std::string_view::npos &&
      !is_small_letter(rest[2]);
  if (line.kind() != StopKind::kNumberMissing || line.at != first || !rest.starts_with('l') || !axis) return false;
  const bool rapid = rest.find("fmax") != std::string_view::npos;
  f.message = "`L` before the axes is a straight move of Heidenhain";
  f.help = rapid ? "write `G0` in place of `L`, without `FMAX`" : "write `G1` in place of `L`, with a feed rate `F`";
  return true;
}

/// `X=R1`, `T="DRILL"`.
bool assigns_word_as_siemens(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kNumberMalformed && line.kind() != StopKind::kNumberMissing) return false;
  const std::string_view rest = line.rest();
  if (rest.size() < 3 || !is_small_letter(rest[0]) || rest[1] != '=') return false;
  const std::string letter = line.written(line.at, line.at + 1);
  if (rest[0] == 't' && (rest[2] == '"' || is_small_letter(rest[2]))) {
    f.message = "LinuxCNC calls a tool by its number, not by its name";
    f.help = "write `T1 M6`, with the number of the tool in the tool table";
    return true;
  }
  size_t to = 3;
  while (to < rest.size() && is_digit(rest[to])) ++to;
  if (rest[2] != 'r' || to == 3) return false;
  const std::string parameter = line.written(line.at + 2, line.at + to);
  const std::string right = letter + "#" + parameter.substr(1);
  f.message = "`" + parameter + "` is a parameter of Siemens: LinuxCNC's parameters are `#1`, `#2` and so on";
  f.help = "write `" + right + "`";
  const bool whole = to == rest.size() || is_small_letter(rest[to]);
  if (whole) line.propose(f, f.help, {line.put(line.at, line.at + to, right)}, false);
  return true;
}

}  // namespace owlint::rules
