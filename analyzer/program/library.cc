#include "analyzer/program/library.h"

#include <utility>

#include "analyzer/program/machine_words.h"
#include "analyzer/text/paths.h"

namespace owlint {
namespace {

/// A file's lines are read in one way for all machines with the same axes and codes.
std::string slot_key(const std::string& file, const WordsOfMachine& machine) { return file + '\0' + machine.key(); }

}  // namespace

void Library::name_files(std::vector<std::string> paths) {
  const std::lock_guard lock(mutex_);
  unnamed_ = std::move(paths);
}

void Library::forget(const std::string& path) {
  const std::lock_guard lock(mutex_);
  const std::string file = file_key(path) + '\0';
  const auto first = slots_.lower_bound(file);
  auto last = first;
  while (last != slots_.end() && last->first.starts_with(file)) ++last;
  slots_.erase(first, last);
}

std::shared_ptr<Library::Slot> Library::slot(const std::string& path, const std::string& key, bool for_call) {
  const std::lock_guard lock(mutex_);
  auto& entry = slots_[key];
  if (entry == nullptr) entry = std::make_shared<Slot>();
  if (for_call) {
    ++uses_;
    if (!entry->called) {
      ++called_;
      entry->called = true;
      for (std::string& name : std::exchange(unnamed_, {})) names_[file_key(name)] = std::move(name);
      const auto named = names_.find(key.substr(0, key.find('\0')));
      entry->path = named == names_.end() ? path : named->second;
    }
  }
  return entry;
}

std::shared_ptr<const Program> Library::load_called(const std::string& path, const Profile& profile) {
  const WordsOfMachine machine(profile);
  const auto entry = slot(path, slot_key(file_key(path), machine), true);
  std::call_once(entry->once, [&] {
    ++parsed_;
    std::string error;
    auto source = files_.read(entry->path, &error);
    if (source == nullptr) source = Source::own(entry->path, "");
    entry->program = build_program(std::move(source), machine.words);
  });
  return entry->program;
}

std::shared_ptr<const Program> Library::load(std::shared_ptr<const Source> source, const Profile& profile) {
  const WordsOfMachine machine(profile);
  const std::string path = source->path();
  const std::string key = slot_key(file_key(path), machine);
  const auto entry = slot(path, key, false);
  std::call_once(entry->once, [&] {
    ++parsed_;
    entry->program = build_program(std::move(source), machine.words);
  });
  std::shared_ptr<const Program> program = entry->program;
  if (!defines_own_name(*program)) {
    const std::lock_guard lock(mutex_);
    if (!entry->called) slots_.erase(key);
  }
  return program;
}

std::shared_ptr<const SearchPath> Library::search_path(const std::string& program, const Profile& profile) {
  if (profile.setup != nullptr) return profile.setup->search_path;
  const std::string_view own = folder_of(program);
  std::vector<std::string> folders{own.empty() ? "." : std::string(own)};
  for (const std::string& folder : profile.sub_path) {
    if (file_key(folder) != file_key(folders[0])) folders.push_back(folder);
  }
  const std::lock_guard lock(mutex_);
  auto& path = search_paths_[folders];
  if (path == nullptr) {
    std::vector<SearchFolder> search;
    search.reserve(folders.size());
    for (std::string& folder : folders) search.push_back({std::move(folder)});
    path = std::make_shared<SearchPath>(files_, std::move(search));
  }
  return path;
}

}  // namespace owlint
