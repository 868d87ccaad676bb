#include "analyzer/audit/page_lines.h"

#include <algorithm>
#include <set>

#include "analyzer/text/printable.h"

namespace owlint::audit {
namespace {

/// Chooses the lines, and gives them in stretches without gaps.
class ShownLines {
 public:
  ShownLines(const Program& program, const std::vector<Finding>& findings)
      : source_(*program.source), count_(source_.line_count()) {
    if (count_ <= kShort) {
      keep(1, count_, 0);
      return;
    }
    for (const Finding& f : findings) keep(source_.position(f.span.begin).line, source_.position(f.span.end).line, 5);
    keep(1, 20, 0);
    keep(count_ - 4, count_, 0);
    for (const Statement& s : program.syntax.statements) {
      if (lines_.size() >= kMost) break;
      keep(s.line, s.line, 1);
    }
  }

  nlohmann::ordered_json json() const {
    nlohmann::ordered_json stretches = nlohmann::ordered_json::array();
    uint32_t next = 0;
    for (const uint32_t number : lines_) {
      if (next == 0 || number - next > kHole) {
        stretches.push_back({number, nlohmann::ordered_json::array()});
        next = number;
      }
      for (; next <= number; ++next) stretches.back()[1].push_back(text(next));
    }
    return stretches;
  }

 private:
  static constexpr uint32_t kShort = 1500;
  static constexpr size_t kMost = 4000;
  static constexpr uint32_t kHole = 3;     // as many lines are shown rather than left out
  static constexpr size_t kWidest = 2000;  // bytes of a line that are shown

  void keep(uint32_t first, uint32_t last, uint32_t around) {
    for (uint32_t line = first > around ? first - around : 1; line <= std::min(count_, last + around); ++line)
      lines_.insert(line);
  }

  std::string text(uint32_t number) const {
    std::string_view line = source_.slice(source_.line(number));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return printable(line.substr(0, kWidest)) + (line.size() > kWidest ? " …" : "");
  }

  const Source& source_;
  uint32_t count_;
  std::set<uint32_t> lines_;
};

}  // namespace

nlohmann::ordered_json shown_lines(const Program& program, const std::vector<Finding>& findings) {
  return ShownLines(program, findings).json();
}

nlohmann::ordered_json kept_lines(const Source& source, const std::vector<Finding>& findings) {
  std::set<uint32_t> numbers;
  for (const Finding& f : findings) numbers.insert(source.position(f.span.begin).line);
  nlohmann::ordered_json stretches = nlohmann::ordered_json::array();
  for (const uint32_t number : numbers) stretches.push_back({number, {printable(source.slice(source.line(number)))}});
  return stretches;
}

}  // namespace owlint::audit
