// Depends on (measured): what an operator runs as an MDI command finds the modes that are in effect, and no local names.
#include "rules/driver/ini_commands.h"

#include <algorithm>
#include <cctype>

#include "analyzer/text/memory_files.h"
#include "analyzer/text/paths.h"
#include "rules/driver/lint.h"

namespace owlint::rules {
namespace {

/// A call of nobody knows what, whose number is an answer of the machine: behind it any modes may be in effect, and any global
/// parameter may have any value.
constexpr std::string_view kAnything = "O#5399 call\n";

/// The machine before its start-up code has run.
std::shared_ptr<const MachineSetup> without_startup(const SetupInput& in) {
  constexpr std::string_view kKey = "RS274NGC_STARTUP_CODE", kOther = "RS274NGC_STARTUP_DONE";
  static_assert(kKey.size() == kOther.size());
  const UnsavedFiles files(in.library.files(), [&](const std::string& path) -> std::shared_ptr<const Source> {
    std::string error;
    const auto source = in.library.files().read(path, &error);
    if (source == nullptr) return nullptr;
    std::string bytes(source->bytes());
    for (size_t at = bytes.find(kKey); at != std::string::npos; at = bytes.find(kKey, at))
      bytes.replace(at, kKey.size(), kOther);
    return Source::own(path, std::move(bytes));
  });
  auto setup = std::make_shared<MachineSetup>(in.setup);
  setup->ini = Ini();
  std::string error;
  setup->ini.read(files, in.setup.path, &error);
  return setup;
}

void replace_line_number(std::string& message, bool behind_anything) {
  if (behind_anything && message.starts_with("2: ")) message[0] = '0';
  constexpr std::string_view kFrom = "from line: ";
  const size_t at = message.rfind(kFrom);
  if (at != std::string::npos && at + kFrom.size() + 1 == message.size()) message.back() = '0';
}

/// A line of its own has no program that could have the sub.
void say_nowhere(CommandStop& stop) {
  constexpr std::string_view kWords = " in this program, and no file";
  const size_t at = stop.message.find(kWords);
  if (at != std::string::npos) stop.message.replace(at, kWords.size(), ": there is no file");
  stop.help = "put the file into a folder of `SUBROUTINE_PATH`, or correct the name";
  stop.interpreter = "File not open";
}

ProgramReport run_alone(const SetupInput& in, const std::string& text, RunsAt when) {
  const auto source = Source::own(joined_path(folder_of(in.setup.path), "command in the INI"), text + "\nM2\n");
  Profile profile = in.profile;
  profile.feature = 0;
  if (when == RunsAt::kStart) profile.setup = without_startup(in);
  return lint(in.library.load(source, profile), profile, {}, in.library);
}

bool stops_each_run(const Finding& f) {
  return f.stops && f.reach == Reach::kAlways && !f.unproven && !f.uncertain && f.block_delete.empty();
}

/// A global name that nothing has set: measured, no program has run before the start-up code. Python may have.
bool lacks_global(const SetupInput& in, const Finding& f) {
  return f.code == "OW603" && f.stops && f.reach == Reach::kAlways && !in.profile.may_be_python() &&
      f.interpreter.find("#<_") != std::string::npos && f.interpreter.find("#<_hal") == std::string::npos;
}

class SureLines {
 public:
  SureLines(const SetupInput& in, std::vector<CommandRuns::SubLine>& out) : in_(in), out_(out) {}

  /// False if it is not known what comes behind the call.
  bool call(const std::string& sub, int depth) {
    constexpr int kDeepest = 9;
    constexpr size_t kMost = 1000;
    const auto found = in_.setup.search_path->find(sub);
    if (!found || depth > kDeepest) return false;
    const std::shared_ptr<const Program> program = in_.library.load_called(found->path, in_.profile);
    const RegionId region = program->find_sub(sub);
    if (region == kNoRegion) return false;
    for (StatementId id = program->regions[region].opener + 1; id < program->size() && out_.size() < kMost; ++id) {
      const Statement& s = program->at(id);
      if (s.is(Keyword::kEndsub)) return true;
      const std::string code = bare_code(program->source->slice(s.whole()));
      if (s.kind == LineKind::kOWord) {
        if (!s.is(Keyword::kCall) || s.label == kNoName || !call(program->name(s.label), depth + 1)) return false;
        continue;
      }
      if (!code.starts_with('/')) out_.push_back({code, {s.whole(), "in this sub", program->source}});
    }
    return false;
  }

