// Any file is an INI.
#include <sys/mman.h>
#include <unistd.h>

#include "analyzer/machine/profile.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const int fd = ::memfd_create("machine.ini", 0);
  if (fd < 0) return 0;
  if (::write(fd, data, size) == static_cast<ssize_t>(size)) {
    owlint::Profile profile;
    std::string error;
    owlint::read_ini("/proc/self/fd/" + std::to_string(fd), &profile, &error);
    profile.warn_only();
  }
  ::close(fd);
  return 0;
}
