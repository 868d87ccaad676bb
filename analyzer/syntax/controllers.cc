#include "analyzer/syntax/controllers.h"

#include <algorithm>
#include <array>
#include <vector>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

constexpr std::string_view kFluid = "FluidNC";
constexpr std::string_view kGrbl = "grbl";
constexpr std::string_view kHal = "grblHAL";
constexpr std::string_view kFanuc = "Fanuc macro B";
constexpr std::string_view kHaas = "Haas";
constexpr std::string_view kMach3 = "Mach3";
constexpr std::string_view kMach4 = "Mach4";
constexpr std::string_view kPathPilot = "PathPilot";
constexpr std::string_view kPrinter = "a 3D printer";
constexpr std::string_view kKlipper = "Klipper";
constexpr std::string_view kSiemens = "Siemens";
constexpr std::string_view kHeidenhain = "Heidenhain";

constexpr Mark kMarks[] = {
    {kFluid, "command", Proof::kAlone, "$&*/*", "$SD/Run=part.nc"},
    {kFluid, "command", Proof::kAlone, "[ESP@]*", "[ESP800]"},
    {kGrbl, "command", Proof::kAlone, "$J=*", "$J=G91 X10 F500"},
    {kGrbl, "command", Proof::kAlone, "$H", "$H"},
    {kGrbl, "command", Proof::kAlone, "$X", "$X"},
    {kGrbl, "command", Proof::kAlone, "$$", "$$"},
    {kGrbl, "command", Proof::kAlone, "$@=@", "$110=500"},
    {kHal, "flow", Proof::kAlone, "O@ALARM*", "o100 alarm [3]"},
    {kHal, "flow", Proof::kAlone, "O@ERROR*", "o100 error [3]"},

    {kFanuc, "jump", Proof::kTwo, "IF*GOTO@", "IF [#1 EQ 2] GOTO 20"},
    {kFanuc, "jump", Proof::kTwo, "IF*GOTO#*", "IF [#1 EQ 2] GOTO #3"},
    {kFanuc, "jump", Proof::kTwo, "GOTO@", "GOTO 20"},
    {kFanuc, "jump", Proof::kTwo, "GOTO#*", "GOTO #3"},
    {kFanuc, "then", Proof::kTwo, "IF*THEN#*", "IF [#1 EQ 2] THEN #3 = 4"},
    {kFanuc, "loop", Proof::kTwo, "WHILE*]DO@", "WHILE [#1 LT 5] DO 1"},
    {kFanuc, "loop", Proof::kTwo, "END@", "END 1"},
    {kFanuc, "print", Proof::kTwo, "POPEN", "POPEN"},
    {kFanuc, "print", Proof::kTwo, "PCLOS", "PCLOS"},
    {kFanuc, "print", Proof::kTwo, "DPRNT[*", "DPRNT[X#1[44]]"},
    {kFanuc, "print", Proof::kTwo, "BPRNT[*", "BPRNT[X#1[44]]"},
    {kFanuc, "null", Proof::kTwo, "IF*EQ#0]*", "IF [#1 EQ #0] GOTO 20"},
    {kFanuc, "call", Proof::kHint, "G65P@*", "G65 P9010 A1"},
    {kFanuc, "call", Proof::kHint, "G66P@*", "G66 P9010 A1"},
    {kFanuc, "alarm", Proof::kHint, "#3000=*", "#3000 = 1 (no tool)"},

    {kHaas, "G103", Proof::kTwo, "G103*", "G103 P1"},
    {kHaas, "G154", Proof::kTwo, "G154P@*", "G154 P2"},
    {kHaas, "G187", Proof::kTwo, "G187*", "G187 P1"},
    {kHaas, "G150", Proof::kTwo, "G150*", "G150 P100 D1"},
    {kHaas, "M97", Proof::kTwo, "M97P@*", "M97 P100"},
    {kHaas, "print", Proof::kHint, "DPRNT[*", "DPRNT[X#1[44]]"},

    {kMach3, "M40", Proof::kIfNamed, "M40", "M40"},
    {kMach3, "M47", Proof::kIfNamed, "M47", "M47"},
    {kMach3, "G31", Proof::kIfNamed, "G31*", "G31 Z-10 F100"},
    {kMach3, "G68", Proof::kIfNamed, "G68*", "G68 A0 B0 R45"},
    {kMach3, "G16", Proof::kIfNamed, "G16", "G16"},
    {kMach4, "M40", Proof::kIfNamed, "M40", "M40"},
    {kMach4, "M47", Proof::kIfNamed, "M47", "M47"},
    {kMach4, "G31", Proof::kIfNamed, "G31*", "G31 Z-10 F100"},
    {kMach4, "G68", Proof::kIfNamed, "G68*", "G68 X0 Y0 R45"},
    {kMach4, "G65", Proof::kIfNamed, "G65P@*", "G65 P1000 A1"},

    {kPathPilot, "G47", Proof::kIfNamed, "G47*", "G47 X0 Y0 Z-0.1"},
    {kPathPilot, "G37", Proof::kIfNamed, "G37*", "G37 P1"},
    {kPathPilot, "G54.1", Proof::kIfNamed, "G54.1P@*", "G54.1 P12"},
    {kPathPilot, "M99x", Proof::kIfNamed, "M998*", "M998"},
    {kPathPilot, "M99x", Proof::kIfNamed, "M997*", "M997"},

    {kPrinter, "extruder", Proof::kTwo, "M82", "M82"},
    {kPrinter, "extruder", Proof::kTwo, "M83", "M83"},
    {kPrinter, "filament", Proof::kTwo, "G92E@*", "G92 E0"},
    {kPrinter, "E", Proof::kTwo, "G0+E@*", "G0 X10 E5"},
    {kPrinter, "E", Proof::kTwo, "G1+E@*", "G1 X10 Y10 E0.5"},
    {kPrinter, "E", Proof::kTwo, "G01+E@*", "G01 X10 Y10 E0.5"},
    {kPrinter, "heat", Proof::kHint, "M104S@*", "M104 S200"},
    {kPrinter, "heat", Proof::kHint, "M109S@*", "M109 S200"},
    {kPrinter, "heat", Proof::kHint, "M140S@*", "M140 S60"},
    {kPrinter, "heat", Proof::kHint, "M190S@*", "M190 S60"},
    {kPrinter, "fan", Proof::kHint, "M106S@*", "M106 S255"},
    {kPrinter, "motors", Proof::kHint, "M84*", "M84 X Y"},
    {kKlipper, "macro", Proof::kAlone, "[GCODE_MACRO*", "[gcode_macro START]"},
    {kKlipper, "macro", Proof::kAlone, "{%*", "{% set x = 1 %}"},
    {kKlipper, "command", Proof::kAlone, "SET_VELOCITY_LIMIT*", "SET_VELOCITY_LIMIT ACCEL=500"},
    {kKlipper, "command", Proof::kAlone, "SET_PRESSURE_ADVANCE*", "SET_PRESSURE_ADVANCE ADVANCE=0.04"},
    {kKlipper, "command", Proof::kAlone, "SET_HEATER_TEMPERATURE*",
     "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=200"},
    {kKlipper, "command", Proof::kAlone, "EXCLUDE_OBJECT*", "EXCLUDE_OBJECT_START NAME=part"},
    {kKlipper, "command", Proof::kAlone, "BED_MESH*", "BED_MESH_CALIBRATE"},
    {kKlipper, "command", Proof::kAlone, "PRINT_START*", "PRINT_START BED=60"},
    {kKlipper, "command", Proof::kAlone, "START_PRINT*", "START_PRINT BED=60"},
    {kKlipper, "command", Proof::kAlone, "SAVE_GCODE_STATE*", "SAVE_GCODE_STATE NAME=pause"},

    {kSiemens, "head", Proof::kAlone, "%_N_*", "%_N_FLANGE_MPF"},
    {kSiemens, "head", Proof::kAlone, ";$PATH=*", ";$PATH=/_N_WKS_DIR"},
    {kSiemens, "cycle", Proof::kAlone, "CYCLE@(*", "CYCLE83(5,0,2,-10)"},
    {kSiemens, "jump", Proof::kAlone, "GOTOF&*", "GOTOF LOOP_END"},
    {kSiemens, "jump", Proof::kAlone, "GOTOB&*", "GOTOB AGAIN"},
    {kSiemens, "jump", Proof::kAlone, "IF*GOTOF&*", "IF R1==1 GOTOF LOOP_END"},
    {kSiemens, "jump", Proof::kAlone, "IF*GOTOB&*", "IF R1==1 GOTOB AGAIN"},
    {kSiemens, "definition", Proof::kAlone, "DEFREAL*", "DEF REAL DEPTH"},
    {kSiemens, "definition", Proof::kAlone, "DEFINT*", "DEF INT COUNT"},
    {kSiemens, "message", Proof::kTwo, "MSG(\"*", "MSG(\"drill\")"},
    {kSiemens, "R", Proof::kTwo, "R@=*", "R1=5"},
    {kSiemens, "frame", Proof::kTwo, "TRANS&*", "TRANS X10"},
    {kSiemens, "frame", Proof::kTwo, "ATRANS*", "ATRANS X10"},
    {kSiemens, "end", Proof::kTwo, "M17", "M17"},
    {kSiemens, "tool", Proof::kTwo, "T=\"*", "T=\"DRILL\" D1"},
    {kSiemens, "SUPA", Proof::kTwo, "SUPA*", "SUPA G0 Z0"},
    {kSiemens, "SUPA", Proof::kTwo, "G+SUPA*", "G0 SUPA Z0"},
    {kSiemens, "radius", Proof::kTwo, "G+CR=@*", "G2 X10 Y0 CR=5"},
    {kSiemens, "loop", Proof::kTwo, "ENDFOR", "ENDFOR"},

    {kHeidenhain, "head", Proof::kAlone, "BEGINPGM*", "0 BEGIN PGM FLANGE MM"},
    {kHeidenhain, "head", Proof::kAlone, "ENDPGM*", "99 END PGM FLANGE MM"},
    {kHeidenhain, "tool", Proof::kTwo, "TOOLCALL*", "TOOL CALL 5 Z S3000"},
    {kHeidenhain, "cycle", Proof::kTwo, "CYCLDEF*", "CYCL DEF 200 DRILLING"},
    {kHeidenhain, "blank", Proof::kTwo, "BLKFORM*", "BLK FORM 0.1 Z X+0 Y+0 Z-20"},
    {kHeidenhain, "label", Proof::kTwo, "LBL@", "LBL 1"},
    {kHeidenhain, "label", Proof::kTwo, "CALLLBL*", "CALL LBL 1 REP 3"},
    {kHeidenhain, "line", Proof::kTwo, "L+FMAX*", "L X+10 Y+20 R0 FMAX M3"},
    {kHeidenhain, "parameter", Proof::kTwo, "FN@:*", "FN 0: Q1 = +5"},
};

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(static_cast<size_t>(std::ranges::find_if_not(text, is_blank) - text.begin()));
  return text;
}

