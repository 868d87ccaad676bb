// Moves of a compensated path that the interpreter holds back, because the next corner says where the tool has to turn.
#pragma once

#include "analyzer/geometry/path_step.h"
#include "analyzer/geometry/plane_point.h"

namespace owlint {

enum class Side : uint8_t { kLeft, kRight };

/// Whether the tool is on the side of the center of an arc that turns this way.
inline bool inside(Side side, int turns) { return side == Side::kLeft ? turns > 0 : turns < 0; }

/// An angle swept from one point to another. Where both are in one direction, rounding decides between nothing and a turn.
struct Sweep {
  double angle = 0;
  double other = 0;  ///< what it would be if the rounding were different; else the same

  bool operator==(const Sweep&) const = default;
};
Sweep sweep(PlanePoint from, PlanePoint to, PlanePoint center, int turns);

struct QueuedMove {
  bool arc = false;
  bool rapid = false;
  int turns = 0;           ///< of an arc
  PlanePoint end{};        ///< of the tool
  PlanePoint center{};     ///< of an arc
  PlanePoint direction{};  ///< of a line
  Sweep swept{};           ///< by an arc, as programmed

  bool operator==(const QueuedMove&) const = default;
};

/// At most two moves that go anywhere are waiting at a time: the next one sends those before it. Others have no end to
/// shorten, so that their number is enough.
class MoveQueue {
 public:
  bool empty() const { return waiting_ == 0; }
  /// The first move that waits, or if there is none, the first of those that were sent last: so does the interpreter.
  const QueuedMove& front() const { return moves_[0]; }

  void append(const QueuedMove& move);
  /// A line that stays where the tool is.
  void append_standing(PlanePoint at, bool rapid);
  /// What does not move, but waits behind moves.
  void append_others(int count);

  /// Where the first waiting move begins.
  void anchor(PlanePoint at);
  void send();
  /// Ends the waiting moves at this point and sends them. Nothing if none is waiting. False if the interpreter stops.
  bool trim(PlanePoint at, bool inch, PathStep& step);
  void scale(double factor);

  bool operator==(const MoveQueue&) const = default;

 private:
  bool reaches(const QueuedMove& move, PlanePoint at, bool inch, PathStep& step) const;

  static constexpr int kMoves = 2;
  QueuedMove moves_[kMoves]{};
  PlanePoint anchor_{};
  int waiting_ = 0;  ///< all that waits; of these only the first ones are in `moves_`
  bool anchored_ = false;
};

}  // namespace owlint
