#include "analyzer/machine/strict_ini.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace owlint {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text[0]) && std::ranges::all_of(text, [](char c) {
    return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
}

std::string_view without_space(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The first byte that begins no UTF-8 character; npos if there is none.
size_t first_bad_byte(std::string_view text) {
  for (size_t at = 0; at < text.size();) {
    const size_t length = sequence_length(text, at);
    if (length == 1 && static_cast<unsigned char>(text[at]) >= 0x80) return at;
    at += length;
  }
  return std::string_view::npos;
}

/// How many hexadecimal digits must follow `\x`, `\u` and `\U`; 0 for other characters.
size_t digits_of(char c) { return c == 'x' ? 2 : c == 'u' ? 4 : c == 'U' ? 8 : 0; }

/// The first of these escapes that lacks a digit.
Span bad_escape(std::string_view text) {
  for (size_t at = 0; at + 1 < text.size(); ++at) {
    if (text[at] != '\\') continue;
    const size_t digits = digits_of(text[at + 1]);
    const std::string_view rest = text.substr(at + 2, digits);
    const bool good = rest.size() == digits &&
        std::ranges::all_of(rest, [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; });
    if (digits > 0 && !good) return {at, at + 2};
    ++at;
  }
  return {};
}

class StrictReader {
 public:
  explicit StrictReader(const IniText& text) : text_(text) {}

  std::vector<StrictRefusal> run() {
    const std::vector<IniLine>& lines = text_.lines();
    for (const IniLine& line : lines) {
      const std::string_view body = text_.text(line);
      if (const size_t bad = first_bad_byte(body); bad != std::string_view::npos)
        add(StrictRefusal::Kind::kNotUtf8, line, {line.span.begin + bad, line.span.begin + bad + 1}, "");
      if (line.kind == IniLine::Kind::kComment) {
        if (!ini_include(body).empty() && text_.slice(line, text_.source(line)->line(line.number)).starts_with('#'))
          add(StrictRefusal::Kind::kNoInclude, line, line.span, "");
        continue;
      }
      if (!line.continuation) read(line);
      if (line.kind == IniLine::Kind::kKey || line.continuation) {
        if (const Span bad = bad_escape(body); bad.end > 0)
          add(StrictRefusal::Kind::kBadEscape, line, {line.span.begin + bad.begin, line.span.begin + bad.end}, "");
      }
    }
    if (!lines.empty() && lines.back().continued && lines.back().kind != IniLine::Kind::kComment)
      add(StrictRefusal::Kind::kOpenEnd, lines.back(), {lines.back().span.end - 1, lines.back().span.end}, "");
    return std::move(out_);
  }

 private:
  void add(StrictRefusal::Kind kind, const IniLine& line, Span span, std::string message) {
    out_.push_back({kind, &line, span, std::move(message)});
  }

  void read(const IniLine& line) {
    const std::string_view body = text_.text(line);
    const std::string_view name = text_.name(line);
    if (line.kind == IniLine::Kind::kOpenSection) {
      add(StrictRefusal::Kind::kOpenSection, line, line.span, "Invalid section. Missing ']'");
    } else if (line.kind == IniLine::Kind::kSection) {
      if (!is_name(without_space(name))) add(StrictRefusal::Kind::kBadSection, line, line.name, "");
    } else if (line.section < 0) {
      add(StrictRefusal::Kind::kBeforeSection, line, line.span, "");
    } else if (line.kind == IniLine::Kind::kText) {
      add(StrictRefusal::Kind::kNoEquals, line, line.span,
          fmt::format("Invalid tag '{}'. Expected '=' after tag identifier", name));
    } else if (const std::string_view key = without_space(body.substr(0, body.find('='))); !is_name(key)) {
      add(StrictRefusal::Kind::kBadKey, line, {line.span.begin, line.span.begin + std::max<size_t>(key.size(), 1)}, "");
    }
  }

  const IniText& text_;
  std::vector<StrictRefusal> out_;
};

}  // namespace

std::vector<StrictRefusal> strict_refusals(const IniText& text) { return StrictReader(text).run(); }

}  // namespace owlint
