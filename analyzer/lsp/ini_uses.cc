#include "analyzer/lsp/ini_uses.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "analyzer/lsp/parameter_uses.h"
#include "analyzer/program/program.h"
#include "analyzer/text/characters.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

bool is_name(char c) { return is_digit(c) || (c >= 'a' && c <= 'z') || c == '_' || c == '-'; }

/// Whether `word` stands in `text`, with no letter, digit or the like around it.
bool has_word(std::string_view text, std::string_view word) {
  for (size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const size_t end = at + word.size();
    if ((at == 0 || !is_name(text[at - 1])) && (end == text.size() || !is_name(text[end]))) return true;
  }
  return false;
}

/// Whether code calls the sub, by its label or with M98. `code`: without blanks, in small letters.
bool calls(std::string_view code, const std::string& name) {
  for (const std::string& call : {label_text(name), "o<" + name + ">", "m98p" + name}) {
    for (size_t at = code.find(call); at != std::string_view::npos; at = code.find(call, at + 1)) {
      const char before = at == 0 ? ' ' : code[at - 1];
      const char behind = at + call.size() == code.size() ? ' ' : code[at + call.size()];
      if (!is_digit(behind) && !(before >= 'a' && before <= 'z')) return true;
    }
  }
  return false;
}

bool names(const Ini::Entry& entry, const std::string& name) {
  const std::string value = small_letters(entry.value);
  if (entry.key == "REMAP" && has_word(value, "ngc=" + name)) return true;
  // gmoccapy and others: the name, and then those of its arguments.
  if (entry.key == "MACRO" && value.substr(0, value.find_first_of(" \t")) == name) return true;
  if (has_word(value, name + ".ngc")) return true;
  std::string code;
  std::ranges::copy_if(value, std::back_inserter(code), [](char c) { return c != ' ' && c != '\t'; });
  return calls(code, name);
}

template <typename Wanted>
const Ini::Entry* find(const Ini& ini, const Wanted& wanted) {
  const auto found = std::ranges::find_if(ini.entries(), wanted);
  return found == ini.entries().end() ? nullptr : &*found;
}

}  // namespace

const Ini::Entry* ini_use_of_sub(const Ini& ini, const std::string& name) {
  return find(ini, [&](const Ini::Entry& entry) { return names(entry, name); });
}

Json ini_places_of_sub(Workspace& workspace, const Document& document, const std::string& name) {
  Json out = Json::array();
  for (const auto& machine : workspace.machines(document)) {
    const auto file = machine->search_path->find(name);
    if (file && file_key(file->path) != file_key(document.path())) continue;  // another machine's
    for (const Ini::Entry& entry : machine->ini.entries()) {
      const Document* const ini = names(entry, name) ? workspace.document_of_path(entry.source->path()) : nullptr;
      if (ini == nullptr) continue;
      const size_t at = small_letters(entry.source->slice(entry.span)).find(name);
      const uint64_t begin = entry.span.begin + (at == std::string::npos ? 0 : at);
      out.push_back(ini->location(at == std::string::npos ? entry.span : Span{begin, begin + name.size()}));
    }
  }
  return out;
}

const Ini::Entry* ini_use_of_parameter(const Ini& ini, const std::string& name) {
  return find(ini, [&](const Ini::Entry& entry) {
    if (entry.value.find('#') == std::string::npos) return false;
    std::string code = entry.value;
    std::ranges::replace(code, ';', ' ');  // stands between lines of code
    return std::ranges::any_of(parameter_uses(code), [&](const ParameterUse& use) { return use.name == name; });
  });
}

bool is_remap(const Ini& ini, const std::string& name) {
  return find(ini, [&](const Ini::Entry& entry) { return entry.key == "REMAP" && names(entry, name); }) != nullptr;
}

uint32_t line_of_kept_number(const MachineSetup& machine, const std::string& number, std::string* path) {
  const Ini::Entry* entry = machine.ini.find("RS274NGC", "PARAMETER_FILE");
  if (entry == nullptr || entry->value.empty()) return 0;
  *path = normal_path(joined_path(folder_of(machine.path), expand_home(entry->value)));
  std::string error;
  const auto source = machine.search_path->files().read(*path, &error);
  if (source == nullptr) return 0;
  std::istringstream lines{std::string(source->bytes())};
  std::string line;
  for (uint32_t at = 1; std::getline(lines, line); ++at) {
    std::string first;
    if (std::istringstream(line) >> first && first == number) return at;
  }
  return 0;
}

std::string text_of(const Ini::Entry& entry) {
  return fmt::format("`{}` on line {} of {}", entry.key, entry.source->position(entry.span.begin).line,
                     name_of(entry.source->path()));
}

}  // namespace owlint::lsp
