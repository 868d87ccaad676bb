// Lathe contours: the moves that G70 to G72.2 make, with what each of them needs.
#include <cmath>

#include "analyzer/geometry/arc_check.h"
#include "analyzer/syntax/mode_place.h"

namespace owlint::places {
namespace {

constexpr StopKind kContour = StopKind::kContourWords;
constexpr auto kAlong = static_cast<size_t>(Axis::kZ), kAcross = static_cast<size_t>(Axis::kX);

/// The words of a contour; nothing if one is not known.
std::optional<ContourWords> contour_words(const ModeLine& line, Motion motion) {
  using Cut = ContourWords::Cut;
  ContourWords words;
  for (const auto& [letter, into] :
       {std::pair{'d', &words.d}, {'e', &words.e}, {'i', &words.i}, {'p', &words.p}, {'r', &words.r}}) {
    if (!line.has(letter)) continue;
    const double* const value = line.value(letter);
    if (value == nullptr) return std::nullopt;
    *into = *value;
  }
  words.facing = motion == Motion::kG72 || motion == Motion::kG72_1 || motion == Motion::kG72_2;
  if (motion == Motion::kG71 || motion == Motion::kG72) words.cut = Cut::kPocketsAtOnce;
  if (motion == Motion::kG71_1 || motion == Motion::kG72_1) words.cut = Cut::kNoPockets;
  if (motion == Motion::kG71_2 || motion == Motion::kG72_2) words.cut = Cut::kPocketsAfterwards;
  return words;
}

/// Makes the moves, from a point on.
class Cutting : public ContourMoves {
 public:
  /// `feeds`: whether the moves are asked for their feed, of which the line tells.
  Cutting(ModeLine& line, PlanePoint at, bool feeds)
      : line_(line), at_(at), inch_(line.only(Mode::kUnits) == modes::kG20), fed_(!feeds) {}

  bool move(const ContourMove& move) override {
    using Kind = ContourMove::Kind;
    if (move.kind != Kind::kRapid && !feeds(move.kind == Kind::kFeed ? Motion::kG1 : Motion::kG2)) return false;
    if ((move.kind == Kind::kClockwise || move.kind == Kind::kCounterclockwise) && !fits(move)) return false;
    at_ = move.end;
    last_ = move.kind;
    return true;
  }
  PlanePoint at() const { return at_; }
  /// The motion mode behind the moves.
  Motion motion() const {
    constexpr Motion kOfKind[] = {Motion::kG0, Motion::kG1, Motion::kG2, Motion::kG3};
    return kOfKind[static_cast<size_t>(last_)];
  }
  /// Whether an arc has been refused, and its message.
  const std::optional<std::string>& refused() const { return refused_; }

 private:
  /// An F on the line is none of these moves.
  bool feeds(Motion motion) {
    if (fed_) return true;
    fed_ = true;
    const char* const without_f = motion == Motion::kG1 ? "F word missing with inverse time g1 move"
                                                        : "F word missing with inverse time arc move";
    return !steps::feed_of(line_, motion) &&
        !line_.stop_in({{Mode::kFeedMode, value_bit(modes::kG93)}}, StopKind::kFeedMode, without_f, line_.mover());
  }
  bool fits(const ContourMove& move) {
    ArcEntry arc{};
    arc.end = move.end;
    arc.center = move.center;
    arc.turns = move.kind == ContourMove::Kind::kClockwise ? -1 : 1;
    arc.spread = inch_ ? line_.machine().arc_tolerance_inch : line_.machine().arc_tolerance_mm;
    PathStep step;
    if (arc_check(at_, {inch_, {'Z', 'X'}}, arc, step)) return true;
    refused_ = std::move(step.message);
    return false;
  }

