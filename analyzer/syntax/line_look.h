// What the bytes of a line tell before it is parsed: whether it matters at all, and what its comments say to LinuxCNC and
// to owlint. For lines that are not plain (bulk.h); the scanner asks.
#pragma once

#include <cstdint>
#include <string_view>

#include "analyzer/syntax/statement.h"

namespace owlint {

struct LineView {
  bool too_long = false;  // longer than LinuxCNC reads; then nothing else is known
  bool matters = false;
  bool code = false;     // something other than blanks and comments
  bool speaks = false;   // a comment that may hold a directive; not looked for in lines that matter
  bool whole_p = false;  // see Syntax::whole_p_lines
  bool owlint = false;   // the word is there, in small letters
};

/// Looks at a line that is not plain. One with code goes to the parser, and of comments those that LinuxCNC refuses.
LineView look(std::string_view line);

/// Whether nothing but NUL bytes comes after the first of them, as at the end of a file on a disk that was pulled out: the
/// interpreter does not see them.
bool ends_in_nuls(std::string_view line);

/// Finds `owlint:` in the comments of a line. It is a fixed word: the parser of directives looks closer.
void note_directive(std::string_view line, uint64_t offset, uint32_t number, bool code, bool on_oword, Syntax& out);

/// The comment that acts: of several in parentheses the last one, and none behind a semicolon (measured).
std::string_view acting_comment(std::string_view line);
/// Whether a comment begins with a word, in small letters or not. Measured: without a blank before its comma.
bool begins(std::string_view comment, std::string_view word);
/// Whether the line runs Python. Behind a semicolon only where the line begins with exactly that (measured).
bool runs_python(std::string_view line, std::string_view comment);

}  // namespace owlint
