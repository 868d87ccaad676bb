// Rename: a block's label on all its lines; a sub in all files, and the file that carries its name; a parameter.
#include <algorithm>
#include <filesystem>
#include <set>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/places.h"

namespace owlint::lsp {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw ResponseError{ErrorCode::kRequestFailed, why}; }

bool is_number(const std::string& text) { return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos; }

/// The bare name: `o100`, `100`, `o<drill>`, `<drill>` and `drill` are all taken.
std::string bare_name(std::string text) {
  const auto drop = [&](std::string_view prefix) {
    if (text.starts_with(prefix)) text.erase(0, prefix.size());
  };
  text = small_letters(text);
  if (text == "o" || text == "#") return {};
  if (text.size() > 1 && text[0] == 'o' && (text[1] == '<' || is_number(text.substr(1)))) drop("o");
  drop("#");
  if (text.size() > 2 && text.front() == '<' && text.back() == '>') text = text.substr(1, text.size() - 2);
  return text;
}

constexpr std::string_view kNever = " \t<>[]()#;\n\r";

void check_name(const std::string& name) {
  if (name.empty()) refuse("the new name is empty");
  if (name.find_first_of(kNever) != std::string::npos) refuse("a name cannot have `" + name.substr(name.find_first_of(kNever), 1) + "` in it");
}

void check_block_label(const Document& document, BlockId block, const std::string& name) {
  const Program& p = document.program();
  const NameId id = p.syntax.names.find(name);
  if (id == kNoName || id == p.blocks[block].label || id >= p.by_label.size()) return;
  for (const StatementId at : p.by_label[id]) {
    const Statement& s = p.at(at);
    if (!global_label(s.keyword) && p.region_of[at] == p.blocks[block].region) refuse("`" + label_text(name) + "` is used on line " + std::to_string(s.line) + " already");
  }
}

}  // namespace

Json prepare_rename(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  if (!target) return nullptr;
  return {{"range", document.range(target->span)}, {"placeholder", document.text().substr(target->span.begin, target->span.end - target->span.begin)}};
}

Json rename(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  if (!target) refuse("there is nothing to rename here");
  const std::string name = bare_name(params.at("newName").get<std::string>());
  check_name(name);
  std::string text = label_text(name);
  Sub sub;
  if (target->kind == Target::Kind::kBlock) {
    check_block_label(document, target->block, name);
  } else if (target->kind == Target::Kind::kSub) {
    sub = find_sub(workspace, document, target->name);
    if (sub.document == nullptr) refuse("the definition of `" + label_text(target->name) + "` is not known");
    if (name != target->name && find_sub(workspace, document, name).document != nullptr) refuse("there is a sub `" + label_text(name) + "` already");
  } else {
    if ((target->name[0] == '<') == is_number(name)) refuse("a named parameter keeps a name, a numbered one a number");
    text = target->name[0] == '<' ? "#<" + name + ">" : "#" + name;
    if (target->name.starts_with("<_") != name.starts_with("_")) refuse("a name with `_` is global, one without belongs to its sub: that would change what the program does");
  }
  std::map<const Document*, Json> edits;
  for (const Occurrence& o : occurrences(workspace, document, *target, offset)) {
    // M98 has its number after a P.
    const char first = o.document->text()[o.span.begin];
    const bool m98 = first == 'P' || first == 'p';
    if (m98 && !is_number(name)) refuse("M98 on line " + std::to_string(o.document->lines().line_of(o.span.begin) + 1) + " calls it, which takes numbers only");
    auto& list = edits.try_emplace(o.document, Json::array()).first->second;
    list.push_back({{"range", o.document->range(o.span)}, {"newText", m98 ? "P" + name : text}});
  }
  Json changes = Json::array();
  for (const auto& [in, list] : edits) {
    const Json version = in->version ? Json(*in->version) : Json(nullptr);
    changes.push_back({{"textDocument", {{"uri", in->uri()}, {"version", version}}}, {"edits", list}});
  }
  if (sub.own_file && name != target->name) {
    const std::filesystem::path old = sub.document->path();
    const std::string to = (old.parent_path() / (name + old.extension().string())).string();
    if (std::filesystem::exists(to)) refuse("the file " + to + " exists already");
    changes.push_back({{"kind", "rename"}, {"oldUri", sub.document->uri()}, {"newUri", uri_of_path(to)}});
  }
  return {{"documentChanges", changes}};
}

}  // namespace owlint::lsp
