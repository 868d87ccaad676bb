// The table of codes and words (codes.def), in a form to look things up in. Words of a line are checked by it in
// word_line.h; documentation, hover and completion iterate over its rows.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace owlint {

/// Releases of LinuxCNC that read words differently. The first is 2.8 and all before the released 2.9.0 (`rs274` of
/// Debian 12, 2.9.0~pre1, is one of them).
enum class Release : uint8_t { k2_8, k2_9, k2_9_9, k2_10 };
inline constexpr size_t kReleases = 4;

/// Modal groups, by LinuxCNC's numbers.
enum class GGroup : uint8_t {
  kNonModal = 0,
  kMotion = 1,
  kPlane = 2,
  kDistance = 3,
  kArcDistance = 4,
  kFeedMode = 5,
  kUnits = 6,
  kCutterCompensation = 7,
  kToolLength = 8,
  kRetract = 10,
  kCoordinateSystem = 12,
  kPathControl = 13,
  kSpindleMode = 14,
  kDiameter = 15,
  kOffsets = 16,
};
inline constexpr size_t kGGroups = 17;

enum class MGroup : uint8_t {
  kStop = 4,
  kInputsOutputs = 5,
  kToolChange = 6,
  kSpindle = 7,
  kCoolant = 8,
  kOverrides = 9,
  kUser = 10,
  kCall = 11,  ///< M98, which is no code on a line of words
};
inline constexpr size_t kMGroups = 11;  ///< without kCall

/// What moves by words alone: the code of the line, or the mode that an earlier line has left.
enum class Motion : uint8_t {
#define MOTION(name, tenths, since, axes, leaves, title) name,
#include "analyzer/syntax/codes.def"
  kRemapped,  ///< a G code that the machine's INI defines
  kNone,      ///< no motion; not the same as G80
};

/// Motions as the bits of a number.
using MotionSet = uint64_t;
constexpr MotionSet set_of(Motion motion) { return MotionSet{1} << static_cast<int>(motion); }
constexpr bool contains(MotionSet set, Motion motion) { return (set & set_of(motion)) != 0; }
inline constexpr MotionSet kStraightMotions = set_of(Motion::kG0) | set_of(Motion::kG1);
inline constexpr MotionSet kArcMotions = set_of(Motion::kG2) | set_of(Motion::kG3);
inline constexpr MotionSet kPlainMotions = kStraightMotions | kArcMotions;
inline constexpr MotionSet kAnyMotion = (set_of(Motion::kNone) << 1) - 1;

/// Numbers of codes by name: `code::kG5_1` is 51, as G codes are counted in tenths, `code::kM3` is 3.
namespace code {
enum : int16_t {
#define MOTION(name, tenths, since, axes, leaves, title) name = (tenths),
#define G_CODE(name, tenths, group, since, title) name = (tenths),
#define M_CODE(name, number, group, title) name = (number),
#include "analyzer/syntax/codes.def"
};
}  // namespace code

struct GCode {
  enum Axes : uint8_t { kFree, kNeeded };             ///< of a motion: whether it stops without an axis or polar word
  enum Leaves : uint8_t { kItself, kEarlier, kAny };  ///< of a motion: the mode behind its line

  int16_t tenths;
  GGroup group;
  Release since;
  Motion motion;  ///< kNone for codes of other groups
  Axes axes;
  Leaves leaves;
  std::string_view title;
};

struct MCode {
  int16_t number;
  MGroup group;
  std::string_view title;
};

enum class NumberKind : uint8_t {
  kReal,
  kInteger,    ///< within a ten-thousandth
  kTruncated,  ///< cut towards zero
  kTenths,     ///< of a G code
};

struct WordRow {
  enum Repeated : uint8_t { kStops, kRuns, kAboveMinusOne };  ///< what a second one on the line does

  char letter;  ///< small
  NumberKind number;
  double least;       ///< smaller ones stop with `below`; minus infinity if all are good
  const char* below;  ///< or null
  Repeated repeated;
  std::string_view name;  ///< in `Multiple … words on one line`
  std::string_view title;
};

/// The motions that can be in effect before a line: those that leave themselves, and none.
MotionSet all_modes();

/// Null if the release has no such code. M100 to M199 have one row.
const GCode* g_code(int tenths, Release release);
const MCode* m_code(int number);
/// Null if the letter, a small one, begins no word. Axis letters are those of all machines.
const WordRow* word_row(char letter);

/// All rows, in the table's order; G codes also those that older releases lack.
std::span<const GCode> g_codes();
std::span<const MCode> m_codes();
std::span<const WordRow> word_rows();

/// `G5.1`, `M3`.
std::string g_name(int tenths);
std::string m_name(int number);
/// The same of a motion's code; what a reader understands for the two that have none.
std::string motion_name(Motion motion);

/// Some codes and words; see codes.def about what that means for a line.
struct CodeSet {
  MotionSet motions = 0;
  uint64_t g = 0;  ///< other G codes, by their row
  uint64_t m = 0;  ///< M codes, by their row
  uint32_t words = 0;

  constexpr CodeSet operator|(const CodeSet& other) const {
    return {motions | other.motions, g | other.g, m | other.m, words | other.words};
  }
  constexpr bool meets(const CodeSet& other) const {
    return (motions & other.motions) != 0 || (g & other.g) != 0 || (m & other.m) != 0 || (words & other.words) != 0;
  }
  constexpr bool empty() const { return motions == 0 && g == 0 && m == 0 && words == 0; }
};

/// The sets of one code: what it adds to those of its line.
CodeSet set_of(const GCode& code);
CodeSet set_of(const MCode& code);

