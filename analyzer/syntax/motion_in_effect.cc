#include "analyzer/syntax/motion_in_effect.h"

#include <bit>

namespace owlint {
namespace {

bool is_single(MotionSet set) { return std::has_single_bit(set); }
Motion only(MotionSet set) { return static_cast<Motion>(std::countr_zero(set)); }

}  // namespace

Statement question_about(const Statement& line, LineKind kind, uint32_t first) {
  Statement asks;
  asks.offset = line.offset;
  asks.length = line.length;
  asks.line = line.line;
  asks.kind = kind;
  asks.block_delete = line.block_delete;
  asks.first = first;
  return asks;
}

void MotionInEffect::pass(Motion motion) {
  if (motion == Motion::kNone) return;
  in_effect_ = set_of(motion);
  leaves(static_cast<uint8_t>(motion));
}

void MotionInEffect::leaves(uint8_t effect) {
  if (effect == kLeavesMotion) return;
  if (out_.statements.empty()) {
    out_.first_motion = effect;
    return;
  }
  // What a line with block delete does itself is kept apart from what comes after it.
  if (out_.statements.back().block_delete) {
    const Statement& deleted = out_.statements.back();
    Statement after;
    after.offset = deleted.end();
    after.line = deleted.line;
    out_.statements.push_back(after);
  }
  out_.statements.back().motion = effect & kLeavesMotion;
}

/// What a line does to the motion in effect, whatever it was.
uint8_t MotionInEffect::effect_of(const WordLine& words) {
  if (words.has_unknown_code()) return kLeavesAny;
  const MotionSet from_g0 = words.after(set_of(Motion::kG0));
  const MotionSet from_g1 = words.after(set_of(Motion::kG1));
  if (from_g0 == set_of(Motion::kG0) && from_g1 == set_of(Motion::kG1)) return kLeavesMotion;
  return from_g0 == from_g1 && is_single(from_g0) ? static_cast<uint8_t>(only(from_g0)) : kLeavesAny;
}

/// Finds what the words stop with, for each motion that may be in effect. What needs a value or a mode that is not known here is
/// not claimed.
void MotionInEffect::check(const WordLine& words, Statement& statement) {
  const MotionSet asked = words.depends_on_motion() ? in_effect_ : in_effect_ & ~(in_effect_ - 1);
  MotionSet passes = in_effect_;
  for (MotionSet rest = asked; rest != 0; rest &= rest - 1) {
    const Motion motion = only(rest);
    const std::optional<Fault> fault =
        words.check({.motion = motion, .distance = Modes::kDistanceUnknown, .plane = Modes::kPlaneUnknown});
    if (!fault || !fault->certain) continue;
    passes &= ~set_of(motion);
    if (faults_.empty() || out_.errors[faults_.back().error].message != fault->message)
      faults_.push_back({.motions = 0, .error = parser_.add_error(*fault), .last = false});
    faults_.back().motions |= words.depends_on_motion() ? set_of(motion) : kAnyMotion;
  }
  // At M98 nothing is checked where lines are skipped: that is for the flow to see.
  const bool always = statement.kind != LineKind::kM98 && !faults_.empty() && (asked != in_effect_ || passes == 0) &&
      faults_.size() == 1;
  if (always) {
    statement.error = faults_.front().error;
    faults_.clear();
  }
  if (passes != 0) in_effect_ = passes;
}

bool MotionInEffect::judge(Statement& statement, bool keep) {
  faults_.clear();
  effect_ = kLeavesMotion;
  const WordLine* words = parser_.words();
  if (words == nullptr || statement.has_error()) {
    if (const WordLine* of_call = parser_.words_of_call()) check(*of_call, statement);
    // At O-words runs come from elsewhere, or go elsewhere and come back; behind a line that stops there is none.
    const bool stops = statement.kind == LineKind::kWords && statement.has_error();
    if (keep && !stops) in_effect_ = all_modes();
    return keep;
  }
  check(*words, statement);
  effect_ = effect_of(*words);
  in_effect_ = words->after(in_effect_) & all_modes();
  // With block delete on the line does nothing.
  if (statement.block_delete && effect_ != kLeavesMotion) {
    in_effect_ = all_modes();
    return true;
  }
  return keep || statement.has_error() || !faults_.empty();
}

void MotionInEffect::push(const Statement& statement) {
  if (faults_.empty()) {
    out_.statements.push_back(statement);
    out_.statements.back().motion = std::exchange(effect_, kLeavesMotion) & kLeavesMotion;
    return;
  }
  faults_.back().last = true;
  const Statement asks =
      question_about(statement, LineKind::kMotionCheck, static_cast<uint32_t>(out_.motion_faults.size()));
  out_.motion_faults.insert(out_.motion_faults.end(), faults_.begin(), faults_.end());
  // The words are checked when the line's values have been computed, and before it does anything.
  const bool computes = statement.kind == LineKind::kWords && statement.item_count > 0;
  if (computes) out_.statements.push_back(statement);
  out_.statements.push_back(asks);
  if (statement.kind != LineKind::kWords) out_.statements.push_back(statement);
  out_.statements.back().motion = std::exchange(effect_, kLeavesMotion) & kLeavesMotion;
}

}  // namespace owlint
