#include "analyzer/syntax/line_text.h"

namespace owlint {

namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }  // as the interpreter's isspace

/// Characters that are kept as they are, or in small letters; 0 for those that need a closer look.
constexpr std::array<char, 256> make_plain() {
  std::array<char, 256> plain{};
  for (size_t c = 1; c < plain.size(); ++c) {
    plain[c] = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
  }
  for (const unsigned char c : {' ', '\t', '\r', '(', ';'}) plain[c] = '\0';
  return plain;
}
constexpr auto kPlain = make_plain();

}  // namespace

StopKind LineText::assign(std::string_view raw, uint64_t offset) {
  offset_ = offset;
  length_ = 0;
  nul_ = comment_ = inner_cr_ = false;
  while (!raw.empty() && is_space(raw.back())) raw.remove_suffix(1);
  end_ = static_cast<uint16_t>(raw.size());
  for (size_t i = 0; i < raw.size(); ++i) {
    size_t length = length_;
    char plain = 0;
    for (; i < raw.size() && (plain = kPlain[static_cast<unsigned char>(raw[i])]) != '\0'; ++i, ++length) {
      text_[length] = plain;
      at_[length] = static_cast<uint16_t>(i);
    }
    length_ = length;
    if (i == raw.size()) break;
    switch (raw[i]) {
      case ' ': case '\t':
        break;
      case '\r':  // what is behind the last character is cut off already
        inner_cr_ = true;
        break;
      case '\0':
        return assign_before_nul(raw, offset);
      default:
        if (const StopKind error = comment(raw, &i); error != StopKind::kNone) return nul_ ? assign_before_nul(raw, offset) : error;
    }
  }
  return StopKind::kNone;
}

/// The interpreter reads with C strings: a NUL hides the rest of the line.
StopKind LineText::assign_before_nul(std::string_view raw, uint64_t offset) {
  const StopKind error = assign(raw.substr(0, raw.find('\0')), offset);
  nul_ = true;
  inner_cr_ = raw.find('\r') != std::string_view::npos;
  return error;
}

/// Takes in the comment that begins at `*at`, as it is, and moves `*at` to its last character. A NUL in it is an error,
/// too, which `nul_` tells.
StopKind LineText::comment(std::string_view raw, size_t* at) {
  comment_ = true;
  const bool to_line_end = raw[*at] == ';';
  const size_t opened = *at;
  for (; *at < raw.size(); ++*at) {
    const char c = raw[*at];
    if (c == '\r') inner_cr_ = true;
    nul_ = c == '\0';
    if (nul_ || (!to_line_end && c == '(' && *at > opened)) {
      error_ = {offset_ + *at, offset_ + *at + 1};
      return StopKind::kCommentNested;
    }
    keep(c, *at);
    if (!to_line_end && c == ')') return StopKind::kNone;
  }
  if (to_line_end) return StopKind::kNone;
  error_ = {offset_ + opened, offset_ + raw.size()};
  return StopKind::kCommentUnclosed;
}

}  // namespace owlint
