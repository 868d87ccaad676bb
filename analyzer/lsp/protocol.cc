#include "analyzer/lsp/protocol.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace owlint::lsp {
namespace {

constexpr size_t kMaxHeader = 8192;
constexpr size_t kMaxBody = size_t{1} << 31;

/// A header line without its end; false at the end of the stream or where the line is too long.
bool read_line(std::FILE* in, std::string* line) {
  line->clear();
  for (int c = std::getc(in); c != EOF && line->size() <= kMaxHeader; c = std::getc(in)) {
    if (c == '\n') {
      if (!line->empty() && line->back() == '\r') line->pop_back();
      return true;
    }
    line->push_back(static_cast<char>(c));
  }
  return false;
}

bool is_content_length(std::string_view name) {
  constexpr std::string_view kName = "content-length";
  if (name.size() != kName.size()) return false;
  for (size_t i = 0; i < name.size(); ++i) {
    if ((name[i] | 0x20) != kName[i] && name[i] != '-') return false;
  }
  return true;
}

}  // namespace

std::optional<std::string> read_message(std::FILE* in, std::string* problem) {
  problem->clear();
  size_t length = 0;
  bool known = false;
  std::string line;
  for (bool first = true;; first = false) {
    if (!read_line(in, &line)) {
      if (!first || !line.empty()) *problem = "the stream ends inside a header";
      return std::nullopt;
    }
    if (line.empty()) break;
    const size_t colon = line.find(':');
    if (colon == std::string::npos) {
      *problem = "a header line without a colon";
      return std::nullopt;
    }
    if (!is_content_length(std::string_view(line).substr(0, colon))) continue;
    const size_t digit = line.find_first_not_of(" \t", colon + 1);
    const char* begin = line.data() + (digit == std::string::npos ? line.size() : digit);
    const auto [end, error] = std::from_chars(begin, line.data() + line.size(), length);
    known = error == std::errc{} && length <= kMaxBody &&
        std::string_view(end).find_first_not_of(" \t") == std::string_view::npos;
  }
  if (!known) {
    *problem = "a message without a usable Content-Length";
    return std::nullopt;
  }
  // Memory grows with what arrives, not with what the header says.
  constexpr size_t kPiece = 1 << 20;
  std::string body;
  while (body.size() < length) {
    const size_t have = body.size();
    const size_t piece = std::min(std::max(kPiece, have), length - have);
    body.resize(have + piece);
    if (std::fread(body.data() + have, 1, piece, in) != piece) {
      *problem = "the stream ends inside a message";
      return std::nullopt;
    }
  }
  return body;
}

bool write_message(std::FILE* out, const Json& message) {
  // Bytes that are not UTF-8 cannot be sent; what comes from files may have them.
  const std::string body = message.dump(-1, ' ', false, Json::error_handler_t::replace);
  return std::fprintf(out, "Content-Length: %zu\r\n\r\n", body.size()) > 0 &&
      std::fwrite(body.data(), 1, body.size(), out) == body.size() && std::fflush(out) == 0;
}

}  // namespace owlint::lsp
