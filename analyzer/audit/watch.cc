#include "analyzer/audit/watch.h"

#include <inotifytools/inotify.h>
#include <inotifytools/inotifytools.h>

#include <cstring>
#include <stdexcept>

namespace owlint::audit {
namespace {

constexpr int kEvents = IN_CLOSE_WRITE | IN_MOVED_FROM | IN_MOVED_TO | IN_CREATE | IN_DELETE | IN_ATTRIB;

}  // namespace

Watch::Watch(const std::vector<std::string>& folders) {
  if (!::inotifytools_initialize())
    throw std::runtime_error(std::string("cannot watch folders: ") + std::strerror(::inotifytools_error()));
  for (const std::string& folder : folders) {
    if (!::inotifytools_watch_recursively(folder.c_str(), kEvents))
      throw std::runtime_error("cannot watch " + folder + ": " + std::strerror(::inotifytools_error()));
  }
}

Watch::~Watch() { ::inotifytools_cleanup(); }

bool Watch::wait(const std::atomic<bool>& stop) {
  constexpr int kLook = 1;  // seconds after which it is asked whether to stop; a signal ends the wait as well
  bool changed = false;
  while (!stop.load()) {
    // Editors save in several steps: after the first event, until there has been none for a second.
    const inotify_event* event = ::inotifytools_next_event(kLook);
    if (event == nullptr) {
      if (changed) return true;
      continue;
    }
    const std::string_view name = event->len > 0 ? std::string_view(event->name) : std::string_view();
    if ((event->mask & IN_ISDIR) != 0 && (event->mask & (IN_CREATE | IN_MOVED_TO)) != 0) {
      const char* folder = ::inotifytools_filename_from_wd(event->wd);
      if (folder != nullptr)
        ::inotifytools_watch_recursively((std::string(folder) + std::string(name)).c_str(), kEvents);
    }
    if (!name.starts_with('.')) changed = true;
  }
  return false;
}

}  // namespace owlint::audit
