#include "analyzer/text/base64.h"

extern "C" {
#include <b64/cencode.h>
}

#include <algorithm>

namespace owlint {

std::string base64(std::string_view bytes) {
  std::string out(bytes.size() * 2 + 16, '\0');  // room for the line ends that libb64 makes
  base64_encodestate state;
  ::base64_init_encodestate(&state);
  int length = ::base64_encode_block(bytes.data(), static_cast<int>(bytes.size()), out.data(), &state);
  length += ::base64_encode_blockend(out.data() + length, &state);
  out.resize(static_cast<size_t>(length));
  std::erase(out, '\n');
  return out;
}

}  // namespace owlint
