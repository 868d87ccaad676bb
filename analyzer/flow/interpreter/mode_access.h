// The modes in a state's parameters: what a line finds in effect, and what it leaves.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "analyzer/flow/domain/known_parameters.h"
#include "analyzer/flow/domain/modes.h"
#include "analyzer/flow/facts/mode_uses.h"
#include "analyzer/syntax/mode_names.h"
#include "analyzer/syntax/moves.h"
#include "analyzer/syntax/place_names.h"

namespace owlint::flow {

class ModeAccess {
 public:
  /// All must outlive it. Saved modes have the keys behind those of local names, of which there are `names`.
  ModeAccess(const ModeUses& uses, size_t names, KnownValues& values, PersistentMap::Pool& pool)
      : uses_(uses), saved_keys_(kLocalNames + static_cast<uint32_t>(names)), values_(values), pool_(pool) {}

  ModeState state(const Parameters& p) const;
  void set(Parameters& p, const ModeState& state);
  /// The same of some lines that are not carried out one by one.
  void apply(Parameters& p, std::span<const ModeChange> changes);
  /// Where the machine stands.
  Place place(const Parameters& p) const;
  void set_place(Parameters& p, const Place& place);
  /// A line moves before its values are worked out here: they are read in the place that it begins in.
  void begin_line(Parameters& p);
  void end_line(Parameters& p);
  /// The machine goes as far as some lines that are not carried out one by one.
  void go(Parameters& p, std::span<const PlaceChange> changes);
  /// Tells where such lines go, before go().
  void tell(const Parameters& p, const PlaceChange& change, MoveWatch watch) const;
  /// What is read under the name of a mode, as far as the program has set the mode, or under that of an axis, as far as it is
  /// known where the machine stands.
  std::optional<Range> named(const Parameters& p, std::string_view name) const;
  /// The same of a number, #5220 or #5420.
  std::optional<Range> numbered(const Parameters& p, long number) const;
  /// Applies what the outcome of a condition says about the modes that it reads. False if no run has this outcome.
  bool learn(Parameters& p, const Syntax& syntax, ExprId condition, bool truth);
  /// A call begins: on its level nothing is saved.
  void begin_level(Parameters& p);
  /// A line with remapped codes is read with the motion in effect; the rest of it behind their subs keeps that.
  void keep_motion(Parameters& p, const ModeState& state);
  ModeValues kept_motion(const Parameters& p) const;
  void drop_motion(Parameters& p);
  /// Whether cutter compensation is surely on.
  bool compensates(const Parameters& p) const;
  /// Whether the modes that M73 has saved come back where the call ends.
  bool restores(const Parameters& p) const;

 private:
  std::optional<Range> shown(const Parameters& p, const std::optional<ModeName>& shown) const;
  std::optional<Range> shown(const Parameters& p, const std::optional<PlaceName>& shown) const;
  bool has_said(const Parameters& p, Mode mode) const;
  void say(Parameters& p, ModeMask modes);
  uint32_t motion_key() const { return saved_keys_ + kPlaceNumber; }
  uint32_t saved_key(Mode mode) const { return saved_keys_ + static_cast<uint32_t>(mode); }

  const ModeUses& uses_;
  uint32_t saved_keys_;
  KnownValues& values_;
  PersistentMap::Pool& pool_;
};

}  // namespace owlint::flow
