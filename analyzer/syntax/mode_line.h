// A line of words while it is carried out on the modes. Its words act in steps, whatever their order on the line; each family of
// steps has a file, mode_steps_*.cc, and mode_run.cc puts them in order.
#pragma once

#include "analyzer/syntax/mode_faults.h"
#include "analyzer/syntax/moves.h"

namespace owlint {

inline constexpr MotionSet kCycles = set_of(Motion::kG73) | set_of(Motion::kG74) | set_of(Motion::kG81) |
    set_of(Motion::kG82) | set_of(Motion::kG83) | set_of(Motion::kG84) | set_of(Motion::kG85) | set_of(Motion::kG86) |
    set_of(Motion::kG87) | set_of(Motion::kG88) | set_of(Motion::kG89);
inline constexpr MotionSet kProbes =
    set_of(Motion::kG38_2) | set_of(Motion::kG38_3) | set_of(Motion::kG38_4) | set_of(Motion::kG38_5);
inline constexpr MotionSet kSplines =
    set_of(Motion::kG5) | set_of(Motion::kG5_1) | set_of(Motion::kG6) | set_of(Motion::kG6_1);

inline constexpr MotionSet kContours = set_of(Motion::kG70) | set_of(Motion::kG71) | set_of(Motion::kG71_1) |
    set_of(Motion::kG71_2) | set_of(Motion::kG72) | set_of(Motion::kG72_1) | set_of(Motion::kG72_2);

/// What such a line stops with hangs on the lines of a sub.
inline bool cuts_contour(const WordLine& words) {
  const GCode* const motion = words.code(GGroup::kMotion);
  return motion != nullptr && contains(kContours, motion->motion);
}

/// How far from a whole number the number of a tool or an orientation may be.
inline constexpr double kWholeSlack = 0.0001;

class ModeLine : public ModeFaults {
 public:
  ModeLine(const MachineWords& machine, const WordLine& words, ModeState* state, std::vector<ModeFault>* faults,
           Place* place, MoveWatch watch = {}, const ContourSub* contour = nullptr)
      : ModeFaults(state, faults), machine_(machine), words_(words), place_(place), watch_(watch), contour_(contour) {}
  /// The same line, on some runs; nobody is told where it goes.
  ModeLine(const ModeLine& line, ModeState* state, std::vector<ModeFault>* faults, Place* place)
      : ModeLine(line.machine_, line.words_, state, faults, place, {}, line.contour_) {}

  const MachineWords& machine() const { return machine_; }
  const WordLine& words() const { return words_; }
  /// Null if positions are not followed.
  Place* place() const { return place_; }
  /// Who is told where the line goes; only with a place.
  const MoveWatch& watch() const { return watch_; }
  /// The sub of a contour; null if its lines are not known.
  const ContourSub* contour() const { return contour_; }
  void save(modes::Saved by);
  bool since(Release release) const { return machine_.release >= release; }

  bool has(char letter) const { return words_.has(letter); }
  uint8_t at(char letter) const { return words_.find(letter); }
  /// P-1 and Q-1 count as missing.
  bool lacks(char letter) const;
  /// The value of a word, or null if it is not on the line or not known.
  const double* value(char letter) const;
  /// The number of the line's code of the group, of a G code in tenths; -1 without one.
  int code(GGroup group) const;
  int code(MGroup group) const;
  uint8_t at(GGroup group) const { return words_.word_of(group); }
  uint8_t at(MGroup group) const { return words_.word_of(group); }
  /// The code that moves; kNoWord if the motion mode does.
  uint8_t mover() const { return at(GGroup::kMotion); }

