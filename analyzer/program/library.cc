#include "analyzer/program/library.h"

#include <utility>

#include "analyzer/text/paths.h"

namespace owlint {

void Library::name_files(std::vector<std::string> paths) {
  const std::lock_guard lock(mutex_);
  unnamed_ = std::move(paths);
}

void Library::forget(const std::string& path) {
  const std::lock_guard lock(mutex_);
  slots_.erase(file_key(path));
}

std::shared_ptr<Library::Slot> Library::slot(const std::string& path, bool for_call) {
  const std::string key = file_key(path);
  const std::lock_guard lock(mutex_);
  auto& entry = slots_[key];
  if (entry == nullptr) entry = std::make_shared<Slot>();
  if (for_call) {
    ++uses_;
    if (!entry->called) {
      ++called_;
      entry->called = true;
      for (std::string& name : std::exchange(unnamed_, {})) names_[file_key(name)] = std::move(name);
      const auto named = names_.find(key);
      entry->path = named == names_.end() ? path : named->second;
    }
  }
  return entry;
}

std::shared_ptr<const Program> Library::load_called(const std::string& path) {
  const auto entry = slot(path, true);
  std::call_once(entry->once, [&] {
    ++parsed_;
    std::string error;
    auto source = files_.read(entry->path, &error);
    if (source == nullptr) source = Source::own(entry->path, "");
    entry->program = build_program(std::move(source));
  });
  return entry->program;
}

std::shared_ptr<const Program> Library::load(std::shared_ptr<const Source> source) {
  const std::string path = source->path();
  const auto entry = slot(path, false);
  std::call_once(entry->once, [&] {
    ++parsed_;
    entry->program = build_program(std::move(source));
  });
  std::shared_ptr<const Program> program = entry->program;
  if (!defines_own_name(*program)) {
    const std::lock_guard lock(mutex_);
    if (!entry->called) slots_.erase(file_key(path));
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
