// OW807 state-stack: M72 without M70 or M73, modes that cannot be restored, or words that M72 loses.
// Depends on: what M70 and M73 save belongs to the call in which they run, M71 discards it. To restore it, LinuxCNC runs a line
// that it makes of what differs; the end of a sub with M73 restores, too.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "rules/driver/modes.h"

namespace owlint::rules::ow807 {
namespace {

constexpr std::string_view kFailed = "restore_settings";

/// The line that LinuxCNC makes, and what it stops with, from `M7x: restore_settings failed executing: ' G96': S word …`.
std::pair<std::string, std::string> line_and_message(const std::string& said) {
  const size_t from = said.find('\'');
  const size_t to = said.find("': ");
  if (from == std::string::npos || to == std::string::npos || to <= from) return {"", said};
  std::string line = said.substr(from + 1, to - from - 1);
  line.erase(0, line.find_first_not_of(' '));
  return {line, said.substr(to + 3)};
}

std::string_view remedy(std::string_view message) {
  if (message.starts_with("S word missing"))
    return "switch back with `G96` and `S` before the modes are restored, or save them in `G97`";
  if (message.find("cutter radius comp") != std::string_view::npos)
    return "save and restore the modes with cutter compensation off: write `G40` before both";
  return "set these modes back by hand before they are restored";
}

/// Whether a word acts behind M72: coolant, overrides, the machine's own codes, most G codes, moves and stops.
bool acts_behind(const WrittenWord& word) {
  constexpr std::string_view kAxisWords = "xyzabcuvw@^";
  if (word.letter != 'g' && word.letter != 'm') return kAxisWords.find(word.letter) != std::string_view::npos;
  if (!word.value) return true;
  constexpr int kUserFirst = 100;
  const int number = static_cast<int>(std::lround(*word.value));
  if (word.letter == 'g') return number < 93 || number > 97;  // feed and spindle modes act before
  const MCode* const code = m_code(number);
  if (code == nullptr) return number >= kUserFirst;
  return code->group == MGroup::kCoolant || code->group == MGroup::kOverrides || code->group == MGroup::kStop;
}

/// What stands on a line with M72 and acts behind it does nothing where M72 restores something.
void check_lost(const Input& in, StatementId id, Reporter& out) {
  const Statement& s = in.program.at(id);
  const Source& source = *in.program.source;
  const std::vector<WrittenWord> line = words_of(source, s.whole());
  if (find_word(line, "M72") == nullptr) return;
  const auto first = std::ranges::find_if(line, acts_behind);
  if (first == line.end()) return;
  const auto last = std::find_if(line.rbegin(), line.rend(), acts_behind);
  const Span span{first->span.begin, last->span.end};
  Finding& f = out.add(span,
                       "`" + std::string(source.slice(span)) +
                           "` does nothing where `M72` restores a mode: then LinuxCNC drops " +
                           "what acts behind it on its line");
  f.help = "write it on a line of its own, below `M72`";
}

void check(const Input& in, Reporter& out) {
  for (StatementId id = 0; id < in.program.size(); ++id) {
    const bool runs = in.program.at(id).kind == LineKind::kModeLine && in.flow.executed[id] && !has_stop(in, id);
    if (runs) check_lost(in, id, out);
  }
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const WordStop at = word_stop(in, stop, "M72");
    Finding& f = out.add(at.span, "");
    const bool m72 = find_word(at.line, "M72") != nullptr;
    if (stop.interpreter.find(kFailed) == std::string::npos) {
      f.message = "`M72` restores modes, but nothing has saved them";
      f.help = "write `M70` before the modes change, in the same sub as `M72`";
      relate_setter(in, f, setter_of(in, stop, "M71", false), "discards what was saved");
      return &f;
    }
    const auto [line, message] = line_and_message(stop.interpreter);
    f.message = (m72 ? "`M72` cannot restore" : "the end of the sub cannot restore") + std::string(" what ") +
        (m72 ? "was" : "`M73` has") + " saved" +
        (line.empty() ? "" : fmt::format(": to do that, LinuxCNC runs `{}`, and stops", line));
    f.help = remedy(message);
    relate_setter(in, f, setter_of(in, stop, "M70 M73", false), "saves the modes here");
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW807",
    .name = "state-stack",
    .summary = "`M72` without `M70` or `M73`, modes that cannot be restored, or words that `M72` loses",
    .group = Group::kModes,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(`M72` when no `M70` or `M73` has saved the modes, or when `M71` has discarded them. Also `M72`, or the end
of a sub with `M73`, when LinuxCNC cannot restore the saved modes. Also a move, `M2` or another word on the
line of an `M72`, which LinuxCNC then ignores.)",
            .why =
                R"(What `M70` and `M73` save belongs to the current call: a sub cannot restore what its caller has saved, and
what the sub has saved is gone when it ends. LinuxCNC stops with `Cannot restore context from invalid
stack frame - missing M70/M73?`.

To restore the modes, LinuxCNC writes the codes for all differences on one line and runs it. If that
is `G96` without `S`, or a plane while cutter compensation is on, it stops with
`M7x: restore_settings failed executing: …`. If anything was restored, LinuxCNC drops what acts behind
`M72` on its line, without a message: coolant, G codes, moves, even `M2`. The motion (`G0`, `G1`) is not
restored.)",
            .bad = R"(G21 G90
o100 sub
  G91 G0 X1
  M72
o100 endsub
M70
o100 call
M2
)",
            .good = R"(G21 G90
o100 sub
  M70
  G91 G0 X1
  M72
o100 endsub
o100 call
M2
)",
            .fix =
                R"(Save and restore in the same sub. `M73` at the start of a sub saves, and restores by itself at its end. Write what
comes after `M72` on a line of its own.)",
            .level_reason = "Error if a run gets here with nothing saved: the program stops. Warning for words that "
                            "`M72` drops. Warning if it stops at an earlier line first.",
            .interpreter = "Cannot restore context from invalid stack frame - missing M70/M73?",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow807
