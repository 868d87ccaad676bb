#include "analyzer/checking/diff.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <dtl/dtl.hpp>

namespace owlint::checking {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const size_t feed = text.find('\n');
    if (feed == std::string_view::npos) {
      lines.push_back(std::string(text) + "\n\\ No newline at end of file");
      break;
    }
    lines.emplace_back(text.substr(0, feed));
    text.remove_prefix(feed + 1);
  }
  return lines;
}

/// Where the line begins that lies `lines` above the one of `at`.
size_t lines_up(std::string_view text, size_t at, int lines) {
  for (;; --lines) {
    const size_t feed = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    if (feed == std::string_view::npos) return 0;
    if (lines == 0) return feed + 1;
    at = feed;
  }
}

}  // namespace

std::string unified_diff(const std::string& path, std::string_view before, std::string_view after) {
  // Only what lies between the parts that are alike is compared line by line: a program may have a gigabyte.
  constexpr int kContext = 3;
  const size_t shorter = std::min(before.size(), after.size());
  size_t head = static_cast<size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
  head = lines_up(before, head, kContext);
  size_t tail = 0;
  while (tail < shorter - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
  const auto end_of = [&](std::string_view text) {
    size_t end = text.size() - tail;
    for (int lines = 0; lines <= kContext && end < text.size(); ++lines)
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
    return end;
  };
  const size_t skipped = static_cast<size_t>(std::ranges::count(before.substr(0, head), '\n'));
  const std::vector<std::string> old_lines = lines_of(before.substr(head, end_of(before) - head));
  const std::vector<std::string> new_lines = lines_of(after.substr(head, end_of(after) - head));
  dtl::Diff<std::string> diff(old_lines, new_lines);
  diff.compose();
  diff.composeUnifiedHunks();
  std::ostringstream out;
  out << fmt::format("--- {}\n+++ {}\n", path, path);
  for (auto hunk : diff.getUniHunks()) {
    out << fmt::format("@@ -{},{} +{},{} @@\n", hunk.a + static_cast<long long>(skipped), hunk.b,
                       hunk.c + static_cast<long long>(skipped), hunk.d);
    const auto write = [&out](const auto& lines) {
      for (const auto& [line, info] : lines)
        out << (info.type == dtl::SES_ADD ? '+' : info.type == dtl::SES_DELETE ? '-' : ' ') << line << '\n';
    };
    write(hunk.common[0]);
    write(hunk.change);
    write(hunk.common[1]);
  }
  return out.str();
}

}  // namespace owlint::checking