/// What stands behind `/`, `N10`, or a number alone.
std::string_view without_number(std::string_view line) {
  line = without_blanks(line);
  if (line.starts_with('/')) line = without_blanks(line.substr(1));
  std::string_view rest = line;
  if (!rest.empty() && capital(rest[0]) == 'N') rest = without_blanks(rest.substr(1));
  if (rest.empty() || !is_digit(rest[0])) return line;
  rest.remove_prefix(static_cast<size_t>(std::ranges::find_if_not(rest, is_digit) - rest.begin()));
  return without_blanks(rest);
}

/// Whether a line is `o100 if`, `o<drill> call` and the like: other controllers of the table have `O1000` for programs only.
bool is_oword(std::string_view line) {
  if (line.empty() || capital(line[0]) != 'O') return false;
  line = without_blanks(line.substr(1));
  if (line.starts_with('<')) return line.find('>') != std::string_view::npos;
  const auto end = std::ranges::find_if_not(line, is_digit);
  if (end == line.begin()) return false;
  const std::string_view rest = without_blanks(line.substr(static_cast<size_t>(end - line.begin())));
  return rest.size() > 1 && is_letter(rest[0]) && is_letter(rest[1]);
}

bool has_owords(std::string_view controller) {
  return controller == kFluid || controller == kGrbl || controller == kHal || controller == kPathPilot;
}

