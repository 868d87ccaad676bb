#include "analyzer/findings/edits.h"

#include <algorithm>
#include <map>

namespace owlint {
namespace {

/// Which bytes are taken already. Edits that only touch are a clash, too: what is written first would depend on chance.
class Taken {
 public:
  bool clashes(Span span) const {
    const auto behind = taken_.upper_bound(span.end);
    return behind != taken_.begin() && std::prev(behind)->second >= span.begin;
  }
  void add(Span span) { taken_.emplace(span.begin, span.end); }

 private:
  std::map<uint64_t, uint64_t> taken_;  // disjoint, so that ends are in the order of the beginnings
};

const Fix* first_fix(const Finding& finding, bool unsafe) {
  const auto fix = std::ranges::find_if(finding.fixes, [&](const Fix& f) { return unsafe || f.safe; });
  return fix == finding.fixes.end() || finding.source != nullptr ? nullptr : &*fix;
}

}  // namespace

Round round_of_fixes(const std::vector<Finding>& findings, bool unsafe) {
  Round round;
  Taken taken;
  for (const Finding& finding : findings) {
    const Fix* fix = first_fix(finding, unsafe);
    if (fix == nullptr || std::ranges::any_of(fix->edits, [&](const Edit& e) { return taken.clashes(e.span); }))
      continue;
    for (const Edit& edit : fix->edits) taken.add(edit.span);
    round.edits.insert(round.edits.end(), fix->edits.begin(), fix->edits.end());
    ++round.made;
  }
  std::ranges::stable_sort(round.edits, {}, [](const Edit& e) { return e.span.begin; });
  return round;
}

std::string apply_edits(std::string_view text, const std::vector<Edit>& edits) {
  std::string out;
  out.reserve(text.size());
  size_t at = 0;
  for (const Edit& edit : edits) {
    out += text.substr(at, edit.span.begin - at);
    out += edit.text;
    at = edit.span.end;
  }
  out += text.substr(at);
  return out;
}

Fixable count_fixable(const std::vector<Finding>& findings) {
  Fixable count;
  for (const Finding& finding : findings) {
    if (first_fix(finding, false) != nullptr) {
      ++count.safe;
    } else if (first_fix(finding, true) != nullptr) {
      ++count.unsafe;
    }
  }
  return count;
}

}  // namespace owlint
