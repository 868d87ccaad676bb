#include "analyzer/lsp/document.h"

#include <algorithm>

#include "analyzer/syntax/last_statement.h"
#include "analyzer/text/printable.h"

namespace owlint::lsp {

Document::Document(std::string uri, std::string path, std::string text, Encoding encoding)
    : uri_(std::move(uri)), path_(std::move(path)), text_(std::move(text)), lines_(text_), encoding_(encoding) {}

void Document::change(const Json& change) {
  std::string fresh = change.at("text").get<std::string>();
  if (!change.contains("range")) {
    text_ = std::move(fresh);
    lines_ = Lines(text_);
  } else {
    const Span at = span(change.at("range"));
    text_.replace(at.begin, at.end - at.begin, fresh);
    lines_.replaced(text_, at.begin, at.end, fresh.size());
  }
  source_.reset();
  program_.reset();
  data_.reset();
}

std::shared_ptr<const Source> Document::source() const {
  if (source_ == nullptr) source_ = Source::own(path_, text_);
  return source_;
}

const Program& Document::program() const {
  if (program_ == nullptr) program_ = build_program(source());
  return *program_;
}

const flow::DataFlow& Document::data() const {
  if (data_ == nullptr) data_ = std::make_shared<flow::DataFlow>(program());
  return *data_;
}

Json Document::position(uint64_t offset) const {
  const EditorPosition p = lines_.position(text_, offset, encoding_);
  return {{"line", p.line}, {"character", p.character}};
}

Json Document::range(Span span) const { return {{"start", position(span.begin)}, {"end", position(span.end)}}; }

uint64_t Document::offset(const Json& position) const {
  const auto part = [&](const char* name) {
    return static_cast<uint32_t>(std::min<uint64_t>(position.at(name).get<uint64_t>(), UINT32_MAX));
  };
  return lines_.offset(text_, {part("line"), part("character")}, encoding_);
}

Span Document::span(const Json& range) const {
  const uint64_t begin = offset(range.at("start"));
  return {begin, std::max(begin, offset(range.at("end")))};
}

StatementId Document::statement_at(uint64_t offset) const {
  const StatementId id = last_statement(program().syntax, offset);
  return id != kNoStatement && offset <= program().at(id).end() ? id : kNoStatement;
}

std::string path_of_uri(const std::string& uri) {
  constexpr std::string_view kScheme = "file://";
  if (!uri.starts_with(kScheme)) return uri;
  std::string path;
  const size_t begin = uri.find('/', kScheme.size());
  for (size_t i = begin == std::string::npos ? uri.size() : begin; i < uri.size(); ++i) {
    const auto hex = [](char c) {
      return c >= '0' && c <= '9' ? c - '0' : (c | 0x20) >= 'a' && (c | 0x20) <= 'f' ? (c | 0x20) - 'a' + 10 : -1;
    };
    if (uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0) {
      path.push_back(static_cast<char>(hex(uri[i + 1]) * 16 + hex(uri[i + 2])));
      i += 2;
    } else {
      path.push_back(uri[i]);
    }
  }
  return path;
}

std::string uri_of_path(const std::string& path) { return "file://" + percent_encoded(path); }

}  // namespace owlint::lsp
