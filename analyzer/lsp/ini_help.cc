// Hover and completion in a machine's INI: what sections and keys mean, and what their values can be.
#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/ini_document.h"
#include "analyzer/lsp/places.h"
#include "analyzer/machine/ini_keys.h"
#include "analyzer/text/characters.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

enum IniItemKind { kSubItem = 3, kSectionItem = 9, kKeyItem = 10, kValueItem = 20 };

/// The values of which there is no other, the usual ones first; empty where there are any number of them.
std::vector<std::string_view> fixed_values(const IniKey& key) {
  switch (key.type) {
    case IniKey::Type::kSwitch: return {"0", "1"};
    case IniKey::Type::kTruth: return {"YES", "NO"};
    case IniKey::Type::kJointType: return {"LINEAR", "ANGULAR"};
    case IniKey::Type::kUnits:
      if (key.name == "LINEAR_UNITS") return {"mm", "inch", "metric", "in", "imperial"};
      return {"degree", "deg", "grad", "gon", "rad", "radian"};
    default: break;
  }
  if (key.section == "EMC" && key.name == "VERSION") return {"1.1"};
  if (key.name == "TASK") return {"milltask"};
  if (key.name == "EMCMOT") return {"motmod"};
  if (key.section == "HAL" && key.name == "HALUI") return {"halui"};
  return {};
}

std::string values_of(const IniKey& key) {
  switch (key.type) {
    case IniKey::Type::kText: return {};
    case IniKey::Type::kSwitch:
      return fmt::format("`0` or `1`; with anything else it is as without this line: {}", key.on ? "on" : "off");
    case IniKey::Type::kTruth: return "`YES`, `NO`, `TRUE`, `FALSE` in any case, or a whole number";
    case IniKey::Type::kInteger: return "a whole number, and nothing behind it";
    case IniKey::Type::kNumber: return "a number, and nothing behind it";
    case IniKey::Type::kJointType: return "`LINEAR` or `ANGULAR`, in any case";
    case IniKey::Type::kUnits: return fmt::format("`{}`, or a number", fmt::join(fixed_values(key), "`, `"));
    case IniKey::Type::kPath: return "a path, seen from the folder of the INI";
    case IniKey::Type::kPaths: return "folders, seen from that of the INI";
    case IniKey::Type::kGcode: return "a line of code; `;` begins a comment";
    case IniKey::Type::kRemap: return "a code and its options; `#` begins a comment";
  }
  return {};
}

std::string about_key(const IniKey& key) {
  std::string out{key.meaning};
  if (const std::string values = values_of(key); !values.empty()) out += ".\n\nIts value: " + values;
  if (key.refuses) out += ". LinuxCNC ends where it is anything else";
  return out + ".";
}

std::string about_target(Workspace& workspace, const IniTarget& target) {
  if (target.sub.empty()) return fmt::format("The file `{}`.", target.path);
  if (target.path.empty()) return fmt::format("owlint finds no file for `{}`.", label_text(target.sub));
  std::string out = fmt::format("`{}` is in `{}`", label_text(target.sub), target.path);
  const Document* const file = workspace.document_of_path(target.path);
  const StatementId opener = file == nullptr ? kNoStatement : definition_in(*file, target.sub);
  if (opener == kNoStatement) return out + ", which does not define it.";
  out += fmt::format(", line {}.", file->program().at(opener).line);
  const std::string comment = leading_comment(*file, opener);
  return comment.empty() ? out : out + "\n\n```\n" + comment + "\n```";
}

Json ini_hover_of(const Document& document, const std::string& text, Span span) {
  return {{"contents", {{"kind", "markdown"}, {"value", text}}}, {"range", document.range(span)}};
}

class IniCompletion {
 public:
  IniCompletion(const IniDocument& ini, uint64_t offset) : ini_(ini), document_(ini.document()), offset_(offset) {
    const Span line = fed_line(document_.text(), offset);
    begin_ = line.begin;
    before_ = std::string_view(document_.text()).substr(line.begin, offset - line.begin);
    behind_ = std::string_view(document_.text()).substr(offset, line.end - offset);
    behind_ = behind_.substr(0, behind_.find_last_not_of(" \t\r") + 1);
  }

  Json run() {
    const size_t first = before_.find_first_not_of(" \t");
    const size_t equals = before_.find('=');
    if (first != std::string_view::npos && (before_[first] == '#' || before_[first] == ';')) return Json::array();
    if (equals != std::string_view::npos) {
      values(equals);
    } else if (first != std::string_view::npos && before_[first] == '[') {
      if (before_.find(']') == std::string_view::npos) sections(first + 1);
    } else {
      keys(first == std::string_view::npos ? before_.size() : first);
    }
    return std::move(out_);
  }

 private:
  void add(std::string_view label, IniItemKind kind, std::string text, size_t from, std::string_view about) {
    Json item{{"label", label},
              {"kind", static_cast<int>(kind)},
              {"filterText", label},
              {"textEdit", {{"range", document_.range({begin_ + from, offset_})}, {"newText", std::move(text)}}}};
    if (!about.empty()) item["documentation"] = {{"kind", "markdown"}, {"value", about}};
    out_.push_back(std::move(item));
  }