/// The letters and digits of a text, one bit each.
uint64_t all_characters(std::string_view text) {
  constexpr int kLetters = 26;
  uint64_t bits = 0;
  for (const char c : text) {
    if (is_letter(c)) bits |= uint64_t{1} << (capital(c) - 'A');
    if (is_digit(c)) bits |= uint64_t{1} << (kLetters + c - '0');
  }
  return bits;
}

/// A mark, and the characters that a line must have to fit it: most lines of motion lack one.
struct Wanted {
  const Mark* mark;
  uint64_t characters;
};

/// Marks by the first character of their patterns.
const std::array<std::vector<Wanted>, 128>& by_first() {
  static const auto lists = [] {
    std::array<std::vector<Wanted>, 128> out;
    for (const Mark& mark : kMarks)
      out[static_cast<unsigned char>(mark.pattern[0])].push_back({&mark, all_characters(mark.pattern)});
    return out;
  }();
  return lists;
}

/// Whether a comment names a controller.
bool mentions(std::string_view head, std::string_view name) {
  const auto same = [](char a, char b) { return capital(a) == capital(b); };
  for (auto at = head.begin(); (at = std::search(at, head.end(), name.begin(), name.end(), same)) != head.end(); ++at) {
    const size_t place = static_cast<size_t>(at - head.begin());
    const size_t feed = head.rfind('\n', place);
    const std::string_view before = head.substr(feed + 1, place - feed - 1);
    if (before.find_first_of("(;") != std::string_view::npos) return true;
  }
  return false;
}

