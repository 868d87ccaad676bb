// The scanner: runs over the raw bytes once and hands to the line parser only the lines that can matter.
// Everything else - motion, blank lines, comments - leaves nothing behind.
#include <algorithm>
#include <array>
#include <cstring>

#include "analyzer/syntax/bulk.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/statement.h"

namespace owlint {
namespace {

enum Class : uint8_t {
  kDull,       // cannot make a line matter
  kMatters,    // the line goes to the parser
  kParen,      // a comment: look for its end
  kSemicolon,  // a comment to the end of the line
  kM,          // M2, M30, M98, M99, or an M with a computed number
};

constexpr std::array<uint8_t, 256> make_classes() {
  std::array<uint8_t, 256> classes{};
  classes.fill(kMatters);
  for (const char c : std::string_view(" \t\v\f\r+-.0123456789^@$")) classes[static_cast<unsigned char>(c)] = kDull;
  for (char c = 'a'; c <= 'z'; ++c) {
    classes[static_cast<unsigned char>(c)] = kDull;
    classes[static_cast<unsigned char>(c - 'a' + 'A')] = kDull;
  }
  for (const char c : {'o', 'O'}) classes[static_cast<unsigned char>(c)] = kMatters;
  for (const char c : {'m', 'M'}) classes[static_cast<unsigned char>(c)] = kM;
  classes['('] = kParen;
  classes[';'] = kSemicolon;
  return classes;
}

constexpr auto kClasses = make_classes();

// Lines are passed over in stretches, and each stretch is let go when it is over: a file of gigabytes is never in
// memory as a whole.
constexpr size_t kStretch = 8 << 20;  // bytes

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// Whether the M at `at` may be an M2, M30, M98, M99 or a computed one.
bool interesting_m(std::string_view line, size_t at) {
  int number = 0;
  bool digits = false;
  for (++at; at < line.size(); ++at) {
    const char c = line[at];
    if (is_blank(c)) continue;
    if (c == '.') return true;
    if (c < '0' || c > '9') break;
    digits = true;
    number = number * 10 + (c - '0');
    if (number > 999) return false;
  }
  return !digits || number == 2 || number == 30 || number == 98 || number == 99;
}

struct LineView {
  bool matters = false;
  bool code = false;    // something other than blanks and comments
  bool speaks = false;  // a comment that may hold a directive
};

LineView look(std::string_view line) {
  LineView view;
  bool first = true;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    switch (kClasses[static_cast<unsigned char>(c)]) {
      case kDull:
        if (is_blank(c)) {
          if (c == '\r' && line.find_first_not_of(" \t\r\v\f", i) != std::string_view::npos) view.matters = true;
          continue;
        }
        // A digit or two letters at the beginning: a zero for the letter O, a keyword without its label.
        if (first && c >= '0' && c <= '9') view.matters = true;
        if (first && i + 1 < line.size() && is_letter(c) && is_letter(line[i + 1])) view.matters = true;
        break;
      case kParen: {
        const size_t close = line.find_first_of(std::string_view("()\0", 3), i + 1);
        if (close == std::string_view::npos || line[close] != ')') {
          view.matters = true;
          view.code = true;
          return view;
        }
        view.speaks = true;
        i = close;
        first = false;
        continue;
      }
      case kSemicolon:
        view.speaks = true;
        if (line.find('\0', i) != std::string_view::npos) view.matters = true;
        return view;
      case kM:
        if (interesting_m(line, i)) view.matters = true;
        break;
      default:
        if (!(first && c == '/')) view.matters = true;
        break;
    }
    view.code = true;
    first = false;
    if (view.matters) {
      view.speaks = view.speaks || line.find('(', i) != std::string_view::npos || line.find(';', i) != std::string_view::npos;
      return view;
    }
  }
  return view;
}

/// Finds `owlint:` in the comments of a line. It is a fixed word, so a plain search is enough; the parser of
/// directives looks closer.
void note_directive(std::string_view line, uint64_t offset, uint32_t number, bool code, bool on_oword, Syntax& out) {
  const size_t at = line.find("owlint:");
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

void note_first_line(std::string_view line, Syntax& out, bool* seen) {
  const size_t first = line.find_first_not_of(" \t\r\v\f");
  if (first == std::string_view::npos) return;
  *seen = true;
  out.percent = line[first] == '%' && line.find_first_not_of(" \t\r\v\f", first + 1) == std::string_view::npos;
}

/// Room for one more, and if there is none, for as many as the whole file will have if it goes on like this.
template <typename T>
void make_room(std::vector<T>& list, size_t at, size_t size) {
  constexpr size_t kFew = 1024;
  if (list.size() < list.capacity() || list.size() < kFew) return;
  const auto expected = static_cast<size_t>(static_cast<double>(list.size()) * static_cast<double>(size) / static_cast<double>(at + 1) * 1.05);
  list.reserve(std::max(expected, list.size() * 2));
}

}  // namespace

Syntax scan(const Source& source) {
  Syntax out;
  LineParser parser(out);
  const std::string_view bytes = source.bytes();
  bool seen_first = false;
  uint32_t number = 0;
  size_t stretch_end = 0;
  const auto note_plain = [&out](uint32_t line) {
    if (out.statements.empty()) {
      if (out.first_plain_line == 0) out.first_plain_line = line;
    } else if (!out.statements.back().plain_code_follows) {
      out.statements.back().plain_code_follows = true;
      out.statements.back().first_plain_line = line;
    }
  };
  for (size_t at = 0; at < bytes.size();) {
    if (at >= stretch_end) {
      source.let_go(at);
      const size_t feed = at + kStretch < bytes.size() ? bytes.find('\n', at + kStretch) : std::string_view::npos;
      stretch_end = feed == std::string_view::npos ? bytes.size() : feed + 1;
    }
    if (seen_first) {
      const Passed passed = pass_plain_lines(bytes.substr(0, stretch_end), at);
      if (passed.first_code != 0) {
        note_plain(number + passed.first_code);
        out.last_code = number + passed.last_code;
      }
      number += passed.lines;
      at = passed.next;
      if (at == stretch_end) continue;
    }
    const auto* feed = static_cast<const char*>(std::memchr(bytes.data() + at, '\n', bytes.size() - at));
    const size_t end = feed == nullptr ? bytes.size() : static_cast<size_t>(feed - bytes.data());
    const std::string_view line = bytes.substr(at, end - at);
    ++number;
    if (!seen_first) note_first_line(line, out, &seen_first);
    Statement statement;
    statement.line = number;
    bool keep = false;
    // The limit counts the line feed: a last line without one may be a character longer.
    if (line.size() > kLineLimit + (feed == nullptr ? 1 : 0)) {
      statement.offset = at;
      statement.length = static_cast<uint32_t>(std::min<size_t>(line.size(), UINT32_MAX));
      statement.error = static_cast<uint32_t>(out.errors.size());
      out.errors.push_back({StopKind::kLineTooLong, {at + kLineLimit, end}, "Command too long"});
      keep = true;
      out.last_code = number;
    } else {
      const LineView view = look(line);
      if (view.code) out.last_code = number;
      if (view.matters) keep = parser.parse(line, at, &statement);
      if (view.speaks) {
        note_directive(line, at, number, view.code, keep && statement.kind == LineKind::kOWord, out);
      }
      if (!keep && view.code) note_plain(number);
    }
    if (keep) {
      make_room(out.statements, at, bytes.size());
      make_room(out.exprs, at, bytes.size());
      make_room(out.values, at, bytes.size());
      out.statements.push_back(statement);
    }
    at = end + 1;
  }
  out.lines = number;
  out.blank = !seen_first;
  return out;
}

}  // namespace owlint
