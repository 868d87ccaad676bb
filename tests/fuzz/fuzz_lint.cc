// Any bytes are a program: lint must come back, with places inside the file and in order.
#include <cstdlib>
#include <sstream>

#include "analyzer/findings/edits.h"
#include "analyzer/flow/engine/extent_map.h"
#include "analyzer/report/extents.h"
#include "analyzer/report/formats.h"
#include "analyzer/text/memory_files.h"
#include "rules/driver/lint.h"

using namespace owlint;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void inside(Span span, uint64_t size) { require(span.begin <= span.end && span.end <= size); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  Profile profile;
  if ((data[0] & 1) != 0) profile.feature = 0x20;
  profile.version = static_cast<Version>(data[0] >> 1 & 3);
  LintOptions options;
  options.extend_select = {"OW"};
  const FileReport report =
      lint(Source::own("p.ngc", {reinterpret_cast<const char*>(data) + 1, size - 1}), profile, options);
  uint64_t last = 0;
  for (const Finding& f : report.findings) {
    inside(f.span, size - 1);
    if (f.code != "OW319") {  // that a program is for another controller comes first
      require(f.span.begin >= last);
      last = f.span.begin;
    }
    for (const Related& related : f.related) inside(related.span, size - 1);
    for (const Fix& fix : f.fixes) {
      for (const Edit& edit : fix.edits) inside(edit.span, size - 1);
    }
  }
  apply_edits(report.source->bytes(), round_of_fixes(report.findings, true).edits);
  if ((data[0] & 8) != 0) {  // as long as all the rest together
    std::ostringstream out;
    write_json(out, {report});
    write_text(out, report, {true, ""});
  }
  if ((data[0] & 16) != 0) {
    profile.measures_extents = true;
    const MemoryFiles none;
    Library library(none);
    const Linked linked(library.load(report.source, profile), profile, library);
    require(!extents_text(flow::extents_of(linked, profile), linked).empty());
  }
  return 0;
}
