#include "support/damage.h"

#include "support/corpus.h"
#include "support/files.h"
#include "support/fixture.h"

namespace owlint::test {

std::vector<std::pair<std::string, std::string>> all_programs() {
  std::vector<std::pair<std::string, std::string>> out;
  for (const CorpusProgram& c : corpus()) out.emplace_back(c.path, read_file(c.path));
  for (const Fixture& f : all_fixtures()) {
    if (!f.bundle) out.emplace_back(f.path, read_file(f.path));
  }
  return out;
}

std::string damaged(const std::string& text, std::mt19937& random) {
  std::vector<std::string> lines;
  for (size_t at = 0; at < text.size();) {
    const size_t feed = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, feed + 1 - at));
    at = feed + 1;
  }
  const auto below = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
  for (size_t edits = 1 + below(3); edits > 0 && lines.size() > 2; --edits) {
    const size_t at = below(lines.size());
    const std::string line = lines[at];
    const size_t kind = below(3);
    if (kind != 1) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
    if (kind != 0) lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())), line);
  }
  std::string out;
  for (const std::string& line : lines) out += line;
  return out;
}

}  // namespace owlint::test
