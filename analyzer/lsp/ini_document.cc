#include "analyzer/lsp/ini_document.h"

#include <algorithm>

#include "analyzer/lsp/places.h"
#include "analyzer/machine/ini_keys.h"
#include "analyzer/machine/remap_line.h"
#include "analyzer/text/characters.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

std::string_view leading_word(std::string_view text) { return text.substr(0, text.find_first_of(" \t")); }

std::string_view without_ending(std::string_view name) {
  const size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? name : name.substr(0, dot);
}

}  // namespace

bool is_ini(std::string_view path) { return small_letters(ending_of(path)) == ".ini"; }

IniDocument::IniDocument(Workspace& workspace, const Document& document)
    : workspace_(workspace), document_(document), profile_(workspace.profile_of(document)) {
  text_.parse(workspace.files(), document.source());
}

const IniLine* IniDocument::line_at(uint64_t offset) const {
  const Span line = fed_line(document_.text(), offset);
  const auto found = std::ranges::find_if(text_.lines(), [&](const IniLine& one) {
    return is_own(one) && one.span.begin >= line.begin && one.span.begin < line.end;
  });
  return found == text_.lines().end() ? nullptr : &*found;
}

std::string_view IniDocument::section_at(uint64_t offset) const {
  std::string_view name;
  for (const IniLine& line : text_.lines()) {
    if (is_own(line) && line.span.begin > offset) break;
    name = text_.section_of(line);
  }
  return name;
}

IniTarget IniDocument::sub_target(std::string_view name, uint64_t begin) const {
  IniTarget target{{begin, begin + name.size()}, small_letters(name), {}};
  if (profile_.setup == nullptr) return target;
  const auto found = profile_.setup->search_path->find(target.sub);
  if (found && found->regular) target.path = found->path;
  return target;
}

std::optional<IniTarget> IniDocument::file_target(std::string_view path, uint64_t begin) const {
  const std::string whole = normal_path(joined_path(folder_of(document_.path()), expand_home(path)));
  if (path.empty() || !workspace_.files().is_file(whole)) return std::nullopt;
  return IniTarget{{begin, begin + path.size()}, {}, whole};
}

/// `o<name> call` in code; the name is what counts.
void IniDocument::add_calls(std::string_view code, uint64_t begin, std::vector<IniTarget>* targets) const {
  for (size_t at = code.find('<'); at != std::string_view::npos; at = code.find('<', at + 1)) {
    const size_t letter = at == 0 ? std::string_view::npos : code.find_last_not_of(" \t", at - 1);
    if (letter == std::string_view::npos || (code[letter] != 'o' && code[letter] != 'O')) continue;
    const size_t end = code.find('>', at);
    if (end == std::string_view::npos) return;
    targets->push_back(sub_target(code.substr(at + 1, end - at - 1), begin + at + 1));
  }
}

std::vector<IniTarget> IniDocument::targets(const IniLine& line) const {
  std::vector<IniTarget> targets;
  const auto add_file = [&](std::string_view path, uint64_t begin) {
    if (auto target = file_target(path, begin)) targets.push_back(std::move(*target));
  };
  if (line.kind == IniLine::Kind::kComment) {
    const std::string_view name = ini_include(text_.text(line));
    if (!name.empty()) add_file(name, line.span.end - name.size());
    return targets;
  }
  if (line.kind != IniLine::Kind::kKey) return targets;
  const std::string_view key = text_.name(line);
  const std::string_view value = text_.value(line);
  const IniKey* const known = find_ini_key(text_.section_of(line), key);
  if (known != nullptr && known->type == IniKey::Type::kRemap) {
    const RemapLine remap = read_remap(value, line.number);
    if (!remap.ngc.empty())
      targets.push_back(
          sub_target(remap.ngc, line.value.begin + static_cast<uint64_t>(remap.ngc.data() - value.data())));
  } else if (key == "MACRO") {
    if (!value.empty()) targets.push_back(sub_target(leading_word(value), line.value.begin));
  } else if (key == "NGCGUI_SUBFILE") {
    IniTarget target = sub_target(without_ending(value), line.value.begin);
    target.span = line.value;
    for (const IniFolder& folder : profile_.setup == nullptr ? std::vector<IniFolder>() : profile_.setup->folders) {
      const std::string path = joined_path(folder.path, std::string(value));
      if (target.path.empty() && folder.key == "NGCGUI_SUBFILE_PATH" && workspace_.files().is_file(path))
        target.path = path;
    }
    if (!value.empty() && value != "\"\"") targets.push_back(std::move(target));
  } else if (key == "MDI_COMMAND" || (known != nullptr && known->type == IniKey::Type::kGcode)) {
    add_calls(value, line.value.begin, &targets);
  } else if (known != nullptr && known->type == IniKey::Type::kPath) {
    add_file(value, line.value.begin);
  } else if (key.ends_with("HALFILE")) {
    add_file(leading_word(value), line.value.begin);
  }
  return targets;
}

std::optional<IniTarget> IniDocument::target_at(uint64_t offset) const {
  const IniLine* const line = line_at(offset);
  if (line == nullptr) return std::nullopt;
  for (IniTarget& target : targets(*line)) {
    if (offset >= target.span.begin && offset <= target.span.end) return std::move(target);
  }
  return std::nullopt;
}

}  // namespace owlint::lsp
