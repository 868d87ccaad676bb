// Any bytes are an INI: reading must come back, with values and places inside the file; and so must a machine made of it.
#include <cstdlib>
#include <string>

#include "analyzer/machine/setup.h"
#include "analyzer/text/memory_files.h"

using namespace owlint;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string path = "/machine.ini";
  MemoryFiles files;
  files.add_file(path, bytes);
  Ini ini;
  ini.parse(files, Source::own(path, bytes));
  for (const Ini::Entry& e : ini.entries()) {
    require(!e.key.empty() || e.value.size() <= size);
    require(e.span.begin <= e.span.end && e.span.end <= size);
    require(e.value.find('\n') == std::string::npos);
    ini.find(e.section, e.key);
    ini.all(e.section, e.key);
  }
  std::string error;
  if (const auto setup = read_setup(files, path, &error)) {
    for (const IniFolder& folder : setup->folders) require(folder.span.end <= folder.source->bytes().size());
    for (const IniCall& call : setup->calls) require(call.span.end <= call.source->bytes().size());
    setup->search_path->find("a/b");
  }
  return 0;
}
