#include "analyzer/syntax/line_text.h"

namespace owlint {

namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }  // as the interpreter's isspace

}  // namespace

StopKind LineText::assign(std::string_view raw, uint64_t offset) {
  offset_ = offset;
  length_ = 0;
  // The interpreter reads with C strings: a NUL hides the rest of the line.
  const size_t nul = raw.find('\0');
  nul_ = nul != std::string_view::npos;
  if (nul_) raw = raw.substr(0, nul);
  while (!raw.empty() && is_space(raw.back())) raw.remove_suffix(1);
  end_ = static_cast<uint16_t>(raw.size());

  bool in_comment = false;
  bool to_line_end = false;
  size_t opened = 0;
  for (size_t i = 0; i < raw.size(); ++i) {
    char c = raw[i];
    if (to_line_end) {
      // the rest of the line is a `;` comment, kept as it is
    } else if (in_comment) {
      if (c == ')') in_comment = false;
      if (c == '(') {
        error_ = {offset + i, offset + i + 1};
        return StopKind::kCommentNested;
      }
    } else if (c == ' ' || c == '\t' || c == '\r') {
      continue;
    } else if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    } else if (c == '(') {
      in_comment = true;
      opened = i;
    } else if (c == ';') {
      to_line_end = true;
    }
    text_[length_] = c;
    at_[length_] = static_cast<uint16_t>(i);
    ++length_;
  }
  if (in_comment) {
    error_ = {offset + opened, offset + raw.size()};
    return StopKind::kCommentUnclosed;
  }
  return StopKind::kNone;
}

}  // namespace owlint
