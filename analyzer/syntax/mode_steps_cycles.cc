// Canned cycles: G73, G74, G81 to G89. Where the place is followed, so are their heights and holes (mode_place_cycles.cc).
#include <algorithm>

#include "analyzer/syntax/mode_place.h"

namespace owlint::steps {
namespace {

constexpr StopKind kWords = StopKind::kCycleWords;

struct CyclePlane {
  modes::Plane plane;
  const char* code;
  char axis;                 ///< along the hole
  std::string_view refused;  ///< axes of the other kind of planes
  const char* name;          ///< as messages about those call it
  const char* unspecified;
  const char* below;
};
constexpr CyclePlane kPlanes[] = {
    {modes::kG17, "G17", 'z', "uvw", "XY", "Z value unspecified in xy plane canned cycle",
     "R less than z in cycle in xy plane"},
    {modes::kG18, "G18", 'y', "uvw", "XZ", "Y value unspecified in xz plane canned cycle",
     "R less than y in cycle in xz plane"},
    {modes::kG19, "G19", 'x', "uvw", "YZ", "X value unspecified in yz plane canned cycle",
     "R less than x in cycle in yz plane"},
    {modes::kG17_1, "G17.1", 'w', "xyz", "UV", "W value unspecified in UV plane canned cycle",
     "R less than w in cycle in uv plane"},
    {modes::kG18_1, "G18.1", 'v', "xyz", "UW", "V value unspecified in UW plane canned cycle",
     "R less than v in cycle in uw plane"},
    {modes::kG19_1, "G19.1", 'u', "xyz", "VW", "U value unspecified in VW plane canned cycle",
     "R less than u in cycle in vw plane"},
};

/// Words that a cycle needs on the line that begins it; further holes have those of the hole before.
struct CycleWord {
  MotionSet cycle;
  char letter;
  const char* message;
};
constexpr CycleWord kNeeded[] = {
    {set_of(Motion::kG82), 'p', "Dwell time p word missing with g82"},
    {set_of(Motion::kG86), 'p', "Dwell time p word missing with g86"},
    {set_of(Motion::kG88), 'p', "Dwell time p word missing with g88"},
    {set_of(Motion::kG89), 'p', "Dwell time p word missing with g89"},
    {set_of(Motion::kG73), 'q', "Q word missing with g73"},
    {set_of(Motion::kG83), 'q', "Q word missing with g83"},
    {set_of(Motion::kG87), 'i', "I word missing with g87"},
    {set_of(Motion::kG87), 'j', "J word missing with g87"},
    {set_of(Motion::kG87), 'k', "K word missing with g87"},
};

char capital(char letter) { return static_cast<char>(letter - 'a' + 'A'); }

/// The line begins the cycle: the motion mode before it is another one.
BadMode begins(Motion motion) { return {Mode::kMotion, ~set_of(motion)}; }

bool lacks_word(ModeLine& line, Motion motion, char letter, const char* message) {
  return line.lacks(letter) && line.stop_in({begins(motion)}, kWords, message, line.mover(), line.at(letter));
}

bool foreign_axis(ModeLine& line, const CyclePlane& in, BadMode plane) {
  for (const char axis : in.refused) {
    if (!line.has(axis)) continue;
    const std::string message = std::string("Cannot put a") + (axis == 'x' ? "n " : " ") + capital(axis) +
        " in a canned cycle in the " + in.name + " plane";
    if (line.stop_in({plane}, StopKind::kPlaneWrong, message, line.at(axis), line.mover())) return true;
  }
  return false;
}

bool lacks_axis(ModeLine& line, const CyclePlane& in, BadMode plane) {
  if ((line.machine().axes & letter_set({&in.axis, 1})) != 0 || line.machine().unsure) return false;
  const std::string message =
      std::string(in.code) + " canned cycle is not possible on a machine without " + capital(in.axis) + " axis";
  return line.stop_in({plane}, StopKind::kPlaneWrong, message, line.mover(), line.at(GGroup::kPlane));
}

/// Whether R lies below the bottom, where the place is followed.
bool is_below(ModeLine& line, const CyclePlane& in, CheckOutcome outcome) {
  const uint8_t written = line.at(line.has('r') ? 'r' : in.axis);
  return stop_by(line, outcome, kWords, in.below, line.has(in.axis) ? line.at(in.axis) : written, line.at('r'),
                 mask_of(Mode::kDistance));
}

/// Whether the first hole would lie above R. In G90 both are on the line, or one of them is not known here; in G91 the depth
/// counts from R on.
bool is_above(ModeLine& line, const CyclePlane& in, BadMode plane) {
  const double* const word = line.value(in.axis);
  if (word == nullptr || line.mover() == kNoWord) return false;
  const Answer halved = in.axis == 'x' ? line.holds({{Mode::kDiameter, value_bit(modes::kG7)}}) : Answer::kNo;
  if (halved == Answer::kMaybe) return false;
  const double depth = halved == Answer::kYes ? *word / 2 : *word;
  const double* const r = line.value('r');
  const auto stops = [&](modes::Distance distance) {
    return line.stop_in({plane, {Mode::kDistance, value_bit(distance)}}, kWords, in.below, line.at(in.axis),
                        line.at('r'));
  };
  if (r != nullptr && *r < depth && stops(modes::kG90)) return true;
  return depth > 0 && stops(modes::kG91);
}

/// The axis words, in one plane.
bool axes(ModeLine& line, Motion motion, const CyclePlane& in) {
  const BadMode plane{Mode::kPlane, value_bit(in.plane)};
  if (line.holds({plane}) == Answer::kNo) return false;
  if (foreign_axis(line, in, plane) || lacks_axis(line, in, plane)) return true;
  if (!line.has(in.axis) && line.stop_in({plane, begins(motion)}, kWords, in.unspecified, line.mover())) return true;
  if (line.place() != nullptr && line.holds({plane}) == Answer::kYes) {
    if (const std::optional<CheckOutcome> below = places::heights(line, in.plane)) return is_below(line, in, *below);
  }
  return is_above(line, in, plane);
}

/// The plane in effect; null if the place is not followed, or the plane is not known.
const CyclePlane* plane_of(const ModeLine& line) {
  const std::optional<uint8_t> plane = line.only(Mode::kPlane);
  if (line.place() == nullptr || !plane) return nullptr;
  return std::ranges::find(kPlanes, *plane, &CyclePlane::plane);
}

bool repeats_none(ModeLine& line) {
  const double* const l = line.value('l');
  int32_t repeats = 1;
  if (l != nullptr) word_integer(*l, &repeats);
  return repeats == 0 && line.stop(kWords, "Cannot do zero repeats of cycle", line.at('l'), line.mover());
}

bool taps(ModeLine& line) {
  const bool g18 = line.holds({{Mode::kPlane, value_bit(modes::kG18)}}) == Answer::kYes;
  return line.choose_spindle(g18 ? "Invalid E-number in G74/G84 cycle" : "Invalid spindle ($) number in G74/G84 cycle",
                             line.mover());
}

bool pecks_nothing(ModeLine& line) {
  const double* const q = line.value('q');
  return q != nullptr && *q <= 0 && !line.lacks('q') &&
      line.stop(kWords, "Negative or zero q value used", line.at('q'), line.mover());
}

}  // namespace

bool cycle(ModeLine& line, Motion motion) {
  constexpr MotionSet kTapping = set_of(Motion::kG74) | set_of(Motion::kG84);
  constexpr MotionSet kPecking = set_of(Motion::kG73) | set_of(Motion::kG83);
  if (feed_of(line, motion) ||
      line.refused_by_compensation("Cannot use canned cycles with cutter compensation on", line.mover()) ||
      lacks_word(line, motion, 'r', "R clearance plane unspecified in cycle") || repeats_none(line))
    return true;
  for (const CyclePlane& plane : kPlanes) {
    if (axes(line, motion, plane)) return true;
  }
  for (const CycleWord& word : kNeeded) {
    if (contains(word.cycle, motion) && lacks_word(line, motion, word.letter, word.message)) return true;
  }
  if (contains(kTapping, motion) && taps(line)) return true;
  const CyclePlane* const in = plane_of(line);
  Point at;
  if (in != nullptr && places::first_hole(line, in->plane, &at)) return true;
  if ((contains(kPecking, motion) && pecks_nothing(line)) || turning(line, motion)) return true;
  if (in == nullptr) {
    places::lose_cycle(line);
    return false;
  }
  places::visit_hole(line, in->plane, at);
  if (places::further_holes(line, in->plane, &at)) return true;
  places::leave_cycle(line, in->plane, at);
  return false;
}

}  // namespace owlint::steps
