#include "analyzer/lsp/lines.h"

#include <algorithm>
#include <cstring>

namespace owlint::lsp {
namespace {

/// Offsets after the line ends that begin in [from, to).
void find_starts(std::string_view text, size_t from, size_t to, std::vector<size_t>& out) {
  const bool returns = std::memchr(text.data() + from, '\r', to - from) != nullptr;
  for (size_t at = from; at < to; ++at) {
    if (!returns) {  // the common case, as fast as memory
      const void* feed = std::memchr(text.data() + at, '\n', to - at);
      if (feed == nullptr) return;
      at = static_cast<size_t>(static_cast<const char*>(feed) - text.data());
    } else if (text[at] == '\r') {
      if (at + 1 < text.size() && text[at + 1] == '\n') continue;  // ends at its line feed
    } else if (text[at] != '\n') {
      continue;
    }
    out.push_back(at + 1);
  }
}

/// A byte that is not UTF-8 counts like one character: editors show a replacement for it.
uint32_t units_of_sequence(size_t length, Encoding encoding) {
  switch (encoding) {
    case Encoding::kUtf8: return static_cast<uint32_t>(length);
    case Encoding::kUtf16: return length == 4 ? 2 : 1;
    case Encoding::kUtf32: break;
  }
  return 1;
}

}  // namespace

uint32_t units(std::string_view bytes, Encoding encoding) {
  if (encoding == Encoding::kUtf8) return static_cast<uint32_t>(bytes.size());
  uint32_t count = 0;
  for (size_t at = 0; at < bytes.size();) {
    const size_t length = sequence_length(bytes, at);
    count += units_of_sequence(length, encoding);
    at += length;
  }
  return count;
}

Lines::Lines(std::string_view text) : starts_{0} { find_starts(text, 0, text.size(), starts_); }

void Lines::replaced(std::string_view text, size_t from, size_t to, size_t inserted) {
  // A line end may be made or unmade by what comes right before and after the edit.
  const size_t begin = from > 0 ? from - 1 : 0;
  const size_t end = std::min(from + inserted + 1, text.size());
  const auto first = std::upper_bound(starts_.begin(), starts_.end(), begin);
  const auto last = std::upper_bound(first, starts_.end(), to + 1);
  std::vector<size_t> fresh;
  find_starts(text, begin, end, fresh);
  const size_t gone = to - from;
  std::vector<size_t> behind(last, starts_.end());
  for (size_t& start : behind) start = start - gone + inserted;
  starts_.erase(first, starts_.end());
  for (const size_t start : fresh) {
    if (behind.empty() || start < behind.front()) starts_.push_back(start);
  }
  starts_.insert(starts_.end(), behind.begin(), behind.end());
}

Span Lines::line(std::string_view text, size_t line) const {
  const size_t begin = starts_[line];
  size_t end = line + 1 < starts_.size() ? starts_[line + 1] : text.size();
  if (line + 1 < starts_.size()) {
    if (end > begin && text[end - 1] == '\n') --end;
    if (end > begin && text[end - 1] == '\r') --end;
  }
  return {begin, end};
}

size_t Lines::line_of(uint64_t offset) const {
  return static_cast<size_t>(std::upper_bound(starts_.begin(), starts_.end(), offset) - starts_.begin()) - 1;
}

EditorPosition Lines::position(std::string_view text, uint64_t offset, Encoding encoding) const {
  offset = std::min<uint64_t>(offset, text.size());
  const size_t at = line_of(offset);
  return {static_cast<uint32_t>(at), units(text.substr(starts_[at], offset - starts_[at]), encoding)};
}

uint64_t Lines::offset(std::string_view text, EditorPosition position, Encoding encoding) const {
  if (position.line >= starts_.size()) return text.size();
  const Span span = line(text, position.line);
  uint32_t left = position.character;
  uint64_t at = span.begin;
  while (at < span.end && left > 0) {
    const size_t length = sequence_length(text.substr(0, span.end), at);
    const uint32_t wide = units_of_sequence(length, encoding);
    if (wide > left) break;
    left -= wide;
    at += length;
  }
  return at;
}

}  // namespace owlint::lsp