/// Letters as the bits of a number: a to z, and the three signs that begin a word.
inline constexpr int kLetters = 29;
constexpr int letter_index(char letter) {
  return letter == '@' ? 26 : letter == '^' ? 27 : letter == '$' ? 28 : letter - 'a';
}
constexpr uint32_t letter_set(std::string_view letters) {
  uint32_t set = 0;
  for (const char letter : letters) set |= 1U << letter_index(letter);
  return set;
}
/// Calls `apply` with the index of each letter.
template <typename Do>
void for_letters(uint32_t letters, const Do& apply) {
  for (; letters != 0; letters &= letters - 1) apply(static_cast<size_t>(std::countr_zero(letters)));
}
inline constexpr uint32_t kAxisLetters = letter_set("xyzabcuvw");
inline constexpr uint32_t kPolarLetters = letter_set("@^");
/// Of words that say where a line goes: no mode depends on their values.
inline constexpr uint32_t kPlaceLetters = kAxisLetters | kPolarLetters;

/// What the machine adds to the table of codes, or lacks; the defaults are those of `rs274` without an INI.
struct RemappedCode {
  char letter;     ///< `g`, `m`, `t`, `s` or `f`
  int16_t number;  ///< of a G code in tenths; 0 of T, S and F, which are remapped with any number
  MGroup group;    ///< of an M code, kStop to kUser; a G code is always a motion
  // What it runs, as the INI has it; the INI must outlive these.
  std::string_view name = {};     ///< the code
  std::string_view sub = {};      ///< the name of the sub's file, with a path if there is one; empty: Python alone
  std::string_view argspec = {};  ///< the words that the sub gets
  bool python_before = false;     ///< Python runs, of which nothing is known: before the sub, and behind it
  bool python_behind = false;
};
/// A built-in code, or an M code above 999, that LinuxCNC cannot remap: a REMAP line puts it into another group, where nothing is
/// called for it, and its own meaning is gone (measured).
struct LostCode {
  char letter;     ///< `g` or `m`
  int32_t number;  ///< of a G code in tenths
  MGroup group;    ///< of an M code: in kStop and kUser it stops the program, in others it does nothing
};
/// What a row of the tool table says that decides whether a line runs.
struct Tool {
  int32_t number;
  double diameter;
  int32_t orientation;
  bool has_offset;
  std::array<double, 9> offset{};  ///< X Y Z A B C U V W, in machine units
};
/// How far an axis of the machine goes, in its units.
struct AxisLimits {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();

  bool operator==(const AxisLimits&) const = default;
};
struct ModeState;
/// What this room must know of the machine. WordsOfMachine fills it in (program/machine_words.h), since this room may not use
/// `analyzer/machine/`.
struct MachineWords {
  Release release = Release::k2_8;
  uint32_t axes = letter_set("xyzabc");
  std::span<const RemappedCode> remapped;
  std::span<const LostCode> lost;
  bool unsure = false;  ///< the machine is not known: it may have other axes, and codes M200 to M999 of its own
  int32_t spindles = 1;
  bool change_keeps_spindle = false;       ///< M6 does not stop the spindle
  bool change_stays = false;               ///< M6 goes nowhere
  bool retains_offset = false;             ///< RETAIN_G43: each line repeats G43 for the tool in the spindle
  double units_per_mm = 0.03937007874016;  ///< of the machine
  double arc_tolerance_mm = 0.02 * 1.4142135623730951;  ///< of arcs by their center, in G21
  double arc_tolerance_inch = 0.002 * 1.4142135623730951;
  /// The modes with which a program starts; null: those of an interpreter that was just started.
  const ModeState* start = nullptr;
  uint32_t wrapped = 0;                ///< rotary axes that count one turn
  uint32_t indexing = 0;               ///< rotary axes that are locked in place, and move alone
  std::array<AxisLimits, 9> limits{};  ///< X Y Z A B C U V W
  bool has_limits = false;             ///< some of them end somewhere
  bool measures_extents = false;       ///< it is asked how far programs go
  /// Without a table nothing is claimed of tools.
  std::optional<std::span<const Tool>> tools = std::nullopt;
  bool tools_written = false;  ///< lines write numbers of the tool table: of its tools only the numbers are known
};

/// One of the checks that a line's words pass, the last rows of codes.def.
struct LineCheck {
  enum Kind : uint8_t { kNever, kRefused, kUnused, kUnusedUnlessMinusOne, kValue, kMissing };
  enum Test : uint8_t { kWhole, kNearest, kInLimits };

  Kind kind;  ///< kNever: not in this release
  uint32_t letters;
  CodeSet codes;
  const char* message;
  CodeSet also{};
  Test test = kWhole;
  double least = 0, most = 0;
};
std::span<const LineCheck> line_checks(Release release);

/// What a line has some of if line_checks finds anything on it.
struct CheckTriggers {
  uint32_t letters;
  CodeSet codes;
};
const CheckTriggers& check_triggers(Release release);

/// The interpreter's message if a word of this letter may not have this value, else null; unknown G and M codes aside.
const char* refused_number(char letter, double value);
/// Whether there are such values.
bool refuses_numbers(char letter);
/// An integer word's number; false where it is not within a ten-thousandth of one. Numbers beyond 32 bits become the
/// smallest.
bool word_integer(double value, int32_t* result);
/// The tenths of a G word; false for what has further decimals. Not checked for its range.
bool g_tenths(double value, int32_t* result);
/// Half away from zero; beyond 32 bits the smallest.
int32_t nearest_integer(double value);

}  // namespace owlint
