// What the rules about words of a line have in common (OW7xx): the words as they are written, and how codes, groups and
// lists of codes are named.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyzer/program/machine_words.h"
#include "analyzer/syntax/codes.h"
#include "analyzer/syntax/word_reader.h"
#include "rules/driver/stops.h"

namespace owlint::rules {

/// The words of a line, in the order of the line, as far as they can be read; see WordReader.
std::vector<WrittenWord> words_of(const Source& source, Span line);

/// The error that a stop at a word is about: its place, and that of another word. Null where only the stop itself is known.
std::optional<LineError> word_error(const Program& program, const FlowStop& stop);

/// A stop at a word: what it is about, and the words around it.
struct WordStop {
  Span span;         ///< the word; where that is not known, all words of the line
  Span other;        ///< another word concerned; empty if there is none
  std::string word;  ///< as shown()
  std::string other_word;
  char letter = 0;  ///< of `word`, small; 0 if it is not one word
  std::optional<double> value;
  std::vector<WrittenWord> line;

  /// The first word with this letter; null if there is none.
  const WrittenWord* find(char letter) const;
};
WordStop word_stop(const Input& in, const FlowStop& stop);

/// A part of a line as messages show it: without blanks and comments, in capital letters but for the names of parameters.
std::string shown(const Source& source, Span span);
std::string capital(char letter);

/// Adds "`G1` is here".
void relate_word(Finding& finding, const WordStop& stop);
/// Adds "LinuxCNC stops at `X2` first" to the finding about a further mistake on the line.
void relate_first_mistake(const Input& in, const FlowStop& further, Finding& finding);
/// Takes a word away from a line. Safe where the new line surely runs and all runs stop at the old one.
Fix without_word(const Program& program, const Statement& statement, Span word, const std::string& shown);
/// The same of any edit of the line.
bool runs_with(const Program& program, const Statement& statement, const Edit& edit);

/// `G4, G10 and G64`, as one speaks; runs of codes are drawn together: `M50 to M53`. `joint`: "and", "or".
std::string spoken(const CodeSet& codes, Release release, std::string_view joint = "and");
/// What the codes of a group have to do with each other: `both say how the tool moves`.
std::string_view what_both_do(GGroup group);
std::string_view what_both_do(MGroup group);

/// What to do about a further coordinate system.
inline constexpr std::string_view kNineSystems =
    "LinuxCNC has nine coordinate systems: G54 to G59, G59.1, G59.2 and G59.3";

/// What to do about a code that LinuxCNC does not have.
struct CodeAdvice {
  std::string what;  ///< what the code does on another controller; empty if it is not known from one
  std::string help;
};
/// `letter`: `g` or `m`; G codes in tenths.
CodeAdvice advice_for_code(char letter, int number, Release release);
/// Says that a code which LinuxCNC does not have is two numbers, which a space divides: `G1 20`. False for others.
bool tell_split_code(const Source& source, const WordStop& at, Finding& finding);

/// What a refused line was meant to be whose codes LinuxCNC knows as something else: `G4 X2`, `G05.1 Q1`, a further line of a
/// spline without its `G5`. Nothing for other lines.
struct Habit {
  std::string message;
  std::string help;
};
std::optional<Habit> habit_of(const Input& in, StatementId statement);

/// Whether `^2` stands right behind a value, as a power of other languages does: `#1=#2^2`, `X[#1]^2`. LinuxCNC reads the angle
/// of a polar position. `line`: the line's words.
bool is_angle_for_power(const Source& source, Span word, const std::vector<WrittenWord>& line);

/// Whether the letter O stands for a zero where a line is refused: `X1O`, `GO X1`. Then `*at` is its byte.
bool writes_o_for_zero(const Program& program, const Statement& statement, const LineError& error, uint64_t* at);
/// Whether a small letter stands for a 1 there: `Gl X5`, `Mi`.
bool writes_letter_for_one(const Program& program, const Statement& statement, const LineError& error);

}  // namespace owlint::rules
