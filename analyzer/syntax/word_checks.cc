// The checks of a complete line, in the interpreter's order: axis words against G codes, codes of group 0, the number
// of M codes, words that no code uses.
#include <algorithm>
#include <bit>

#include "analyzer/syntax/word_line.h"

namespace owlint {

/// What was found so far. A fault that is only possible must not hide one that is certain.
class WordLine::Outcome {
 public:
  explicit Outcome(bool unknown_code) : unknown_code_(unknown_code) {}

  /// True if the line stops here for certain.
  bool stop(StopKind kind, const char* message, uint8_t word, uint8_t other = kNoWord, bool certain = true) {
    certain &= !unknown_code_;
    if (certain || message_ == nullptr) {
      kind_ = kind;
      message_ = message;
      word_ = word;
      other_ = other;
      certain_ = certain;
    }
    return certain;
  }

  std::optional<Fault> fault() const {
    if (message_ == nullptr) return std::nullopt;
    return Fault{kind_, message_, word_, other_, certain_};
  }

 private:
  bool unknown_code_;
  StopKind kind_{};
  const char* message_ = nullptr;
  uint8_t word_ = kNoWord, other_ = kNoWord;
  bool certain_ = true;
};

namespace {

constexpr uint32_t kCenterLetters = letter_set("ijk");
constexpr MotionSet kNurbs = set_of(Motion::kG5_2) | set_of(Motion::kG6_2);
constexpr MotionSet kMotionless = set_of(Motion::kG80) | set_of(Motion::kNone);
using enum GGroup;

}  // namespace

bool WordLine::has_code(GGroup group, int tenths) const {
  const GCode* const on_line = code(group);
  return on_line != nullptr && on_line->tenths == tenths;
}

bool WordLine::has_taker() const {
  const GCode* const on_line = code(kNonModal);
  if (on_line == nullptr) return false;
  switch (on_line->tenths) {
    case code::kG10:
    case code::kG28:
    case code::kG30:
    case code::kG52:
    case code::kG92: return true;
    default: return false;
  }
}

uint32_t WordLine::given(uint32_t letters) const {
  letters &= letters_;
  for (const char letter : {'p', 'q'}) {
    const uint8_t at = find(letter);
    if (at != kNoWord && words_[at].known && words_[at].value == -1) letters &= ~letter_set({&letter, 1});
  }
  return letters;
}

uint8_t WordLine::first_word(uint32_t letters) const {
  uint8_t first = kNoWord;
  for (uint32_t rest = letters & letters_; rest != 0; rest &= rest - 1)
    first = std::min(first, at_[static_cast<size_t>(std::countr_zero(rest))]);
  return first;
}

/// The word that is one of the codes, if it stands on the line.
uint8_t WordLine::word_of(const CodeSet& codes) const {
  for (const Place<GCode>& place : g_) {
    if (place.code != nullptr && codes.meets(set_of(*place.code))) return place.word;
  }
  for (const Place<MCode>& place : m_) {
    if (place.code != nullptr && codes.meets(set_of(*place.code))) return place.word;
  }
  return kNoWord;
}

bool WordLine::depends_on_motion() const {
  if (lost_g_ != kNoWord || code_ != Motion::kNone || has_taker()) return false;
  if (has_axis_words() || has_polar_words()) return !has_code(GGroup::kToolLength, code::kG43_1);
  return (letters_ & kCenterLetters) != 0;
}

Motion WordLine::motion(Motion mode) const {
  if (code_ != Motion::kNone) return code_;
  if (lost_g_ != kNoWord || has_taker()) return Motion::kNone;
  if (has_axis_words() || has_polar_words()) return has_code(GGroup::kToolLength, code::kG43_1) ? Motion::kNone : mode;
  return (letters_ & kCenterLetters) != 0 && contains(kArcMotions, mode) ? mode : Motion::kNone;
}

MotionSet WordLine::after(MotionSet before) const {
  MotionSet after = 0;
  const bool ends_nurbs = has_code(kNonModal, code::kG5_3) || has_code(kNonModal, code::kG6_3);
  for (MotionSet rest = before; rest != 0; rest &= rest - 1) {
    const auto mode = static_cast<Motion>(std::countr_zero(rest));
    const Motion moved = motion(mode);
    if (moved == Motion::kNone) {
      after |= set_of(ends_nurbs ? Motion::kNone : mode);
      continue;
    }
    // What a remapped code leaves is for its sub or its Python to say.
    const auto row = static_cast<size_t>(moved);
    const GCode::Leaves leaves = moved == Motion::kRemapped ? GCode::kAny : g_codes()[row].leaves;
    after |= leaves == GCode::kAny ? kAnyMotion : set_of(leaves == GCode::kEarlier ? mode : moved);
  }
  return after;
}

std::optional<Fault> WordLine::check(const Modes& before, MotionSet* after) const {
  if (after != nullptr) *after = this->after(set_of(before.motion));
  Outcome out(unknown_code_);
  if (axis_words(before, out) || non_modal(before, out)) return out.fault();
  if (fifth_m_ != kNoWord && out.stop(StopKind::kCodesConflict, "Too many m codes on line", fifth_m_)) {
    return out.fault();
  }
  other_words(motion(before.motion), out);
  std::optional<Fault> fault = out.fault();
  if (fault && fault->certain) return fault;
  std::optional<Fault> of_lost = lost_fault();
  return of_lost ? of_lost : fault;
}

/// In the order in which they are executed.
std::optional<Fault> WordLine::lost_fault() const {
  if (call_) return std::nullopt;
  const auto fault = [&](std::string message, uint8_t word) {
    return Fault{StopKind::kCodeUnknown, std::move(message), word, kNoWord, !unknown_code_};
  };
  if (lost_user_ != kNoWord) {
    int32_t number = 0;
    word_integer(words_[lost_user_].value, &number);
    return fault("Unknown m code used: M" + std::to_string(number), lost_user_);
  }
  if (lost_g_ != kNoWord) return fault("Bug unknown motion code", lost_g_);
  if (lost_stop_ != kNoWord) return fault("Bug code not m0 m1 m2 m30 m60 m99", lost_stop_);
  return std::nullopt;
}

bool WordLine::polar_words(const Modes& before, Outcome& out) const {
  const uint8_t polar = first_word(kPolarLetters);
  const auto stop = [&](const char* message, uint8_t other = kNoWord, bool certain = true) {
    return out.stop(StopKind::kAxisWords, message, polar, other, certain);
  };
  constexpr uint32_t kXY = letter_set("xy");
  if ((machine_->axes & kXY) != kXY && stop("Cannot use polar coordinate on a machine lacking X or Y axes")) {
    return true;
  }
  if (before.plane != Modes::kG17 && stop(kPolarOutsideG17, kNoWord, before.plane == Modes::kOtherPlane)) {
    return true;
  }
  if (has('x') && stop("Cannot specify both polar coordinate and X word", find('x'))) return true;
  return has('y') && stop("Cannot specify both polar coordinate and Y word", find('y'));
}

bool WordLine::axis_words(const Modes& before, Outcome& out) const {
  const bool axis = has_axis_words();
  const bool polar = has_polar_words();
  if (polar && polar_words(before, out)) return true;
  const uint8_t first = first_word(kAxisLetters | kPolarLetters);
  const bool taker = has_taker();
  const uint8_t taking = word_of(kNonModal);
  const uint8_t moving = word_of(GGroup::kMotion);
  if (lost_g_ != kNoWord) {
    if (taker && out.stop(StopKind::kAxisWords, "Cannot use two g codes that both use axis values", taking, moving))
      return true;
    return !axis && !polar && out.stop(StopKind::kCodeUnknown, "All axes missing with motion code", lost_g_);
  }
  if (code_ != Motion::kNone && code_ != Motion::kG80) {
    if (taker && out.stop(StopKind::kAxisWords, "Cannot use two g codes that both use axis values", taking, moving))
      return true;
    const GCode* const code = this->code(GGroup::kMotion);
    return code != nullptr && code->axes == GCode::kNeeded && !axis && !polar &&
        out.stop(StopKind::kWordMissing, "All axes missing with motion code", moving);
  }
  if (taker) {
    if (polar && has_code(kNonModal, code::kG92) &&
        out.stop(StopKind::kAxisWords, "Polar coordinates can only be used for motion", first, taking))
      return true;
    if (!axis && (has_code(kNonModal, code::kG52) || has_code(kNonModal, code::kG92)) &&
        out.stop(StopKind::kWordMissing, "All axes missing with g52 or g92", taking))
      return true;
  } else if (axis || polar) {
    if (code_ == Motion::kG80) return out.stop(StopKind::kAxisWords, "Cannot use axis values with g80", first, moving);
    if (contains(kMotionless, before.motion) && !has_code(GGroup::kToolLength, code::kG43_1) &&
        !has_code(GGroup::kToolLength, code::kG43_2) &&
        out.stop(StopKind::kAxisWords, "Cannot use axis values without a g code that uses them", first))
      return true;
  }
  return polar && motion(before.motion) == Motion::kNone &&
      out.stop(StopKind::kAxisWords, "Polar coordinates can only be used for motion", first);
}

bool WordLine::non_modal(const Modes& before, Outcome& out) const {
  const GCode* const code = this->code(kNonModal);
  if (code == nullptr) return false;
  const uint8_t at = word_of(kNonModal);
  const uint8_t moving = word_of(GGroup::kMotion);
  if (code->tenths == code::kG4) {
    if (given(letter_set("p")) == 0 && out.stop(StopKind::kWordMissing, "Dwell time missing with g4", at)) return true;
    return contains(kArcMotions, code_) &&
        out.stop(StopKind::kCodesConflict, "G4 not allowed with G2 or G3 because they both use P", at, moving);
  }
  if (code->tenths == code::kG10) return g10(out);
  if (code->tenths == code::kG5_3) {
    return code_ != Motion::kNone && code_ != Motion::kG5_2 &&
        out.stop(StopKind::kCodesConflict, "Between G5.2 and G5.3 codes, only additional G5.2 codes are allowed.", at,
                 moving);
  }
  if (contains(kNurbs, code_)) return false;  // and so G53 is not checked
  if (code->tenths == code::kG6_3)
    return out.stop(StopKind::kCodesConflict, "Bug bad g code modal group 0", at, moving);
  if (code->tenths != code::kG53) return false;
  const Motion moved = motion(before.motion);
  if (moved != Motion::kG0 && moved != Motion::kG1 &&
      out.stop(StopKind::kCodesConflict, "Must use g0 or g1 with g53", at, moving))
    return true;
  const GCode* const distance = this->code(GGroup::kDistance);
  const bool known = distance != nullptr || before.distance != Modes::kDistanceUnknown;
  const bool absolute = distance != nullptr ? distance->tenths == code::kG90 : before.distance == Modes::kAbsolute;
  return !absolute && out.stop(StopKind::kCodesConflict, kIncrementalG53, at, word_of(GGroup::kDistance), known);
}

bool WordLine::g10(Outcome& out) const {
  const uint8_t code = word_of(kNonModal);
  const uint8_t l = find('l');
  int32_t what = -1;
  if (l != kNoWord && words_[l].known) word_integer(words_[l].value, &what);
  const bool what_known = l == kNoWord || words_[l].known;
  const bool in_system = what == 2 || what == 20;
  const bool in_tool_table = what == 1 || what == 10 || what == 11;
  if (what_known && !in_system && !in_tool_table && what != 0 &&
      out.stop(StopKind::kWordMissing, "Line with G10 does not have L0, L1, L10, L11, L2, or L20", code, l))
    return true;
  const uint8_t p = find('p');
  if (p != kNoWord && !words_[p].known) return false;
  const double value = p == kNoWord ? -1 : words_[p].value;
  const int32_t number = nearest_integer(value);
  const uint8_t about = p == kNoWord ? code : p;
  const auto stop = [&](const char* message) {
    return out.stop(StopKind::kNumberOutOfRange, message, about, about == code ? kNoWord : code);
  };
  // One-sided: what is rounded up passes.
  if (value + 0.0001 - number > 0.0002 && stop("P value not an integer with G10")) return true;
  if (in_system && (number < 0 || number > 9)) {
    return stop(what == 2 ? "P value out of range (0-9) with G10 L2" : "P value out of range (0-9) with G10 L20");
  }
  if (!in_tool_table || number >= 1) return false;
  return stop(what == 1        ? "P value out of range with G10 L1"
                  : what == 10 ? "P value out of range with G10 L10"
                               : "P value out of range with G10 L11");
}

bool WordLine::other_words(Motion motion, Outcome& out) const {
  if (motion == Motion::kRemapped || remapped_m_) return false;
  CodeSet line = codes_;
  line.motions = set_of(motion);
  line.words = letters_;
  // Most lines have nothing but axes and F.
  const CheckTriggers& triggers = check_triggers(machine_->release);
  if ((letters_ & triggers.letters) == 0 && !line.meets(triggers.codes)) return false;
  for (const LineCheck& check : line_checks(machine_->release)) {
    if (fails(check, line, out)) return true;
  }
  return false;
}

bool WordLine::fails(const LineCheck& check, const CodeSet& line, Outcome& out) const {
  if (check.kind == LineCheck::kMissing) {
    return line.meets(check.codes) && given(check.letters) != check.letters &&
        out.stop(StopKind::kWordMissing, check.message, word_of(check.codes));
  }
  if ((letters_ & check.letters) == 0) return false;
  const uint8_t word = first_word(check.letters);
  switch (check.kind) {
    case LineCheck::kRefused:
      if (!line.meets(check.codes) || (!check.also.empty() && !line.meets(check.also))) return false;
      return out.stop(check.also.empty() ? StopKind::kWordUnused : StopKind::kCodesConflict, check.message, word,
                      word_of(check.codes));
    case LineCheck::kUnused: return !line.meets(check.codes) && out.stop(StopKind::kWordUnused, check.message, word);
    case LineCheck::kUnusedUnlessMinusOne:
      if (line.meets(check.codes) || given(check.letters) == 0) return false;
      return out.stop(StopKind::kWordUnused, check.message, word, kNoWord, words_[word].known);
    case LineCheck::kValue:
      return line.meets(check.codes) && words_[word].known && fails_value(check) &&
          out.stop(StopKind::kNumberOutOfRange, check.message, word, word_of(check.codes));
    default: return false;
  }
}

bool WordLine::fails_value(const LineCheck& check) const {
  const double value = words_[first_word(check.letters)].value;
  const int32_t nearest = nearest_integer(value);
  if (check.test == LineCheck::kWhole) return value - nearest > 0.001 || nearest - value > 0.001;
  const double tested = check.test == LineCheck::kNearest ? nearest : value;
  return tested < check.least || tested > check.most;
}

}  // namespace owlint
