// Any bytes are a machine: an INI with its tool table, its file of parameters, a sub for remaps and a program, cut at the first
// four `\f`. Every rule about INIs must come back, with findings inside their files, and so must those about the program.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "analyzer/machine/check_config.h"
#include "analyzer/machine/ngcgui_file.h"
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

/// The program, with codes that the INI remaps to the sub `r`.
void check_program(const Files& files, const std::shared_ptr<const MachineSetup>& setup) {
  Library library(files);
  Profile profile;
  profile.setup = setup;
  std::string error;
  const auto source = files.read("/program.ngc", &error);
  const ProgramReport report = lint(library.load(source, profile), profile, {}, library);
  for (const Finding& f : report.own.findings)
    require(f.span.begin <= f.span.end && f.span.end <= source->bytes().size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  MemoryFiles files;
  size_t at = 0;
  for (const char* name : {"/machine.ini", "/tool.tbl", "/rs274ngc.var", "/r.ngc", "/program.ngc"}) {
    const size_t end = std::min(bytes.find('\f', at), size);
    files.add_file(name, bytes.substr(at, end - at));
    at = std::min(end + 1, size);
  }
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
  const auto sub = files.read("/r.ngc", &error);
  if (const auto problem = ngcgui_problem("r", sub->bytes()))
    require(problem->span.begin <= problem->span.end && problem->span.end <= sub->bytes().size());
  check_program(files, setup);
  return 0;
}
