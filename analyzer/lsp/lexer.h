// One line cut into tokens, for what an editor wants to know of text that need not be correct: colours, parameters under
// the cursor. The analysis itself does not use it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace owlint::lsp {

enum class TokenKind : uint8_t { kComment, kLabel, kKeyword, kParameter, kNumber, kOperator, kFunction, kWord };

struct Token {
  TokenKind kind;
  size_t begin = 0;  ///< bytes from the line's beginning
  size_t end = 0;
};

std::vector<Token> tokenize(std::string_view line);

/// The normalised name of a parameter token: `<depth>` or `31`; empty for one that is computed.
std::string parameter_name(std::string_view token);

}  // namespace owlint::lsp
