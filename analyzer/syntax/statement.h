// A statement is one line that matters to O-words: an O-word, M98/M99, the program end, `%`, a line that sets or reads
// parameters, `(abort, …)`, or a line that is an error. Some statements are no line of their own: a question to the flow about a
// line, in front of that line's own statement if it has one (questions.h), a remapped code, or the end of a file. Plain motion
// lines have no statement. What those between two statements do is kept with the first of the two: ModeChange, ModeNeed,
// PlaceChange.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analyzer/syntax/codes.h"
#include "analyzer/syntax/expression.h"
#include "analyzer/syntax/extents.h"
#include "analyzer/syntax/keyword.h"
#include "analyzer/syntax/limit_checks.h"
#include "analyzer/syntax/modes.h"
#include "analyzer/syntax/names.h"
#include "analyzer/syntax/place.h"
#include "analyzer/syntax/plain_words.h"
#include "analyzer/syntax/stop.h"
#include "analyzer/text/source.h"

namespace owlint {

enum class LineKind : uint8_t {
  kOWord,
  kM98,           // Fanuc-style call, as the line's first word
  kM99,           // Fanuc-style return, as the line's first word
  kM99Behind,     // M99 behind other words: no return, but in the main program an end
  kProgramEnd,    // M2 or M30, with whatever else is on the line
  kAbort,         // a comment `(abort, …)`: stops the program on purpose, before anything else on the line (measured)
  kPercent,       // `%` alone on its line
  kContour,       // G70, G71 or G72 with Q: runs the sub of that number for the contour
  kWords,         // any other line that is kept
  kUserCode,      // no line of its own: a line has M100 to M199, whose number is `first`, and whose word is the keyword
  kMachineCheck,  // no line of its own: only some machines stop at the line with the error, or some values do
  kModeLine,      // no line of its own: the words of a line, for what they need of the modes, and do to them
  kRemap,  // no line of its own: a line has a code that the INI remaps, and runs its sub if that has a label; a kModeLine follows
  kFileEnd,  // no line: where one file ends in a program joined from several
};

/// Bytes from the beginning of a line. A line that LinuxCNC reads has at most 253; longer lines have no parts.
using LineByte = uint8_t;

/// One value on a line of words, in reading order: a word's value (`X[#1]`) or an assignment (`#<a>=3`).
struct Item {
  ExprId value = kNoExpr;
  ExprId target = kNoExpr;       ///< assignment to a numbered parameter: the number
  NameId target_name = kNoName;  ///< assignment to a named one
  LineByte from = 0;
  LineByte to = 0;
  char letter = 0;  ///< of a word, small
};

/// A reading error: the interpreter's message, and the bytes that it is about.
struct LineError {
  StopKind kind = StopKind::kNone;
  Span span;
  std::string message;
  /// Another word that it is about, such as the first of two codes of one group; empty if there is none.
  Span other;
  /// Of a second P or Q: the value of the first, if it is computed. Where that is -1 or less, the second one is the first.
  ExprId first_value = kNoExpr;
  /// What the interpreter has read of the unfinished word or setting before the error, in this order: it computes while it reads,
  /// so a name that is not there or a division by 0 among these is what it reports.
  ExprId read_from = 0, read_to = 0;
  /// The modes that decide it, if it is refused in what is in effect.
  ModeMask decided_by = 0;
};

inline constexpr uint32_t kNoError = UINT32_MAX;

/// A word of a line that the modes decide about.
struct ModeWord {
  double value = 0;           ///< if it is known
  ExprId computed = kNoExpr;  ///< what the value is computed by, if it reads parameters
  char letter = 0;            ///< small
  LineByte from = 0, to = 0;
  bool known = true;  ///< false if it is computed
};

using StatementId = uint32_t;
inline constexpr StatementId kNoStatement = UINT32_MAX;

/// What the lines behind a statement, up to the next one, set a mode to.
struct ModeChange {
  static constexpr uint8_t kAny = UINT8_MAX;  ///< it is not known which value

