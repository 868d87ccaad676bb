// A damaged store may contain any bytes: they are refused, or give findings that every format can write.
#include <sstream>

#include "analyzer/audit/record.h"
#include "analyzer/audit/store.h"
#include "analyzer/report/formats.h"

using namespace owlint;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    audit::Records records;
    records.add({reinterpret_cast<const char*>(data), size});
    const checking::Checked checked = records.checked(0);
    std::ostringstream out;
    for (const Format& format : formats()) format.write(out, {checked.report.own}, {});
  } catch (const audit::StoreProblem&) {
  }
  return 0;
}
