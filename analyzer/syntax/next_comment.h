// Where comments are in a file, for what looks at them alone.
#pragma once

#include <algorithm>

#include "analyzer/text/source.h"

namespace owlint {

/// The next `(` from a place on; the end of the bytes if there is none. What has no comment is let go: a file of gigabytes is
/// never in memory as a whole.
inline size_t next_comment(const Source& source, size_t at) {
  constexpr size_t kStretch = 4 << 20;
  const std::string_view text = source.bytes();
  while (at < text.size()) {
    const size_t end = std::min(text.size(), at + kStretch);
    const size_t found = text.substr(at, end - at).find('(');
    if (found != std::string_view::npos) return at + found;
    if (text.size() > kStretch) source.let_go({at, end});
    at = end;
  }
  return at;
}

}  // namespace owlint
