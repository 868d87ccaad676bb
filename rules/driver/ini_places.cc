#include "rules/driver/ini_places.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

#include "analyzer/program/machine_words.h"
#include "rules/driver/machine_rules.h"
#include "rules/driver/remap_rules.h"
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

void relate_unused_remap(const Input& in, const FlowStop& stop, Finding& finding) {
  if (in.profile.setup == nullptr || stop.statement == kNoStatement) return;
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

std::vector<Related> search_path_places(const Profile& profile) {
  std::vector<Related> places;
  if (profile.setup == nullptr) return places;
  const IniText& text = profile.setup->text;
  for (const IniLine& line : text.lines()) {
    if (line.kind != IniLine::Kind::kKey || text.name(line) != "SUBROUTINE_PATH" || places.size() == kMostPlaces)
      continue;
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
