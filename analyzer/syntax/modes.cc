#include "analyzer/syntax/modes.h"

#include <algorithm>
#include <bit>
#include <functional>

namespace owlint {
namespace {

constexpr size_t kMostNames = 9;

struct ModeRow {
  Mode mode;
  std::string_view name;
  std::array<std::string_view, kMostNames> values;
};

constexpr auto kModeRows = std::to_array<ModeRow>({
#define MODE(mode, name, ...) {Mode::mode, name, {__VA_ARGS__}},
#include "analyzer/syntax/modes.def"
});

constexpr bool in_order() {
  for (size_t i = 0; i < kModeRows.size(); ++i) {
    if (static_cast<size_t>(kModeRows[i].mode) != i) return false;
  }
  return kModeRows.size() == kModes;
}
static_assert(in_order());

constexpr ValueSet first_values(size_t count) { return (ValueSet{1} << count) - 1; }

ValueSet values_of(const ModeRow& row) {
  switch (row.mode) {
    case Mode::kMotion: return all_modes();
    case Mode::kNurbs: return first_values(modes::kMostPoints + 1);
    case Mode::kNurbsOrder: return first_values(modes::kMostOrder + 1);
    default: break;
  }
  return first_values(static_cast<size_t>(std::ranges::count_if(row.values, [](auto name) { return !name.empty(); })));
}

}  // namespace

ValueSet all_values(Mode mode) {
  static const auto sets = [] {
    std::array<ValueSet, kModes> all{};
    std::ranges::transform(kModeRows, all.begin(), values_of);
    return all;
  }();
  return sets[static_cast<size_t>(mode)];
}

std::string_view mode_name(Mode mode) { return kModeRows[static_cast<size_t>(mode)].name; }

std::string value_name(Mode mode, uint8_t value) {
  switch (mode) {
    case Mode::kMotion: return motion_name(static_cast<Motion>(value));
    case Mode::kNurbs: return std::to_string(value);
    case Mode::kNurbsOrder: return std::to_string(value + modes::kLeastOrder);
    default: return std::string(kModeRows[static_cast<size_t>(mode)].values[value]);
  }
}

ModeSets ModeSets::started() {
  ModeSets sets;
  sets.may.fill(value_bit(0));
  sets[Mode::kMotion] = set_of(Motion::kNone);
  return sets;
}

ModeSets ModeSets::unknown() {
  ModeSets sets;
  for (const ModeRow& row : kModeRows) sets[row.mode] = all_values(row.mode);
  sets.open = kAllModes;
  sets.feed_number = sets.speed_number = ModeSets::kAnyNumber;
  return sets;
}

ModeSets ModeSets::usual() {
  ModeSets sets = unknown();
  const ModeSets start = started();
  for (const ModeRow& row : kModeRows) {
    if ((kUsualModes & mask_of(row.mode)) != 0) sets[row.mode] = start[row.mode];
  }
  sets.open &= ~kUsualModes;
  return sets;
}

void ModeSets::lose_runs() {
  for (const ModeRow& row : kModeRows) {
    if (!is_single((*this)[row.mode])) open |= mask_of(row.mode);
  }
}

ModeSets join(const ModeSets& a, const ModeSets& b) {
  ModeSets joined;
  std::ranges::transform(a.may, b.may, joined.may.begin(), std::bit_or<>());
  joined.open = a.open | b.open;
  joined.assigned = a.assigned | b.assigned;
  joined.feed_number = a.feed_number == b.feed_number ? a.feed_number : ModeSets::kAnyNumber;
  joined.speed_number = a.speed_number == b.speed_number ? a.speed_number : ModeSets::kAnyNumber;
  return joined;
}

ModeState join(const ModeState& a, const ModeState& b) { return {join(a.now, b.now), join(a.saved, b.saved)}; }

}  // namespace owlint
