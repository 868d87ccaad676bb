#include "analyzer/syntax/contour_sub.h"

#include <algorithm>
#include <cmath>

namespace owlint {
namespace {

constexpr int kTenthsInOne = 10;

const double* value_of(std::span<const ContourWord> words, char letter) {
  const auto last =
      std::find_if(words.rbegin(), words.rend(), [letter](const ContourWord& word) { return word.letter == letter; });
  return last == words.rend() ? nullptr : &last->value;
}

/// The code that moves; -1 without one.
int motion_code(std::span<const ContourWord> words) {
  int code = -1;
  for (const ContourWord& word : words) {
    if (word.letter != 'g') continue;
    const int tenths = static_cast<int>(std::lround(word.value * kTenthsInOne));
    const GCode* const row = g_code(tenths, Release::k2_10);
    if (row != nullptr && row->group == GGroup::kMotion) code = tenths;
  }
  return code;
}

}  // namespace

void ContourSub::add_blank_line() {
  if (ends.empty()) {
    begins_blank = true;
    return;
  }
  const size_t begin = ends.size() == 1 ? 0 : ends[ends.size() - 2];
  const std::vector<ContourWord> again(words.begin() + static_cast<ptrdiff_t>(begin), words.end());
  words.insert(words.end(), again.begin(), again.end());
  ends.push_back(words.size());
}

Motion ContourSub::motion() const {
  const int code = motion_code(words);
  return code < 0 ? Motion::kG0 : g_code(code, Release::k2_10)->motion;
}

const char* ContourReader::read(const ContourSub& sub) {
  size_t begin = 0;
  for (const size_t end : sub.ends) {
    if (const char* const message = line(std::span(sub.words).subspan(begin, end - begin))) return message;
    begin = end;
  }
  return nullptr;
}

const char* ContourReader::line(std::span<const ContourWord> words) {
  if (const int code = motion_code(words); code >= 0) motion_ = code;
  PlanePoint end = at_;
  const double* const x = value_of(words, 'x');
  const double* const z = value_of(words, 'z');
  const double* const u = value_of(words, 'u');
  const double* const w = value_of(words, 'w');
  const double share = modes_.diameter ? 2 : 1;
  if (u != nullptr && modes_.incremental) return "G7x error: Cannot use U in incremental mode (G91)";
  if (u != nullptr && x != nullptr) return "G7x error: Cannot use U and X in the same block";
  if (w != nullptr && modes_.incremental) return "G7x error: Cannot use W in incremental mode (G91)";
  if (w != nullptr && z != nullptr) return "G7x error: Cannot use W and Z in the same block";
  if (x != nullptr) end.second = modes_.incremental ? at_.second + *x / share : *x / share;
  if (u != nullptr) end.second = at_.second + *u / share;
  if (z != nullptr) end.first = modes_.incremental ? at_.first + *z : *z;
  if (w != nullptr) end.first = at_.first + *w;
  if (end == at_) return nullptr;
  if (const char* const message = element(words, end)) return message;
  at_ = end;
  return nullptr;
}

/// A line that moves, and the corner behind it.
const char* ContourReader::element(std::span<const ContourWord> words, PlanePoint end) {
  using Kind = ContourElement::Kind;
  ContourElement element;
  element.start = at_;
  element.end = end;
  const double* const r = value_of(words, 'r');
  const double* const i = value_of(words, 'i');
  const double* const k = value_of(words, 'k');
  switch (motion_) {
    case code::kG0:
    case code::kG1: break;
    case code::kG2:
    case code::kG3:
      element.kind = motion_ == code::kG2 ? Kind::kClockwise : Kind::kCounterclockwise;
      if (r != nullptr && (i != nullptr || k != nullptr)) return "G7X error: both R and I or K flag used for arc";
      if (r == nullptr && i == nullptr && k == nullptr) return "G7X error: either I or K must be present for arc";
      element.by_radius = r != nullptr;
      if (r != nullptr) element.size = *r;
      element.center = {k == nullptr ? 0 : *k, i == nullptr ? 0 : *i};
      if (!modes_.absolute_centers)
        element.center = {at_.first + element.center.first, at_.second + element.center.second};
      break;
    default: return nullptr;
  }
  elements_.push_back(element);
  const double* const fillet = value_of(words, 'a');
  const double* const chamfer = value_of(words, 'c');
  if (fillet != nullptr && chamfer != nullptr) return "G7X error: Both A and C parameters on a corner";
  if (fillet == nullptr && chamfer == nullptr) return nullptr;
  ContourElement corner;
  corner.kind = fillet != nullptr ? Kind::kFillet : Kind::kChamfer;
  corner.start = corner.end = end;
  corner.size = fillet != nullptr ? *fillet : *chamfer;
  elements_.push_back(corner);
  return nullptr;
}

}  // namespace owlint
