// Any bytes are a tool table: reading must come back, with every number once and places inside the table.
#include <cstdlib>
#include <unordered_set>

#include "analyzer/machine/tool_table.h"

using namespace owlint;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const ToolChanger changer : {ToolChanger::kFixed, ToolChanger::kRandom}) {
    const ToolTable table = read_tool_table(bytes, changer);
    std::unordered_set<int32_t> numbers;
    for (const ToolRow& row : table.rows) {
      require(numbers.insert(row.number).second && table.find(row.number) == &row);
      require(row.span.begin < row.span.end && row.span.end <= size);
      require(bytes.substr(row.span.begin, row.span.end - row.span.begin).find('\n') == std::string_view::npos);
      require(row.line >= 1 && row.line <= size);
    }
  }
  return 0;
}
