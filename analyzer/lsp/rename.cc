// Rename: a block's label on all its lines; a sub in all files, and the file that carries its name; a parameter.
#include <unistd.h>

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/naming.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

constexpr std::string_view kNever = "<>[]()#;/\\`$|&{}*?~\"'";

void check_name(const std::string& name) {
  constexpr size_t kDigits = 9;
  if (name.empty()) refuse("the new name is empty");
  const auto bad = std::ranges::find_if(name, [](char c) {
    return static_cast<unsigned char>(c) <= ' ' || c == '\x7F' || kNever.find(c) != std::string_view::npos;
  });
  if (bad != name.end())
    refuse(static_cast<unsigned char>(*bad) < ' ' ? "a name cannot have a control character in it"
                                                  : "a name cannot have `" + std::string(1, *bad) + "` in it");
  if (is_number(name) && name.size() > kDigits) refuse("`" + name + "` is too large a number");
}

std::string without_zeros(const std::string& number) {
  return number.substr(std::min(number.find_first_not_of('0'), number.size() - 1));
}

/// The label that was typed, as LinuxCNC keeps it: `o100`, `100`, `o<drill>`, `<drill>` and `drill` are all taken.
std::string label_of(std::string typed) {
  typed = small_letters(typed);
  if (typed == "o") return {};
  if (typed.starts_with("o<") || (typed.starts_with('o') && is_number(typed.substr(1)))) typed.erase(0, 1);
  if (is_number(typed)) return without_zeros(typed);
  return typed.size() >= 2 && typed.front() == '<' && typed.back() == '>' ? typed.substr(1, typed.size() - 2) : typed;
}

/// The same for a parameter: `#<depth>`, `<depth>` and `depth`, or `#5` and `5`.
std::string parameter_of(std::string typed, const std::string& old) {
  typed = small_letters(typed);
  if (typed.starts_with('#')) typed.erase(0, 1);
  if (typed.size() >= 2 && typed.front() == '<' && typed.back() == '>') typed = typed.substr(1, typed.size() - 2);
  check_name(typed);
  if ((old[0] == '<') == is_number(typed)) refuse("a named parameter keeps a name, a numbered one a number");
  std::string name = is_number(typed) ? without_zeros(typed) : "<" + typed + ">";
  if (is_shared(old) == is_shared(name)) return name;
  refuse(old[0] == '<' ? "a name with `_` is shared by all subs, one without belongs to its own: that would change "
                         "what the program does"
                       : "`#1` to `#30` belong to their sub, other numbers are shared by all: that would change what "
                         "the program does");
}

using Edits = std::map<const Document*, std::vector<std::pair<Span, std::string>>>;

/// A longer name must not make a line longer than LinuxCNC reads.
void check_length(const Naming& naming, const Document& in, const std::vector<std::pair<Span, std::string>>& edits) {
  std::map<size_t, std::pair<size_t, size_t>> lengths;  // by beginning: before and after
  for (const auto& [span, text] : edits) {
    const size_t begin = in.text().rfind('\n', span.begin) + 1;  // 0 where there is none
    const size_t length = std::min(in.text().find('\n', span.begin), in.text().size()) - begin;
    size_t& after = lengths.try_emplace(begin, length, length).first->second.second;
    after += text.size() - (span.end - span.begin);
  }
  for (const auto& [begin, length] : lengths) {
    if (length.second > std::max(length.first, kLineLimit))
      refuse(naming.place(in, begin) + " would be longer than the " + std::to_string(kLineLimit) +
             " characters that LinuxCNC reads");
  }
}

Edits edits_of(const Naming& naming, const std::string& name) {
  Edits edits;
  const std::string text = naming.text(name);
  for (const Occurrence& o : naming.places()) {
    const char first = o.document->text()[o.span.begin];
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(first)));
    const bool by_number = letter == 'P' || letter == 'Q';  // M98 has the number after a P, G71 after a Q
    if (by_number && !is_number(name))
      refuse((letter == 'P' ? "`M98` on " : "the `Q` on ") + naming.place(*o.document, o.span.begin) +
             " calls it, and takes numbers only");
    const StatementId line = o.document->statement_at(o.span.begin);
    const bool program_number = line != kNoStatement && o.document->program().at(line).is(Keyword::kBare);
    if (program_number && !is_number(name))
      refuse("the label on " + naming.place(*o.document, o.span.begin) + " is a program number, which is no name");
    edits[o.document].emplace_back(o.span, by_number ? letter + name : text);
  }
  for (const auto& [in, list] : edits) {
    check_length(naming, *in, list);
    const char* path = in->path().c_str();
    if (::access(path, F_OK) == 0 && ::access(path, W_OK) != 0)
      refuse(in->path() + " has the name, and cannot be written");
  }
  return edits;
}

/// The file that is named after a sub goes with it.
Json rename_file(const Files& files, const Sub& sub, const std::string& name) {
  const std::string& old = sub.document->path();
  const std::string to = joined_path(folder_of(old), fmt::format("{}{}", name, ending_of(old)));
  if (files.exists(to)) refuse("the file " + to + " exists already");
  return {{"kind", "rename"}, {"oldUri", sub.document->uri()}, {"newUri", uri_of_path(to)}};
}

}  // namespace

Json prepare_rename(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  if (!target) return nullptr;
  const Naming naming(workspace, document, *target, offset);
  return {{"range", document.range(target->span)},
          {"placeholder", document.text().substr(target->span.begin, target->span.end - target->span.begin)}};
}

Json rename(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  if (!target) refuse("there is nothing to rename here");
  const Naming naming(workspace, document, *target, offset);
  const std::string typed = params.at("newName").get<std::string>();
  const bool parameter = target->kind == Target::Kind::kParameter;
  const std::string name = parameter ? parameter_of(typed, target->name) : label_of(typed);
  if (!parameter) check_name(name);
  Json changes = Json::array();
  if (name == naming.old_name()) return {{"documentChanges", changes}};
  naming.require_free(name);
  for (const auto& [in, edits] : edits_of(naming, name)) {
    Json list = Json::array();
    for (const auto& [span, text] : edits) list.push_back({{"range", in->range(span)}, {"newText", text}});
    const Json version = in->version ? Json(*in->version) : Json(nullptr);
    changes.push_back({{"textDocument", {{"uri", in->uri()}, {"version", version}}}, {"edits", std::move(list)}});
  }
  if (naming.sub().own_file) changes.push_back(rename_file(workspace.files(), naming.sub(), name));
  return {{"documentChanges", changes}};
}

}  // namespace owlint::lsp
