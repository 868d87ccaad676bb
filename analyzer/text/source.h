// The text room: a file as bytes, and positions in it. Everything else in owlint points into a Source by
// byte offset; lines and columns are computed on demand, only for findings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace owlint {

/// A half-open range of bytes: offsets from 0, `end` exclusive.
struct Span {
  uint64_t begin = 0;
  uint64_t end = 0;

  bool operator==(const Span&) const = default;
};

/// A position as people and editors count it.
struct Position {
  uint32_t line = 1;    ///< from 1; a line ends at a line feed, as for LinuxCNC
  uint32_t column = 1;  ///< from 1, in Unicode code points; a byte that is not UTF-8 counts as one
  uint64_t offset = 0;  ///< bytes from 0
};

/// One line of an excerpt.
struct KeptLine {
  uint32_t number = 1;  ///< in the file, from 1
  uint64_t offset = 0;  ///< of its first byte in the file
  std::string text;     ///< without its line end
};

/// The bytes of one program, mapped or owned, and never changed. A Source always exists: an empty file is empty bytes.
class Source {
 public:
  /// Takes bytes that are in memory; `path` is how reports name them. Files are read through Files (files.h).
  static std::shared_ptr<const Source> own(std::string path, std::string bytes);
  /// Takes over a mapping of a file, which is unmapped in the end.
  static std::shared_ptr<const Source> adopt(std::string path, void* mapping, size_t size);

  /// A file of which only some lines were kept, in their order. Positions in these lines are those of the whole file; other
  /// positions become the nearest one before. bytes() are the kept lines.
  static std::shared_ptr<const Source> excerpt(std::string path, const std::vector<KeptLine>& lines,
                                               uint32_t line_count);

  ~Source();
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  const std::string& path() const { return path_; }
  std::string_view bytes() const { return bytes_; }
  std::string_view slice(Span span) const {
    if (is_excerpt_) return kept_slice(span);
    return bytes_.substr(span.begin, span.end - span.begin);
  }

  /// Announces that a part will be read from end to end; this only saves time.
  void will_read(Span part) const;
  /// Announces that a part is not needed for now: its memory is released, and read from the file again if it is needed
  /// later. Does nothing for bytes that do not come from a file.
  void let_go(Span part) const;

  /// Line and column of an offset (clamped to the file's size).
  Position position(uint64_t offset) const;

  /// The bytes of a line (from 1) without its line end; empty beyond the last line.
  Span line(uint32_t number) const;

  /// How many lines there are: line feeds, plus one when bytes follow the last of them.
  uint32_t line_count() const;

 private:
  explicit Source(std::string path) : path_(std::move(path)) {}
  void index() const;
  void find_marks() const;
  void advise(Span part, int advice) const;

  /// A line of an excerpt: where it is in the file, and where its text is in bytes().
  struct Kept {
    uint32_t number;
    uint64_t offset;
    Span text;
  };
  const Kept* kept_at(uint64_t offset) const;
  std::string_view kept_slice(Span span) const;

  std::string path_;
  std::string owned_;
  std::string_view bytes_;
  void* mapping_ = nullptr;
  size_t mapping_size_ = 0;
  // Offsets of every 256th line only, built when first needed: a gigabyte of motion costs a few megabytes.
  mutable std::once_flag indexed_;
  mutable std::vector<uint64_t> marks_;
  mutable uint32_t line_count_ = 0;
  bool is_excerpt_ = false;
  std::vector<Kept> kept_;
};

/// Changes ASCII letters to lower case and leaves other bytes.
std::string small_letters(std::string_view text);

/// Length in bytes of the UTF-8 sequence that begins at `at`; 1 for a byte that begins none.
size_t sequence_length(std::string_view bytes, size_t at);

/// Number of code points in `bytes` (invalid bytes count one each).
uint32_t count_code_points(std::string_view bytes);

}  // namespace owlint
