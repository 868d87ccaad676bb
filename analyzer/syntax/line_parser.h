// Turns one normalised line into a Statement. Called by the scanner for the lines that can matter.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "analyzer/syntax/statement.h"
#include "analyzer/syntax/word_line.h"

namespace owlint {

class LineParser {
 public:
  explicit LineParser(Syntax& syntax, const MachineWords& machine = {})
      : out_(syntax), machine_(machine), words_(machine_) {}

  /// Parses `raw` (without line feed) which begins at `offset`. Fills `*statement` and returns true if the line
  /// is to be kept; its values, items and errors are then in the Syntax. A line that is kept for none of them leaves
  /// nothing there.
  bool parse(std::string_view raw, uint64_t offset, Statement* statement);
  /// The words of the line that was parsed last: null for O-words, M98, and where reading has failed.
  const WordLine* words() const { return has_words_ ? &words_ : nullptr; }
  /// The same of a line with M98. They are checked, but nothing of them is executed.
  const WordLine* words_of_call() const { return has_words_of_call_ ? &words_ : nullptr; }
  /// The errors with which that line stops on some machines, or for some values: indices in Syntax::errors.
  std::span<const uint32_t> questions() const { return questions_; }
  /// Whether that line reads where the machine stands, or which tool it has.
  bool reads_place() const;
  /// Records a fault of the words against each other, or in the modes that are in effect: returns its index in Syntax::errors.
  uint32_t add_error(const Fault& fault, ModeMask decided_by);
  /// Whether a comment begins on the line that was parsed last.
  bool has_comment() const { return line_.has_comment(); }

 private:
  void o_word(size_t at, Statement& s, bool has_letter = true);
  void label(ExpressionParser& in, Statement& s, bool has_letter);
  void arguments(ExpressionParser& in, Statement& s);
  bool words(size_t at, Statement& s);
  bool fanuc_code(size_t at, Statement& s);
  void m98(ExpressionParser& in, Statement& s);
  void m98_word(char letter, ExprId value, size_t from, size_t to, Statement& s);
  void m98_target(ExprId value, size_t from, size_t to, Statement& s);
  void m98_other(ExprId value, size_t from, size_t to, Statement& s);
  void m99(ExpressionParser& in, Statement& s);
  bool all_words(ExpressionParser& in, Statement& s);
  bool word(ExpressionParser& in, Statement& s);
  bool number_of(ExpressionParser& in, size_t from, ExprId* value, Statement& s);
  void fail(Statement& s, const Fault& fault, size_t from, size_t to);
  bool passes(Statement& s, const Fault& fault, size_t from, size_t to);
  Span span_of_word(uint8_t word) const;
  void contour(Statement& s);
  bool m_code(ExprId value, size_t from, size_t to, Statement& s);
  void note_rest(size_t at, Statement& s);
  bool assignment(ExpressionParser& in, Statement& s);
  static std::string bad_character(char c);
  void misplaced_character(size_t at, Statement& s);
  size_t label_end(size_t at) const;
  bool label_without_o(size_t at, Statement& s);
  bool label_forgotten(size_t at, Statement& s);
  void unreadable(const ReadError& error, size_t from, Statement& s);
  void recover(size_t at, Statement& s, bool has_letter = true);
  void fail(Statement& s, StopKind kind, size_t from, size_t to, std::string message);
  LineByte relative(size_t at) const;
  size_t keyword_at(size_t at) const;
  static bool starts_word(char c);
  size_t skip_comments(size_t at, bool* any) const;

  static constexpr size_t kFanucCode = 3;  // characters of `M98` and `M99`
  // Beside the letters of a line's words: M codes that were among them.
  static constexpr uint32_t kHasStop = 1U << 30;
  static constexpr uint32_t kHasReturn = 1U << 31;

  Syntax& out_;
  MachineWords machine_;
  LineText line_;
  WordLine words_;
  bool has_words_ = false;
  bool has_words_of_call_ = false;
  std::array<ExprId, 2> value_of_{};  // of the line's last P and Q
  std::vector<uint32_t> questions_;   // see questions()
  bool unsure_ = false;               // one of them is about the machine
  ExprId contour_sub_ = kNoExpr;      ///< the value of the line's Q word
  size_t contour_from_ = 0, contour_to_ = 0;
  bool cuts_contour_ = false;                  ///< the line has a G70, G71 or G72
  size_t number_at_ = std::string_view::npos;  // where the line number is, if there is one
  ExprId line_begins_ = 0;                     // the first expression of the line
  ExprId item_begins_ = 0;                     // and of the word or setting that is being read
  uint32_t letters_ = 0;                       // of the words on the line so far, one bit each
  ExprId target_ = kNoExpr;                    // the P of M98
  size_t target_from_ = 0, target_to_ = 0;
};

/// The value of an expression made of literals only; false when it has parameters or fails.
bool literal_value(const ExprPool& pool, ExprId id, double* value);
/// The same for a number that names a parameter or a code: only a whole one does.
std::optional<long> literal_integer(const ExprPool& pool, ExprId id);

/// Name of a numeric label; false when the value is not within 0.0001 of an integer.
bool label_of_number(double value, std::string* name);

}  // namespace owlint
