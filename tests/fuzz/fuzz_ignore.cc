// Any bytes are an ignore file, and any a path: the first line is the path.
#include <algorithm>

#include "analyzer/checking/ignore.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const size_t feed = std::min(text.find('\n'), text.size());
  owlint::checking::IgnorePatterns patterns;
  patterns.add(text.substr(feed));
  patterns.decide(text.substr(0, feed), size % 2 == 0);
  return 0;
}
