// Any words after `owlint:`: every code lies inside them.
#include <cstdlib>

#include "rules/driver/rule.h"

using namespace owlint;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto source = Source::own("p.ngc", {reinterpret_cast<const char*>(data), size});
  const auto list = parse_suppressions(*source, {0, size}, 7, size % 2 == 0, suppressed_code);
  if (list.empty()) std::abort();
  for (const Suppression& s : list) {
    if (s.span.begin > s.span.end || s.span.end > size) std::abort();
    if (!s.malformed && s.line != 0 && s.line != 7 && s.line != 8) std::abort();
  }
  return 0;
}
