// How far a program goes: along each axis the least and the greatest coordinate of all its moves, with arcs between their ends,
// and of what it is not known.
#pragma once

#include <array>
#include <compare>
#include <limits>
#include <map>

#include "analyzer/syntax/moves.h"

namespace owlint {

/// A line of one of the files of a program; 0 is its own.
struct LineOfFile {
  uint32_t file = 0;
  uint32_t line = 0;  ///< from 1

  auto operator<=>(const LineOfFile&) const = default;
};

/// How far moves go along one axis. Empty if there is none.
struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  LineOfFile least_at, greatest_at;

  bool empty() const { return !(least <= greatest); }
  void add(double from, LineOfFile from_at, double to, LineOfFile to_at);
  void add(const Extent& other);
};

/// Why it is not known how far a line goes.
enum class UnknownExtent : uint8_t {
  kPlace,    ///< where the move ends
  kArc,      ///< where an arc goes between its ends
  kUnits,    ///< whether its numbers are inches or millimetres
  kCode,     ///< its code is not followed
  kBesides,  ///< cutter compensation: the tool goes beside the contour, which is counted as it is written
};

class Extents final : public MoveVisitor {
 public:
  /// What coordinates count from.
  struct Origin {
    static constexpr uint8_t kMachine = kSystemCount;  ///< the zero of the machine
    static constexpr uint8_t kSomeSystem = kSystemCount + 1;

    uint8_t system = 0;       ///< G54 is 0
    bool shifted = false;     ///< by G92 or G52
    bool from_start = false;  ///< from where the machine stands before the first of these moves

    auto operator<=>(const Origin&) const = default;
  };
  struct Rates {
    Extent rapid, feed;

    Extent both() const;
  };
  using Axes = std::array<Rates, kAxisCount>;

  bool visit(const Moves& moves) override;
  void lose(uint32_t line, AxisSet axes) override { miss(UnknownExtent::kCode, axes, line); }
  /// Further lines are those of this file.
  void go_on_in(uint32_t file) { file_ = file; }
  /// A run stops at a line.
  void stop(LineOfFile at);

  /// Lengths are in units of the first move.
  const std::map<Origin, Axes>& origins() const { return origins_; }
  /// Millimetres in this unit.
  double unit() const { return unit_ == 0 ? 1 : unit_; }
  /// The first line that is not known for a reason, by axis.
  const std::map<std::pair<UnknownExtent, size_t>, LineOfFile>& unknown() const { return unknown_; }
  /// The first line at which a run stops; a line of 0 if none does.
  LineOfFile stops_at() const { return stops_at_; }

 private:
  void miss(UnknownExtent why, AxisSet axes, uint32_t line);
  void add(Origin origin, size_t axis, bool rapid, const Way& way, double factor);
  void add_machine(const Moves& moves, size_t axis);
  void add_arc(const Moves& moves, Origin origin, double factor);

  std::map<Origin, Axes> origins_;
  std::map<std::pair<UnknownExtent, size_t>, LineOfFile> unknown_;
  LineOfFile stops_at_;
  double unit_ = 0;
  uint32_t file_ = 0;
};

}  // namespace owlint
