// Codes that LinuxCNC does not have: what they do on other controllers, and codes that are typed nearly the same.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "rules/driver/words.h"

namespace owlint::rules {
namespace {

/// Codes from `first` to `last` of another controller.
struct OtherCode {
  char letter;
  int first, last;        ///< G codes in tenths
  std::string_view what;  ///< empty: each controller has something else
  std::string_view instead;
};

constexpr std::string_view kOutput =
    "switch an output of the machine with `M64 P0` and `M65 P0`, or write a program M100";
constexpr std::string_view kOwn = "functions of the machine's own are programs M100 to M199";
constexpr std::string_view kMacro = "call a sub: `o<name> call [1] [2]`";
constexpr std::string_view kMeasure = "probe with `G38.2`, and set the offset with `G10 L1` or `G43.1`";
constexpr std::string_view kPolar = "write a polar position as `@` (distance) and `^` (angle) in a move: `G1 @10 ^45`";
constexpr std::string_view kRemove = "remove it";
constexpr std::string_view kRotary = "let the CAM program write the moves of the machine's axes";
constexpr std::string_view kPocket = "write the circles with `G2` or `G3`, or call a sub that does";
constexpr std::string_view kScale = "LinuxCNC cannot scale: multiply the positions, or scale in the CAM program";
constexpr std::string_view kTap = "`G33.1` with `K` taps with the spindle synchronized";

constexpr std::array kOtherCodes = std::to_array<OtherCode>({
    {'g', 90, 99, "is an exact stop at the end of its line on Fanuc",
     "write `G61.1` before the move, and `G64` after it"},
    {'g', 71, 71, "begins cylindrical interpolation on Fanuc", kRotary},
    {'g', 110, 119, "ends data input on Fanuc", "remove it: `G10` counts for its own line only"},
    {'g', 101, 109, "is data input on Fanuc", "set offsets with `G10`"},
    {'g', 121, 121, "begins polar interpolation on Fanuc", kRotary},
    {'g', 131, 131, "ends polar interpolation on Fanuc", kRemove},
    {'g', 120, 139, "mills a circular pocket on Haas", kPocket},
    {'g', 150, 159, "ends polar positions on Fanuc", "remove it: `@` and `^` count for their own line only"},
    {'g', 160, 169, "begins polar positions on Fanuc", kPolar},
    {'g', 230, 239, "switches a limit of travel off on Fanuc", "remove it: the limits are in the machine's INI"},
    {'g', 250, 259, "ends the watch over the spindle's speed on Fanuc", kRemove},
    {'g', 260, 269, "watches over the spindle's speed on Fanuc", kRemove},
    {'g', 220, 229, "is a limit of travel on Fanuc", "the limits are in the machine's INI"},
    {'g', 270, 279, "checks the reference position on Fanuc", "`G28` moves to the stored position"},
    {'g', 282, 289, "homes the machine on other controllers",
     "home the machine on its screen; `G28.1` stores a position"},
    {'g', 290, 299, "returns from the reference position on Fanuc", "write the move with `G0`"},
    {'g', 310, 319, "is a move that a probe ends, on Fanuc", "probe with `G38.2`"},
    {'g', 320, 329, "is a thread on Fanuc", "`G33` with `K` cuts one pass, `G76` all of them"},
    {'g', 340, 349, "is a thread of variable lead on Fanuc", "LinuxCNC has threads of constant lead: `G33`"},
    {'g', 360, 379, "measures the tool on Fanuc", kMeasure},
    {'g', 401, 401, "cancels the turning of the tool along the path on Fanuc", kRemove},
    {'g', 434, 435, "is a tool length for five axes on Fanuc", kRotary},
    {'g', 440, 449, "is a negative tool length offset on Fanuc", "write `G43`, with the length in the tool table"},
    {'g', 450, 489, "is a tool offset for one line on Fanuc",
     "compensate with `G41` or `G42`, or add the radius to the move"},
    {'g', 500, 500, "cancels scaling on Fanuc", kRemove},
    {'g', 501, 501, "cancels mirroring on Fanuc", kRemove},
    {'g', 511, 511, "mirrors on Fanuc", "LinuxCNC cannot mirror: change the signs, or mirror in the CAM program"},
    {'g', 502, 519, "scales on Fanuc", kScale},
    {'g', 531, 531, "turns the tool to a tilted plane on Fanuc", kRotary},
    {'g', 541, 549, "is a further coordinate system on Fanuc", kNineSystems},
    {'g', 600, 609, "positions from one side on Fanuc", "`G61` follows the exact path"},
    {'g', 620, 639, "is a feed mode on Fanuc", "`G61` follows the exact path, `G64` rounds corners"},
    {'g', 670, 679, "ends the calls of a macro on Fanuc", "remove it: a call counts for its own line only"},
    {'g', 650, 669, "calls a macro on Fanuc", kMacro},
    {'g', 682, 684, "tilts the plane of work on Fanuc", kRotary},
    {'g', 690, 699, "cancels a rotation on Fanuc",
     "remove it; a rotation with `G10 L2 P0 R30` ends with `G10 L2 P0 R0`"},
    {'g', 680, 689, "rotates the coordinate system on Fanuc", "rotate with `G10 L2 P0 R30`, and back with `R0`"},
    {'g', 750, 759, "is a grooving cycle on Fanuc", "write the moves, or call a sub"},
    {'g', 770, 799, "is a turning cycle on Fanuc", "write the moves, or use `G71` or `G76`"},
    {'g', 841, 849, "taps on other controllers", kTap},
    {'g', 1030, 1039, "limits look-ahead on Haas",
     "remove it: LinuxCNC always looks ahead; `G64 P0.01` lets it round corners within a tolerance"},
    {'g', 1070, 1079, "maps a move to a cylinder on Haas", "let the CAM program write the moves of the rotary axis"},
    {'g', 1100, 1119, "is a coordinate system on Haas", kNineSystems},
    {'g', 1120, 1139, "is a coordinate system on Haas mills, and polar interpolation on lathes", kNineSystems},
    {'g', 1140, 1299, "is a coordinate system on Haas", kNineSystems},
    {'g', 1430, 1439, "is a tool length for five axes on Haas", kRotary},
    {'g', 1500, 1509, "is a pocket cycle on Haas", "call a sub that mills the pocket"},
    {'g', 1540, 1549, "is a coordinate system on Haas", kNineSystems},
    {'g', 2340, 2349, "is a tool length for five axes on Haas", kRotary},
    {'g', 1870, 1879, "sets the accuracy of the path on Haas", "`G64 P0.01` rounds corners within a tolerance"},
    {'m', 10, 11, "clamps an axis on other controllers", kOutput},
    {'m', 12, 12, "", kOwn},
    {'m', 13, 13, "turns the spindle clockwise, with coolant, on other controllers", "write `M3 M8`"},
    {'m', 14, 14, "turns the spindle counterclockwise, with coolant, on other controllers", "write `M4 M8`"},
    {'m', 17, 17, "ends a sub on Siemens",
     "write `o<name> endsub`, or `M99` for a sub that begins with O and a number"},
    {'m', 18, 18, "switches the motors off on other controllers", "switch the machine off on its screen"},
    {'m', 20, 28, "", kOwn},
    {'m', 29, 29, "is rigid tapping on Fanuc", kTap},
    {'m', 31, 37, "", kOwn},
    {'m', 47, 47, "jumps to the first line on Mach3",
     "repeat with `o100 while [1]` … `o100 endwhile`, or press start again"},
    {'m', 40, 44, "selects a gear of the spindle on other controllers", kOutput},
    {'m', 82, 83, "sets the extruder's mode on 3D printers", "remove it"},
    {'m', 84, 84, "switches the motors off on 3D printers", "remove it, or switch the machine off on its screen"},
    {'m', 88, 89, "switches coolant through the spindle on Haas", "`M7` and `M8` switch coolant on, `M9` off"},
    {'m', 97, 97, "calls a sub in the same program on Haas", "call a sub: `o<name> call`, or `M98` with its number"},
});

std::string text_of(char letter, int number) { return (letter == 'g' ? g_name(number) : m_name(number)).substr(1); }

/// Codes that make the machine go elsewhere, or forget a stored place: nobody shall try one in the place of another code.
bool goes_elsewhere(char letter, int number) {
  constexpr int kG28 = 280, kG28_1 = 281, kG30 = 300, kG30_1 = 301, kM6 = 6;
  if (letter == 'm') return number == kM6;
  return number == kG28 || number == kG28_1 || number == kG30 || number == kG30_1;
}

/// Codes that end the program, or switch the spindle or the coolant: not to be named for one that has a digit more or less.
bool has_consequences(char letter, std::string_view digits) {
  constexpr std::string_view kCodes[] = {"2", "3", "4", "7", "8", "19", "30", "60"};
  return letter == 'm' && std::ranges::find(kCodes, digits) != std::end(kCodes);
}

/// Whether it is a code that may be named in the place of another one.
bool exists(char letter, std::string_view digits, Release release) {
  if (digits.empty() || digits.front() == '.' || digits.back() == '.') return false;
  if (digits.size() > 1 && (digits.front() == '0' || digits.ends_with(".0"))) return false;
  const auto whole = digits.substr(0, digits.find('.'));
  int number = 0;
  for (const char c : whole) number = number * 10 + (c - '0');
  if (letter == 'm')
    return digits.find('.') == std::string_view::npos && number < code::kM100 && m_code(number) != nullptr &&
        !goes_elsewhere(letter, number);
  number *= 10;
  if (whole.size() < digits.size()) {
    if (digits.size() - whole.size() != 2) return false;
    number += digits.back() - '0';
  }
  return g_code(number, release) != nullptr && !goes_elsewhere(letter, number);
}

/// For a code whose decimals are missing, `G38`: those that there are. Empty for others.
std::string with_decimals(int tenths, Release release) {
  constexpr int kTenths = 10;
  if (tenths % kTenths != 0) return {};
  std::vector<std::string> names;
  for (int number = tenths + 1; number < tenths + kTenths; ++number) {
    if (g_code(number, release) != nullptr) names.push_back("`" + g_name(number) + "`");
  }
  if (names.empty()) return {};
  const std::string_view between = names.size() > 2 ? " to " : " or ";
  return "write " + names.front() + (names.size() > 1 ? std::string(between) + names.back() : "") + ": LinuxCNC has `" +
      g_name(tenths) + "` only with a decimal";
}

constexpr int kFirstOfOthers = 1000;  // G100, in tenths

/// Whether a code with a decimal belongs to one that LinuxCNC has without any: `G80.1` is another controller's.
bool has_decimal_of_others(int tenths, Release release) {
  constexpr int kTenths = 10;
  const int whole = tenths - tenths % kTenths;
  if (tenths == whole || g_code(whole, release) == nullptr) return false;
  for (int number = whole + 1; number < whole + kTenths; ++number) {
    if (g_code(number, release) != nullptr) return false;
  }
  return true;
}

/// Codes that differ by one slip of the fingers, the likeliest kind of slip first.
std::vector<std::string> near_codes(char letter, const std::string& digits, Release release) {
  std::vector<std::string> kinds[3];
  const auto add = [&](size_t kind, const std::string& other) {
    if (exists(letter, other, release) && std::ranges::find(kinds[kind], other) == kinds[kind].end())
      kinds[kind].push_back(other);
  };
  for (size_t i = 0; i < digits.size(); ++i) {
    if (digits[i] == '.') continue;
    // A key pressed twice, a neighbouring key, a key too many.
    const std::string without = digits.substr(0, i) + digits.substr(i + 1);
    if (i > 0 && digits[i] == digits[i - 1]) add(0, without);
    for (const int step : {-1, 1}) {
      std::string other = digits;
      other[i] = static_cast<char>(other[i] + step);
      if (other[i] >= '0' && other[i] <= '9') add(1, other);
    }
    if (!has_consequences(letter, without)) add(2, without);
  }
  for (const std::vector<std::string>& kind : kinds) {
    if (!kind.empty() && kind.size() <= 2) return kind;
  }
  return {};
}

}  // namespace

CodeAdvice advice_for_code(char letter, int number, Release release) {
  const auto* other = std::ranges::find_if(kOtherCodes, [&](const OtherCode& code) {
    return code.letter == letter && number >= code.first && number <= code.last;
  });
  const GCode* later = letter == 'g' ? g_code(number, Release::k2_10) : nullptr;
  if (later != nullptr && release < later->since) {
    return {"is a code of LinuxCNC 2.10 and later", "use `G5`, `G5.1` or `G5.2`, or check for 2.10: `--linuxcnc 2.10`"};
  }
  if (other != kOtherCodes.end() && !other->what.empty())
    return {std::string(other->what), std::string(other->instead)};
  CodeAdvice advice;
  // Others have their own functions there, and a guess must not start the spindle.
  const bool guesses =
      letter == 'g' ? number < kFirstOfOthers && !has_decimal_of_others(number, release) : number >= code::kM100;
  if (letter == 'g') advice.help = with_decimals(number, release);
  if (!advice.help.empty()) return advice;
  const std::vector<std::string> near_ones =
      guesses ? near_codes(letter, text_of(letter, number), release) : std::vector<std::string>();
  for (const std::string& near : near_ones) {
    advice.help +=
        fmt::format("{}`{}{}`", advice.help.empty() ? "did you mean " : " or ", letter == 'g' ? 'G' : 'M', near);
  }
  if (!advice.help.empty()) advice.help += "?";
  if (letter == 'm' && !guesses)
    advice.help = kOwn;
  else if (other != kOtherCodes.end())
    advice.help += (advice.help.empty() ? "" : " ") + std::string(other->instead);
  return advice;
}

bool tell_split_code(const Source& source, const WordStop& at, Finding& f) {
  std::string_view written = source.slice(at.span);
  if (written.size() < 2 || !at.value) return false;
  written.remove_prefix(std::min(written.find_first_not_of(" \t", 1), written.size()));
  const size_t blank = written.find_first_of(" \t");
  const size_t second = blank == std::string_view::npos ? blank : written.find_first_not_of(" \t", blank);
  if (second == std::string_view::npos || written.find_first_not_of("0123456789. \t") != std::string_view::npos)
    return false;
  f.message = fmt::format("`{} {}` is read as `{}`: LinuxCNC removes spaces, also inside numbers",
                          capital(at.letter) + std::string(written.substr(0, blank)), written.substr(second), at.word);
  f.help = fmt::format("write the letter that is missing before `{}`", written.substr(second));
  return true;
}

}  // namespace owlint::rules
