// Splits one line into tokens, also if it is not correct: for colours, and for the parameter under the cursor. The
// analysis itself does not use it.
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

}  // namespace owlint::lsp
