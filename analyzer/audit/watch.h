// Waits until a program in one of some folders is saved, moved or deleted.
#pragma once

#include <atomic>
#include <string>
#include <vector>

namespace owlint::audit {

class Watch {
 public:
  /// Watches the folders and all folders below them. Throws std::runtime_error if the system does not allow it.
  explicit Watch(const std::vector<std::string>& folders);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Returns true when something has changed and then nothing more for a moment, or false when `stop` was set.
  bool wait(const std::atomic<bool>& stop);
};

}  // namespace owlint::audit
