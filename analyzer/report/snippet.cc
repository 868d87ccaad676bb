#include "analyzer/report/snippet.h"

#include <algorithm>

#include "analyzer/text/printable.h"
#include "analyzer/text/width.h"

namespace owlint {
namespace {

constexpr size_t kTab = 8;
constexpr std::string_view kCut = "…";

bool inside_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Appends bytes as a terminal shows them; `at` is the column that they begin at, and then the one that they end at.
void show(std::string_view bytes, std::string* text, size_t* at) {
  const std::string shown = printable(bytes);
  for (std::string_view left = shown; !left.empty();) {
    if (left.front() == '\t') {
      const size_t blanks = kTab - *at % kTab;
      text->append(blanks, ' ');
      *at += blanks;
      left.remove_prefix(1);
      continue;
    }
    const Character character = first_character(left);
    *text += left.substr(0, character.bytes);
    *at += character.columns;
    left.remove_prefix(character.bytes);
  }
}

/// Takes columns from the beginning of a text; how many they were, as a wide character may be one more.
size_t cut_front(std::string* text, size_t columns) {
  size_t bytes = 0;
  size_t cut = 0;
  while (cut < columns && bytes < text->size()) {
    const Character character = first_character(std::string_view(*text).substr(bytes));
    bytes += character.bytes;
    cut += character.columns;
  }
  text->erase(0, bytes);
  return cut;
}

/// Leaves no more than so many columns of a text.
void cut_back(std::string* text, size_t room) {
  size_t bytes = 0;
  for (size_t at = 0; bytes < text->size();) {
    const Character character = first_character(std::string_view(*text).substr(bytes));
    at += character.columns;
    if (at > room) break;
    bytes += character.bytes;
  }
  text->resize(bytes);
}

}  // namespace

Snippet snippet(const Source& source, Span span, size_t room) {
  Snippet out;
  out.line = source.position(span.begin).line;
  Span line = source.line(out.line);
  if (source.slice(line).ends_with('\r')) --line.end;  // a line end, not part of the line
  const uint64_t begin = std::clamp(span.begin, line.begin, line.end);
  const uint64_t end = std::clamp(span.end, begin, line.end);
  // A character has at most some ten bytes; what is further away is never shown.
  const uint64_t reach = 16 * room;
  uint64_t from = begin - std::min(begin - line.begin, reach);
  while (from > line.begin && from < begin && inside_character(source.slice({from, from + 1})[0])) ++from;
  const uint64_t to = std::min(line.end, begin + reach);

  size_t before = 0;
  show(source.slice({from, begin}), &out.text, &before);
  size_t after = before;
  show(source.slice({begin, std::min(end, to)}), &out.text, &after);
  size_t all = after;
  show(source.slice({std::min(end, to), to}), &out.text, &all);
  while (out.text.ends_with(' ')) {
    out.text.pop_back();
    --all;
  }
  out.pad = before;
  out.marked = after - before;
  bool cut_left = from > line.begin;
  // The marked part is shown with something before it; where all of it fits from the beginning, from there.
  if (cut_left || (all > room && after > room - 1)) {
    const size_t behind = std::min(room - 2, all - before);  // with what is marked
    const size_t kept = std::min(before, std::max(out.marked > room / 2 ? room / 3 : room / 2, room - 2 - behind));
    const size_t gone = cut_front(&out.text, before - kept);
    cut_left = cut_left || gone > 0;
    all -= gone;
    out.pad -= gone;
    if (cut_left) {
      out.text.insert(0, kCut);
      ++all;
      ++out.pad;
    }
  }
  if (all > room || to < line.end) {
    cut_back(&out.text, room - 1);
    out.text += kCut;
    all = columns(out.text);
  }
  out.marked = std::max<size_t>(1, std::min(out.marked, std::max(all, out.pad + 1) - out.pad));
  return out;
}

}  // namespace owlint
