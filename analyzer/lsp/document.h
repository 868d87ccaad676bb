// A file as the language server sees it: open in the editor, or on disk. Everything about it is made when first
// needed, and discarded with the next change.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "analyzer/flow/summaries/data_flow.h"
#include "analyzer/lsp/lines.h"
#include "analyzer/lsp/protocol.h"
#include "analyzer/program/program.h"

namespace owlint::lsp {

class Document {
 public:
  Document(std::string uri, std::string path, std::string text, Encoding encoding);

  const std::string& uri() const { return uri_; }
  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }
  const Lines& lines() const { return lines_; }
  Encoding encoding() const { return encoding_; }

  std::optional<int64_t> version;  ///< the editor's version number; none for files on disk

  /// One of the editor's changes: a range and its new text, or a new text of the whole. Throws Json's exceptions.
  void change(const Json& change);

  std::shared_ptr<const Source> source() const;
  /// Structure of the text, without the files that it calls.
  const Program& program() const;
  /// What its subs do with parameters.
  const flow::DataFlow& data() const;

  // Positions, to the protocol and back.
  Json position(uint64_t offset) const;
  Json range(Span span) const;
  Json location(Span span) const { return {{"uri", uri_}, {"range", range(span)}}; }
  uint64_t offset(const Json& position) const;
  Span span(const Json& range) const;
  /// The bytes of the editor's line that holds an offset, without its end.
  Span line_at(uint64_t offset) const { return lines_.line(text_, lines_.line_of(offset)); }

  /// The statement whose line holds the offset; kNoStatement if there is none.
  StatementId statement_at(uint64_t offset) const;

 private:
  std::string uri_, path_, text_;
  Lines lines_;
  Encoding encoding_;
  mutable std::shared_ptr<const Source> source_;
  mutable std::shared_ptr<const Program> program_;
  mutable std::shared_ptr<const flow::DataFlow> data_;
};

/// `file:///a%20b.ngc` to a path and back; other schemes stay as they are.
std::string path_of_uri(const std::string& uri);
std::string uri_of_path(const std::string& path);

}  // namespace owlint::lsp
