#include "analyzer/syntax/line_look.h"

#include <algorithm>

#include "analyzer/syntax/comment_command.h"
#include "analyzer/syntax/line_text.h"
#include "analyzer/text/characters.h"

namespace owlint {
namespace {

LineView view_of(std::string_view line) {
  LineView view;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '(') {
      const size_t close = line.find_first_of(std::string_view("()\0", 3), i + 1);
      view.speaks = true;
      if (close == std::string_view::npos || line[close] != ')') {
        view.matters = view.code = true;
        return view;
      }
      i = close;
    } else if (c == ';') {
      view.speaks = true;
      if (line.find('\0', i) != std::string_view::npos) view.matters = true;
      return view;
    } else if (!is_blank(c)) {
      view.matters = view.code = true;
      return view;
    } else if (c == '\r' && line.find_first_not_of(" \t\r\v\f", i) != std::string_view::npos) {
      view.matters = true;
    }
  }
  return view;
}

/// Whether a `P` is on the line, before a whole number of so many digits that is written without a point; in a comment perhaps.
bool has_whole_p(std::string_view line) {
  constexpr size_t kDigits = 3;
  for (size_t at = 0; (at = line.find_first_of("Pp", at)) != std::string_view::npos;) {
    ++at;
    while (at < line.size() && is_space_or_tab(line[at])) ++at;
    const size_t from = at;
    while (at < line.size() && is_digit(line[at])) ++at;
    if (at - from >= kDigits && (at == line.size() || line[at] != '.')) return true;
  }
  return false;
}

/// Whether a character, made small, is `b`.
bool same_letter(char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + ('a' - 'A')) : a) == b; }

/// Where `owlint:` is on a line, in capitals or not. Few comments have a colon.
size_t find_directive(std::string_view line) {
  for (size_t colon = line.find(':'); colon != std::string_view::npos; colon = line.find(':', colon + 1)) {
    if (colon >= kOwlint.size() &&
        std::ranges::equal(line.substr(colon - kOwlint.size(), kOwlint.size()), kOwlint, same_letter))
      return colon - kOwlint.size();
  }
  return std::string_view::npos;
}

}  // namespace

LineView look(std::string_view line) {
  LineView view = view_of(line);
  view.whole_p = view.code && has_whole_p(line);
  return view;
}

bool ends_in_nuls(std::string_view line) {
  const size_t first = line.find('\0');
  return first <= kLineLimit && line.find_first_not_of('\0', first) == std::string_view::npos;
}

void note_directive(std::string_view line, uint64_t offset, uint32_t number, bool code, bool on_oword, Syntax& out) {
  const size_t at = find_directive(line);
  if (at == std::string_view::npos) return;
  const size_t opened = line.find_last_of("(;", at);
  if (opened == std::string_view::npos) return;
  size_t end = line.size();
  if (line[opened] == '(') {
    end = line.find(')', at);
    if (end == std::string_view::npos) return;
  }
  while (end > at && is_blank(line[end - 1])) --end;
  out.directives.push_back({number, {offset + at + 7, offset + end}, !code, on_oword});
}

bool begins(std::string_view comment, std::string_view word) {
  return std::ranges::equal(comment.substr(0, word.size()), word, same_letter);
}

std::string_view acting_comment(std::string_view line) {
  std::string_view comment;
  for (size_t at = 0; (at = line.find_first_of("(;", at)) != std::string_view::npos && line[at] == '(';) {
    const size_t close = line.find(')', at);
    if (close == std::string_view::npos) break;
    comment = line.substr(at + 1, close - at - 1);
    at = close + 1;
  }
  comment.remove_prefix(std::min(comment.find_first_not_of(" \t"), comment.size()));
  return comment;
}

bool runs_python(std::string_view line, std::string_view comment) {
  return line.starts_with(";py,") || begins(comment, "py,") || begins(comment, "pyrun,");
}

}  // namespace owlint
