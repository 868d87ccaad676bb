#include "analyzer/syntax/line_text.h"

namespace owlint {

namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }  // as the interpreter's isspace

// What becomes of a character: the low byte is what is kept of it.
constexpr uint16_t kKeep = 0x100;
constexpr uint16_t kLook = 0x200;  // a closer look: a comment, a carriage return, a NUL

constexpr std::array<uint16_t, 256> make_fates() {
  std::array<uint16_t, 256> fates{};
  for (size_t c = 0; c < fates.size(); ++c) {
    fates[c] = static_cast<uint16_t>(kKeep | (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c));
  }
  for (const unsigned char c : {' ', '\t'}) fates[c] = 0;
  for (const unsigned char c : {'\0', '\r', '(', ';'}) fates[c] = kLook;
  return fates;
}
constexpr auto kFates = make_fates();

}  // namespace

StopKind LineText::assign(std::string_view raw, uint64_t offset) {
  offset_ = offset;
  nul_ = comment_ = inner_cr_ = false;
  while (!raw.empty() && is_space(raw.back())) raw.remove_suffix(1);
  end_ = static_cast<uint8_t>(raw.size());
  // Without branches: where the blanks are cannot be foreseen.
  size_t length = 0;
  unsigned seen = 0;
  for (size_t i = 0; i < raw.size(); ++i) {
    const unsigned fate = kFates[static_cast<unsigned char>(raw[i])];
    text_[length] = static_cast<char>(fate);
    at_[length] = static_cast<uint8_t>(i);
    length += (fate & kKeep) / kKeep;
    seen |= fate;
  }
  length_ = length;
  const StopKind error = (seen & kLook) == 0 ? StopKind::kNone : assign_slowly(raw);
  text_[length_] = '\0';
  return error;
}

/// The same for a line with a comment, a carriage return or a NUL.
StopKind LineText::assign_slowly(std::string_view raw) {
  length_ = 0;
  for (size_t i = 0; i < raw.size(); ++i) {
    const unsigned fate = kFates[static_cast<unsigned char>(raw[i])];
    if ((fate & kKeep) != 0) keep(static_cast<char>(fate), i);
    if ((fate & kLook) == 0) continue;
    if (raw[i] == '\0') return assign_before_nul(raw);
    if (raw[i] == '\r') {  // what is after the last character is cut off already
      inner_cr_ = true;
      continue;
    }
    if (const StopKind error = comment(raw, &i); error != StopKind::kNone) return nul_ ? assign_before_nul(raw) : error;
  }
  return StopKind::kNone;
}

/// The interpreter reads with C strings: a NUL hides the rest of the line.
StopKind LineText::assign_before_nul(std::string_view raw) {
  const StopKind error = assign(raw.substr(0, raw.find('\0')), offset_);
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