  StatementId after = 0;  ///< the statement
  uint32_t line = 0;      ///< the line that sets it, from 1
  Mode mode{};
  uint8_t value = kAny;
  double number = ModeSets::kAnyNumber;  ///< of a feed or a speed, if it is known
  bool moves = false;                    ///< the lines move, and not at the rapid rate alone
};

/// How far lines behind a statement, before the next one, go: straight lines and arcs with nothing but their ends.
struct PlaceChange {
  StatementId after = 0;                    ///< the statement
  bool alone = false;                       ///< by a motion that the lines do not say, if it is one of G0 to G3
  bool lost = false;                        ///< the machine is somewhere
  uint8_t distance = ModeChange::kAny;      ///< what the distance mode is, if the lines say it
  uint8_t diameter = ModeChange::kAny;      ///< the same of the diameter mode
  uint8_t units = ModeChange::kAny;         ///< of the units
  uint8_t system = ModeChange::kAny;        ///< of the coordinate system
  uint8_t compensation = ModeChange::kAny;  ///< and of cutter compensation
  uint16_t axes = 0;                        ///< that move, by Axis
  std::array<double, kAxisCount> last{};    ///< of each the last word: where it is in G90
  std::array<double, kAxisCount> sum{};     ///< of all words: how far it has gone in G91
  std::shared_ptr<PlainReaches> reaches;    ///< where it has been on the way, if that is asked for
};

/// A mode that is set, and set again before any line depends on it.
struct UnusedChange {
  ModeChange first;
  uint32_t line = 0;  ///< the second one
  uint8_t value = 0;
};

/// A curve of G5.2 that is not ended with G5.3: LinuxCNC drops it without a message.
struct DroppedCurve {
  StatementId after = kNoStatement;  ///< the last statement before the curve; none if it is before all of them
  uint32_t line = 0;                 ///< the first line of the curve
  uint32_t dropped = 0;              ///< the line that moves otherwise, or ends the program
};

/// The first line behind a statement, before the next one, that means something else in another mode, where the lines between
/// have not set the mode.
struct ModeNeed {
  StatementId after = 0;  ///< the statement
  uint32_t line = 0;      ///< from 1; of lines that were not read one by one the first, which may come before it
  Mode mode{};
};

/// Kept small (48 bytes): a program of nothing but O-words is as fast as memory is.
struct Statement {
  uint64_t offset = 0;  ///< where the line begins
  uint32_t length = 0;  ///< in bytes, line feed excluded; 2^32 - 1 for longer ones
  uint32_t line = 0;    ///< from 1

  NameId label = kNoName;       ///< the label, normalised (`o0100.0` is "100"); kNoName when it must be computed
  ExprId label_expr = kNoExpr;  ///< a computed label (also the P of M98, the Q of G71)
  /// The first part of the line, as an index into
  ///   Syntax::items       if has_items()
  ///   Syntax::mode_words  of kModeLine and kRemap
  ///   Syntax::errors      of kMachineCheck
  ///   Syntax::values      of all others: condition, arguments, returned value; of M98, L if it has one, then what else is
  ///                       computed on the line
  /// Of kUserCode, the code's number.
  uint32_t first = 0;
  uint32_t error = kNoError;      ///< into Syntax::errors; raised after the values before it
  uint32_t first_plain_line = 0;  ///< the first of the lines meant by plain_code_follows

  LineKind kind = LineKind::kWords;
  Keyword keyword = Keyword::kUnknown;  ///< of kOWord; of kWords only where the label before it was forgotten

  bool block_delete : 1 = false;        ///< `/` first on the line
  bool comment : 1 = false;             ///< the line has a comment
  bool inner_cr : 1 = false;            ///< a carriage return within the line
  bool nul : 1 = false;                 ///< a NUL byte hides the rest of the line
  bool name_open : 1 = false;           ///< `o<name` without `>`
  bool named : 1 = false;               ///< the label is written in `< >`
  bool has_bracket : 1 = false;         ///< `[` follows the keyword
  bool refused : 1 = false;             ///< because of something before the O-word, the line is an error
  bool repeats : 1 = false;             ///< M98 with an L, its first value
  bool plain_code_follows : 1 = false;  ///< lines of code without a statement come before the next statement
  bool changes_modes : 1 = false;       ///< lines without a statement, before the next one, change modes
  bool needs_modes : 1 = false;         ///< or depend on them
  bool changes_place : 1 = false;       ///< or go somewhere
  bool asks_inputs : 1 = false;         ///< or ask the machine's inputs: G38.2 to G38.5, M66
  bool for_place : 1 = false;           ///< a kModeLine that only its numbers ask for

  // Equal if there is no such part.
  LineByte label_from = 0, label_to = 0;      ///< with the `o`
  LineByte keyword_from = 0, keyword_to = 0;  ///< the keyword, or the unknown word
  LineByte rest_from = 0, rest_to = 0;  ///< text left over after the O-word or M99; on an M98 line, all its other words
  uint8_t value_count = 0;              ///< of values from `first` on
  uint8_t item_count = 0;               ///< of items from `first` on

