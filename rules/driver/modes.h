// What the rules about modes, arcs, cycles and contours have in common (OW8xx, OW9xx): the word that a message of the
// interpreter is about, and the line that has set the mode which decides.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "rules/driver/words.h"

namespace owlint::rules {

/// What to say for a message of the interpreter.
struct Said {
  std::string_view interpreter;  ///< a part of the message; of several rows that fit, the first counts
  std::string_view about;        ///< the words that it may be about, for find_word()
  std::string_view message;      ///< behind that word
  std::string_view help;
};
/// Null if no row fits.
const Said* said_of(std::span<const Said> rows, std::string_view interpreter);

/// The word of a line that `names` means first: `G1` is that code, `F` a word with this letter, `*` an axis word. Null if
/// there is none.
const WrittenWord* find_word(const std::vector<WrittenWord>& line, std::string_view names);

/// word_stop(), about the word that `names` means. A line may have none of them, where a motion from before is in effect or
/// a code is computed.
WordStop word_stop(const Input& in, const FlowStop& stop, std::string_view names);
/// The word as messages begin with it; `this line` where it is not one word.
std::string subject(const WordStop& stop);

/// What has set the mode that decides whether a line stops.
struct Setter {
  const Program* program;
  uint32_t line;
  Span span;             ///< the word, or all of the line
  std::string word;      ///< as shown(); empty where the line restores modes
  bool on_line = false;  ///< on the very line that stops

  bool restores() const { return word.empty(); }
};
/// `names`: for find_word(). With `own`, the line that stops may have set the mode itself. Nothing where no single line has.
std::optional<Setter> setter_of(const Input& in, const FlowStop& stop, std::string_view names, bool own = true);
/// `on line 12`, `on this line`.
std::string where(const Input& in, const Setter& setter);
/// Adds "`G93` is set here", with `what` behind the word.
void relate_setter(const Input& in, Finding& finding, const std::optional<Setter>& setter,
                   std::string_view what = "is set here");

/// Adds the finding for a stop: what the row for its message says of the word.
Finding& add_said(const Input& in, Reporter& out, const FlowStop& stop, std::span<const Said> rows);

/// Writes a code before a word. The line has no code of its group.
Fix with_code(Span word, const std::string& code);

}  // namespace owlint::rules
