// Where the machine stands while a file is read from the first line to the last. Up to the first line from where runs may go
// elsewhere that is what every run does, and so long as nothing stops there is nothing to tell of it. From there on the flow
// carries lines out: it gets those whose numbers matter as questions (kModeLine), and how far the plain lines between them go
// as a PlaceChange.
#pragma once

#include <array>
#include <vector>

#include "analyzer/syntax/bulk.h"
#include "analyzer/syntax/mode_run.h"
#include "analyzer/syntax/place.h"
#include "analyzer/syntax/plain_words.h"
#include "analyzer/syntax/statement.h"

namespace owlint {

class PlacesInEffect {
 public:
  PlacesInEffect(Syntax& out, const MachineWords& machine, Sums sums)
      : out_(out), machine_(machine), sums_(sums), place_(Place::started(machine.units_per_mm)) {
    if (machine.start != nullptr) assumed_ = *machine.start;
  }

  /// Takes in the plain lines in [from, to), which have this effect. Where there are arcs it ends at the first that has to
  /// be looked at by itself, and returns its offset; else `to`.
  size_t pass(std::string_view bytes, size_t from, size_t to, const PlainEffect& effect, const LastLines& last,
              const ModeSets& before);
  /// Carries out another line; `before`: what is known of the modes, `asked`: the flow carries it out in any case. Whether
  /// it is a
  /// question for the flow, for its numbers.
  bool judge(const WordLine& words, const ModeSets& before, bool block_delete, bool asked);
  /// The statement that is kept next is one from where runs may go elsewhere.
  void leave() { leave(place_); }
  bool has_moved() const { return !pending_.empty(); }
  /// Writes down how far the lines since the last statement go.
  void flush();

 private:
  /// Modes that a line's numbers are read in, as far as lines have said; else as an interpreter starts.
  void assume(const ModeSets& before);
  void leave(const Place& place);
  bool needs_sums(const ModeSets& before);
  bool is_plain_move(const WordLine& words, Motion motion) const;
  bool arc_passes(const PlainWords& words) const;
  void go(size_t letter, double last, double sum);
  void note(const PlainMoves& moves, const ModeSets& before, bool alone);
  void note_lost();
  PlaceChange& pending(const ModeSets& before, bool alone);

  /// Lines that the flow is asked about: as many as people write by hand.
  static constexpr uint32_t kMostQuestions = 2000;

  Syntax& out_;
  const MachineWords& machine_;
  Sums sums_;
  ModeState assumed_ = ModeState::started();
  Place place_;
  bool left_ = false;
  uint32_t questions_ = 0;
  std::vector<PlaceChange> pending_;  // since the last statement
  std::vector<ModeFault> faults_;
};

}  // namespace owlint
