#include "analyzer/machine/ini_hidden.h"

#include <algorithm>

namespace owlint {
namespace {

bool is_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  return bytes.size() > 1 && (bytes[0] == '\0') != (bytes[1] == '\0');
}

/// Whether already the first line ends so that LinuxCNC gives up: then it has found nothing before.
bool ends_with_returns(std::string_view bytes) {
  const size_t end = bytes.find_first_of("\r\n");
  return end != std::string_view::npos && end + 1 < bytes.size() && bytes[end] == '\r' && bytes[end + 1] != '\n';
}

IniHidden form_of(std::string_view bytes) {
  if (is_utf16(bytes)) return IniHidden::kUtf16;
  return ends_with_returns(bytes) ? IniHidden::kReturns : IniHidden::kNone;
}

bool has_section_line(std::string_view text) {
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    if (line.starts_with('[') && line.find(']') != std::string_view::npos) return true;
    at = end + 1;
  }
  return false;
}

std::string seen(std::string_view bytes, IniHidden form) {
  std::string text(bytes);
  if (form == IniHidden::kUtf16) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) text.erase(0, 2);
    std::erase(text, '\0');
  }
  if (form != IniHidden::kNone) std::ranges::replace(text, '\r', '\n');
  return text;
}

}  // namespace

IniHidden how_hidden(std::string_view bytes) {
  const IniHidden form = form_of(bytes);
  return form != IniHidden::kNone && has_section_line(seen(bytes, form)) ? form : IniHidden::kNone;
}

std::string text_as_seen(std::string_view bytes) { return seen(bytes, form_of(bytes)); }

}  // namespace owlint
