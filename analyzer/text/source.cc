#include "analyzer/text/source.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace owlint {
namespace {

constexpr uint32_t kMarkEvery = 256;

}  // namespace

size_t sequence_length(std::string_view bytes, size_t at) {
  const auto lead = static_cast<unsigned char>(bytes[at]);
  const size_t length = lead < 0xC2 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 1;
  if (at + length > bytes.size()) return 1;
  for (size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(bytes[at + i]) & 0xC0) != 0x80) return 1;
  }
  return length;
}

std::string small_letters(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

uint32_t count_code_points(std::string_view bytes) {
  uint32_t count = 0;
  for (size_t at = 0; at < bytes.size(); at += sequence_length(bytes, at)) ++count;
  return count;
}

std::shared_ptr<const Source> Source::own(std::string path, std::string bytes) {
  std::shared_ptr<Source> source(new Source(std::move(path)));
  source->owned_ = std::move(bytes);
  source->bytes_ = source->owned_;
  return source;
}

std::shared_ptr<const Source> Source::adopt(std::string path, void* mapping, size_t size) {
  std::shared_ptr<Source> source(new Source(std::move(path)));
  source->mapping_ = mapping;
  source->mapping_size_ = size;
  source->bytes_ = {static_cast<const char*>(mapping), size};
  return source;
}

std::shared_ptr<const Source> Source::excerpt(std::string path, const std::vector<KeptLine>& lines,
                                              uint32_t line_count) {
  std::shared_ptr<Source> source(new Source(std::move(path)));
  for (const KeptLine& line : lines) {
    const uint64_t begin = source->owned_.size();
    source->owned_ += line.text;
    source->kept_.push_back({line.number, line.offset, {begin, source->owned_.size()}});
    source->owned_ += '\n';
  }
  source->bytes_ = source->owned_;
  source->is_excerpt_ = true;
  source->line_count_ = line_count;
  return source;
}

/// The last kept line that begins at an offset of the file or before it.
const Source::Kept* Source::kept_at(uint64_t offset) const {
  const auto after = std::ranges::upper_bound(kept_, offset, {}, &Kept::offset);
  return after == kept_.begin() ? nullptr : &*(after - 1);
}

std::string_view Source::kept_slice(Span span) const {
  const Kept* line = kept_at(span.begin);
  if (line == nullptr) return {};
  const uint64_t begin = std::min(line->text.begin + (span.begin - line->offset), line->text.end);
  return bytes_.substr(begin, span.end - span.begin);
}

Source::~Source() {
  if (mapping_ != nullptr) ::munmap(mapping_, mapping_size_);
}

void Source::index() const {
  std::call_once(indexed_, [this] { find_marks(); });  // files that many programs call are asked from many threads
}

void Source::find_marks() const {
  marks_.push_back(0);
  const char* const begin = bytes_.data();
  const char* const end = begin + bytes_.size();
  const char* at = begin;
  uint32_t feeds = 0;
  while (at < end) {
    const auto* feed = static_cast<const char*>(std::memchr(at, '\n', static_cast<size_t>(end - at)));
    if (feed == nullptr) break;
    at = feed + 1;
    if (++feeds % kMarkEvery == 0) marks_.push_back(static_cast<uint64_t>(at - begin));
  }
  line_count_ = feeds + (at < end ? 1 : 0);
}

void Source::advise(Span part, int advice) const {
  const auto page = static_cast<uint64_t>(::sysconf(_SC_PAGESIZE));
  part.begin -= part.begin % page;
  if (part.end < bytes_.size()) part.end -= part.end % page;
  if (mapping_ == nullptr || part.end <= part.begin) return;
  ::madvise(static_cast<char*>(mapping_) + part.begin, part.end - part.begin,
            advice);  // older kernels refuse some: no harm
}

void Source::will_read(Span part) const {
#ifdef MADV_POPULATE_READ
  advise(part, MADV_POPULATE_READ);
#endif
}

void Source::let_go(Span part) const { advise(part, MADV_DONTNEED); }

uint32_t Source::line_count() const {
  if (is_excerpt_) return line_count_;
  index();
  return line_count_;
}

Span Source::line(uint32_t number) const {
  if (is_excerpt_) {
    const auto line = std::ranges::find(kept_, number, &Kept::number);
    if (line == kept_.end()) return {};
    return {line->offset, line->offset + (line->text.end - line->text.begin)};
  }
  index();
  if (number == 0 || number > line_count_) return {bytes_.size(), bytes_.size()};
  uint64_t begin = marks_[(number - 1) / kMarkEvery];
  for (uint32_t left = (number - 1) % kMarkEvery; left > 0; --left) begin = bytes_.find('\n', begin) + 1;
  const size_t feed = bytes_.find('\n', begin);
  return {begin, feed == std::string_view::npos ? bytes_.size() : feed};
}

Position Source::position(uint64_t offset) const {
  if (is_excerpt_) {
    const Kept* line = kept_at(offset);
    if (line == nullptr) return {1, 1, offset};
    return {line->number, count_code_points(slice({line->offset, offset})) + 1, offset};
  }
  index();
  offset = std::min<uint64_t>(offset, bytes_.size());
  const auto mark = std::upper_bound(marks_.begin(), marks_.end(), offset) - 1;
  uint32_t line = static_cast<uint32_t>(mark - marks_.begin()) * kMarkEvery + 1;
  uint64_t begin = *mark;
  for (;;) {
    const size_t feed = bytes_.find('\n', begin);
    if (feed == std::string_view::npos || feed >= offset) break;
    begin = feed + 1;
    ++line;
  }
  return {line, count_code_points(bytes_.substr(begin, offset - begin)) + 1, offset};
}

}  // namespace owlint
