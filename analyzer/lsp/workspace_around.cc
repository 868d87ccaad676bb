// What belongs together in a workspace: programs that call each other, and the machines that they may run on.
#include <algorithm>

#include "analyzer/checking/walk.h"
#include "analyzer/lsp/ini_document.h"
#include "analyzer/lsp/workspace.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {

std::vector<const Document*> Workspace::documents_around(const Document& from) {
  std::vector<std::string> paths;
  checking::WalkOptions all;
  all.ignore_files = false;  // LinuxCNC runs these, too
  for (checking::WalkedFile& file : checking::walk(files_, folders_, all).files) paths.push_back(std::move(file.path));
  for (const auto& [uri, document] : open_) {
    if (!is_ini(document->path())) paths.push_back(document->path());
  }
  const auto folders = search_path(from);
  for (const std::string& name : folders->names()) {
    if (const auto file = folders->find(name); file && file->regular) paths.push_back(file->path);
  }
  std::vector<const Document*> out{&from};
  std::set<std::string> known{file_key(from.path())};
  for (const std::string& path : paths) {
    if (!known.insert(file_key(path)).second) continue;
    if (const Document* document = document_of_path(path)) out.push_back(document);
  }
  return out;
}

std::vector<const Document*> Workspace::documents_run_with(const Document& from) {
  std::vector<const Document*> all = documents_around(from);
  std::map<std::string, size_t> numbers;
  for (size_t i = 0; i < all.size(); ++i) numbers.emplace(file_key(all[i]->path()), i);
  std::vector<std::vector<size_t>> callees, callers(all.size());
  for (size_t i = 0; i < all.size(); ++i) {
    callees.emplace_back();
    const Program& p = all[i]->program();
    const auto folders = p.calls.empty() ? nullptr : search_path(*all[i]);
    for (const Call& call : p.calls) {
      if (call.callee == kNoName || call.target != kNoRegion) continue;
      const auto file = folders->find(p.name(call.callee));
      const Document* called = file && file->regular ? document_of_path(file->path) : nullptr;
      if (called == nullptr) continue;
      const auto [entry, is_new] = numbers.emplace(file_key(file->path), all.size());
      if (is_new) {
        all.push_back(called);
        callers.emplace_back();
      }
      callees[i].push_back(entry->second);
      callers[entry->second].push_back(i);
    }
  }
  const auto reach = [&](std::vector<size_t> todo, const std::vector<std::vector<size_t>>& edges) {
    std::vector<bool> reached(all.size());
    for (const size_t i : todo) reached[i] = true;
    for (size_t at = 0; at < todo.size(); ++at) {
      for (const size_t next : edges[todo[at]]) {
        if (!reached[next]) todo.push_back(next);
        reached[next] = true;
      }
    }
    return todo;
  };
  std::vector<const Document*> out;
  std::vector<size_t> found = reach(reach({0}, callers), callees);
  std::ranges::sort(found);
  out.reserve(found.size());
  for (const size_t i : found) out.push_back(all[i]);
  return out;
}

std::vector<std::shared_ptr<const MachineSetup>> Workspace::machines(const Document& from) {
  std::vector<std::shared_ptr<const MachineSetup>> out;
  std::set<std::string> known;
  checking::Settings settings;
  if (settings_for(from.path(), &settings) && settings.profile.setup != nullptr) {
    out.push_back(settings.profile.setup);
    known.insert(file_key(settings.profile.setup->path));
  }
  std::vector<std::string> paths;
  checking::WalkOptions all;
  all.ignore_files = false;
  all.include = {"*.ini"};
  for (checking::WalkedFile& file : checking::walk(files_, folders_, all).files) paths.push_back(std::move(file.path));
  for (const SearchFolder& folder : search_path(from)->folders()) {
    std::string unread;  // then none are found there
    for (const FolderEntry& entry : files_.list(folder.path, &unread))
      paths.push_back(joined_path(folder.path, entry.name));
  }
  for (const std::string& path : paths) {
    std::string error;
    if (!small_letters(path).ends_with(".ini") || !known.insert(file_key(path)).second) continue;
    if (auto setup = read_setup(files_, path, &error)) out.push_back(std::move(setup));
  }
  return out;
}

}  // namespace owlint::lsp
