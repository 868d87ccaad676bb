// OW208 call-undefined: a call of a sub that is defined nowhere.
// Depends on: an unknown sub is looked for as a file on the search path, then by reading ahead to the end of the
// file that calls it; not found is an error there.
#include <algorithm>
#include <optional>
#include <span>
#include <unordered_map>

#include "rules/driver/ini_places.h"
#include "rules/driver/machine_rules.h"
#include "rules/driver/stops.h"
#include "rules/driver/words.h"
#include "rules/driver/wrong_ends.h"

namespace owlint::rules::ow208 {
namespace {

constexpr double kMostNumber = 1e9;  // of a sub

std::string number_only(const std::string& name) {
  return name.find_first_not_of("-0123456789") == std::string::npos ? name : std::string();
}

/// `o<drill.ngc> call` of the file `drill.ngc`.
bool without_ending(const Input& in, const Statement& s, const std::string& name, Finding& f) {
  constexpr std::string_view kEnding = ".ngc";
  if (!name.ends_with(kEnding) || s.label == kNoName || !s.is(Keyword::kCall)) return false;
  const std::string meant = name.substr(0, name.size() - kEnding.size());
  const auto file = in.linked.search_path().find(meant);
  if (!file) return false;
  f.message = "the label has the ending `.ngc`: LinuxCNC looks for a file `" + name + ".ngc`";
  f.help = "write `" + label_text(meant) + " call`, which calls the sub in " + file->path;
  f.fixes.push_back({"write `" + label_text(meant) + "`", false, {{s.label_span(), label_text(meant)}}});
  return true;
}

/// `M98 P27001`, on other controllers two calls of 7001.
bool repeats_in_number(const Program& p, const Statement& s, const std::string& name, Finding& f) {
  constexpr size_t kDigits = 4;  // of the program's number
  constexpr size_t kMost = 8;
  if (s.kind != LineKind::kM98 || name.size() <= kDigits || name.size() > kMost || number_only(name).empty())
    return false;
  std::string meant = name.substr(name.size() - kDigits);
  meant.erase(0, std::min(meant.find_first_not_of('0'), meant.size() - 1));
  const NameId id = p.syntax.names.find(meant);
  if (id == kNoName || std::ranges::none_of(p.by_label[id], [&](StatementId at) { return p.at(at).opens_sub(); }))
    return false;
  const std::string right = "M98 P" + meant + " L" + name.substr(0, name.size() - kDigits);
  f.message = "no sub `" + label_text(name) + "`: LinuxCNC takes all digits after `P` for the number of the sub";
  f.help = "to call " + label_text(meant) + " several times, write `" + right + "`";
  return true;
}

/// `M98 P-7001`: no sub has such a number where that comes from.
bool has_sign(const Program& p, const Statement& s, const std::string& name, Finding& f) {
  if (s.kind != LineKind::kM98 || !name.starts_with('-') || number_only(name).empty()) return false;
  f.help = "write `M98 P" + name.substr(1) + "`";
  const NameId id = p.syntax.names.find(name.substr(1));
  const size_t sign = p.source->slice({s.offset, s.end()}).find('-');
  const bool known =
      id != kNoName && std::ranges::any_of(p.by_label[id], [&](StatementId at) { return p.at(at).opens_sub(); });
  if (known && sign != std::string_view::npos)
    f.fixes.push_back({f.help, false, {{{s.offset + sign, s.offset + sign + 1}, ""}}});
  return true;
}

/// The line that begins with `N1000` or `:1000`; empty if there is none.
Span numbered_line(const Source& source, std::string_view number) {
  const std::string_view bytes = source.bytes();
  for (size_t at = bytes.find(number); at != std::string_view::npos; at = bytes.find(number, at + 1)) {
    const size_t behind = at + number.size();
    if (at == 0 || (behind < bytes.size() && bytes[behind] >= '0' && bytes[behind] <= '9')) continue;
    const size_t sign = bytes.find_last_not_of('0', at - 1);
    if (sign == std::string_view::npos || std::string_view("nN:").find(bytes[sign]) == std::string_view::npos) continue;
    const size_t line = sign == 0 ? std::string_view::npos : bytes.find_last_not_of(" \t", sign - 1);
    if (line == std::string_view::npos || bytes[line] == '\n') return {sign, behind};
  }
  return {};
}

/// `M98 P1000` of a sub that begins with `N1000` or `:1000`, and `G71 P10 Q20` of the lines `N10` to `N20`.
bool means_line(const Input& in, const Statement& s, StatementId id, const std::string& name, Finding& f) {
  if ((s.kind != LineKind::kM98 && s.kind != LineKind::kContour) || number_only(name).empty()) return false;
  const Source& source = *in.program.source;
  if (s.kind == LineKind::kContour) {
    const std::optional<Habit> habit = habit_of(in, id);
    if (!habit) return false;
    f.message = habit->message;
    f.help = habit->help;
    return true;
  }
  const Span line = numbered_line(source, name);
  if (line.end == line.begin) return false;
  const std::string written(source.slice(line));
  f.help = written[0] == ':'
      ? "write `O" + name + "` in place of `" + written + "`"
      : "write `O" + name + "` on a line of its own before the sub: `" + written + "` is only a line number";
  f.related.push_back({line, "`" + written + "` is here", nullptr});
  return true;
}

/// `M98 P123` beside `0123.ngc`: LinuxCNC takes the zeros away before it looks for the file. And `drill.nc` in place of
/// `drill.ngc`.
bool names_file(const Input& in, const Statement& s, const std::string& name, Finding& f) {
  const Answers& path = in.linked.search_path();
  if (s.kind == LineKind::kContour) return false;
  std::string file;
  if (!number_only(name).empty()) {
    std::string zeros;
    constexpr size_t kMostZeros = 4;
    while (file.empty() && zeros.size() < kMostZeros) {
      zeros += '0';
      if (const auto found = path.find(zeros + name)) file = found->path;
    }
  }
  if (file.empty()) file = path.find_other_ending(name).value_or("");
  if (file.empty() || file == normal_path(in.program.source->path())) return false;  // the program itself lacks the sub
  f.help = "LinuxCNC looks only for `" + name + ".ngc`: rename " + file;
  return true;
}

/// A definition in another file of the run, which comes too late.
Elsewhere defined_elsewhere(const Input& in, const std::string& name) {
  for (const LinkedFile& file : in.linked.files()) {
    const Program& p = *file.program;
    for (const Region& region : p.regions) {
      if (&p != &in.program && region.opener != kNoStatement && p.name(region.name) == name) return {&p, region.opener};
    }
  }
  return {};
}

/// How a call without `P` is written: with the number of another word, as in `M98 Q7001`, if that is a sub's.
std::string call_meant(const Program& p, const Statement& s) {
  const auto begins_sub = [&](std::string_view number) {
    const NameId id = p.syntax.names.find(number);
    return id != kNoName && std::ranges::any_of(p.by_label[id], [&](StatementId at) { return p.at(at).opens_sub(); });
  };
  for (const WrittenWord& word : words_of(*p.source, s.whole())) {
    if (word.letter == 'm' || word.letter == 'l' || !word.value || *word.value < 0 || *word.value > kMostNumber)
      continue;
    const std::string number = std::to_string(static_cast<long>(*word.value));
    if (begins_sub(number)) return "M98 P" + number;
  }
  return "M98 P100";
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  constexpr size_t kMaxCandidates = 2000;  // and as many misspelt names: beyond, nobody reads suggestions
  constexpr size_t kMaxListings = 50;      // misspelt names for which all files of the search path are looked through
  std::vector<std::string> known;
  std::unordered_map<std::string, const Region*> by_name;
  const bool suggests = in.index.by_code.contains(out.rule().code);
  for (const Region& region : suggests ? std::span(p.regions) : std::span<const Region>{}) {
    if (region.name == kNoName || !by_name.emplace(p.name(region.name), &region).second) continue;
    if (known.size() < kMaxCandidates) known.push_back(p.name(region.name));
  }
  size_t suggestions = 0;
  size_t searches = 0;                                      // for lines with a number
  std::unordered_map<std::string, std::string> near_files;  // by name
  std::optional<std::vector<Related>> folders;              // lines of the INI
  const auto relate_folders = [&](Finding& f) {
    if (!folders) folders = search_path_places(in.profile);
    f.related.insert(f.related.end(), folders->begin(), folders->end());
  };
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const Statement& s = p.at(stop.statement);
    if (stop.kind == StopKind::kM98NoTarget) {
      Finding& f = out.add(s.keyword_span(), "`M98` has no `P` with the number of the sub");
      f.help = "write `" + call_meant(p, s) + "`";
      return &f;
    }
    const std::string label = label_text(stop.detail);
    const bool machine = in.profile.setup != nullptr;
    Finding& f = out.add(s.head_span(),
                         "no sub `" + label + "` in this program, and no file `" + stop.detail + ".ngc` " +
                             (machine                           ? "on the machine's search path"
                                  : in.profile.sub_path.empty() ? "in its folder"
                                                                : "in its folder or those of `--sub-path`"));
    if (tell_deleted_sub(p, stop.statement, f)) return &f;
    if (in.linked.target(stop.detail).opaque) {
      f.message = "no sub `" + label + "` in this program, and owlint does not look for a file with such a name";
      f.help = "define the sub, or correct the name";
      return &f;
    }
    if (const auto misread = in.index.subs.find(p.syntax.names.find(stop.detail)); misread != in.index.subs.end()) {
      f.message = "`" + label + "` is not known here: " + misread_words(p, misread->second);
      name_misread(p, misread->second, label + " sub", f);
      return &f;
    }
    if (const auto found = by_name.find(stop.detail); found != by_name.end()) {
      const Region& region = *found->second;
      f.message = "`" + label + "` is not known here: the program has not run its definition on line " +
          std::to_string(p.at(region.opener).line) + " before";
      relate(f, p, region.opener,
             region.enclosing == kNoBlock ? "defined here" : "defined here, inside a block that may be skipped");
      f.help = "define the sub before the call, outside of blocks";
      return &f;
    }
    if (const std::string other = look_alike_name(in, stop.detail); !other.empty()) {
      f.help = other;
      return &f;
    }
    if (has_sign(p, s, stop.detail, f)) return &f;
    if (without_ending(in, s, stop.detail, f) || repeats_in_number(p, s, stop.detail, f)) return &f;
    if (searches < kMaxListings && ++searches > 0 && means_line(in, s, stop.statement, stop.detail, f)) return &f;
    if (searches < kMaxListings && names_file(in, s, stop.detail, f)) return &f;
    std::string near;
    std::string near_file;
    const Elsewhere late = defined_elsewhere(in, stop.detail);
    if (late.program != nullptr) {
      f.message = "`" + label + "` is not known here: the program has not run its definition on " +
          line_words(in, late) + " before";
      relate(in, f, late, "defined here");
      f.help = "define the sub before the call that leads here, or move it into a file of its own";
      return &f;
    }
    // A name of one or two letters is near to everything, and the sub around the call is never meant.
    if (number_only(stop.detail).empty() && stop.detail.size() > 2 && suggestions++ < kMaxCandidates) {
      near = nearest(stop.detail, known, 1);
      const NameId around = p.regions[p.region_of[stop.statement]].name;
      if (around != kNoName && near == p.name(around)) near.clear();
      if (near.empty() && suggestions < kMaxListings) {
        const auto [known_file, first] = near_files.try_emplace(stop.detail);
        if (first) known_file->second = nearest(stop.detail, in.linked.search_path().names(), 2);
        near_file = known_file->second;
      }
    }
    if (!near.empty()) {
      f.help = "write `" + label_text(near) + "`";
      if (s.label != kNoName)
        f.fixes.push_back(
            {f.help,
             false,
             {{s.label_span(),
               s.is(Keyword::kCall) ? label_text(near) : (s.kind == LineKind::kM98 ? "P" : "Q") + near}}});
      relate(f, p, by_name.at(near)->opener, "`" + label_text(near) + "` is defined here");
    } else if (!near_file.empty()) {
      const auto file = in.linked.search_path().find(near_file);
      f.help = "did you mean `" + label_text(near_file) + "`, in " + (file ? file->path : near_file + ".ngc") + "?";
      if (s.is(Keyword::kCall) && s.label != kNoName)
        f.fixes.push_back({"write `" + label_text(near_file) + "`", false, {{s.label_span(), label_text(near_file)}}});
    } else if (p.sub_file && machine) {
      relate_folders(f);
      f.group = stop.detail;
      if (stop.unproven) f.habit_severity = Severity::kInfo;
      f.help = "define the sub here or in every program that calls this file, or correct the name";
    } else if (stop.unproven) {
      f.group = stop.detail;
      f.habit_severity = Severity::kInfo;
      f.help =
          "define the sub, or correct the name; if it is in a file, use `--sub-path DIR`, or `--ini FILE` with the "
          "machine's INI";
    } else {
      if (machine && number_only(stop.detail).empty()) relate_folders(f);
      f.help = "define the sub, or correct the label";
    }
    return &f;
  });
  for_unmet_errors(in, out, [&](StatementId id, const LineError& error) {
    Finding& f = out.add(p.at(id).keyword_span(), "`M98` has no `P` with the number of the sub");
    f.interpreter = error.message;
    f.reach = Reach::kNever;
  });
  // Calls that no run gets to, of subs that nobody defines.
  for (const Call& call : p.calls) {
    if (call.callee == kNoName || call.target != kNoRegion || has_stop(in, call.statement)) continue;
    if (p.at(call.statement).runs_remap()) continue;
    if (in.flow.executed[call.statement] || p.sub_file || in.profile.may_be_python()) continue;
    const CallTarget target = in.linked.target(p.name(call.callee));
    if (target.file != CallTarget::kNotFound || target.opaque) continue;
    if (std::ranges::any_of(p.by_label[call.callee], [&](StatementId id) { return p.at(id).opens_sub(); })) continue;
    if (in.index.subs.contains(call.callee)) continue;
    if (number_only(p.name(call.callee)).empty() && in.profile.setup == nullptr) continue;
    Finding& f = out.add(p.at(call.statement).head_span(), "no sub `" + p.label_text(call.callee) + "` is defined");
    f.help = "define the sub, or correct the label";
    if (searches < kMaxListings && ++searches > 0)
      means_line(in, p.at(call.statement), call.statement, p.name(call.callee), f);
    f.reach = Reach::kNever;
  }
}

