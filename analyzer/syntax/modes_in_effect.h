// Which modes are in effect, as far as the lines themselves say, while a file is read from the first line to the last. Between
// two O-words a mode is known from the first line that sets it. What depends on one that is not known becomes a question to the
// flow: a kModeLine. What lines set becomes a ModeChange.
#pragma once

#include <array>
#include <vector>

#include "analyzer/syntax/bulk.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/mode_run.h"
#include "analyzer/syntax/places_in_effect.h"
#include "analyzer/syntax/statement.h"

namespace owlint {

/// A question to the flow about a line, which may have no statement itself: a kModeLine, kMachineCheck or kUserCode.
Statement question_about(const Statement& line, LineKind kind, uint32_t first);

class ModesInEffect {
 public:
  ModesInEffect(Syntax& out, LineParser& parser, const MachineWords& machine, Expected expected = Expected::kAnything)
      : out_(out),
        parser_(parser),
        machine_(machine),
        anything_(expected == Expected::kUsual ? ModeState::usual() : ModeState::unknown()),
        places_(out, machine_, expected) {}

  /// Takes in plain lines, whose numbers count from `before` on; `last`: the number of the last of them.
  void pass(const PlainEffect& effect, uint32_t before, uint32_t last);
  /// Follows where plain lines go, the first of which has this number; see PlacesInEffect::pass. To be called before pass().
  size_t follow(std::string_view bytes, size_t from, size_t to, uint32_t line, const PlainEffect& effect,
                const LastLines& last) {
    if (stopped_) return to;
    return drills_deep(effect) ? from : places_.pass(bytes, from, to, line, effect, last, state_.now);
  }
  /// Carries out the line that was parsed last. An error that it has whatever was in effect before goes into the statement.
  /// Returns whether the line is to be kept: `keep`, or because of its words.
  bool judge(Statement& statement, bool keep);
  /// Keeps the line that was judged, with the question that it has.
  void push(const Statement& statement);
  /// No line comes after those that were taken in.
  void finish() {
    flush();
    places_.finish();
  }

 private:
  void forget();
  void leave_out_asked(ModeMask assigned);
  static void set_feed(const WordLine& words, ModeSets* after);
  bool drills_deep(const PlainEffect& effect) const;
  bool asks(const WordLine& words, const ModeState& after, bool alone) const;
  bool judge_behind(Statement& statement, const WordLine& words);
  bool writes_offsets(const Statement& statement) const;
  bool stays_rapid(const WordLine& words) const;
  void take(const ModeState& after, bool alone, uint32_t line);
  double number_of(Mode mode);
  void set(Mode mode, uint8_t value, uint32_t line);
  void note(Mode mode, uint8_t value, uint32_t line);
  void moved(bool alone, uint32_t line);
  void note_set(Mode mode, uint8_t value, uint32_t line);
  void need(Mode mode, uint32_t line);
  void need_of(const WordLine& words, uint32_t line);
  void follow_curve(const WordLine& words, const ModeSets& after, const Statement& statement);
  void drop_curve(uint32_t line);
  void flush();
  Statement question_of(const Statement& statement);
  void push_remaps(const Statement& statement, const Statement& asks);
  static bool has_own(const Statement& statement);

  Syntax& out_;
  LineParser& parser_;
  MachineWords machine_;
  const ModeState anything_;  // what may be in effect where runs come from elsewhere
  PlacesInEffect places_;
  ModeState state_ = anything_;
  std::array<ModeChange, kModes> pending_{};   // by mode, where changed_ has it
  ModeMask changed_ = 0;                       // since the last statement
  ModeMask settled_ = 0;                       // set or needed since the last O-word
  std::array<ModeChange, kModes> last_set_{};  // by mode, where unused_ has it
  ModeMask unused_ = 0;                        // set, and not needed since
  bool feeds_ = false;                         // lines since the last statement move, not at the rapid rate alone
  DroppedCurve curve_;                         // that of G5.2 which goes on; its line is 0 if there is none
  int percents_ = 0;                           // lines of `%`
  bool stopped_ = false;                       // no run goes on behind a line since the last O-word
  bool asks_ = false;                          // of the line that was judged
  bool asks_place_ = false;                    // the same, and for its numbers alone
  std::vector<ModeFault> faults_;
  std::vector<RemappedWord> remaps_;  // of the line that was judged, if the flow leads into them
  std::vector<ModeFault> asked_;      // of lines since the last O-word, in modes that none has set since
};

}  // namespace owlint
