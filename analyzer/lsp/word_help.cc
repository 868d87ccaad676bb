#include "analyzer/lsp/word_help.h"

#include <algorithm>

#include <fmt/format.h>

#include "analyzer/lsp/ini_uses.h"
#include "analyzer/lsp/places.h"
#include "analyzer/lsp/remaps.h"
#include "rules/driver/code_facts.h"
#include "rules/driver/words.h"

namespace owlint::lsp {
namespace {

/// Some lines of a Markdown list.
class Points {
 public:
  void add(std::string_view name, std::string_view text) {
    if (!text.empty()) text_ += fmt::format("\n- {}: {}", name, text);
  }
  void add(std::string_view name, const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    add(name, list);
  }
  void add(std::string_view text) { text_ += fmt::format("\n- {}", text); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// What a REMAP line of the machine makes of a code or word, as a paragraph.
std::string remapped(char letter, int number, const Profile& profile) {
  for (const Remap& remap : remaps(profile)) {
    if (remap.letter == letter && remap.number == number)
      return fmt::format("\n\n{}: on this machine it calls {}.", text_of(*remap.entry), remap.calls);
  }
  return {};
}

/// Names the axes that the machine has.
void name_axes(std::vector<std::string>& words, const Profile& profile) {
  if (profile.setup == nullptr || words.empty() || words[0] != "axes") return;
  const uint32_t axes = WordsOfMachine(profile).words.axes;
  std::string letters;
  for (const WordRow& row : word_rows()) {
    if ((axes & kAxisLetters & letter_set({&row.letter, 1})) != 0) letters += " " + rules::capital(row.letter);
  }
  words[0] += letters;
}

std::string g_help(const GCode& code, const Profile& profile) {
  Points points;
  if (code.group == GGroup::kNonModal) {
    points.add("not modal: it acts once");
  } else {
    points.add("group", rules::group_text(code.group));
  }
  points.add("needs", rules::words_needed(code));
  std::vector<std::string> words = rules::words_taken(code);
  name_axes(words, profile);
  points.add("takes", words);
  points.add("refuses", rules::words_refused(code));
  if (const std::string_view since = rules::since_text(code.since); !since.empty()) {
    points.add(fmt::format("since LinuxCNC {}", since));
    if (release_of(profile) < code.since)
      points.add(
          fmt::format("the program is checked for LinuxCNC {}, which does not have it", version_text(profile.version)));
  }
  return fmt::format("**{}** {}\n{}", g_name(code.tenths), code.title, points.text());
}

std::string m_help(int number, const MCode& code, const Profile& profile) {
  Points points;
  points.add("group", rules::group_text(code.group));
  points.add("takes", rules::words_taken(code));
  if (code.group == MGroup::kCall) points.add("only as the first word of its line");
  std::string text = fmt::format("**{}** {}\n{}", m_name(number), code.title, points.text());
  if (code.group == MGroup::kUser) text += "\n\n" + rules::user_code_text(number, profile.setup.get()) + ".";
  return text;
}

bool is_axis(char letter) { return (letter_set({&letter, 1}) & (kAxisLetters | kPolarLetters)) != 0; }

/// The number of a code as it is written; nothing for one that is computed, or that LinuxCNC refuses to read.
std::optional<int> number_of(const WrittenWord& word) {
  if ((word.letter != 'g' && word.letter != 'm') || !word.value || refused_number(word.letter, *word.value) != nullptr)
    return std::nullopt;
  int32_t number = 0;
  const bool whole = word.letter == 'g' ? g_tenths(*word.value, &number) : word_integer(*word.value, &number);
  return whole ? std::optional<int>(number) : std::nullopt;
}

/// Whether a code of the same line takes the word.
bool takes(const WrittenWord& code, char letter, const CodeSet& taking, Release release) {
  const std::optional<int> number = number_of(code);
  if (!number) return false;
  if (code.letter == 'm') {
    const MCode* m = m_code(*number);
    return m != nullptr && set_of(*m).meets(taking);
  }
  const GCode* g = g_code(*number, release);
  if (g == nullptr) return false;
  return set_of(*g).meets(taking) || (is_axis(letter) && g->motion != Motion::kNone && g->tenths != code::kG80);
}

std::string letter_help(const WordRow& row, const std::vector<WrittenWord>& line, const Profile& profile) {
  const Release release = release_of(profile);
  const CodeSet taking = rules::codes_taking(row.letter, release);
  Points points;
  points.add("number",
             fmt::format("{}{}", rules::number_text(row.number),
                         row.below == nullptr ? "" : fmt::format(", {} or more", row.least)));
  std::string takers = is_axis(row.letter) ? "motions" : "";
  if (!taking.empty()) takers += (takers.empty() ? "" : "; ") + rules::spoken(taking, release);
  points.add("taken by", takers);
  if (std::string_view("fst").find(row.letter) != std::string_view::npos) points.add("stands with any code, and alone");
  points.add("needed by", rules::spoken(rules::codes_needing(row.letter, release), release));
  std::vector<std::string> here;
  for (const WrittenWord& word : line) {
    if (takes(word, row.letter, taking, release))
      here.push_back(word.letter == 'g' ? g_name(*number_of(word)) : m_name(*number_of(word)));
  }
  points.add("on this line for", here);
  points.add("twice on a line", rules::twice_text(row));
  const std::string name = rules::capital(row.letter);
  std::string text = fmt::format("**{}** {}\n{}", name, row.title, points.text());
  const uint32_t axis = letter_set({&row.letter, 1}) & kAxisLetters;
  if (profile.setup != nullptr && axis != 0 && (WordsOfMachine(profile).words.axes & axis) == 0)
    text += "\n\nThis machine has no such axis.";
  return text + remapped(row.letter, -1, profile);
}

}  // namespace

std::string code_help(char letter, int number, const Profile& profile) {
  const std::string name = letter == 'g' ? g_name(number) : m_name(number);
  std::string text;
  if (const GCode* g = letter == 'g' ? g_code(number, Release::k2_10) : nullptr) text = g_help(*g, profile);
  if (const MCode* m = letter == 'm' ? m_code(number) : nullptr) text = m_help(number, *m, profile);
  const std::string remap = remapped(letter, number, profile);
  if (text.empty() && !remap.empty()) text = fmt::format("**{}** code of this machine", name);
  return text + remap;
}

std::optional<WordHelp> word_help(const Document& document, const Profile& profile, uint64_t offset) {
  const std::vector<WrittenWord> line = rules::words_of(*document.source(), fed_line(document.text(), offset));
  // Between two words, the one behind.
  auto word = std::find_if(line.rbegin(), line.rend(),
                           [&](const WrittenWord& w) { return w.span.begin <= offset && offset <= w.span.end; });
  if (word == line.rend()) return std::nullopt;
  // With M98 or M99 as the first word, LinuxCNC reads the others in another way.
  const std::optional<int> first = number_of(line.front());
  const bool fanuc = line.front().letter == 'm' && (first == code::kM98 || first == code::kM99);
  if (fanuc && word->span.begin != line.front().span.begin) return std::nullopt;
  const std::optional<int> number = number_of(*word);
  const bool is_code = word->letter == 'g' || word->letter == 'm';
  if (is_code && word->value && !number) return std::nullopt;  // refused, as a finding says
  std::string text =
      number ? code_help(word->letter, *number, profile) : letter_help(*word_row(word->letter), line, profile);
  if (text.empty()) return std::nullopt;
  return WordHelp{std::move(text), word->span};
}

}  // namespace owlint::lsp
