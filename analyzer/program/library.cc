#include "analyzer/program/library.h"

namespace owlint {

void Library::forget(const std::string& path) {
  const std::lock_guard lock(mutex_);
  slots_.erase(file_key(path));
}

std::shared_ptr<Library::Slot> Library::slot(const std::string& path, bool for_call) {
  const std::lock_guard lock(mutex_);
  auto& entry = slots_[file_key(path)];
  if (entry == nullptr) entry = std::make_shared<Slot>();
  if (for_call) {
    ++uses_;
    if (!entry->called) ++called_;
    entry->called = true;
  }
  return entry;
}

std::shared_ptr<const Program> Library::load_called(const std::string& path) {
  const auto entry = slot(path, true);
  std::call_once(entry->once, [&] {
    ++parsed_;
    std::string error;
    auto source = open_(path, &error);
    if (source == nullptr) source = Source::own(path, "");
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
  const auto program = entry->program;
  if (!defines_own_name(*program)) {
    const std::lock_guard lock(mutex_);
    if (!entry->called) slots_.erase(file_key(path));
  }
  return program;
}

std::shared_ptr<const SearchPath> Library::beside(const std::string& folder) {
  const std::lock_guard lock(mutex_);
  auto& path = folders_[folder];
  if (path == nullptr) path = std::make_shared<SearchPath>(std::vector<std::string>{folder});
  return path;
}

}  // namespace owlint
