// JSON-RPC over a pair of streams, framed as LSP 3.17 "Base Protocol" says: headers, a blank line, a body of
// Content-Length bytes.
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace owlint::lsp {

using Json = nlohmann::json;

/// Codes of the protocol.
enum class ErrorCode : int {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,
  kServerNotInitialized = -32002,
  kRequestCancelled = -32800,
  kRequestFailed = -32803,
};

/// The answer to a request instead of a result.
struct ResponseError {
  ErrorCode code;
  std::string message;
};

/// Reads one message's body. Returns nothing at the end of the stream. If the stream cannot be read any further, `*problem`
/// says why: an invalid header, a length that is missing or too large, an end in the middle of a message.
std::optional<std::string> read_message(std::FILE* in, std::string* problem);

/// Writes one message. False if the reader is gone.
bool write_message(std::FILE* out, const Json& message);

}  // namespace owlint::lsp
