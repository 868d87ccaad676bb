// OW417 remap-never-called: a REMAP of a code that LinuxCNC never hands over to the sub.
// Depends on: which codes the interpreter hands over (measured for each kind with `rs274 -i`).
#include <algorithm>

#include "rules/driver/remap_rules.h"
#include "rules/driver/words.h"

namespace owlint::rules::ow417 {
namespace {

constexpr int kLastMCode = 999;

bool is_user_code(int number) { return number >= code::kM100 && number < code::kM100 + 100; }

std::string of_m_code(const SetupInput& in, const Remap& remap, const std::string& code) {
  const int number = remap.read.m_number();
  if (number < 0) return "LinuxCNC never uses this remap: a program cannot write a code such as " + code;
  const std::string_view text = in.setup.text.value(*remap.line);
  const std::string never = "LinuxCNC never uses this remap";
  const std::optional<LostCode> lost = lost_code(text, release_of(in.profile));
  if (!lost) {
    const bool kept = !remapped_code(text, release_of(in.profile)).has_value();
    return kept ? never + ": " + code + " keeps its built-in meaning" : std::string();
  }
  const std::string above = number > kLastMCode ? ", as it has no M codes above 999: " : ": ";
  switch (lost->group) {
    case MGroup::kUser:
      if (is_user_code(number))
        return never + ": " + code + " runs the program with that name, as it does without the `REMAP`, but without " +
            "`P` and `Q`";
      if (number > kLastMCode)
        return never + above + code + " stops the program, `Unknown m code used: " + m_name(number) + "`";
      return never + ": " + code + " stops the program or crashes LinuxCNC";
    case MGroup::kStop: return never + above + code + " stops the program, `Bug code not m0 m1 m2 m30 m60 m99`";
    default:
      if (number > kLastMCode) return never + above + code + " does nothing";
      return never + ", but because of it " + code + " no longer does anything";
  }
}

std::string of_g_code(const SetupInput& in, const Remap& remap, const std::string& code) {
  const int number = remap.read.g_number();
  constexpr int kMost = 999;
  if (number < 0) return "LinuxCNC never uses this remap: a program cannot write a code such as " + code;
  if (is_built_in_motion(number)) return "LinuxCNC never uses this remap: " + code + " keeps its built-in meaning";
  if (lost_code(in.setup.text.value(*remap.line), release_of(in.profile)))
    return "LinuxCNC never uses this remap: " + code + " stops the program, `All axes missing with motion code`";
  return number > kMost ? code + " is remapped, but a program that uses it stops with `G-code out of range`"
                        : std::string();
}

/// Where a program uses a code that does nothing any more. Codes that stop the program are for OW705.
void check(const Input& in, Reporter& out) {
  std::vector<LostRemap> idle = lost_codes(in.profile);
  std::erase_if(idle, [](const LostRemap& lost) {
    return lost.code.letter != 'm' || lost.code.group == MGroup::kStop || lost.code.group == MGroup::kUser;
  });
  // OW315 says it of the end of the program.
  constexpr int kM2 = 2, kM30 = 30;
  if (in.index.by_code.contains("OW315"))
    std::erase_if(idle, [](const LostRemap& lost) { return lost.code.number == kM2 || lost.code.number == kM30; });
  if (idle.empty()) return;
  const Source& source = *in.program.source;
  for (uint32_t number = 1; number <= in.program.syntax.lines; ++number) {
    const Span span = source.line(number);
    const std::string_view line = source.slice(span);
    const size_t first = std::min(line.find_first_not_of(" \t/"), line.size());
    if (first == line.size() || std::string_view("oO;(%").find(line[first]) != std::string_view::npos) continue;
    if (line.find_first_of("mM", first) == std::string_view::npos) continue;
    for (const WrittenWord& word : words_of(source, span)) {
      if (word.letter != 'm' || !word.value) continue;
      const auto lost =
          std::ranges::find_if(idle, [&](const LostRemap& one) { return one.code.number == *word.value; });
      if (lost == idle.end()) continue;
      Finding& f = out.add(word.span,
                           "`" + lost->name +
                               "` does nothing: LinuxCNC cannot remap it, and because of its `REMAP` "
                               "it has lost its own meaning");
      if (lost->code.number > kLastMCode)
        f.message = "`" + lost->name + "` does nothing: LinuxCNC remaps no M codes above 999";
      blame(in.profile, *lost, f);
      f.group = "code " + lost->name;
    }
  }
}

/// `REMAP M400 modalgroup=6`: LinuxCNC looks only at the beginning of what stands before the first `=`.
bool lacks_equals(const IniText& text, const IniLine& line) {
  return text.slice(line, {line.name.end, line.value.begin}).find_first_not_of(" \t=") != std::string_view::npos;
}

void check_setup(const SetupInput& in, Reporter& out) {
  for (const Remap& remap : remaps_of(in.setup.text)) {
    if (remap.read.problem != RemapLine::Problem::kNone || remap.earlier != nullptr) continue;
    const char letter = remap.read.letter();
    const std::string code = "`" + std::string(remap.read.code) + "`";
    std::string message;
    if (letter == 'M') {
      message = of_m_code(in, remap, code);
    } else if (letter == 'G') {
      message = of_g_code(in, remap, code);
    } else if (letter != 'T' && letter != 'S' && letter != 'F') {
      message = "LinuxCNC cannot remap " + code + ": it remaps only M and G codes, T, S and F";
    }
    if (message.empty()) continue;
    Finding& f = add_at(in, out, *remap.line, span_in(in.setup.text, *remap.line, remap.read.code), std::move(message));
    if (lacks_equals(in.setup.text, *remap.line)) {
      f.message =
          "`=` is missing behind `REMAP`: LinuxCNC takes what follows the first `=`, " + code + ", for the code";
      f.help = "write `REMAP = M400 modalgroup=10 ngc=name`";
      continue;
    }
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
999, or of a letter other than M, G, T, S and F. In a program: a code that does nothing any more because
of such a line.)",
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
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow417
