// Straight moves, arcs, threads, probes and contours: what they need of modes and words. Where they go: mode_place_moves.cc.
#include <algorithm>
#include <cmath>

#include "analyzer/syntax/mode_place.h"

namespace owlint::steps {
namespace {

constexpr BadMode kUvwPlanes{Mode::kPlane,
                             value_bit(modes::kG17_1) | value_bit(modes::kG18_1) | value_bit(modes::kG19_1)};
constexpr BadMode kNoRadius{Mode::kRadius, value_bit(modes::kNoRadius)};
constexpr BadMode kInverseTime{Mode::kFeedMode, value_bit(modes::kG93)};

/// Behind a straight move.
void owe_nothing(ModeLine& line) { line.set(Mode::kStraightOwed, modes::kNotOwed); }

/// A compensated path has begun, if the compensation has a radius.
void enter(ModeLine& line) {
  const Answer moves = line.holds({kCompensationMoves});
  if (moves == Answer::kYes) line.set(Mode::kEntry, modes::kMade);
  if (moves == Answer::kMaybe) line.set_open(Mode::kEntry);
}

/// In G93 a move leaves the feed with which it was made; before 2.10 that was never 0.
void keep_feed(ModeLine& line) {
  const Answer inverse = line.holds({kInverseTime});
  if (inverse == Answer::kNo) return;
  const ValueSet left = line.since(Release::k2_10) ? all_values(Mode::kFeed) : value_bit(modes::kFeedSet);
  line.set_open(Mode::kFeed, inverse == Answer::kYes ? left : left | line.now()[Mode::kFeed]);
}

bool compensates_uvw(ModeLine& line) {
  return line.stop_in({kCompensationMoves, kUvwPlanes}, StopKind::kCompensation,
                      "BUG: Invalid plane for cutter compensation", line.mover());
}

bool machine_coordinates(ModeLine& line) {
  if (line.code(GGroup::kNonModal) != code::kG53) return false;
  const uint8_t word = line.at(GGroup::kNonModal);
  if (line.words().has_polar_words())
    return line.stop(StopKind::kModeConflict, "Cannot use polar coordinates with G53", word,
                     line.at(line.has('@') ? '@' : '^'));
  return line.stop_in({kCompensationMoves}, StopKind::kCompensation, "Cannot use g53 with cutter radius comp", word);
}

struct ArcPlane {
  modes::Plane plane;
  char across;  ///< the letter of a center that lies across the plane
  const char* given;
  std::string_view center, end;
  const char* no_end;
};
constexpr ArcPlane kArcPlanes[] = {
    {modes::kG17, 'k', "K word given for arc in xy plane", "ij", "xy", "X and y words missing for arc in xy plane"},
    {modes::kG18, 'j', "J word given for arc in xz plane", "ik", "xz", "X and z words missing for arc in xz plane"},
    {modes::kG19, 'i', "I word given for arc in yz plane", "jk", "yz", "Y and z words missing for arc in yz plane"},
};

bool lacks_center(const ModeLine& line) { return !line.has('i') && !line.has('j') && !line.has('k'); }

/// An arc by its center, in one plane.
bool center(ModeLine& line, const ArcPlane& in) {
  const BadMode plane{Mode::kPlane, value_bit(in.plane)};
  if (line.has(in.across) && line.stop_in({plane}, StopKind::kPlaneWrong, in.given, line.at(in.across), line.mover()))
    return true;
  const BadMode absolute{Mode::kArcDistance, value_bit(modes::kG90_1)};
  for (const char letter : in.center) {
    if (line.has(letter) || line.holds({plane, absolute}) == Answer::kNo) continue;
    const auto capital = static_cast<char>(letter - 'a' + 'A');
    if (line.stop_in({plane, absolute}, StopKind::kArcWords,
                     std::string(1, capital) + " word missing in absolute center arc", line.mover()))
      return true;
  }
  return false;
}

/// An arc by its radius: it has to go somewhere.
bool radius(ModeLine& line, const ArcPlane& in) {
  const bool polar = in.plane == modes::kG17 && line.words().has_polar_words();
  if (polar || std::ranges::any_of(in.end, [&](char letter) { return line.has(letter); })) return false;
  return line.stop_in({{Mode::kPlane, value_bit(in.plane)}}, StopKind::kArcWords, in.no_end, line.at('r'),
                      line.mover());
}

/// A thread stops for this, unless it is a move on a compensated path.
bool stop_thread(ModeLine& line, StopKind kind, std::string message, uint8_t word, uint8_t other = kNoWord) {
  if (line.holds({kNoRadius}) == Answer::kYes) return line.stop(kind, std::move(message), word, other);
  return line.stop_in({kNoRadius}, kind, message, word, other);
}

/// The spindle of a thread, and that it turns.
bool thread_spindle(ModeLine& line, std::string_view no_spindle, std::string_view not_turning) {
  constexpr BadMode kStopped{Mode::kTurning, value_bit(modes::kStopped)};
  if (line.holds({kNoRadius}) == Answer::kYes) {
    return line.choose_spindle(no_spindle, line.mover()) ||
        line.stop_in({kStopped}, StopKind::kSpindleStopped, not_turning, line.mover());
  }
  return (line.names_no_spindle(0) &&
          line.stop_in({kNoRadius}, StopKind::kModeConflict, no_spindle, line.at('$'), line.mover())) ||
      line.stop_in({kStopped, kNoRadius}, StopKind::kSpindleStopped, not_turning, line.mover());
}

/// The numbers of G76: K goes deeper than J.
bool thread_depths(ModeLine& line) {
  const double* const i = line.value('i');
  const double* const j = line.value('j');
  const double* const k = line.value('k');
  constexpr StopKind kWords = StopKind::kContourWords;
  if (i != nullptr && *i == 0 && stop_thread(line, kWords, "In G76, I must not be 0", line.at('i'), line.mover()))
    return true;
  if (j != nullptr && *j <= 0 &&
      stop_thread(line, kWords, "In G76, J must be greater than 0", line.at('j'), line.mover()))
    return true;
  return j != nullptr && k != nullptr && *k <= *j &&
      stop_thread(line, kWords, "In G76, K must be greater than J", line.at('k'), line.at('j'));
}

bool g76(ModeLine& line, const Point& end) {
  const double* const chosen = line.value('$');
  const int spindle = chosen == nullptr ? 0 : nearest_integer(std::trunc(*chosen));
  std::string not_turning;
  if (line.holds({{Mode::kTurning, value_bit(modes::kStopped)}}) != Answer::kNo || chosen != nullptr)
    not_turning = "Chosen spindle (" + std::to_string(spindle) + ") not turning in G76";
  if (thread_spindle(line, "Invalid D-number in G76 cycle", not_turning)) return true;
  if (line.holds({kNoRadius}) == Answer::kYes && places::moves_rotary_axes(line, end)) return true;
  if (line.stop_in({kCompensationOn, kNoRadius}, StopKind::kCompensation,
                   "Cannot use G76 threading cycle with cutter radius compensation on", line.mover()))
    return true;
  return thread_depths(line);
}

/// `G71.0`: in its messages a contour has a decimal in any case.
std::string name_of_contour(int tenths) {
  return "G" + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

bool straight(ModeLine& line, Motion motion) {
  Point end;
  owe_nothing(line);
  if (feed_of(line, motion) || places::end_point(line, &end) || machine_coordinates(line) || compensates_uvw(line) ||
      places::enters_nowhere(line) || places::follow_path(line, motion, end))
    return true;
  places::visit(line, motion == Motion::kG0 ? MoveKind::kRapid : MoveKind::kFeed, end, places::named_axes(line));
  if (motion == Motion::kG1) keep_feed(line);
  enter(line);
  places::arrive(line, end);
  return false;
}

bool arc(ModeLine& line, Motion motion) {
  if (line.stop_in({{Mode::kStraightOwed, value_bit(modes::kOwed)}}, StopKind::kCompensation,
                   "The move just after exiting cutter compensation mode must be straight, not an arc", line.mover()) ||
      line.stop_in({kUvwPlanes}, StopKind::kPlaneWrong, "Cannot do an arc in planes G17.1, G18.1, or G19.1",
                   line.mover()))
    return true;
  const bool no_center = lacks_center(line);
  if (no_center && !line.has('r'))
    return line.stop(StopKind::kArcWords, "R i j k words all missing for arc", line.mover());
  if (!no_center && line.has('r'))
    return line.stop(StopKind::kArcWords, "Mixed radius ijk format for arc", line.at('r'), line.mover());
  if (feed_of(line, motion)) return true;
  for (const ArcPlane& plane : kArcPlanes) {
    if (no_center ? radius(line, plane) : center(line, plane)) return true;
  }
  Point end;
  if (places::end_point(line, &end) || places::arc(line, motion, end) || places::follow_path_by_arc(line, motion, end))
    return true;
  places::visit_arc(line, motion, end);
  keep_feed(line);
  enter(line);
  places::arrive(line, end);
  return false;
}

bool thread(ModeLine& line, Motion motion) {
  Point end;
  owe_nothing(line);
  if (places::end_point(line, &end) || compensates_uvw(line) || places::enters_nowhere(line) ||
      places::follow_path(line, motion, end))
    return true;
  if (motion == Motion::kG33 &&
      thread_spindle(line, "Invalid spindle ($) number in G33 move", "Spindle not turning in G33"))
    return true;
  if (motion == Motion::kG33_1 &&
      thread_spindle(line, "Invalid spindle ($) number in G33.1 move", "Spindle not turning in G33.1"))
    return true;
  if (motion == Motion::kG76 && g76(line, end)) return true;
  if (motion == Motion::kG76) {
    places::lose_moves(line, axis_set(0) | axis_set(2));
  } else {
    const MoveKind kind = motion == Motion::kG33_1 ? MoveKind::kTap : MoveKind::kFeed;
    places::visit(line, kind, end, places::named_axes(line));
  }
  if (motion == Motion::kG33_1) places::return_to_start(line, &end);
  places::arrive(line, end);
  return false;
}

bool probe(ModeLine& line, Motion motion) {
  if (line.refused_by_compensation("Cannot probe with cutter radius comp on", line.mover()) || feed_of(line, motion))
    return true;
  Point end;
  if (places::end_point(line, &end)) return true;
  const bool has_to_move = motion == Motion::kG38_2 || motion == Motion::kG38_4;
  if (has_to_move && places::starts_at_end(line, end)) return true;
  places::visit(line, MoveKind::kProbe, end, places::named_axes(line));
  places::go_towards(line, end);
  return false;
}

bool contour(ModeLine& line, Motion motion) {
  const int code = line.code(GGroup::kMotion);
  if (!line.has('q')) return line.stop(StopKind::kContourWords, "G7x.x  requires a Q word", line.mover());
  if (motion != Motion::kG70 && line.holds({kCompensationOn}) != Answer::kNo &&
      line.refused_by_compensation(name_of_contour(code) + " cannot be used with cutter compensation enabled",
                                   line.mover()))
    return true;
  constexpr BadMode kOtherPlane{Mode::kPlane, all_but(modes::kG18)};
  if (line.holds({kOtherPlane}) != Answer::kNo &&
      line.stop_in({kOtherPlane}, StopKind::kPlaneWrong, name_of_contour(code) + " can only be used in XZ plane (G18)",
                   line.mover()))
    return true;
  places::lose_moves(line, axis_set(0) | axis_set(2));  // it goes to and fro along its contour
  // The last move of the cut decides; if nothing is cut, the sub does.
  line.set_open(Mode::kMotion,
                kPlainMotions | (line.contour() == nullptr ? all_modes() : set_of(line.contour()->motion())));
  if (line.holds({kCompensationOn}) == Answer::kNo) {
    owe_nothing(line);
    if (places::cut_contour(line, motion)) return true;
  } else {
    places::lose_point(line);
    line.set_open(Mode::kStraightOwed);
    if (line.holds({kCompensationMoves}) != Answer::kNo) line.set_open(Mode::kEntry);
  }
  if (line.holds({kInverseTime}) != Answer::kNo) line.set_open(Mode::kFeed);
  return false;
}

}  // namespace owlint::steps
