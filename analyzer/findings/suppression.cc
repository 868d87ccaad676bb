#include "analyzer/findings/suppression.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/text/paths.h"

namespace owlint {
namespace {

struct Word {
  std::string_view text;
  Span span;
};

/// Words up to `--`, which begins a reason as `because` does, separated by blanks and punctuation.
std::vector<Word> words_of(std::string_view text, uint64_t offset) {
  std::vector<Word> words;
  constexpr std::string_view kBetween = " \t\r,;:";
  size_t at = 0;
  while (at < text.size()) {
    const size_t from = text.find_first_not_of(kBetween, at);
    if (from == std::string_view::npos) break;
    size_t to = text.find_first_of(kBetween, from);
    if (to == std::string_view::npos) to = text.size();
    const std::string_view word = text.substr(from, to - from);
    if (word.starts_with("--")) break;
    words.push_back({word, {offset + from, offset + to}});
    at = to;
  }
  return words;
}

}  // namespace

std::vector<Suppression> parse_suppressions(const Source& source, Span words, uint32_t line, bool own_line,
                                            const CodeOf& code_of) {
  std::vector<Suppression> out;
  const std::vector<Word> list = words_of(source.slice(words), words.begin);
  Suppression base;
  base.comment = words;
  base.span = list.empty() ? words : list[0].span;
  const std::string wanted = list.empty() ? std::string() : small_letters(list[0].text);
  if (wanted != "ignore" && wanted != "ignore-file") {
    base.malformed = true;
    out.push_back(base);
    return out;
  }
  if (wanted == "ignore") base.line = own_line ? line + 1 : line;
  if (list.size() == 1) out.push_back(base);  // everything
  for (size_t i = 1; i < list.size(); ++i) {
    std::optional<std::string> code = code_of(list[i].text, i == 1);
    if (!code) break;  // the reason
    Suppression one = base;
    one.span = list[i].span;
    one.code = std::move(*code);
    out.push_back(std::move(one));
  }
  return out;
}

void apply_suppressions(const Source& source, std::vector<Suppression>& suppressions, std::vector<Finding>& findings) {
  if (suppressions.empty()) return;
  std::unordered_map<uint32_t, std::vector<Suppression*>> by_line;
  for (Suppression& s : suppressions) {
    if (!s.malformed) by_line[s.line].push_back(&s);
  }
  std::erase_if(findings, [&](const Finding& finding) {
    bool suppressed = false;
    for (const uint32_t line : {0U, source.position(finding.span.begin).line}) {
      const auto found = by_line.find(line);
      if (found == by_line.end()) continue;
      for (Suppression* s : found->second) {
        if (!finding.code.starts_with(s->code)) continue;
        s->used = true;
        suppressed = true;
      }
    }
    return suppressed;
  });
}

std::vector<Edit> suppression_comments(const Source& source, const std::vector<Finding>& findings,
                                       const std::string& reason) {
  std::map<uint32_t, std::set<std::string_view>> codes;  // by line
  for (const Finding& f : findings) {
    if (f.source == nullptr) codes[source.position(f.span.begin).line].insert(f.code);
  }
  const bool ini = small_letters(ending_of(source.path())) == ".ini";
  // A reason with brackets would end the other kind of comment.
  const bool brackets = reason.find_first_of("()") != std::string::npos;
  std::vector<Edit> edits;
  for (const auto& [number, list] : codes) {
    const Span line = source.line(number);
    const std::string_view text = source.slice(line);
    const std::string_view before = source.bytes().substr(0, line.begin);
    // With anything above it, the `%` that begins a program begins none any more: then a comment below is for the whole file.
    const bool below = text.starts_with('%') && before.find_first_not_of(" \t\r\n") == std::string_view::npos &&
        line.end < source.bytes().size();
    const uint64_t at = below ? line.end + 1 : line.begin;
    const std::string_view indent = text.substr(0, std::min(text.find_first_not_of(" \t"), text.size()));
    const std::string words =
        fmt::format("owlint: {} {} because {}", below ? "ignore-file" : "ignore", fmt::join(list, " "), reason);
    edits.push_back({{at, at},
                     fmt::format("{}{}{}", indent,
                                 ini            ? "# " + words
                                     : brackets ? "; " + words
                                                : "(" + words + ")",
                                 text.ends_with('\r') ? "\r\n" : "\n")});
  }
  return edits;
}

}  // namespace owlint