  void sections(size_t from) {
    const std::string close = behind_.starts_with(']') ? "" : "]";
    const auto offer = [&](const std::string& name, std::string_view meaning) {
      const auto* const there = ini_.text().find_section(name);
      if (there == nullptr || ini_.text().lines()[there->line].span.begin == begin_)
        add(name, kSectionItem, name + close, from, meaning);
    };
    const auto value = [this](const char* section, const char* key, const char* otherwise) {
      const Ini::Entry* entry = ini_.setup() == nullptr ? nullptr : ini_.setup()->ini.find(section, key);
      return entry == nullptr || entry->value.empty() ? std::string(otherwise) : entry->value;
    };
    for (const IniSection& section : machine_sections()) {
      const std::string name(section.name);
      if (name == "AXIS_") {
        for (const char letter : value("TRAJ", "COORDINATES", "XYZ")) {
          if (is_letter(letter)) offer(name + static_cast<char>(letter & ~0x20), section.meaning);
        }
      } else if (name == "JOINT_") {
        constexpr int kMostJoints = 16;
        const int joints = std::clamp(std::atoi(value("KINS", "JOINTS", "3").c_str()), 1, kMostJoints);
        for (int joint = 0; joint < joints; ++joint) offer(name + std::to_string(joint), section.meaning);
      } else {
        offer(name, section.meaning);
      }
    }
  }

  void keys(size_t from) {
    const std::string_view section = ini_.section_at(begin_);
    const std::string_view typed = before_.substr(from);
    if (!std::ranges::all_of(typed, [](char c) { return is_letter(c) || is_digit(c) || c == '_'; })) return;
    std::set<std::string_view> there;
    for (const IniLine& line : ini_.text().lines()) {
      if (line.kind == IniLine::Kind::kKey && line.span.begin != begin_ + from &&
          ini_.text().section_of(line) == section)
        there.insert(ini_.text().name(line));
    }
    const std::string equals = behind_.find('=') == std::string_view::npos ? " = " : "";
    for (const IniKey& key : ini_keys()) {
      if (key.section != section_family(section) || (!key.several && there.contains(key.name))) continue;
      add(key.name, kKeyItem, std::string(key.name) + equals, from, about_key(key));
    }
  }

  void values(size_t equals) {
    const std::string_view section = ini_.section_at(begin_);
    std::string_view name = before_.substr(0, equals);
    name = name.substr(0, name.find_last_not_of(" \t") + 1);
    name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
    const size_t from = std::min(before_.find_first_not_of(" \t", equals + 1), before_.size());
    const std::string_view typed = before_.substr(from);
    const IniKey* const key = find_ini_key(section, name);
    for (const std::string_view value : key == nullptr ? std::vector<std::string_view>() : fixed_values(*key))
      add(value, kValueItem, std::string(value), from, {});
    const size_t option =
        key != nullptr && key->type == IniKey::Type::kRemap ? typed.rfind("ngc=") : std::string_view::npos;
    if (option != std::string_view::npos && typed.find_first_of(" \t", option) == std::string_view::npos)
      subs(from + option + 4);
    if (name == "MACRO" && typed.find_first_of(" \t") == std::string_view::npos) subs(from);
    if (const size_t label = typed.rfind('<'); label != std::string_view::npos && label > 0 &&
        (typed[label - 1] | 0x20) == 'o' && typed.find('>', label) == std::string_view::npos)
      subs(from + label + 1);
  }

  void subs(size_t from) {
    constexpr size_t kMost = 500;
    if (ini_.setup() == nullptr) return;
    for (const std::string& name : ini_.setup()->search_path->names()) {
      if (out_.size() >= kMost) return;
      add(name, kSubItem, name, from, {});
    }
  }

  const IniDocument& ini_;
  const Document& document_;
  uint64_t offset_, begin_ = 0;
  std::string_view before_, behind_;
  Json out_ = Json::array();
};

}  // namespace

Json ini_hover(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const IniDocument ini(workspace, document);
  const IniLine* const line = ini.line_at(offset);
  if (line == nullptr) return nullptr;
  if (const auto target = ini.target_at(offset))
    return ini_hover_of(document, about_target(workspace, *target), target->span);
  if (offset < line->name.begin || offset > line->name.end) return nullptr;
  const std::string_view section = ini.text().section_of(*line);
  if (line->kind == IniLine::Kind::kSection) {
    const IniSection* const known = find_ini_section(section);
    if (known == nullptr) return nullptr;
    return ini_hover_of(document, fmt::format("**[{}]** {}.", section, known->meaning), line->name);
  }
  const IniKey* const key = line->kind == IniLine::Kind::kKey ? find_ini_key(section, ini.text().name(*line)) : nullptr;
  if (key == nullptr) return nullptr;
  return ini_hover_of(document, fmt::format("**[{}]{}** {}", section, key->name, about_key(*key)), line->name);
}

Json ini_completion(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  return {{"isIncomplete", false}, {"items", IniCompletion(IniDocument(workspace, document), offset).run()}};
}

}  // namespace owlint::lsp
