#include "rules/driver/codes_page.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "rules/driver/words.h"

namespace owlint {
namespace {

constexpr std::string_view kAbove = R"(# Codes and words

Generated from the table by which owlint reads a line (`analyzer/syntax/codes.def`). Measured with LinuxCNC's interpreter; what later
releases add has their number behind it.

A line has one code of each group and four M codes at most; [OW706](rules/OW706.md) reports others. A word must stand with a code that
takes it ([OW707](rules/OW707.md)); a motion in effect from a line before counts, if the line moves. Every code has the words that it
needs on its own line ([OW708](rules/OW708.md)). `F`, `S` and `T` may stand with any code, and alone; the table leaves them out.

Axes are `X Y Z A B C U V W` as far as the machine has them, and `@` and `^` with a motion. The drilling cycles (G73, G74, G81 to G89)
refuse `A`, `B` and `C`; G33 and G33.1 refuse `F`.
)";

constexpr std::string_view kBelow = R"(
M98 is a code only as the first word of its line.
)";

std::string_view since_text(Release since) {
  constexpr std::array<std::string_view, kReleases> kTexts = {"", "2.9", "2.9.9", "2.10"};
  return kTexts[static_cast<size_t>(since)];
}

std::string_view group_text(GGroup group) {
  switch (group) {
    case GGroup::kNonModal: return "this line only";
    case GGroup::kMotion: return "motion";
    case GGroup::kPlane: return "plane";
    case GGroup::kDistance: return "distance mode";
    case GGroup::kArcDistance: return "arc distance mode";
    case GGroup::kFeedMode: return "feed mode";
    case GGroup::kUnits: return "units";
    case GGroup::kCutterCompensation: return "cutter compensation";
    case GGroup::kToolLength: return "tool length";
    case GGroup::kRetract: return "cycle retract";
    case GGroup::kCoordinateSystem: return "coordinate system";
    case GGroup::kPathControl: return "path control";
    case GGroup::kSpindleMode: return "spindle mode";
    case GGroup::kDiameter: return "lathe diameter";
    case GGroup::kOffsets: return "G92 offset";
  }
  return "";
}

std::string_view group_text(MGroup group) {
  switch (group) {
    case MGroup::kStop: return "stop";
    case MGroup::kInputsOutputs: return "inputs and outputs";
    case MGroup::kToolChange: return "tool change";
    case MGroup::kSpindle: return "spindle, saved modes";
    case MGroup::kCoolant: return "coolant";
    case MGroup::kOverrides: return "overrides";
    case MGroup::kUser: return "the machine's own";
    case MGroup::kCall: return "call";
  }
  return "";
}

std::string_view number_text(NumberKind kind) {
  switch (kind) {
    case NumberKind::kReal: return "real";
    case NumberKind::kInteger: return "whole";
    case NumberKind::kTruncated: return "whole, decimals are cut off";
    case NumberKind::kTenths: return "one decimal";
  }
  return "";
}

/// The capital letters of a set, in the order of the words' rows.
std::vector<std::string> letters_of(uint32_t set) {
  std::vector<std::string> letters;
  for (const WordRow& row : word_rows()) {
    if ((set & letter_set({&row.letter, 1})) != 0) letters.push_back(rules::capital(row.letter));
  }
  return letters;
}

/// The letters that a code takes in a release, axis words aside.
uint32_t taken(const CodeSet& code, Release release) {
  uint32_t letters = 0;
  for (const LineCheck& check : line_checks(release)) {
    const bool unused = check.kind == LineCheck::kUnused || check.kind == LineCheck::kUnusedUnlessMinusOne;
    if (unused && code.meets(check.codes)) letters |= check.letters;
  }
  return letters;
}

void add(std::string& list, std::string_view item) { list.append(list.empty() ? "" : " ").append(item); }

/// `axes I J K D (2.10)`. `first`: the first release that has the code.
std::string takes(const CodeSet& code, bool axes, Release first) {
  std::string text = axes ? "axes" : "";
  const uint32_t at_first = taken(code, first);
  for (const std::string& letter : letters_of(at_first)) add(text, letter);
  uint32_t known = at_first;
  for (size_t r = static_cast<size_t>(first) + 1; r < kReleases; ++r) {
    const auto release = static_cast<Release>(r);
    const uint32_t more = taken(code, release) & ~known;
    for (const std::string& letter : letters_of(more)) add(text, fmt::format("{} ({})", letter, since_text(release)));
    known |= more;
  }
  return text;
}

/// What the table's last rows say; they are the same in all releases.
std::string needs(const CodeSet& code) {
  std::string text;
  for (const LineCheck& check : line_checks(Release::k2_10)) {
    if (check.kind != LineCheck::kMissing || !code.meets(check.codes)) continue;
    for (const std::string& letter : letters_of(check.letters)) add(text, letter);
  }
  return text;
}

// The checks of group 0 are no rows of the table.
bool takes_axes(const GCode& g) {
  if (g.motion != Motion::kNone) return g.tenths != code::kG80;
  switch (g.tenths) {
    case code::kG10:
    case code::kG28:
    case code::kG30:
    case code::kG43_1:
    case code::kG43_2:
    case code::kG52:
    case code::kG92: return true;
    default: return false;
  }
}

std::string needs(const GCode& g) {
  const bool axis = g.axes == GCode::kNeeded || g.tenths == code::kG52 || g.tenths == code::kG92;
  std::string text = axis ? "an axis" : "";
  if (g.tenths == code::kG4) add(text, "P");
  if (g.tenths == code::kG10) add(text, "L");
  if (g.tenths == code::kG53) add(text, "G0 or G1");
  const std::string rows = needs(set_of(g));
  if (!rows.empty()) add(text, rows);
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
    out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", g_name(code->tenths), group_text(code->group), code->title,
                       takes(set_of(*code), takes_axes(*code), code->since), needs(*code), since_text(code->since));
  }
  out += "\n## M codes\n\n| code | group | what it does | takes |\n|---|---|---|---|\n";
  std::vector<const MCode*> m;
  for (const MCode& code : m_codes()) m.push_back(&code);
  std::ranges::sort(m, {}, &MCode::number);
  for (const MCode* code : m) {
    const std::string name = code->group == MGroup::kUser ? "M100 to M199" : m_name(code->number);
    const std::string words = code->group == MGroup::kCall ? "P L" : takes(set_of(*code), false, Release::k2_8);
    out += fmt::format("| {} | {} | {} | {} |\n", name, group_text(code->group), code->title, words);
  }
  out += kBelow;
  out += "\n## Words\n\n| word | what it is | number | least | twice on a line |\n|---|---|---|---|---|\n";
  for (const WordRow& word : word_rows()) {
    const std::string_view twice = word.repeated == WordRow::kStops ? "stops"
        : word.repeated == WordRow::kAboveMinusOne                  ? "stops if the first is above -1"
        : word.letter == 'g' || word.letter == 'm'                  ? "codes of different groups"
                                                                    : "the last counts";
    out +=
        fmt::format("| {} | {} | {} | {} | {} |\n", rules::capital(word.letter), word.title, number_text(word.number),
                    word.below == nullptr ? std::string() : fmt::format("{}", word.least), twice);
  }
  return out;
}

}  // namespace owlint
