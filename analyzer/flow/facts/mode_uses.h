// Which modes decide anything in a program: only those are followed. Most programs never leave most modes, so that what a
// line needs of them is there in any case.
#pragma once

#include <span>
#include <vector>

#include "analyzer/program/program.h"
#include "analyzer/syntax/mode_run.h"

namespace owlint::flow {

/// The words of a kModeLine, as far as they are not computed. False for those of a line that begins with M98: they are
/// checked, but not carried out.
bool read_words(const Syntax& syntax, const Statement& asks, WordLine& into);

class ModeUses {
 public:
  /// `start`: the modes with which a run begins; `others`: modes that are followed in any case.
  ModeUses(const Program& program, const MachineWords& machine, const ModeSets& start, ModeMask others = 0);

  /// The modes that decide whether some line stops, or what it means.
  ModeMask followed() const { return followed_; }
  /// The values that the other modes may have, as far as the program's lines say.
  const ModeSets& others() const { return others_; }
  bool follows(Mode mode) const { return (followed_ & mask_of(mode)) != 0; }
  /// Of these, the ones that the program reads under a name, such as `#<_metric>`.
  ModeMask named() const { return named_; }
  /// Whether it is followed where the machine stands, from the line on where runs may go elsewhere.
  bool follows_place() const { return program_.syntax.asks_place; }
  bool follows_place(StatementId at) const { return follows_place() && at >= program_.syntax.left_at; }
  /// Whether some line stops in some of the modes that may be in effect.
  bool refuses() const { return refuses_; }
  /// Of these, the ones that a statement, or the lines behind it, may change; kPlaceBit if they may go somewhere.
  ModeMask changed_at(StatementId id) const;
  /// Of these, the ones that the words of a kModeLine set: not what the lines behind it do.
  ModeMask set_at(StatementId id) const;

 private:
  void find_reachable();
  void find_followed();
  /// Carries out a kModeLine in all modes that are reachable; true if more are behind it.
  bool run(StatementId id, std::vector<ModeFault>* faults);
  /// The same of one with remapped codes: its part.
  bool run_part(StatementId id, const WordLine& words, ModeState* after, std::vector<ModeFault>* faults) const;
  ModeMask modes_changed_at(const Statement& s, StatementId id) const;

  const Program& program_;
  const MachineWords& machine_;
  ModeSets reachable_, others_;
  ModeMask followed_ = 0;
  ModeMask named_ = 0;
  bool refuses_ = false;
};

}  // namespace owlint::flow
