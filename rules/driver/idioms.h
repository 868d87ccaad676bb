// What people write who know another controller, BASIC or C. The one place for such words: asked about every error of
// reading, whichever rule reports it. What was meant goes into message and help, and a fix only where it is clear.
#pragma once

#include <optional>

#include "analyzer/syntax/line_text.h"
#include "rules/driver/stops.h"

namespace owlint::rules {

/// Puts the idiom in which a refused line is written, if it is a known one, into the finding about it: its words instead
/// of the rule's, and its fix, or none.
void explain_idiom(const Input& in, StatementId statement, Finding& finding);

/// A refused line and the place of its error, as the functions below see it. Text is in small letters and without blanks.
struct RefusedLine {
  const Program& program;
  const Input& in;
  const Statement& statement;
  StatementId id;
  const LineError& error;
  LineText text;
  size_t at = 0;   ///< where the error begins in `text`
  size_t end = 0;  ///< where the comment at the line's end begins, or the line's end

  RefusedLine(const Input& input, StatementId statement_id);

  StopKind kind() const { return error.kind; }
  /// From the error on.
  std::string_view rest() const { return text.text().substr(at, end > at ? end - at : 0); }
  std::string_view before() const { return text.text().substr(0, at); }
  std::string keyword_text() const { return std::string(spelling(statement.keyword)); }
  /// The keyword of the line, with or without a label; `while` for the WHILE of a Fanuc loop.
  bool has_keyword(Keyword keyword) const { return statement.keyword == keyword; }
  /// The letters that rest() begins with.
  std::string_view first_word() const;
  /// Whether the innermost open block with the line's label is a `do`.
  bool ends_do() const;
  /// As it is written in the file.
  std::string written(size_t from, size_t to) const;
  /// Whether a blank or a comment stands before the character.
  bool apart(size_t i) const { return i > 0 && text.offset(i) > text.offset(i - 1) + 1; }
  /// Whether another line of the program has the parameter `#<name>`; the name in small letters and without blanks.
  bool is_parameter(std::string_view name) const;
  /// Whether the program has a sub with this label.
  bool is_sub(std::string_view name) const { return program.find_sub(name) != kNoRegion; }
  Edit put(size_t from, size_t to, std::string new_text) const { return {text.span(from, to), std::move(new_text)}; }
  /// Proposes edits of the line. Safe where that is surely meant, the new line surely runs, and all runs stop at the old one.
  void propose(Finding& f, std::string title, std::vector<Edit> edits, bool surely_meant) const;
};

/// Whether the subs that a line calls are known: in the program or on the search path. A fix that writes a call of another one
/// would only lead to the next stop.
bool calls_known_subs(const Input& in, const std::string& line);

/// Operators that are words. Longer ones come before their beginnings.
inline constexpr std::string_view kWordOperators[] = {"mod", "and", "xor", "or", "eq", "ne", "gt", "ge", "lt", "le"};

inline constexpr std::string_view kFunctionNames[] = {"abs", "acos", "asin", "atan",  "cos", "exists", "exp",
                                                      "fix", "fup",  "ln",   "round", "sin", "sqrt",   "tan"};

/// Behind the closing bracket of the one at `at`; nothing if it is not closed.
std::optional<size_t> behind_bracket(std::string_view text, size_t at);
/// Behind the value that begins at `at`: `5`, `#<name>`, `[...]`, `ATAN[1]/[2]`; nothing if none does.
std::optional<size_t> behind_value(std::string_view text, size_t at);

/// One idiom: whether the line is written so, and if, words and fix for the finding.
using Idiom = bool (*)(const RefusedLine& line, Finding& finding);

// On a line as a whole (idioms_lines.cc).
bool has_braces(const RefusedLine& line, Finding& f);
bool has_comment_inside(const RefusedLine& line, Finding& f);
bool brackets_behind_keyword(const RefusedLine& line, Finding& f);
bool tests_behind_do(const RefusedLine& line, Finding& f);
bool rounds_brackets(const RefusedLine& line, Finding& f);
bool lacks_letter(const RefusedLine& line, Finding& f);
bool has_odd_sign(const RefusedLine& line, Finding& f);
bool has_other_comment(const RefusedLine& line, Finding& f);
bool comes_before_percent(const RefusedLine& line, Finding& f);
bool jumps_behind_keyword(const RefusedLine& line, Finding& f);
bool continues_with_if(const RefusedLine& line, Finding& f);

// In a condition (idioms_conditions.cc).
bool has_two_brackets(const RefusedLine& line, Finding& f);
bool compares_nothing(const RefusedLine& line, Finding& f);

// Of one sign that is too many, or missing (idioms_signs.cc).
bool numbers_block_delete(const RefusedLine& line, Finding& f);
bool has_percent(const RefusedLine& line, Finding& f);
bool assigns_to_number(const RefusedLine& line, Finding& f);
bool has_dollar(const RefusedLine& line, Finding& f);
bool quotes_text(const RefusedLine& line, Finding& f);
bool names_axis(const RefusedLine& line, Finding& f);

// In a word of another language (idioms_words.cc).
bool jumps(const RefusedLine& line, Finding& f);
bool loops_as_fanuc(const RefusedLine& line, Finding& f);
bool says_then(const RefusedLine& line, Finding& f);
bool repeats_until(const RefusedLine& line, Finding& f);
bool ends_as_shell(const RefusedLine& line, Finding& f);
bool has_words_behind_label(const RefusedLine& line, Finding& f);
bool misspells_keyword(const RefusedLine& line, Finding& f);
bool is_other_word(const RefusedLine& line, Finding& f);

// In a character that looks like another (idioms_characters.cc).
bool has_look_alike(const RefusedLine& line, Finding& f);
bool has_letters_in_number(const RefusedLine& line, Finding& f);

// In a letter that looks like a digit (idioms_digits.cc).
bool has_letter_for_digit(const RefusedLine& line, Finding& f);
bool has_exponent_in_parameter(const RefusedLine& line, Finding& f);

// In a number that is written otherwise, and where a part of a word or value is missing (idioms_numbers.cc).
/// A number with an exponent, `1E-3`, with all its digits; empty if it is none, or would be very long.
std::string with_all_digits(std::string_view number);
bool has_exponent(const RefusedLine& line, Finding& f);
bool is_no_number(const RefusedLine& line, Finding& f);
bool lacks_letter_of_value(const RefusedLine& line, Finding& f);
bool lacks_closing_bracket(const RefusedLine& line, Finding& f);
bool assigns_twice(const RefusedLine& line, Finding& f);

// In the name of a parameter (idioms_names.cc).
/// Where the name that begins at `from` ends, at the latest at the end of the line.
size_t name_end(const RefusedLine& line, size_t from);
bool names_without_brackets(const RefusedLine& line, Finding& f);
bool names_half_bracketed(const RefusedLine& line, Finding& f);
bool names_without_number_sign(const RefusedLine& line, Finding& f);

// In a value (idioms_values.cc).
bool lacks_value(const RefusedLine& line, Finding& f);
bool brackets_whole_word(const RefusedLine& line, Finding& f);
bool has_comment_in_value(const RefusedLine& line, Finding& f);
bool assigns_otherwise(const RefusedLine& line, Finding& f);
bool has_other_operator(const RefusedLine& line, Finding& f);
bool has_other_function(const RefusedLine& line, Finding& f);
bool has_not_before_bracket(const RefusedLine& line, Finding& f);

// In a calculation that is not in brackets, and what looks like one (idioms_calculations.cc).
bool has_checksum(const RefusedLine& line, Finding& f);
bool has_slash_inside(const RefusedLine& line, Finding& f);
bool computes_across_comment(const RefusedLine& line, Finding& f);
bool computes_without_brackets(const RefusedLine& line, Finding& f);
bool calls_function_in_round(const RefusedLine& line, Finding& f);
bool calls_function_behind_letter(const RefusedLine& line, Finding& f);

// In a comma or a semicolon (idioms_commas.cc).
/// Whether `1,000` may be a thousand: then no point is put in the place of the comma at `comma`. `*text` says so.
bool may_be_thousands(const RefusedLine& line, size_t comma, size_t behind, std::string* text);
bool has_thousands_mark(const RefusedLine& line, Finding& f);
bool has_comma(const RefusedLine& line, Finding& f);

// In an assignment (idioms_assignments.cc).
bool changes_in_place(const RefusedLine& line, Finding& f);
bool lacks_equal(const RefusedLine& line, Finding& f);
bool assigns_to_word(const RefusedLine& line, Finding& f);
bool lacks_bracket_of_number(const RefusedLine& line, Finding& f);
bool names_in_other_brackets(const RefusedLine& line, Finding& f);

// In the arguments of a call (idioms_arguments.cc).
/// The values of a call, each in its own brackets, whatever brackets, commas and blanks are between them: `[5] [6]` for `5] 6`.
/// Empty if that is not clear.
std::string arguments_in_brackets(std::string_view written);
bool passes_without_brackets(const RefusedLine& line, Finding& f);
bool passes_words(const RefusedLine& line, Finding& f);
bool divides_arguments(const RefusedLine& line, Finding& f);
bool names_sub_arguments(const RefusedLine& line, Finding& f);

// In a label (idioms_labels.cc).
/// The number of other lines that the label of a line was surely meant to be, `100` of `o1o0 endif` and of `N10 100 endif`;
/// kNoName for other lines.
NameId mistyped_label(const Program& program, StatementId id);
/// The label that a line with this keyword is meant to have, as it is written, where its own is none of the program's: that of
/// the block or sub that it ends, or of the lines below that belong to it. Empty if there are no such lines.
std::string label_meant(const RefusedLine& line, Keyword keyword);
/// `o100`, or the next number that no O-word of the program has; each time another one.
std::string free_label_for(const Input& in);
bool lacks_label(const RefusedLine& line, Finding& f);
bool has_letter_in_label(const RefusedLine& line, Finding& f);
bool has_sign_behind_label(const RefusedLine& line, Finding& f);
bool divides_keyword(const RefusedLine& line, Finding& f);
bool ends_with_colon(const RefusedLine& line, Finding& f);
bool begins_with_zero(const RefusedLine& line, Finding& f);

// In a code or word of another controller, and in a unit (idioms_controllers.cc).
bool prints_text(const RefusedLine& line, Finding& f);
bool has_unit(const RefusedLine& line, Finding& f);
bool is_other_controllers_word(const RefusedLine& line, Finding& f);
bool moves_as_heidenhain(const RefusedLine& line, Finding& f);
bool assigns_word_as_siemens(const RefusedLine& line, Finding& f);

// In a call: its label (idioms_calls.cc).
bool calls_without_keyword(const RefusedLine& line, Finding& f);
bool calls_by_name(const RefusedLine& line, Finding& f);
bool names_contour(const RefusedLine& line, Finding& f);
bool calls_in_value(const RefusedLine& line, Finding& f);
bool calls_m98_in_value(const RefusedLine& line, Finding& f);
bool names_arguments(const RefusedLine& line, Finding& f);
bool has_label_behind(const RefusedLine& line, Finding& f);
bool labels_with_word(const RefusedLine& line, Finding& f);
bool quotes_name(const RefusedLine& line, Finding& f);

}  // namespace owlint::rules
