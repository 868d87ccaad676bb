// OW417 remap-never-called: a REMAP of a code that LinuxCNC never hands over to the sub.
// Depends on: which codes the interpreter hands over (measured for each kind with `rs274 -i`).
#include <algorithm>
#include <array>

#include "rules/driver/remap_rules.h"

namespace owlint::rules::ow417 {
namespace {

constexpr std::array kBuiltInM{2, 3, 4, 5, 7, 8, 19, 30, 48, 49, 50, 51, 52, 53, 70, 71, 72, 73, 98, 99};
/// The modal groups of those that have one in which a REMAP is possible.
constexpr std::array<std::pair<int, int>, 17> kGroups{{{2, 4},
                                                       {30, 4},
                                                       {3, 7},
                                                       {4, 7},
                                                       {5, 7},
                                                       {19, 7},
                                                       {7, 8},
                                                       {8, 8},
                                                       {48, 9},
                                                       {49, 9},
                                                       {50, 9},
                                                       {51, 9},
                                                       {52, 9},
                                                       {53, 9},
                                                       {99, 4},
                                                       {70, 5},
                                                       {73, 5}}};

constexpr int kFirstUserCode = 100;
constexpr int kLastUserCode = 199;
constexpr int kLastMCode = 999;

/// Built-in G codes that are no motion, ten times.
constexpr std::array kOtherG{40,  70,  80,  100, 170, 171, 180, 181, 190, 191, 200, 210, 280, 281, 300, 301, 400, 410,
                             411, 420, 421, 430, 431, 432, 490, 530, 540, 550, 560, 570, 580, 590, 591, 592, 593, 610,
                             611, 640, 900, 901, 910, 911, 920, 921, 922, 923, 930, 940, 950, 960, 970, 980, 990};

template <typename List>
bool has(const List& list, int number) {
  return std::ranges::find(list, number) != list.end();
}

std::string of_m_code(const RemapLine& remap, const std::string& code, bool strict) {
  const int number = remap.m_number();
  if (number < 0) return "LinuxCNC never uses this remap: a program cannot write a code such as " + code;
  if (strict && (number == 7 || number == 8)) return {};
  const bool user = number >= kFirstUserCode && number <= kLastUserCode;
  if (!has(kBuiltInM, number) && !user && number <= kLastMCode) return {};
  const int group = remap.group.value_or(-1) == -1 ? 10 : *remap.group;
  if (number > kLastMCode)
    return code + " is remapped, but LinuxCNC has no M codes above 999: " +
        (group == 4 || group == 10 ? "a program that uses it stops" : "in a program it does nothing");
  const auto own = std::ranges::find(kGroups, number, &std::pair<int, int>::first);
  if (number == 98 || (own != kGroups.end() && own->second == group))
    return "LinuxCNC never uses this remap: " + code + " keeps its built-in meaning";
  if (user && group == 10)
    return "LinuxCNC never uses this remap: " + code +
        " runs the program with that name, as it does without the `REMAP`";
  if (group == 4)
    return "LinuxCNC never uses this remap: " + code + " stops the program, `Bug code not m0 m1 m2 m30 m60 m99`";
  if (group == 10) return "LinuxCNC never uses this remap: " + code + " stops the program or crashes LinuxCNC";
  return "LinuxCNC never uses this remap, but because of it " + code + " no longer does anything";
}

std::string of_g_code(const RemapLine& remap, const std::string& code) {
  const int number = remap.g_number();
  constexpr int kMost = 999;
  if (number < 0) return "LinuxCNC never uses this remap: a program cannot write a code such as " + code;
  if (is_built_in_motion(number)) return "LinuxCNC never uses this remap: " + code + " keeps its built-in meaning";
  if (has(kOtherG, number))
    return "LinuxCNC never uses this remap: " + code + " stops the program, `All axes missing with motion code`";
  return number > kMost ? code + " is remapped, but a program that uses it stops with `G-code out of range`"
                        : std::string();
}

void check_setup(const SetupInput& in, Reporter& out) {
  for (const Remap& remap : remaps_of(in.setup.text)) {
    if (remap.read.problem != RemapLine::Problem::kNone || remap.earlier != nullptr) continue;
    const char letter = remap.read.letter();
    const std::string code = "`" + std::string(remap.read.code) + "`";
    std::string message;
    if (letter == 'M') {
      message = of_m_code(remap.read, code, reads_strictly(in));
    } else if (letter == 'G') {
      message = of_g_code(remap.read, code);
    } else if (letter != 'T' && letter != 'S' && letter != 'F') {
      message = "LinuxCNC cannot remap " + code + ": it remaps only M and G codes, T, S and F";
    }
    if (message.empty()) continue;
    Finding& f = add_at(in, out, *remap.line, span_in(in.setup.text, *remap.line, remap.read.code), std::move(message));
    f.help = letter == 'G' ? "remap a code that is free, such as `G88.1`" : "remap a code that is free, such as `M400`";
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW417",
    .name = "remap-never-called",
    .summary = "a REMAP that LinuxCNC never uses",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A `REMAP` of a built-in code that cannot be remapped, of a user code M100 to M199, of an M code above
999, or of a letter other than M, G, T, S and F.)",
            .why =
                R"(LinuxCNC accepts the line and gives no message, but uses the remap only for these codes: M0, M1, M6,
M9, M60 to M68 (since 2.10 also M7 and M8), M and G codes that are not built in, T, S and F. What
any other code does then depends on its `modalgroup`: in its own group it keeps its built-in
meaning, in groups 5 to 9 it does nothing (`M3` starts no spindle), and in other groups it stops the
program.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
REMAP = M3 modalgroup=7 ngc=start
; file: start.ngc
o<start> sub
  G4 P0
o<start> endsub
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
REMAP = M400 modalgroup=7 ngc=start
; file: start.ngc
o<start> sub
  G4 P0
o<start> endsub
)",
            .fix = R"(Remap a code that is free, such as M200 to M999 or G88.1, and use that in programs.)",
            .level_reason = "Warning: LinuxCNC starts, but the code does not run what the remap names.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow417
