// Any bytes are an INI: reading must come back, with values and places inside the file; and so must a machine made of it.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "analyzer/machine/setup.h"

using namespace owlint;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  Ini ini;
  ini.parse(Source::own("no-such-folder/machine.ini", bytes));
  for (const Ini::Entry& e : ini.entries()) {
    require(!e.key.empty() || e.value.size() <= size);
    require(e.span.begin <= e.span.end && e.span.end <= size);
    require(e.value.find('\n') == std::string::npos);
    ini.find(e.section, e.key);
    ini.all(e.section, e.key);
  }
  // The machine is read from a file; one name serves all runs of this process.
  static const std::string path = "/tmp/owlint-fuzz-" + std::to_string(reinterpret_cast<uintptr_t>(&ini)) + ".ini";
  std::ofstream(path, std::ios::binary) << bytes;
  std::string error;
  if (const auto setup = read_setup(path, &error)) {
    for (const IniFolder& folder : setup->folders) require(folder.span.end <= folder.source->bytes().size());
    for (const IniCall& call : setup->calls) require(call.span.end <= call.source->bytes().size());
    setup->search_path->find("a/b");
  }
  return 0;
}