struct Seen {
  const Mark* mark;
  Span span;
};

/// Whether what was seen of one controller is enough; the marks that say so.
bool enough(const std::vector<Seen>& seen, std::string_view controller, bool named, Nature* nature) {
  const Seen* first = nullptr;
  for (const Seen& s : seen) {
    if (s.mark->controller != controller) continue;
    const Proof proof = s.mark->proof;
    if (proof == Proof::kAlone || (proof == Proof::kIfNamed && named)) {
      nature->mark = s.span;
      nature->other_mark = {};
      return true;
    }
    if (proof == Proof::kIfNamed) continue;
    // Of two, one at least must be what no machine can be taught.
    if (first != nullptr && s.mark->family != first->mark->family &&
        (proof == Proof::kTwo || first->mark->proof == Proof::kTwo)) {
      nature->mark = first->span;
      nature->other_mark = s.span;
      return true;
    }
    if (first == nullptr || (first->mark->proof == Proof::kHint && proof == Proof::kTwo)) first = &s;
  }
  return false;
}

}  // namespace

std::span<const Mark> marks() { return kMarks; }

// Depth is bounded by the length of a pattern.
bool fits(std::string_view line, std::string_view pattern) {
  for (size_t i = 0; i < pattern.size(); ++i) {
    line = without_blanks(line);
    const char wanted = pattern[i];
    if (wanted == '*' || wanted == '+') {
      const std::string_view rest = pattern.substr(i + 1);
      if (rest.empty()) return true;
      for (; !line.empty(); line.remove_prefix(1)) {
        if (fits(line, rest)) return true;
        const char c = line[0];
        if (c == '(' || c == ';' || (wanted == '+' && (c == '[' || c == '#'))) return false;
      }
      return false;
    }
    if (line.empty()) return false;
    if (wanted == '@') {
      if (line[0] == '-' || line[0] == '+') line = without_blanks(line.substr(1));
      const auto end = std::ranges::find_if_not(line, [](char c) { return is_digit(c) || c == '.'; });
      if (end == line.begin()) return false;
      line.remove_prefix(static_cast<size_t>(end - line.begin()));
      continue;
    }
    if (wanted == '&' ? !is_letter(line[0]) : capital(line[0]) != wanted) return false;
    line.remove_prefix(1);
  }
  line = without_blanks(line);
  return line.empty() || line[0] == '(' || line[0] == ';';
}

void find_controller(std::string_view head, Nature* nature) {
  constexpr size_t kLongest = 256;  // of a line that is looked at
  std::vector<Seen> seen;           // each mark once
  bool owords = false;
  for (size_t at = 0; at < head.size();) {
    const size_t end = std::min(head.find('\n', at), head.size());
    const std::string_view whole = head.substr(at, std::min(end - at, kLongest));
    const std::string_view line = without_number(whole);
    owords = owords || is_oword(line);
    const auto first = line.empty() ? 0U : static_cast<unsigned char>(capital(line[0]));
    if (first < 128) {
      const std::vector<Wanted>& marks = by_first()[first];
      const uint64_t characters = marks.empty() ? 0 : all_characters(line);
      for (const auto& [mark, wanted] : marks) {
        if ((wanted & ~characters) == 0 && fits(line, mark->pattern) &&
            std::ranges::find(seen, mark, &Seen::mark) == seen.end()) {
          const auto from = static_cast<uint64_t>(line.data() - head.data());
          const size_t blanks = line.size() - std::min(line.find_last_not_of(" \t\r") + 1, line.size());
          seen.push_back({mark, {from, from + line.size() - blanks}});
        }
      }
    }
    at = end + 1;
  }
  for (const Seen& s : seen) {
    const std::string_view controller = s.mark->controller;
    if (owords && !has_owords(controller)) continue;
    const bool named = s.mark->proof == Proof::kIfNamed && mentions(head, controller) && !mentions(head, "LinuxCNC");
    if (!enough(seen, controller, named, nature)) continue;
    nature->kind = Nature::kOtherController;
    nature->controller = controller;
    return;
  }
}

}  // namespace owlint
