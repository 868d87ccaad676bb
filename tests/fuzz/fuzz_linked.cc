// Any bytes are a program and a file that it calls: the flow through both must come back, with places inside the files.
#include <cstdlib>

#include "analyzer/text/memory_files.h"
#include "rules/driver/lint.h"

using namespace owlint;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const FileReport& report) {
  for (const Finding& f : report.findings) {
    require(f.span.end <= report.source->bytes().size());
    for (const Related& related : f.related) {
      require(related.span.end <= (related.source == nullptr ? report.source : related.source)->bytes().size());
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const size_t cut = std::min(bytes.find('\x01'), bytes.size());
  MemoryFiles files;
  files.add_file("/f.ngc", bytes.substr(std::min(cut + 1, bytes.size())));
  Profile profile;
  profile.version = static_cast<Version>(data[0] >> 1 & 3);
  LintOptions options;
  options.all_versions = (data[0] & 1) != 0;
  Library library(files);
  const auto program = library.load(Source::own("/p.ngc", "o<f> call\n" + bytes.substr(0, cut)));
  const ProgramReport report = lint(program, profile, options, library);
  check(report.own);
  for (const FileReport& called : report.called) check(called);
  return 0;
}