 private:
  const SetupInput& in_;
  std::vector<CommandRuns::SubLine>& out_;
};

}  // namespace

std::string bare_code(std::string_view code) {
  std::string out;
  bool inside = false;
  for (const char c : code) {
    if (c == ';' && !inside) break;
    inside = c == '(' || (inside && c != ')');
    if (!inside && c != ')' && c != ' ' && c != '\t')
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return out;
}

bool has_code(std::string_view line, char letter, int number) {
  for (size_t at = line.find(letter); at != std::string_view::npos; at = line.find(letter, at + 1)) {
    if (at > 0 && (std::isalpha(static_cast<unsigned char>(line[at - 1])) != 0 || line[at - 1] == '<')) continue;
    size_t end = at + 1;
    int value = 0;
    while (end < line.size() && line[end] >= '0' && line[end] <= '9' && value < 1000)
      value = value * 10 + (line[end++] - '0');
    if (end > at + 1 && value == number) return true;
  }
  return false;
}

std::vector<CommandStop> CommandRuns::stops(const std::string& code, RunsAt when, bool missing_subs) const {
  const std::string before(when == RunsAt::kAny ? kAnything : std::string_view());
  ProgramReport report = run_alone(in_, before + code, when);
  std::vector<CommandStop> out;
  const auto add = [&](Finding& f) -> CommandStop& {
    CommandStop& stop = out.emplace_back();
    stop.code = f.code;
    stop.message = std::move(f.message);
    stop.help = std::move(f.help);
    stop.interpreter = std::move(f.interpreter);
    replace_line_number(stop.interpreter, when == RunsAt::kAny);
    return stop;
  };
  for (Finding& f : report.own.findings) {
    const bool at_start = when == RunsAt::kStart && lacks_global(in_, f);
    if ((!stops_each_run(f) && !at_start) || f.span.begin < before.size() || f.span.begin > before.size() + code.size())
      continue;
    if (!missing_subs && (f.code == "OW208" || f.code == "OW402")) continue;
    // Behind a first call it is no error any more.
    if (when == RunsAt::kAny && f.code == "OW101" && f.interpreter != "Not in subroutine definition") continue;
    const Span span{f.span.begin - before.size(), f.span.end - before.size()};
    CommandStop& stop = add(f);
    stop.span = span;
    if (stop.code == "OW208") say_nowhere(stop);
  }
  if (!out.empty()) return out;
  for (FileReport& called : report.called) {
    for (Finding& f : called.findings) {
      if (!stops_each_run(f) && (when != RunsAt::kStart || !lacks_global(in_, f))) continue;
      const Span place = f.span;
      CommandStop& stop = add(f);
      stop.span = {0, code.size()};
      stop.in_sub = true;
      stop.related.push_back({place, "the sub stops here", called.source});
    }
  }
  return out;
}

std::vector<CommandStop> CommandRuns::beyond_limits(const std::string& code) const {
  const std::string bare = bare_code(code);
  std::vector<CommandStop> out;
  // `G53` needs no offsets. In inches each end is further away, in millimetres on a machine in inches it is not.
  const Ini::Entry* const units = in_.setup.ini.find("TRAJ", "LINEAR_UNITS");
  const bool metric =
      units != nullptr && (small_letters(units->value) == "mm" || small_letters(units->value) == "metric");
  if (!has_code(bare, 'G', 53) || (!metric && !has_code(bare, 'G', 20) && !has_code(bare, 'G', 21))) return out;
  for (Finding& f : run_alone(in_, code, RunsAt::kAny).own.findings) {
    if (f.code != "OW907" || !stops_each_run(f) || f.span.end > code.size()) continue;
    CommandStop& stop = out.emplace_back();
    stop.code = f.code;
    stop.span = f.span;
    stop.message = std::move(f.message);
    stop.help = std::move(f.help);
    stop.interpreter = std::move(f.interpreter);
    stop.related = std::move(f.related);
    constexpr std::string_view kLine = " on line 1 ";
    const size_t at = stop.interpreter.find(kLine);
    if (at != std::string::npos) stop.interpreter.replace(at, kLine.size(), " on line 0 ");  // measured, of MDI
  }
  return out;
}

std::vector<Finding> CommandRuns::unpassed(const std::string& sub, size_t values) const {
  std::string call = std::string(kAnything) + "o<" + sub + "> call";
  for (size_t i = 0; i < values; ++i) call += " [#4998]";
  std::vector<Finding> findings = run_alone(in_, call, RunsAt::kAny).own.findings;
  std::erase_if(findings, [](const Finding& f) { return f.code != "OW507"; });
  return findings;
}

std::vector<CommandRuns::SubLine> CommandRuns::lines_in_subs(const std::string& code) const {
  std::vector<SubLine> out;
  SureLines lines(in_, out);
  for (const std::string& sub : called_names(code)) {
    if (!lines.call(sub, 1)) break;
  }
  return out;
}

}  // namespace owlint::rules
