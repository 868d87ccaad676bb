#include "rules/driver/ini_places.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "analyzer/machine/ini_keys.h"
#include "analyzer/program/machine_words.h"
#include "rules/driver/machine_rules.h"
#include "rules/driver/remap_rules.h"
#include "rules/driver/start_refusals.h"
#include "rules/driver/words.h"

namespace owlint::rules {

void relate_ini(Finding& finding, const Ini::Entry& entry, std::string message) {
  finding.related.push_back({entry.span, std::move(message), entry.source});
}

const Ini::Entry* remap_entry(const Profile& profile, char letter, int number) {
  if (profile.setup == nullptr) return nullptr;
  for (const Ini::Entry* entry : profile.setup->ini.all("RS274NGC", "REMAP")) {
    const auto code = remapped_code(entry->value, release_of(profile));
    if (code && code->letter == letter && code->number == number) return entry;
  }
  return nullptr;
}

const Ini::Entry* remap_entry(const Input& in, StatementId remap) {
  std::string code = small_letters(in.program.head(remap));
  std::erase_if(code, [](char c) { return c == ' ' || c == '\t'; });
  if (code.empty()) return nullptr;
  double value = 0;
  const bool numbered = code[0] == 'g' || code[0] == 'm';
  if (numbered) std::from_chars(code.data() + 1, code.data() + code.size(), value);
  int32_t number = 0;
  if (code[0] == 'g' ? !g_tenths(value, &number) : !word_integer(value, &number)) return nullptr;
  return remap_entry(in.profile, code[0], number);
}

namespace {

/// Why LinuxCNC does not use the line for a key of a section; empty if it does, or if that is another value's matter.
std::string why_unread(const Profile& profile, const IniLine& line, std::string_view section, bool list) {
  const IniText& text = profile.setup->text;
  const std::string key(text.name(line));
  if (line.continuation) return "the line before goes on in this one, so that LinuxCNC does not see it";
  if (text.section_of(line) != section) return fmt::format("not read: LinuxCNC looks for `{}` in `[{}]`", key, section);
  if (!text.is_read(line) && profile.version < Version::k2_10)
    return fmt::format("not read: LinuxCNC reads only the first `[{}]`", section);
  for (const IniLine* other : lines_of(text, section)) {
    if (other == &line) return {};
    if (text.name(*other) != key) continue;
    const bool empty = other->value.begin == other->value.end;
    if (empty) return fmt::format("not read: an empty `{}` comes before it", key);
    if (!list) return fmt::format("not read: LinuxCNC uses the first `{}`", key);
  }
  return {};
}

Related line_place(const IniText& text, const IniLine& line, std::string message) {
  return {line.span, std::move(message), text.source(line)};
}

constexpr size_t kMostPlaces = 3;

}  // namespace

void relate_unread_remap(const Profile& profile, char letter, int number, Finding& finding) {
  if (profile.setup == nullptr) return;
  const IniText& text = profile.setup->text;
  for (const IniLine& line : text.lines()) {
    if (line.kind != IniLine::Kind::kKey || text.name(line) != "REMAP") continue;
    const auto code = remapped_code(text.value(line), release_of(profile));
    if (!code || code->letter != letter || code->number != number) continue;
    const std::string why = why_unread(profile, line, "RS274NGC", true);
    if (why.empty()) continue;
    finding.related.push_back(line_place(text, line, why));
    return;
  }
}

namespace {

/// What a code that a REMAP line has taken away has to do with a stop.
void relate_lost_code(const Input& in, const FlowStop& stop, Finding& finding) {
  const std::string_view rule = finding.code;
  if (rule != "OW705" && rule != "OW706" && rule != "OW707" && rule != "OW802") return;
  const std::vector<LostRemap> all = lost_codes(in.profile);
  if (all.empty()) return;
  constexpr int kTenths = 10, kM3 = 3, kM4 = 4;
  const std::vector<WrittenWord> words = words_of(*in.program.source, in.program.at(stop.statement).whole());
  for (const LostRemap& lost : all) {
    const auto is_code = [&](const WrittenWord& word) {
      const double value = word.value.value_or(-1) * (word.letter == 'g' ? kTenths : 1);
      return word.letter == lost.code.letter && std::lround(value) == lost.code.number;
    };
    const bool here = std::ranges::any_of(words, is_code);
    if (rule == "OW705" && here && lost.crashes) finding.interpreter.clear();
    if (rule == "OW706" && here && finding.interpreter.starts_with("Two ")) {
      finding.message = finding.message.substr(0, finding.message.find(": ")) + ": the `REMAP` of `" + lost.name +
          "` puts both into one group";
      return blame(in.profile, lost, finding);
    }
    if (rule == "OW707" && here) return blame(in.profile, lost, finding);
    // A spindle that never starts.
    const bool starts = lost.code.letter == 'm' && (lost.code.number == kM3 || lost.code.number == kM4);
    if (rule == "OW802" && starts) return blame(in.profile, lost, finding);
  }
}

}  // namespace

void relate_unused_remap(const Input& in, const FlowStop& stop, Finding& finding) {
  if (in.profile.setup == nullptr || stop.statement == kNoStatement) return;
  relate_lost_code(in, stop, finding);
  if (finding.code != "OW708" && finding.code != "OW801" && finding.code != "OW802") return;
  if (in.profile.setup->ini.find("RS274NGC", "REMAP") == nullptr) return;
  for (const WrittenWord& word : words_of(*in.program.source, in.program.at(stop.statement).whole())) {
    int32_t code = 0;
    if (word.letter != 'g' || !word.value || !g_tenths(*word.value, &code) || !is_built_in_motion(code)) continue;
    const Ini::Entry* const entry = remap_entry(in.profile, 'g', code);
    if (entry == nullptr) continue;
    const std::string written = shown(*in.program.source, word.span);
    relate_ini(finding, *entry,
               fmt::format("LinuxCNC never uses this `REMAP`: `{}` keeps its built-in meaning", written));
    finding.help = "remap a code that is free, such as `G88.1`, and write that one here";
    finding.fixes.clear();
    return;
  }
}

bool relate_unread_entry(const Profile& profile, std::string_view section, std::string_view key, Finding& finding) {
  if (profile.setup == nullptr) return false;
  std::string in_section(section), name(key);
  const auto to_capital = [](unsigned char c) { return static_cast<char>(std::toupper(c)); };
  std::ranges::transform(in_section, in_section.begin(), to_capital);
  std::ranges::transform(name, name.begin(), to_capital);
  const IniText& text = profile.setup->text;
  for (const IniLine& line : text.lines()) {
    if (line.kind != IniLine::Kind::kKey || small_letters(text.section_of(line)) != small_letters(section) ||
        small_letters(text.name(line)) != small_letters(key))
      continue;
    const bool exact = text.section_of(line) == in_section && text.name(line) == name;
    const std::string why = exact ? why_unread(profile, line, in_section, false)
                                  : fmt::format("not read: LinuxCNC looks for `{}` in `[{}]`", name, in_section);
    if (why.empty()) continue;
    finding.related.push_back(line_place(text, line, why));
    return true;
  }
  return false;
}

bool relate_given_name(const Profile& profile, std::string_view sub, std::string_view name, Finding& finding) {
  if (profile.setup == nullptr) return false;
  if (name.starts_with("_ini[")) {
    const Ini::Entry* const entry = profile.setup->ini.find("RS274NGC", "INI_VARS");
    if (profile.setup->reads_ini || entry == nullptr) return false;
    finding.help = "remove `INI_VARS`, or write `INI_VARS = 1`: then programs read the entries of the INI";
    relate_ini(finding, *entry, "switched off here");
    return true;
  }
  if (name == "n_args") {
    finding.help = "write `OWORD_NARGS = 1` in `[RS274NGC]` of the machine's INI: then subs have this name";
    const Ini::Entry* const entry = profile.setup->ini.find("RS274NGC", "OWORD_NARGS");
    if (entry != nullptr) relate_ini(finding, *entry, "this does not switch it on");
    return true;
  }
  if (name.size() != 1 || name[0] < 'a' || name[0] > 'z') return false;
  const IniText& text = profile.setup->text;
  for (const Remap& remap : remaps_of(text)) {
    const std::string ngc = small_letters(remap.read.ngc);
    if (ngc.empty() || ngc.substr(ngc.rfind('/') + 1) != sub || remap.earlier != nullptr) continue;
    const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    const bool optional = remap.read.argspec.find(name[0]) != std::string_view::npos;
    const bool by_number = remap.read.argspec.find('@') != std::string_view::npos;
    if (by_number) {
      finding.help =
          fmt::format("with `@` in `argspec` the words are in `#1`, `#2` …: remove the `@`, or read the numbers");
    } else if (optional) {
      finding.help = fmt::format(
          "ask with `EXISTS[#<{0}>]` in an `if` of its own first; or write `{1}` in `argspec`, so that "
          "every line must have the word",
          name, capital);
    } else {
      finding.help =
          fmt::format("add `{}` to the `argspec` of the `REMAP`, or assign `#<{}>` in the sub", capital, name);
    }
    finding.related.push_back(line_place(text, *remap.line,
                                         optional ? fmt::format("a line with the code may leave out `{}`", capital)
                                                  : fmt::format("this passes no `#<{}>`", name)));
    return true;
  }
  return false;
}

std::vector<const IniFolder*> unused_folders(const MachineSetup& setup) {
  constexpr int kSearched = 10, kOfUserCodes = 5;
  std::vector<const IniFolder*> unused;
  int searched = 0, of_user_codes = 0;
  for (const IniFolder& folder : setup.folders) {
    if (folder.key == "SUBROUTINE_PATH" && folder.exists && ++searched > kSearched) unused.push_back(&folder);
    if (folder.key == "USER_M_PATH" && ++of_user_codes > kOfUserCodes) unused.push_back(&folder);
  }
  return unused;
}

std::vector<const IniFolder*> user_code_folders(const MachineSetup& setup) {
  const std::vector<const IniFolder*> unused = unused_folders(setup);
  std::vector<const IniFolder*> folders;
  for (const IniFolder& folder : setup.folders) {
    const bool of_user_codes = folder.key == "PROGRAM_PREFIX" || folder.key == "USER_M_PATH";
    if (of_user_codes && std::ranges::find(unused, &folder) == unused.end()) folders.push_back(&folder);
  }
  return folders;
}

namespace {

/// The list goes on with folders that are not used.
void end_before(Related& list, const IniFolder& unused) {
  if (list.source == unused.source && unused.span.begin > list.span.begin + 1 && unused.span.begin <= list.span.end)
    list.span.end = unused.span.begin - 1;
}

}  // namespace

namespace {

/// A line that was meant for the search path and is not; empty for others.
std::string why_no_path(const IniText& text, const IniLine& line) {
  constexpr std::string_view kKey = "SUBROUTINE_PATH";
  if (line.continuation) {
    return text.text(line).starts_with(kKey) ? "the line before goes on in this one, so that LinuxCNC does not see it"
                                             : "";
  }
  if (line.kind == IniLine::Kind::kText)
    return text.text(line).starts_with(kKey) ? "not read: a line without `=` sets nothing" : "";
  const bool misspelt = line.kind == IniLine::Kind::kKey && text.section_of(line) == "RS274NGC" &&
      find_ini_key("RS274NGC", text.name(line)) == nullptr && meant_key("RS274NGC", text.name(line)) == kKey;
  return misspelt ? "not read: LinuxCNC looks for `SUBROUTINE_PATH`" : "";
}

}  // namespace

std::vector<Related> search_path_places(const Profile& profile) {
  std::vector<Related> places;
  if (profile.setup == nullptr) return places;
  const IniText& text = profile.setup->text;
  for (const IniLine& line : text.lines()) {
    if (places.size() == kMostPlaces) break;
    if (line.continuation || text.name(line) != "SUBROUTINE_PATH" || line.kind != IniLine::Kind::kKey) {
      if (const std::string why = why_no_path(text, line); !why.empty()) places.push_back(line_place(text, line, why));
      continue;
    }
    const std::string why = why_unread(profile, line, "RS274NGC", false);
    places.push_back(line_place(text, line, why.empty() ? "the folders in which LinuxCNC looks" : why));
    const std::vector<const IniFolder*> unused = unused_folders(*profile.setup);
    if (why.empty() && !unused.empty() && unused[0]->key == "SUBROUTINE_PATH") end_before(places.back(), *unused[0]);
  }
  return places;
}

void relate_user_folders(const Profile& profile, Finding& finding) {
  if (profile.setup == nullptr) return;
  for (const auto& [section, key] : {std::pair("DISPLAY", "PROGRAM_PREFIX"), std::pair("RS274NGC", "USER_M_PATH")}) {
    const Ini::Entry* const entry = profile.setup->ini.find(section, key);
    if (entry == nullptr || entry->value.empty()) continue;
    relate_ini(finding, *entry, "LinuxCNC looks here");
    for (const IniFolder* const unused : unused_folders(*profile.setup)) {
      if (unused->key == key) end_before(finding.related.back(), *unused);
    }
  }
  const IniText& text = profile.setup->text;
  for (const IniLine& line : text.lines()) {
    if (line.kind != IniLine::Kind::kKey || text.name(line) != "USER_M_PATH") continue;
    const std::string why = why_unread(profile, line, "RS274NGC", false);
    if (why.empty()) continue;
    finding.related.push_back(line_place(text, line, why));
    return;
  }
}

}  // namespace owlint::rules