  ModeLine& line_;
  PlanePoint at_;
  bool inch_;
  bool fed_;
  ContourMove::Kind last_ = ContourMove::Kind::kRapid;
  std::optional<std::string> refused_;
};

/// What becomes of a contour that begins at one point.
struct Cut {
  ContourOutcome outcome;
  std::string message;  ///< the interpreter's, if it stops for the contour
  PlanePoint at;        ///< the end, if it comes to it
  Motion motion;        ///< the mode behind it
};

Cut cut_from(ModeLine& line, const ContourModes& modes, const ContourWords& words, PlanePoint start, bool feeds) {
  ContourReader reader(modes, start);
  if (const char* const message = reader.read(*line.contour())) return {{ContourEnd::kStops}, message, start, {}};
  Cutting moves(line, start, feeds);
  const ContourOutcome outcome = cut_contour(reader.elements(), words, moves);
  Cut cut{outcome, {}, moves.at(), moves.motion()};
  if (cut.outcome.message != nullptr) cut.message = cut.outcome.message;
  if (moves.refused()) cut.message = *moves.refused();
  if (reader.elements().size() < 2) {
    cut.at = reader.at();
    cut.motion = line.contour()->motion();
  }
  return cut;
}

bool comes_to_end(const Cut& cut) { return cut.outcome.end == ContourEnd::kDone && !cut.outcome.unsure; }

/// Rounding decides, or the place does.
bool stops_cutting(ModeLine& line, CheckOutcome outcome, bool unsure, std::string message) {
  if (!unsure) return stop_by(line, outcome, kContour, std::move(message), line.mover());
  line.may_stop(kContour, std::move(message), line.mover(), kNoWord, 0, true);
  line.faults()->back().by_place = true;
  return false;
}

std::optional<ContourModes> contour_modes(const ModeLine& line) {
  const auto distance = line.only(Mode::kDistance), centers = line.only(Mode::kArcDistance),
             diameter = line.only(Mode::kDiameter);
  if (!distance || !centers || !diameter || !line.only(Mode::kUnits)) return std::nullopt;
  return ContourModes{*distance == modes::kG91, *centers == modes::kG90_1, *diameter == modes::kG7};
}

/// Behind the cut: the rapid move to its start takes words for positions, whatever the distance mode.
void leave_contour(ModeLine& line, Coordinate along, Coordinate across) {
  Point end = line.place()->at;
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (const auto word = axis_word(line, i)) end[i] = *word;
  }
  end[kAlong] = along;
  end[kAcross] = across;
  arrive(line, end);
}

}  // namespace

bool cut_contour(ModeLine& line, Motion motion) {
  Place* const place = line.place();
  if (place == nullptr) return false;
  Point start;
  if (end_point(line, &start)) return true;
  const auto modes = contour_modes(line);
  const auto words = contour_words(line, motion);
  const Coordinate along = start[kAlong], across = start[kAcross];
  const bool readable = line.contour() != nullptr && modes && !(line.contour()->begins_blank && modes->incremental);
  if (!readable || !words || along.is_unknown() || across.is_unknown()) {
    lose_point(line);
    return false;
  }
  const bool anywhere = along.is_known() && across.is_known();
  const Cut cut = cut_from(line, *modes, *words, {along.value, across.value}, true);
  if (!cut.message.empty() &&
      stops_cutting(line, anywhere ? CheckOutcome::kStops : CheckOutcome::kFromStart, cut.outcome.unsure, cut.message))
    return true;
  if (cut.outcome.end == ContourEnd::kRefused && cut.message.empty()) return true;
  const bool is_lost = cut.outcome.end == ContourEnd::kCrashes || cut.outcome.end == ContourEnd::kNeverEnds;
  if (is_lost && !cut.outcome.unsure && anywhere)
    return stop_by(line, CheckOutcome::kStops, kContour, "", line.mover());
  if (!comes_to_end(cut)) {
    lose_point(line);
    return false;
  }
  Cut other = cut;
  if (!anywhere) other = cut_from(line, *modes, *words, {along.other, across.other}, false);
  constexpr double kNowhere = Coordinate::unknown().other;
  if (!comes_to_end(other)) {
    other.at = {kNowhere, kNowhere};
  } else if (cut.motion == other.motion) {
    line.set_known(Mode::kMotion, set_of(cut.motion));
  }
  leave_contour(line, {cut.at.first, other.at.first}, {cut.at.second, other.at.second});
  return false;
}

}  // namespace owlint::places
