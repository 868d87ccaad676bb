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
  PlacesInEffect(Syntax& out, const MachineWords& machine, Expected expected)
      : out_(out), machine_(machine), expected_(expected), limits_(machine), place_(started_on(machine)) {
    if (machine.start != nullptr) assumed_ = *machine.start;
    if (machine.has_limits) visitor_ = &limits_;
    if (machine.measures_extents) visitor_ = extents_.get();
  }

  /// Takes in the plain lines in [from, to), which have this effect; `line`: the number of the first. Where there are arcs it
  /// ends at the first that has to be looked at by itself, and returns its offset; else `to`.
  size_t pass(std::string_view bytes, size_t from, size_t to, uint32_t line, const PlainEffect& effect,
              const LastLines& last, const ModeSets& before);
  /// Carries out another line; `before`: what is known of the modes, `asked`: the flow carries it out in any case. Whether
  /// it is a
  /// question for the flow, for its numbers.
  bool judge(const WordLine& words, const ModeSets& before, const Statement& statement, bool asked);
  /// The statement that is kept next is one from where runs may go elsewhere.
  void leave() { leave(place_); }
  /// The same of one that reads where the machine stands.
  void leave_reading();
  /// The same of one that writes numbers of the place.
  void leave_writing();
  /// All runs stop at a line.
  void stop(uint32_t line);
  /// The program ends.
  void end() { visitor_ = nullptr; }
  bool has_moved() const { return !pending_.empty(); }
  /// Writes down how far the lines since the last statement go.
  void flush();
  /// No line comes any more.
  void finish() {
    out_.limit_faults = limits_.faults();
    if (machine_.measures_extents) out_.extents = extents_;
  }

 private:
  /// Where it may begin: what no tool of the table has is no offset from before.
  static Place started_on(const MachineWords& machine);
  /// Modes that a line's numbers are read in, as far as lines have said; else as an interpreter starts.
  void assume(const ModeSets& before);
  void leave(const Place& place);
  bool needs_sums(const ModeSets& before);
  bool is_plain_move(const WordLine& words, Motion motion) const;
  bool arc_passes(const PlainWords& words) const;
  void go(size_t letter, double last, double sum);
  void note(const PlainMoves& moves, const PlainReaches* reaches, const ModeSets& before, bool alone);
  void note_limits(const WordLine& words);
  void note_lost();
  PlaceChange& pending(const ModeSets& before, bool alone);

  // For those who ask where moves end: places_visited.cc.
  Moves moves_from_here(MoveKind kind) const;
  bool tell(const PlainReach& reach, MoveKind kind);
  void tell_each(std::string_view bytes, size_t from, size_t to, uint32_t line);
  void tell_line(const PlainWords& words, Motion motion, uint32_t line);
  void add_arc(const PlainWords& words, bool clockwise, uint32_t line, Moves* moves) const;
  void walk(std::string_view bytes, size_t from, size_t to, uint32_t line, const ModeSets& before, bool alone);

  /// Lines that the flow is asked about: as many as people write by hand.
  static constexpr uint32_t kMostQuestions = 2000;

  Syntax& out_;
  const MachineWords& machine_;
  const Expected expected_;
  LimitChecks limits_;
  std::shared_ptr<Extents> extents_ = std::make_shared<Extents>();
  MoveVisitor* visitor_ = nullptr;  // of the lines up to the first from where runs may go elsewhere; null: nobody asks
  ModeState assumed_ = ModeState::started();
  Place place_;
  bool left_ = false;
  uint32_t questions_ = 0;
  PlainWordReader reader_;
  std::vector<PlaceChange> pending_;  // since the last statement
  std::vector<ModeFault> faults_;
};

}  // namespace owlint
