// Any bytes are a stream of messages: reading comes back, at the latest with the end of the bytes.
#include <cstdlib>

#include "analyzer/lsp/protocol.h"

using namespace owlint;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  std::FILE* in = fmemopen(const_cast<uint8_t*>(data), size, "rb");
  std::string problem;
  size_t total = 0;
  while (const auto body = lsp::read_message(in, &problem)) {
    total += body->size();
    if (total > size) std::abort();
  }
  std::fclose(in);
  return 0;
}