/// Measured: `ngc=~/name` is looked for in the home folder of whoever starts LinuxCNC, and nowhere else.
void check_home(const SetupInput& in, Reporter& out, const IniCall& call) {
  const std::string path = expand_home(call.name) + ".ngc";
  if (path.starts_with('~') || in.library.files().exists(path)) return;
  Finding& f =
      out.add(call.source, call.span,
              "`REMAP` names `" + call.name + "`, but that file is not in the home folder: LinuxCNC does not start");
  f.help =
      "put the file there, or write its name without `~/`: LinuxCNC looks for it in the folders of `SUBROUTINE_PATH`";
  refuses(f, "INTERP_REMAP: NGC file not found: ngc=" + call.name);
  f.unproven = true;  // the home folder may be another one on the machine
}

/// Subs that the INI calls, by a remap, a button or at the start: they must be files.
void check_setup(const SetupInput& in, Reporter& out) {
  const bool whole = std::ranges::all_of(in.setup.folders, [](const IniFolder& folder) {
    return folder.exists || (folder.key != "PROGRAM_PREFIX" && folder.key != "SUBROUTINE_PATH");
  });
  for (const IniCall& call : in.setup.calls) {
    if (call.key == "REMAP" && call.name.starts_with("~/")) check_home(in, out, call);
  }
  if (!whole) return;  // a folder is missing, which OW407 says: the files may be meant to be there
  for (const IniCall& call : in.setup.calls) {
    for (const std::string& name : called_names(call.code)) {
      if (has_file(in.setup, call, name) || leaves_folders(name) || expands(name) || in.profile.may_be_python())
        continue;
      if (in.setup.search_path->find_other_case(name)) continue;  // OW402 says so
      const bool named = !call.name.empty();
      Finding& f = out.add(call.source, call.span,
                           "`" + std::string(call.key) + "` calls `" + label_text(name) + "`, but there is no file `" +
                               name + ".ngc` on the machine's search path");
      if (call.key == "REMAP") {  // measured: the interpreter does not even start
        f.stops = true;
        f.reach = Reach::kAlways;
        f.interpreter = "INTERP_REMAP: NGC file not found: ngc=" + call.name;
      } else if (call.key == "RS274NGC_STARTUP_CODE") {  // nor with this
        f.stops = true;
        f.reach = Reach::kAlways;
        f.interpreter = "File not open";
      }
      const std::string near = nearest(name, in.setup.search_path->names(), 2);
      if (near.empty()) f.missing = name + ".ngc";
      f.help = !near.empty() ? "did you mean `" + (named ? near : label_text(near)) + "`?"
                             : "put the file into a folder of `SUBROUTINE_PATH`, or add its folder there";
      constexpr std::string_view kEnding = ".ngc";
      if (const std::string stem = name.substr(0, name.size() - std::min(name.size(), kEnding.size()));
          named && name.ends_with(kEnding) && in.setup.search_path->find(stem)) {
        f.help = "write `" + stem + "`: LinuxCNC adds the `.ngc` itself";
        f.missing.clear();
      }
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW208",
    .name = "call-undefined",
    .summary = "a `call` or M98 of a sub that LinuxCNC cannot find",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `call`, or `M98 P…`, of a sub that is not defined in the program, and there is no file with its
name on the machine's search path: the INI's folder, `PROGRAM_PREFIX`, and the folders of
`SUBROUTINE_PATH` in order. Without an INI owlint knows only the program's own folder and the
folders of `--sub-path`. A name that it does not find there is a warning, reported once for all
calls in the checked folder. owlint also looks for the subs that the INI itself calls (`REMAP`,
`NGCGUI_SUBFILE`, `MDI_COMMAND` …).)",
            .why =
                R"(The interpreter first looks for a file (`o200 call` for `200.ngc`, `o<drill> call` for `drill.ngc`).
Then it looks ahead through the rest of the program for the `sub` line, and stops at the end of the
file. In a program between `%` signs the message is `Failed to find sub 'O200' before EOF`. This
happens when the call is executed, not when the program is loaded.)",
            .bad = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
o200 call [30]
M2
)",
            .good = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
o100 call [30]
M2
)",
            .fix = R"(Correct the name, or add the sub. If a file on the machine's search path has the sub, give owlint
the INI with `--ini FILE` or `ini = "…"` in `owlint.toml`, or only the file's folder with
`--sub-path DIR` or `sub-path = ["DIR"]`. If the INI has a `[PYTHON]` section, the name may be a
Python function, and owlint does not report it.)",
            .level_reason = "Error if the sub does not exist: the call stops the program. Warning if the file may be "
                            "in a folder that owlint does not know; info if several files call the sub, three times or "
                            "more: then it is probably on the machine.",
            .interpreter = "EOF in file:PROGRAM seeking o-word: o<200> from line: N",
            .options = "",
        },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow208
