#include "rules/driver/codes_page.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "rules/driver/code_facts.h"
#include "rules/driver/words.h"

namespace owlint {
namespace {

constexpr std::string_view kAbove = R"(# Codes and words

Generated from the table by which owlint reads a line (`analyzer/syntax/codes.def`). Measured with LinuxCNC's interpreter. A number such as
2.10 beside a code or a word is the release that added it.

A line may have one code of each group, and at most four M codes ([OW706](rules/OW706.md)). A word needs a code on its line that takes it
([OW707](rules/OW707.md)); a motion in effect from an earlier line counts too, if the line moves. The words that a code needs must be on
its own line ([OW708](rules/OW708.md)). `F`, `S` and `T` need no code; the table leaves them out.

Arcs also need `I`, `J`, `K` or `R` ([OW903](rules/OW903.md)). Drilling cycles also need `R` and a depth, G73 and G83 `Q`, G82 and G89 `P`,
unless the same cycle on the line before has given them ([OW904](rules/OW904.md)).

*Axes* are `X Y Z A B C U V W`, as far as the machine has them, and `@` and `^` with a motion. The drilling cycles (G73,
G74, G81 to G89) refuse `A`, `B` and `C`; G33 and G33.1 refuse `F`.
)";

constexpr std::string_view kBelow = R"(
M98 is a code only as the first word of its line.
)";

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : ", ").append(word);
  return text;
}

}  // namespace

std::string codes_page() {
  std::string out(kAbove);
  out += "\n## G codes\n\n| code | group | what it does | takes | needs | since |\n|---|---|---|---|---|---|\n";
  // Pointers, as a code is known by its place in the table.
  std::vector<const GCode*> g;
  for (const GCode& code : g_codes()) g.push_back(&code);
  std::ranges::sort(g, {}, &GCode::tenths);
  for (const GCode* code : g) {
    out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", g_name(code->tenths), rules::group_text(code->group),
                       code->title, joined(rules::words_taken(*code)), joined(rules::words_needed(*code)),
                       rules::since_text(code->since));
  }
  out += "\n## M codes\n\n| code | group | what it does | takes |\n|---|---|---|---|\n";
  std::vector<const MCode*> m;
  for (const MCode& code : m_codes()) m.push_back(&code);
  std::ranges::sort(m, {}, &MCode::number);
  for (const MCode* code : m) {
    const std::string name = code->group == MGroup::kUser ? "M100 to M199" : m_name(code->number);
    out += fmt::format("| {} | {} | {} | {} |\n", name, rules::group_text(code->group), code->title,
                       joined(rules::words_taken(*code)));
  }
  out += kBelow;
  out += "\n## Words\n\n| word | what it is | number | least | twice on a line |\n|---|---|---|---|---|\n";
  for (const WordRow& word : word_rows()) {
    out += fmt::format("| {} | {} | {} | {} | {} |\n", rules::capital(word.letter), word.title,
                       rules::number_text(word.number), word.below == nullptr ? "" : fmt::format("{}", word.least),
                       rules::twice_text(word));
  }
  return out;
}

}  // namespace owlint
