// OW806 tool-missing: a tool that is not in the tool table, or no tool selected.
// Depends on: T, Q of M61, D of G41 and G42, H of G43 and G43.2, P of G10 L1, L10 and L11 are looked up in the tool table, in
// this order. T0, D0 and H0 always are there. G43.2 with axis words looks up tool -1 before 2.10.
#include <cmath>

#include <fmt/format.h>

#include "rules/driver/ini_places.h"
#include "rules/driver/modes.h"

namespace owlint::rules::ow806 {
namespace {

constexpr std::string_view kNotFound = "Requested tool ";

/// The word with which a line asks for a tool: the first that may mean it.
const WrittenWord* asking(const std::vector<WrittenWord>& line, const std::string& number) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"T", "T"}, {"M61", "Q"}, {"G41 G42", "D"}, {"G43 G43.2", "H"}, {"G10", "P"}};
  for (const auto& [codes, letter] : kWords) {
    if (find_word(line, codes) == nullptr) continue;
    const WrittenWord* word = find_word(line, letter);
    if (word != nullptr && (!word->value || std::to_string(std::lround(*word->value)) == number)) return word;
  }
  return nullptr;
}

/// `T0101`: on Fanuc lathes the tool and its offset.
void tell_tool_and_offset(std::string_view word, Finding& f) {
  constexpr size_t kDigits = 4;
  const std::string_view digits = word.substr(1);
  if (digits.size() != kDigits || digits.find_first_not_of("0123456789") != std::string_view::npos ||
      (digits[0] != '0' && digits.substr(0, 2) != digits.substr(2)))
    return;
  const auto number = [](std::string_view two) { return std::string(two.substr(two[0] == '0' ? 1 : 0)); };
  const std::string tool = number(digits.substr(0, 2));
  const std::string offset = number(digits.substr(2));
  f.help = fmt::format("on Fanuc lathes this is tool {} with offset {}: write `T{} M6`, and `{}`", tool, offset, tool,
                       offset == "0" ? "G49" : "G43 H" + offset);
}

void not_found(const Source& source, const std::string& number, const WordStop& at, Finding& f) {
  const WrittenWord* word = asking(at.line, number);
  if (word == nullptr && number == "-1" && find_word(at.line, "G43.2") != nullptr) {
    f.message = "`G43.2` with axis words stops: before version 2.10, LinuxCNC looks for tool -1";
    f.help = "write `G43.1` and the sum of the offsets, or `G43.2` with the tool as `H`";
    return;
  }
  f.help = "add the tool to the tool table, or write the number of a tool in the table";
  if (word == nullptr) {
    f.message = "this line needs tool " + number + ", which is not in the tool table";
    return;
  }
  f.span = word->span;
  f.message = "`" + shown(source, word->span) + "` " +
      (word->value ? "is not in the tool table" : "means tool " + number + ", which is not in the tool table");
  if (word->letter == 't') tell_tool_and_offset(source.slice(word->span), f);
  if (word->letter == 'h' && number == "-1") f.help = "write the tool's number, or no `H` for the tool in the spindle";
}

/// The table, and the line of the INI that names it.
void relate_table(const Profile& profile, Finding& f) {
  if (profile.setup == nullptr) return;
  const Ini::Entry* const key = profile.setup->ini.find("EMCIO", "TOOL_TABLE");
  if (key != nullptr && !key->value.empty()) relate_ini(f, *key, "the tool table is named here");
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const WordStop at = word_stop(in, stop, "M6 G43 G43.2 G41 G42 M61 G10 T");
    Finding& f = out.add(at.span, "");
    const std::string& said = stop.interpreter;
    if (said.starts_with(kNotFound)) {
      not_found(*in.program.source, said.substr(kNotFound.size(), said.find(' ', kNotFound.size()) - kNotFound.size()),
                at, f);
      relate_table(in.profile, f);
    } else {
      f.message = subject(at) + " changes the tool, but no `T` has selected one";
      f.help = "write `T` and the tool's number on this line or before it";
    }
    relate_setter(in, f, setter_of(in, stop, "T M6 M61", false), "is here");
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW806",
    .name = "tool-missing",
    .summary = "a tool that is not in the tool table, or no tool selected",
    .group = Group::kModes,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A tool number that the machine's tool table does not have: `T`, `H` of `G43`, `D` of `G41` and `G42`, `Q`
of `M61`, `P` of `G10 L1`. `G43.2` with axis words, which always looks for tool -1 before version 2.10.)",
            .why =
                R"(LinuxCNC stops with `Requested tool N not found in the tool table`. `T` alone does so, without `M6`. The
number 0 of `T`, `D` and `H` means the spindle and is always there; -1 never is.

The tools depend on the machine. Without its INI, owlint reports only numbers that no tool table can have.)",
            .bad = R"(G21 G90
T1 M6
G43 H1
G43.2 Z0.5
G0 X10 Y10 Z5
M2
)",
            .good = R"(G21 G90
T1 M6
G43 H1
G43.2 H2
G0 X10 Y10 Z5
M2
)",
            .fix =
                R"(Write the number of a tool in the tool table, or add the tool to the table. An offset for wear can be an
entry of its own, for `G43.2 H`.)",
            .level_reason =
                "Error if a run gets here: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "Requested tool -1 not found in the tool table",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow806
