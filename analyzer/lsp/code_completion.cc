// Completion of codes: those of LinuxCNC, and what the machine adds to them.
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "analyzer/lsp/places.h"
#include "analyzer/lsp/remaps.h"
#include "analyzer/lsp/word_help.h"
#include "analyzer/program/machine_words.h"
#include "rules/driver/words.h"

namespace owlint::lsp {
namespace {

/// The code that ends at an offset: its letter, and the digits that are there. Nothing where no word may begin.
std::optional<Span> begun_code(const Document& document, uint64_t offset, bool* first_word) {
  const Span line = fed_line(document.text(), offset);
  const std::vector<rules::WrittenWord> words = rules::words_of(*document.source(), {line.begin, offset});
  if (words.empty()) return std::nullopt;
  const rules::WrittenWord& last = words.back();
  if ((last.letter != 'g' && last.letter != 'm') || last.span.end != offset) return std::nullopt;
  *first_word = words.size() == 1;
  // LinuxCNC reads what stands behind these in another way.
  const rules::WrittenWord& first = words.front();
  const bool fanuc = first.letter == 'm' && (first.value == code::kM98 || first.value == code::kM99);
  return fanuc && !*first_word ? std::nullopt : std::optional(last.span);
}

}  // namespace

Json code_completion(const Document& document, const Profile& profile, uint64_t offset) {
  constexpr int kKeyword = 14;  // of the protocol
  Json out = Json::array();
  bool first_word = false;
  std::optional<Span> typed = begun_code(document, offset, &first_word);
  if (!typed) return out;
  const std::string_view text = document.text();
  const char written = text[typed->begin];
  const char letter = written == 'G' || written == 'g' ? 'g' : 'm';
  // Digits behind the cursor belong to the code that is replaced.
  while (typed->end < text.size() && std::string_view("0123456789.").find(text[typed->end]) != std::string_view::npos)
    ++typed->end;

  std::map<int, std::string> titles;  // by number; of G codes in tenths
  if (letter == 'g') {
    for (const GCode& code : g_codes()) {
      if (code.since <= release_of(profile)) titles.emplace(code.tenths, code.title);
    }
  } else {
    for (const MCode& code : m_codes()) {
      if (code.group != MGroup::kUser && (code.group != MGroup::kCall || first_word))
        titles.emplace(code.number, code.title);
    }
    for (int number = code::kM100; profile.setup != nullptr && number < code::kM100 + 100; ++number) {
      if (profile.setup->user_code(number) == UserCode::kThere) titles.emplace(number, m_code(number)->title);
    }
  }
  for (const Remap& remap : remaps(profile)) {
    if (remap.number >= 0 && remap.letter == letter) titles[remap.number] = "calls " + remap.calls;
  }
  for (const auto& [number, title] : titles) {
    const std::string label = letter == 'g' ? g_name(number) : m_name(number);
    out.push_back({{"label", label},
                   {"kind", kKeyword},
                   {"detail", title},
                   {"documentation", {{"kind", "markdown"}, {"value", code_help(letter, number, profile)}}},
                   {"sortText", fmt::format("{:05}", number)},
                   {"textEdit", {{"range", document.range(*typed)}, {"newText", written + label.substr(1)}}}});
  }
  return out;
}

}  // namespace owlint::lsp
