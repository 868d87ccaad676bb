#include "analyzer/findings/identity.h"

#include <map>

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include "analyzer/text/printable.h"

namespace owlint {
namespace {

/// Blanks at the ends cut off, those between as one: indenting a program makes no new findings.
std::string squeezed(std::string_view line) {
  std::string out;
  bool blank = false;
  for (const char c : line) {
    if (c == ' ' || c == '\t' || c == '\r') {
      blank = !out.empty();
      continue;
    }
    if (blank) out.push_back(' ');
    blank = false;
    out.push_back(c);
  }
  return out;
}

}  // namespace

Identity identity_of(const Source& own, const Finding& finding) {
  const Source& source = finding.source == nullptr ? own : *finding.source;
  constexpr size_t kLongest = 300;  // a line that LinuxCNC reads is shorter
  const Span line = source.line(source.position(finding.span.begin).line);
  const std::string& path = source.path();
  return {printable(path.substr(path.rfind('/') + 1)), std::string(finding.code), printable(finding.scope),
          printable(squeezed(source.slice({line.begin, std::min(line.end, line.begin + kLongest)})))};
}

std::vector<std::string> fingerprints(const Source& source, const std::vector<Finding>& findings) {
  std::map<Identity, size_t> seen;
  std::vector<std::string> out;
  for (const Finding& finding : findings) {
    const Identity identity = identity_of(source, finding);
    const size_t number = seen[identity]++;
    const std::string all =
        fmt::format("{}\n{}\n{}\n{}\n{}", identity.file, identity.code, identity.scope, identity.text, number);
    const XXH128_hash_t hash = XXH3_128bits(all.data(), all.size());
    out.push_back(fmt::format("{:016x}{:016x}", hash.high64, hash.low64));
  }
  return out;
}

}  // namespace owlint