  /// Whether `$` is known to name no spindle; `least` is -1 where all may be meant.
  bool names_no_spindle(int least) const;
  bool refuses_spindle(int least, std::string_view message, uint8_t word);
  /// Makes the spindle that `$` names the active one, to which motions look. Only that of `$0` is followed: with another one
  /// the speed, and whether it turns, are not known any more.
  bool choose_spindle(std::string_view message, uint8_t word);
  /// Whether `S`, `M3`, `M4` or `M5` is for the spindle that is followed: without `$`, with `$0`, and with `$-1` for all.
  Answer is_for_spindle() const;
  /// The speed of that spindle, or whether it turns.
  void set_spindle(Mode mode, uint8_t value);
  /// Stops if the tool table lacks the number.
  bool lacks_tool(int number, uint8_t word, uint8_t other = kNoWord);
  /// Null if nothing is known of it.
  const Tool* tool(int number) const;
  /// The same of the tool in the spindle.
  const Tool* tool_in_spindle() const;
  bool refused_by_compensation(std::string_view message, uint8_t word);

 private:
  const MachineWords& machine_;
  const WordLine& words_;
  Place* const place_;
  const MoveWatch watch_;
  const ContourSub* const contour_;
};

/// The checks of the complete line, and its motion: for each motion that may be in effect (mode_motion.cc).
bool stops_before_it_acts(const MachineWords& machine, const WordLine& words, ModeState* state,
                          std::vector<ModeFault>* faults);
bool stops_moving(ModeLine& line);

/// The steps: each is true if no run goes on.
namespace steps {

bool spindle_mode(ModeLine& line);    ///< G96 G97
bool feed_mode(ModeLine& line);       ///< G93 G94 G95
bool feed(ModeLine& line);            ///< F
bool speed(ModeLine& line);           ///< S
bool select_tool(ModeLine& line);     ///< T
bool inputs_outputs(ModeLine& line);  ///< M62 to M68
bool change_tool(ModeLine& line);     ///< M6 M61
bool spindle(ModeLine& line);         ///< M3 M4 M5 M19
bool save(ModeLine& line);            ///< M70 M71 M73
bool coolant(ModeLine& line);         ///< M7 M8 M9
bool overrides(ModeLine& line);       ///< M48 to M53
bool plane(ModeLine& line);           ///< G17 to G19.1
bool units(ModeLine& line);           ///< G20 G21
bool diameter(ModeLine& line);        ///< G7 G8
bool compensation(ModeLine& line);    ///< G40 to G42.1
bool tool_length(ModeLine& line);     ///< G43 G43.1 G43.2 G49
bool system(ModeLine& line);          ///< G54 to G59.3
bool path_control(ModeLine& line);    ///< G61 G61.1 G64
bool distance(ModeLine& line);        ///< G90 G91, then G90.1 G91.1
bool retract(ModeLine& line);         ///< G98 G99
bool non_modal(ModeLine& line);       ///< G10 G28 G28.1 G30 G30.1 G52 G92 G5.3
bool axis_offsets(ModeLine& line);    ///< G92.1 G92.2 G92.3
bool pause(ModeLine& line);           ///< M0 M1 M60, behind the motion

/// G40, also one that M72 writes.
void switch_compensation_off(ModeFaults& of);

// The motions.
bool straight(ModeLine& line, Motion motion);  ///< G0 G1
bool arc(ModeLine& line, Motion motion);       ///< G2 G3
bool spline(ModeLine& line, Motion motion);    ///< G5 G5.1 G6 G6.1
bool nurbs(ModeLine& line, Motion motion);     ///< G5.2 G6.2
bool end_nurbs(ModeLine& line);                ///< G5.3
bool thread(ModeLine& line, Motion motion);    ///< G33 G33.1 G76
bool probe(ModeLine& line, Motion motion);     ///< G38.2 to G38.5
bool contour(ModeLine& line, Motion motion);   ///< G70 to G72.2
bool cycle(ModeLine& line, Motion motion);     ///< G73 G74 G81 to G89
/// What a motion needs of the feed: a table of these checks is in mode_steps_feed.cc.
bool feed_of(ModeLine& line, Motion motion);
/// The same of the spindle: that it turns, and in which direction.
bool turning(ModeLine& line, Motion motion);

}  // namespace steps
}  // namespace owlint
