#include "analyzer/flow/engine/mode_words.h"

#include <bit>

#include <fmt/format.h>

namespace owlint::flow {

std::string joined(const std::vector<std::string>& words, std::string_view last) {
  std::string out;
  for (size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " " + std::string(last) + " " : ", ") + words[i];
  return out;
}

std::vector<std::string> values_of(const ModeThere& there) {
  std::vector<std::string> names;
  for (ValueSet rest = there.may; rest != 0; rest &= rest - 1)
    names.push_back(value_name(there.mode, static_cast<uint8_t>(std::countr_zero(rest))));
  return names;
}

bool is_inner(Mode mode) {
  switch (mode) {
    case Mode::kRadius:
    case Mode::kEntry:
    case Mode::kStraightOwed:
    case Mode::kNurbs:
    case Mode::kNurbsOrder:
    case Mode::kFeedOverride:
    case Mode::kAdaptiveFeed:
    case Mode::kFeedHold:
    case Mode::kSaved: return true;
    default: return false;
  }
}

std::string places_of(const ModeThere& there, const Program& own) {
  std::vector<std::string> here, elsewhere;
  for (const ModeSetter& setter : there.set_on) {
    if (setter.file == &own) {
      here.push_back(std::to_string(setter.line));
    } else {
      const std::string& path = setter.file->source->path();
      elsewhere.push_back(fmt::format("line {} of {}", setter.line, path.substr(path.rfind('/') + 1)));
    }
  }
  if (!here.empty()) elsewhere.insert(elsewhere.begin(), (here.size() == 1 ? "line " : "lines ") + joined(here, "and"));
  return joined(elsewhere, "and");
}

std::string value_text(const ModeThere& there) {
  constexpr size_t kFew = 4;
  const std::vector<std::string> values = values_of(there);
  if (there.known || (values.size() <= kFew && !there.set_on.empty())) return joined(values, "or");
  if (!there.set_on.empty()) return "not known";
  return values.size() > kFew ? "as before the program" : joined(values, "or") + ", as before the program";
}

bool is_worth_showing(const ModeThere& there) {
  static const ModeSets start = ModeSets::started();
  return !is_inner(there.mode) || (there.known && there.may != start[there.mode]);
}

}  // namespace owlint::flow
