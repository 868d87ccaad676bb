// Which motion is in effect, as far as the lines themselves say, while a file is read from the first line to the last. Between
// two O-words it is known from the first code on. What is not known becomes a question to the flow: a kMotionCheck.
#pragma once

#include <utility>

#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/statement.h"

namespace owlint {

/// A question to the flow about a line, which may have no statement itself: a kMotionCheck, kMachineCheck or kUserCode.
Statement question_about(const Statement& line, LineKind kind, uint32_t first);

class MotionInEffect {
 public:
  MotionInEffect(Syntax& out, LineParser& parser) : out_(out), parser_(parser) {}

  /// Takes in plain lines; `motion` is what they set, kNone for nothing.
  void pass(Motion motion);
  /// Holds the words of the line that was parsed last against the motion in effect. An error that the line has in any
  /// case goes into the statement. Returns whether the line is to be kept: `keep`, or because of its words.
  bool judge(Statement& statement, bool keep);
  /// The line that was judged is not kept: what it does counts to the statement before it.
  void leave() { leaves(std::exchange(effect_, kLeavesMotion)); }
  /// Keeps the line that was judged, with the questions that it has.
  void push(const Statement& statement);

 private:
  void leaves(uint8_t effect);
  void check(const WordLine& words, Statement& statement);
  static uint8_t effect_of(const WordLine& words);

  Syntax& out_;
  LineParser& parser_;
  MotionSet in_effect_ = all_modes();
  uint8_t effect_ = kLeavesMotion;   // of the line that is judged
  std::vector<MotionFault> faults_;  // that it has with some motions
};

}  // namespace owlint
