#include "analyzer/syntax/nature.h"

#include <algorithm>

#include "analyzer/syntax/controllers.h"

namespace owlint {
namespace {

constexpr size_t kHead = 16 << 10;  // bytes: what tells a controller by its programs comes early, and often

/// Two bytes a letter: a byte order mark, or a NUL beside most letters.
bool is_utf16(std::string_view head) {
  if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF")) return true;
  constexpr size_t kFew = 8;
  size_t nul[2] = {0, 0};
  for (size_t i = 0; i < head.size(); ++i) nul[i & 1] += head[i] == '\0' ? 1 : 0;
  const size_t pairs = head.size() / 2;
  const size_t most = std::max(nul[0], nul[1]);
  return pairs >= kFew && most > pairs * 3 / 4 && most - std::min(nul[0], nul[1]) > pairs / 2;
}

/// Text has no control characters but those for blanks and line ends. A damaged program has some.
bool is_no_text(std::string_view head) {
  constexpr size_t kFew = 8;
  constexpr size_t kShare = 20;  // one in so many
  const auto control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && (byte < '\t' || byte > '\r') && byte != 0x1A;  // 0x1A ends old DOS files
  };
  const auto count = static_cast<size_t>(std::ranges::count_if(head, control));
  return count >= kFew && count * kShare >= head.size();
}

}  // namespace

Nature nature_of(std::string_view bytes) {
  constexpr size_t kFirst = 2048;
  // A crash leaves a file of the right length with NUL bytes at its end.
  const std::string_view first = bytes.substr(0, std::min(kFirst, bytes.find_last_not_of('\0') + 1));
  Nature nature;
  if (first.empty() && !bytes.empty()) {
    nature.kind = Nature::kNoText;
  } else if (is_utf16(first)) {
    nature.kind = Nature::kUtf16;
  } else if (is_no_text(first)) {
    nature.kind = Nature::kNoText;
  } else {
    find_controller(bytes.substr(0, kHead), &nature);
  }
  return nature;
}

}  // namespace owlint