  bool has_error() const { return error != kNoError; }
  bool is(Keyword k) const { return kind == LineKind::kOWord && keyword == k; }
  bool opens_sub() const { return is(Keyword::kSub) || is(Keyword::kBare); }
  bool has_m99() const { return kind == LineKind::kM99 || kind == LineKind::kM99Behind; }
  bool has_items() const {
    return kind == LineKind::kWords || kind == LineKind::kContour || kind == LineKind::kProgramEnd || has_m99();
  }
  /// Whether the line runs a sub that it names.
  bool calls() const { return is(Keyword::kCall) || kind == LineKind::kM98 || kind == LineKind::kContour; }
  /// Whether it runs one because the machine's INI remaps a code of it.
  bool runs_remap() const { return kind == LineKind::kRemap && label != kNoName; }
  uint64_t end() const { return offset + length; }
  Span whole() const { return {offset, end()}; }
  Span span(LineByte from, LineByte to) const { return {offset + from, offset + to}; }
  Span label_span() const { return span(label_from, label_to); }
  Span keyword_span() const { return span(keyword_from, keyword_to); }
  /// Label and keyword: what a finding about the whole O-word underlines.
  Span head_span() const { return span(label_from, keyword_to > label_to ? keyword_to : label_to); }
  Span rest_span() const { return span(rest_from, rest_to); }
};
static_assert(sizeof(Statement) == 48);

/// A comment for owlint: `(owlint: ignore OW301 -- reason)`.
struct Directive {
  uint32_t line = 0;
  Span span;              ///< the words after `owlint:`
  bool own_line = false;  ///< nothing else is on the line
  bool on_oword = false;
};

/// Everything read from one file.
struct Syntax {
  std::vector<Statement> statements;  ///< in file order
  std::vector<ExprId> values;
  std::vector<Item> items;
  std::vector<LineError> errors;
  std::vector<ModeWord> mode_words;
  std::vector<ModeChange> mode_changes;  ///< in the order of statements
  std::vector<ModeNeed> mode_needs;      ///< the same
  std::vector<UnusedChange> unused_changes;
  std::vector<DroppedCurve> dropped_curves;  ///< in the order of the file, as far as lines without O-words show them
  std::vector<PlaceChange> place_changes;    ///< in the order of statements
  /// The first statement from where runs may go elsewhere than to the next line, and where the machine is there.
  StatementId left_at = kNoStatement;
  Place place_at_start;
  std::vector<LimitFault> limit_faults;    ///< of lines up to that one
  std::shared_ptr<const Extents> extents;  ///< the same, if that is asked for
  bool writes_tools = false;               ///< lines write numbers of the tool table
  bool reads_place = false;                ///< some line reads where the machine stands, or which tool it has
  bool asks_place = false;                 ///< some kModeLine may stop for where the machine is
  std::vector<ModeNeed> first_needs;       ///< of plain lines before the first statement
  std::vector<ModeChange> first_changes;   ///< by plain lines before the first statement
  std::vector<uint32_t> input_lines;       ///< lines that ask the machine's inputs: G38.2 to G38.5, M66
  std::vector<Directive> directives;
  std::vector<uint64_t>
      command_lines;  ///< offsets of lines with a comment that begins like a command (comment_command.h)
  /// Offsets of lines with a `P` and a whole number of three digits or more, without a point: a time of minutes, perhaps.
  std::vector<uint64_t> whole_p_lines;
  std::vector<uint64_t>
      owlint_lines;                   ///< offsets of lines with the word `owlint`, in small letters, first in a comment
  std::vector<uint64_t> angle_lines;  ///< offsets of lines with `^`, in a comment perhaps
  std::vector<Span> split_numbers;    ///< `1 2` in a value, which is read as 12
  ExprPool exprs;
  Names names;
  uint32_t lines = 0;             ///< number of lines in the file
  uint32_t last_code = 0;         ///< the last line that is neither blank nor comment; 0 if there is none
  uint32_t first_plain_line = 0;  ///< the first code line before the first statement, 0 if none
  bool percent = false;           ///< the file begins with `%`: another `%` ends it
  bool deletes_lines = false;     ///< a statement has block delete, `/` first on its line
  bool runs_python = false;       ///< a comment is Python code (`;py,` or `(py,`), which may set any global parameter
  bool blank = false;             ///< nothing but blank lines: LinuxCNC refuses to open it
  bool lacks_sums = false;        ///< some PlaceChange has no `sum`, although the lines do not say the distance mode
  bool may_set_g91 = false;       ///< a line does, or has a code that is not known
  bool unusual = false;           ///< what Expected::kUsual takes for granted is not so: read the file again

  const LineError* error(const Statement& s) const { return s.has_error() ? &errors[s.error] : nullptr; }
  std::span<const ExprId> values_of(const Statement& s) const {
    return s.value_count == 0 ? std::span<const ExprId>() : std::span(values).subspan(s.first, s.value_count);
  }
  std::span<const Item> items_of(const Statement& s) const {
    return s.item_count == 0 || !s.has_items() ? std::span<const Item>()
                                               : std::span(items).subspan(s.first, s.item_count);
  }
  /// Of a kModeLine or kRemap.
  std::span<const ModeWord> words_of(const Statement& s) const {
    return std::span(mode_words).subspan(s.first, s.item_count);
  }
  /// What the lines behind a statement do to the modes, and need of them.
  std::span<const ModeChange> changes_after(StatementId id) const;
  std::span<const ModeNeed> needs_after(StatementId id) const;
  std::span<const PlaceChange> places_after(StatementId id) const;
};

/// What is taken for granted. A large program is read as usual ones are first, which is much less work.
enum class Expected : uint8_t {
  kAnything,  ///< nothing
  kNoG91,     ///< where the lines do not say the distance mode, it is G90: a PlaceChange then needs no `sum`
  kUsual  ///< modes that few programs leave are as at the start (kUsualModes), and behind the first O-word nobody asks where
          ///< the machine stands: plain lines run there, and no PlaceChange is needed
};

/// Reads a whole file as a program for this machine. Any bytes are accepted; nothing is reported here, only recorded.
Syntax scan(const Source& source, const MachineWords& machine = {}, Expected expected = Expected::kAnything);

}  // namespace owlint
