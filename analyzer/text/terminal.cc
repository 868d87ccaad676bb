#include "analyzer/text/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace owlint {
namespace {

std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

}  // namespace

bool is_terminal(int stream) { return ::isatty(stream) != 0 && environment("TERM") != "dumb"; }

bool use_color(const std::string& wanted, int stream) {
  if (wanted != "auto") return wanted == "always";
  return environment("NO_COLOR").empty() && is_terminal(stream);
}

size_t columns_of(int stream) {
  winsize size{};
  return ::isatty(stream) != 0 && ::ioctl(stream, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace owlint
