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
  Cutting(ModeLine& line, PlanePoint at) : line_(line), at_(at), inch_(line.only(Mode::kUnits) == modes::kG20) {}

  bool move(const ContourMove& move) override {
    using Kind = ContourMove::Kind;
    if (move.kind != Kind::kRapid && !feeds(move.kind == Kind::kFeed ? Motion::kG1 : Motion::kG2)) return false;
    if ((move.kind == Kind::kClockwise || move.kind == Kind::kCounterclockwise) && !fits(move)) return false;
    at_ = move.end;
    return true;
  }
  PlanePoint at() const { return at_; }
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
  bool fed_ = false;
  std::optional<std::string> refused_;
};

/// Rounding decides, or the place does.
bool stops_cutting(ModeLine& line, Verdict verdict, bool unsure, std::string message) {
  if (!unsure) return stop_by(line, verdict, kContour, std::move(message), line.mover());
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
void leave_contour(ModeLine& line, PlanePoint at) {
  Point end = line.place()->at;
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (const auto word = axis_word(line, i)) end[i] = *word;
  }
  end[kAlong] = Coordinate::of(at.first);
  end[kAcross] = Coordinate::of(at.second);
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
  const Verdict verdict = anywhere ? Verdict::kStops : Verdict::kFromStart;
  const PlanePoint at{along.value, across.value};
  ContourReader reader(*modes, at);
  if (const char* const message = reader.read(*line.contour()))
    return stop_by(line, verdict, kContour, message, line.mover());
  Cutting moves(line, at);
  const ContourOutcome outcome = cut_contour(reader.elements(), *words, moves);
  if (outcome.end == ContourEnd::kStops && stops_cutting(line, verdict, outcome.unsure, outcome.message)) return true;
  if (outcome.end == ContourEnd::kRefused) {
    if (!moves.refused()) return true;
    if (stops_cutting(line, verdict, outcome.unsure, *moves.refused())) return true;
  }
  const bool known = outcome.end == ContourEnd::kDone && !outcome.unsure && anywhere;
  if (known) {
    leave_contour(line, reader.elements().size() < 2 ? reader.at() : moves.at());
  } else {
    lose_point(line);
  }
  return false;
}

}  // namespace owlint::places
