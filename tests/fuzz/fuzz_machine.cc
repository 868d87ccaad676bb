// Any bytes are a machine: an INI with its tool table and its file of parameters, cut at the first two `\f`. Every rule
// about INIs
// must come back, with findings inside their files.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "analyzer/machine/check_config.h"
#include "analyzer/machine/strict_ini.h"
#include "analyzer/machine/tool_lines.h"
#include "analyzer/machine/var_file.h"
#include "analyzer/text/memory_files.h"
#include "rules/driver/lint.h"

using namespace owlint;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const Files& files, const std::shared_ptr<const MachineSetup>& setup, Version version) {
  Library library(files);
  Profile profile;
  profile.setup = setup;
  profile.version = version;
  profile.version_given = true;
  for (const FileReport& report : lint_setup(profile, {}, library)) {
    for (const Finding& f : report.findings) {
      require(f.span.begin <= f.span.end && f.span.end <= report.source->bytes().size());
      require(!f.message.empty());
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const size_t table = std::min(bytes.find('\f'), size);
  const size_t parameters = std::min(bytes.find('\f', table + 1), size);
  MemoryFiles files;
  files.add_file("/machine.ini", bytes.substr(0, table));
  files.add_file("/tool.tbl", bytes.substr(std::min(table + 1, size), parameters - std::min(table + 1, parameters)));
  files.add_file("/rs274ngc.var", bytes.substr(std::min(parameters + 1, size)));
  std::string error;
  const auto setup = read_setup(files, "/machine.ini", &error);
  if (setup == nullptr) return 0;
  for (const IniLine& line : setup->text.lines()) {
    require(line.span.begin <= line.span.end && line.span.end <= setup->text.source(line)->bytes().size());
    require(line.name.begin <= line.name.end && line.name.end <= line.span.end);
    require(line.value.begin <= line.value.end && line.value.end <= line.span.end);
  }
  for (const StrictRefusal& refusal : strict_refusals(setup->text)) require(refusal.span.begin <= refusal.span.end);
  check_config(setup->text);
  check(files, setup, Version::k2_9);
  check(files, setup, Version::k2_10);
  return 0;
}
