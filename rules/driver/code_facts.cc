#include "rules/driver/code_facts.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "rules/driver/words.h"

namespace owlint::rules {
namespace {

constexpr std::string_view kAxes = "axes";
constexpr std::string_view kAnAxis = "an axis";

/// The capital letters of a set, in the order of the words' rows.
std::vector<std::string> letters_of(uint32_t set) {
  std::vector<std::string> letters;
  for (const WordRow& row : word_rows()) {
    if ((set & letter_set({&row.letter, 1})) != 0) letters.push_back(capital(row.letter));
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

/// `first`: the first release that has the code.
std::vector<std::string> taken_since(const CodeSet& code, Release first) {
  uint32_t known = taken(code, first);
  std::vector<std::string> words = letters_of(known);
  for (size_t r = static_cast<size_t>(first) + 1; r < kReleases; ++r) {
    const auto release = static_cast<Release>(r);
    const uint32_t more = taken(code, release) & ~known;
    for (const std::string& letter : letters_of(more))
      words.push_back(fmt::format("{} ({})", letter, since_text(release)));
    known |= more;
  }
  return words;
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

}  // namespace

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

std::string_view twice_text(const WordRow& word) {
  if (word.repeated == WordRow::kStops) return "stops";
  if (word.repeated == WordRow::kAboveMinusOne) return "stops if the first is above -1";
  return word.letter == 'g' || word.letter == 'm' ? "codes of different groups" : "the last counts";
}

std::vector<std::string> words_taken(const GCode& code) {
  std::vector<std::string> words = taken_since(set_of(code), code.since);
  if (takes_axes(code)) words.insert(words.begin(), std::string(kAxes));
  return words;
}

std::vector<std::string> words_taken(const MCode& code) {
  if (code.group == MGroup::kCall) return {"P", "L"};
  return taken_since(set_of(code), Release::k2_8);
}

std::vector<std::string> words_needed(const GCode& g) {
  std::vector<std::string> words;
  if (g.axes == GCode::kNeeded || g.tenths == code::kG52 || g.tenths == code::kG92) words.emplace_back(kAnAxis);
  if (g.tenths == code::kG4) words.emplace_back("P");
  if (g.tenths == code::kG10) words.emplace_back("L");
  if (g.tenths == code::kG53) words.emplace_back("G0 or G1");
  // What the table's last rows say; they are the same in all releases.
  for (const LineCheck& check : line_checks(Release::k2_10)) {
    if (check.kind != LineCheck::kMissing || !set_of(g).meets(check.codes)) continue;
    for (std::string& letter : letters_of(check.letters)) words.push_back(std::move(letter));
  }
  return words;
}

std::vector<std::string> words_refused(const GCode& code) {
  std::vector<std::string> words;
  for (const LineCheck& check : line_checks(Release::k2_10)) {
    if (check.kind != LineCheck::kRefused || !check.also.empty() || !set_of(code).meets(check.codes)) continue;
    for (std::string& letter : letters_of(check.letters)) words.push_back(std::move(letter));
  }
  return words;
}

CodeSet codes_taking(char letter, Release release) {
  const uint32_t wanted = letter_set({&letter, 1});
  CodeSet codes;
  if ((wanted & kAxisLetters) != 0) {
    for (const GCode& code : g_codes()) {
      if (code.motion == Motion::kNone && takes_axes(code)) codes = codes | set_of(code);
    }
  }
  for (const LineCheck& check : line_checks(release)) {
    const bool unused = check.kind == LineCheck::kUnused || check.kind == LineCheck::kUnusedUnlessMinusOne;
    if (unused && (check.letters & wanted) != 0) codes = codes | check.codes;
  }
  return codes;
}

CodeSet codes_needing(char letter, Release release) {
  CodeSet codes;
  for (const GCode& code : g_codes()) {
    if (code.since > release) continue;
    const std::vector<std::string> words = words_needed(code);
    if (std::ranges::find(words, capital(letter)) != words.end()) codes = codes | set_of(code);
  }
  return codes;
}

std::string user_code_text(int number, const MachineSetup* setup) {
  const std::string runs = fmt::format("`{0}` runs a program of the machine named `{0}`", m_name(number));
  if (setup == nullptr) return runs + "; without the machine's INI, owlint cannot look for it";
  switch (setup->user_code(number)) {
    case UserCode::kThere: return runs + ", and this machine has it";
    case UserCode::kMissing: return runs + ", and this machine has none";
    case UserCode::kUnknown: return runs + "; the folders for it are not here";
  }
  return runs;
}

}  // namespace owlint::rules
