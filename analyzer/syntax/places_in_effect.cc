#include "analyzer/syntax/places_in_effect.h"

#include <algorithm>
#include <bit>

#include "analyzer/geometry/arc.h"
#include "analyzer/syntax/mode_line.h"

namespace owlint {
namespace {

/// The only value of a mode.
uint8_t only_value(const ModeSets& sets, Mode mode) { return static_cast<uint8_t>(std::countr_zero(sets[mode])); }

bool is_known(const ModeSets& sets, Mode mode) { return is_single(sets[mode]) && !sets.is_open(mode); }

/// Groups of codes that may change where the machine stands, or what its numbers mean.
constexpr GGroup kGroups[] = {GGroup::kMotion,      GGroup::kNonModal,
                              GGroup::kPlane,       GGroup::kDistance,
                              GGroup::kArcDistance, GGroup::kUnits,
                              GGroup::kDiameter,    GGroup::kCutterCompensation,
                              GGroup::kToolLength,  GGroup::kCoordinateSystem,
                              GGroup::kRetract,     GGroup::kOffsets,
                              GGroup::kFeedMode};
/// Of these, those that change no number but where other lines go.
bool has_code_of_place(const WordLine& words) {
  return std::ranges::any_of(kGroups, [&](GGroup group) { return words.code(group) != nullptr; }) ||
      words.code(MGroup::kToolChange) != nullptr || words.code(MGroup::kStop) != nullptr ||
      words.code(MGroup::kSpindle) != nullptr;
}

/// Codes with which a line is no plain move: what they do to the place is left to the flow.
bool has_code_for_the_flow(const WordLine& words) {
  for (const GGroup group : {GGroup::kUnits, GGroup::kDiameter, GGroup::kCutterCompensation, GGroup::kToolLength,
                             GGroup::kCoordinateSystem, GGroup::kOffsets}) {
    if (words.code(group) != nullptr) return true;
  }
  const GCode* const non_modal = words.code(GGroup::kNonModal);
  const MCode* const store = words.code(MGroup::kSpindle);
  return (non_modal != nullptr && non_modal->tenths != code::kG4) || words.code(MGroup::kToolChange) != nullptr ||
      (store != nullptr && store->number >= code::kM70 && store->number <= code::kM73) || words.has_polar_words();
}

/// Whether only the flow knows where the line goes: the numbers of its axes, or the code itself, or what such a code takes (the D
/// of G41, the P of G10).
bool has_computed_place(const WordLine& words) {
  const bool takes_any = has_code_for_the_flow(words);
  for (size_t i = 0; i < words.size(); ++i) {
    const uint32_t letter = letter_set({&words[i].letter, 1});
    if (!words[i].known && (takes_any || (letter & (kPlaceLetters | letter_set("ijkrg"))) != 0)) return true;
  }
  return false;
}

}  // namespace

Place PlacesInEffect::started_on(const MachineWords& machine) {
  Place place = Place::started(machine.units_per_mm);
  for (size_t axis = 0; machine.tools && axis < kAxisCount; ++axis) {
    const bool none = std::ranges::all_of(*machine.tools, [&](const Tool& tool) { return tool.offset[axis] == 0; });
    if (none) place.tool[axis] = Coordinate::of(0);
  }
  return place;
}

void PlacesInEffect::assume(const ModeSets& before) {
  ModeSets& now = assumed_.now;
  for (size_t i = 0; i < kModes; ++i) {
    const bool known = is_single(before.may[i]) && (before.open >> i & 1) == 0;
    const ValueSet values = known ? before.may[i] : now.may[i];
    now.may[i] = values & (~values + 1);
  }
  now.open = 0;
  // What refuses a move is not for its numbers.
  now[Mode::kFeed] = value_bit(modes::kFeedSet);
  now[Mode::kSpeed] = value_bit(modes::kSpeedSet);
}

void PlacesInEffect::leave(const Place& place) {
  if (left_) return;
  left_ = true;
  out_.left_at = static_cast<StatementId>(out_.statements.size());
  out_.place_at_start = place;
  if (machine_.measures_extents) out_.asks_place = true;
  // Where offsets are known, any move may end beyond a limit.
  const auto& origin = place.system.origin.axes;
  if (machine_.has_limits && std::ranges::any_of(origin, [](const Coordinate& axis) { return axis.is_known(); }))
    out_.asks_place = true;
}

void PlacesInEffect::leave_reading() {
  leave();
  out_.asks_place = out_.reads_place = true;
  out_.unusual = out_.unusual || expected_ == Expected::kUsual;
}

void PlacesInEffect::leave_writing() {
  leave();
  if (machine_.has_limits) out_.asks_place = true;
}

void PlacesInEffect::stop(uint32_t line) {
  if (left_) return;
  if (machine_.measures_extents) extents_->stop({0, line});
  visitor_ = nullptr;
}

/// Behind these lines moves may end beyond a limit, whatever the machine's offsets.
void PlacesInEffect::note_limits(const WordLine& words) {
  const GCode* const code = words.code(GGroup::kNonModal);
  if (machine_.has_limits && code != nullptr && (code->tenths == code::kG53 || code->tenths == code::kG10))
    out_.asks_place = true;
}

/// Whether it has to be known how far plain lines go in G91.
bool PlacesInEffect::needs_sums(const ModeSets& before) {
  if (assumed_.now[Mode::kDistance] != value_bit(modes::kG90)) return true;
  if (is_known(before, Mode::kDistance)) return false;
  if (expected_ == Expected::kAnything) return true;
  out_.lacks_sums = true;
  return false;
}

bool PlacesInEffect::is_plain_move(const WordLine& words, Motion motion) const {
  return contains(kPlainMotions | set_of(Motion::kNone), motion) && !has_code_for_the_flow(words) &&
      assumed_.now[Mode::kCompensation] == value_bit(modes::kG40);
}

bool PlacesInEffect::judge(const WordLine& words, const ModeSets& before, const Statement& statement, bool asked) {
  const bool block_delete = statement.block_delete;
  const bool unknown = words.has_unknown_code() || words.has_remapped_code();
  const bool chooses_tool = machine_.tools && words.has('t');
  // Compensation with the tool in the spindle: only where the place is known, it is known which one that is.
  const GCode* const side = words.code(GGroup::kCutterCompensation);
  const bool takes_tool = place_.loaded_tool > 0 && side != nullptr && side->tenths != code::kG40 && !words.has('d');
  // With an arc in effect a center alone is a whole circle.
  const bool turns = words.has('i') || words.has('j') || words.has('k');
  if (!words.has_axis_words() && !words.has_polar_words() && !turns && !has_code_of_place(words) && !unknown &&
      !chooses_tool)
    return false;
  assume(before);
  const Motion motion = words.motion(static_cast<Motion>(only_value(assumed_.now, Mode::kMotion)));
  if (left_ && expected_ == Expected::kUsual) {
    const bool moves = words.has_axis_words() || words.has_polar_words();
    const bool straight = contains(kStraightMotions, motion) || (!moves && !contains(kContours, motion));
    if (!straight || words.has_polar_words()) out_.asks_place = out_.unusual = true;
    return false;
  }
  const Place start = place_;
  const bool compensates = assumed_.now[Mode::kCompensation] != value_bit(modes::kG40);
  const bool pauses = compensates && words.code(MGroup::kStop) != nullptr;  // which ends the move before it
  const bool computed = has_computed_place(words);
  const bool leaves = computed || block_delete || unknown;
  faults_.clear();
  // Further lines are carried out by the flow, which tells of them.
  const MoveWatch watch{left_ || leaves ? nullptr : visitor_, statement.line};
  ModeRun(machine_, words).run(&assumed_, &faults_, &place_, watch);
  const bool stops = std::ranges::any_of(
      faults_, [](const ModeFault& fault) { return fault.by_place && (fault.fault.certain || fault.believed); });
  const bool cuts = contains(kContours, motion);
  // Where each line repeats G43, it matters whether the tool in the spindle has a length.
  const GCode* const length = words.code(GGroup::kToolLength);
  const bool takes_offset = machine_.retains_offset && place_.loaded_tool > 0 && length != nullptr &&
      length->tenths == code::kG43 && !words.has('h');
  if (!left_ && (stops || leaves || takes_tool || takes_offset || cuts)) leave(start);
  if (!left_) return false;
  if (machine_.retains_offset && side != nullptr) out_.asks_place = true;
  note_limits(words);
  // A whole circle comes back: only who asks how far it goes has to know of it.
  const bool curves = contains(kArcMotions, motion);
  const bool moves = words.has_axis_words() || words.has_polar_words() || (machine_.measures_extents && curves);
  const bool plain = is_plain_move(words, motion) && !computed && !block_delete && !unknown && !chooses_tool;
  const bool needs_no_question =
      contains(kStraightMotions | set_of(Motion::kNone), motion) || (!stops && questions_ == kMostQuestions);
  if (plain && needs_no_question && !asked) {
    PlainMoves line;
    PlainWords written;
    for (size_t i = 0; i < words.size(); ++i) {
      const uint32_t bit = letter_set({&words[i].letter, 1});
      if ((bit & kAxisLetters) == 0) continue;
      const auto letter = static_cast<size_t>(letter_index(words[i].letter));
      written.letters |= bit;
      written.values[letter] = words[i].value;
      line.add(letter, words[i].value);
    }
    ModeSets in = before;
    if (words.code(GGroup::kDistance) != nullptr) {
      in[Mode::kDistance] = assumed_.now[Mode::kDistance];
      in.open &= ~mask_of(Mode::kDistance);
    }
    PlainReaches reaches;
    (motion == Motion::kG0 ? reaches.rapid : reaches.feed).add(written, line, statement.line);
    reaches.curves = curves;
    note(line, &reaches, in, words.depends_on_motion() && !is_single(before[Mode::kMotion]));
    return false;
  }
  if (!moves && !has_code_for_the_flow(words) && !pauses && !unknown && !block_delete && !stops && !chooses_tool &&
      !cuts)
    return false;
  if (questions_ == kMostQuestions && !asked) {
    note_lost();
    return false;
  }
  if (!asked) ++questions_;
  // Only these can stop for their numbers; where a file has none, nothing is followed.
  const uint8_t code = words.find('g');
  const bool computes_code = code != kNoWord && !words[code].known;
  if (stops || (moves && computes_code) || pauses || cuts || words.has_polar_words() ||
      (moves && (compensates || !contains(kStraightMotions, motion))))
    out_.asks_place = true;
  return true;
}

bool PlacesInEffect::arc_passes(const PlainWords& words) const {
  const ModeSets& now = assumed_.now;
  const uint8_t plane = only_value(now, Mode::kPlane);
  if (plane > modes::kG19 || now[Mode::kCompensation] != value_bit(modes::kG40)) return false;
  constexpr char kFirst[] = {'x', 'z', 'y'}, kSecond[] = {'y', 'x', 'z'};
  constexpr char kFirstCenter[] = {'i', 'k', 'j'}, kSecondCenter[] = {'j', 'i', 'k'};
  const bool incremental = now[Mode::kDistance] == value_bit(modes::kG91);
  const auto end_of = [&](char letter, double start) {
    if (!words.has(letter)) return start;
    const double word =
        letter == 'x' && now[Mode::kDiameter] == value_bit(modes::kG7) ? words[letter] / 2 : words[letter];
    return incremental ? start + word : word;
  };
  const auto at = [this](char letter) { return place_.at[static_cast<size_t>(letter - 'x')]; };
  const Coordinate first = at(kFirst[plane]), second = at(kSecond[plane]);
  const bool inch = now[Mode::kUnits] == value_bit(modes::kG20);
  const ArcTolerance tolerance = arc_tolerance(inch, inch ? machine_.arc_tolerance_inch : machine_.arc_tolerance_mm);
  const auto passes = [&](double first_start, double second_start) {
    const Flat start{first_start, second_start};
    const Flat end{end_of(kFirst[plane], first_start), end_of(kSecond[plane], second_start)};
    if (words.has('r')) return arc_by_radius(start, end, words['r'], tolerance).fault == ArcFault::kNone;
    Flat center{words.has(kFirstCenter[plane]) ? words[kFirstCenter[plane]] : 0,
                words.has(kSecondCenter[plane]) ? words[kSecondCenter[plane]] : 0};
    if (now[Mode::kArcDistance] == value_bit(modes::kG91_1))
      center = {start.first + center.first, start.second + center.second};
    return arc_surely_fits(start, center, end, tolerance) ||
        arc_by_center(start, center, end, tolerance).fault == ArcFault::kNone;
  };
  return (first.is_unknown() || second.is_unknown() || passes(first.value, second.value)) &&
      (first.is_known() && second.is_known() ? true : !left_ || passes(first.other, second.other));
}

size_t PlacesInEffect::pass(std::string_view bytes, size_t from, size_t to, uint32_t line, const PlainEffect& effect,
                            const LastLines& last, const ModeSets& before) {
  if (effect.axes == 0 && effect.first_arc == 0) return to;
  if (left_ && expected_ == Expected::kUsual) {
    if (effect.first_arc != 0) out_.asks_place = out_.unusual = true;
    return to;
  }
  const bool alone = effect.alone && !is_single(before[Mode::kMotion]);
  assume(before);
  // Each move on a compensated path is looked at.
  const bool compensates = assumed_.now[Mode::kCompensation] != value_bit(modes::kG40);
  if (compensates && left_ && questions_ == kMostQuestions) {
    note_lost();
    return to;
  }
  if (effect.first_arc == 0 && !compensates) {
    place_.keeps_height = false;
    if (visitor_ != nullptr) {
      walk(bytes, from, to, line, before, alone);
      return to;
    }
    const PlainMoves moves =
        needs_sums(before) ? plain_moves(bytes, from, to, &reader_) : last_plain_moves(bytes, effect.axes, last);
    for_letters(moves.letters, [&](size_t letter) { go(letter, moves.last[letter], moves.sum[letter]); });
    if (left_) note(moves, nullptr, before, alone);
    return to;
  }
  const bool each = visitor_ != nullptr || needs_sums(before);
  auto motion = static_cast<Motion>(only_value(assumed_.now, Mode::kMotion));
  PlainWords words;
  PlainMoves passed;
  PlainReaches reaches;
  // Words that were not made numbers yet: in G90 the next one of the axis may come before a place is asked for.
  std::array<const char*, kLetters> texts{};
  uint32_t waiting = 0;
  const char* const end = bytes.data() + bytes.size();
  const auto go_to = [&](size_t letter, double value) {
    go(letter, value, value);
    if (left_) passed.add(letter, value);
  };
  const auto settle = [&](uint32_t letters) {
    for_letters(waiting & letters, [&](size_t letter) { go_to(letter, plain_number(texts[letter], end)); });
    waiting &= ~letters;
  };
  for (; from < to; ++line) {
    const size_t next = reader_.read(bytes, from, &words);
    if (words.code >= 0) motion = static_cast<Motion>(words.code);
    if (compensates && words.letters != 0) break;
    const uint32_t axes = words.letters & PlainLine::kAxes;
    const bool arc = contains(kArcMotions, motion) && words.letters != 0;
    if (arc) {
      words.convert(PlainLine::kAxes | letter_set("ijkr"));
      settle(PlainLine::kAxes);
      const bool asks = left_ ? questions_ < kMostQuestions : !arc_passes(words);
      if (asks) break;
    }
    if (arc || each) {
      if (!arc) words.convert(axes);
      if (visitor_ != nullptr && !left_) tell_line(words, motion, line);
      for_letters(axes, [&](size_t letter) { go_to(letter, words.values[letter]); });
      if (visitor_ != nullptr && left_) {
        (motion == Motion::kG0 ? reaches.rapid : reaches.feed).add(words, passed, line);
        reaches.curves = reaches.curves || arc;
      }
    } else {
      for_letters(axes, [&](size_t letter) { texts[letter] = words.texts[letter]; });
      waiting |= axes;
    }
    from = next;
  }
  settle(PlainLine::kAxes);
  place_.keeps_height = false;
  if (left_) note(passed, &reaches, before, alone);
  return from;
}

/// A plain line has this word for the axis; or several have, with this sum.
void PlacesInEffect::go(size_t letter, double last, double sum) {
  const size_t axis = axis_of_letter(letter);
  const bool halved = axis == 0 && assumed_.now[Mode::kDiameter] == value_bit(modes::kG7);
  const bool incremental = assumed_.now[Mode::kDistance] == value_bit(modes::kG91);
  const double way = incremental ? sum : last;
  const Coordinate by = Coordinate::of(halved ? way / 2 : way);
  Coordinate& at = place_.at[axis];
  at = incremental ? at + by : by;
}

PlaceChange& PlacesInEffect::pending(const ModeSets& before, bool alone) {
  const auto known = [&](Mode mode) { return is_known(before, mode) ? only_value(before, mode) : ModeChange::kAny; };
  PlaceChange change;
  change.alone = alone;
  change.distance = known(Mode::kDistance);
  change.diameter = known(Mode::kDiameter);
  change.units = known(Mode::kUnits);
  change.system = known(Mode::kSystem);
  change.compensation = known(Mode::kCompensation);
  const auto same = [&](const PlaceChange& last) {
    return !last.lost && last.alone == alone && last.distance == change.distance && last.diameter == change.diameter &&
        last.units == change.units && last.system == change.system && last.compensation == change.compensation;
  };
  if (pending_.empty() || !same(pending_.back())) pending_.push_back(change);
  return pending_.back();
}

void PlacesInEffect::note(const PlainMoves& moves, const PlainReaches* reaches, const ModeSets& before, bool alone) {
  const bool curves = visitor_ != nullptr && reaches != nullptr && reaches->curves;
  if (moves.letters == 0 && !curves) return;
  PlaceChange& change = pending(before, alone);
  if (visitor_ != nullptr && reaches != nullptr) {
    if (change.reaches == nullptr) change.reaches = std::make_shared<PlainReaches>();
    change.reaches->rapid.add(reaches->rapid, change.sum);
    change.reaches->feed.add(reaches->feed, change.sum);
    change.reaches->curves = change.reaches->curves || curves;
  }
  for_letters(moves.letters, [&](size_t letter) {
    const size_t axis = axis_of_letter(letter);
    change.axes |= static_cast<uint16_t>(1U << axis);
    change.last[axis] = moves.last[letter];
    change.sum[axis] += moves.sum[letter];
  });
}

void PlacesInEffect::note_lost() {
  pending_.clear();
  pending_.emplace_back().lost = true;
}

void PlacesInEffect::flush() {
  if (pending_.empty()) return;
  if (!out_.statements.empty()) {
    const auto last = static_cast<StatementId>(out_.statements.size() - 1);
    for (PlaceChange& change : pending_) {
      change.after = last;
      out_.place_changes.push_back(change);
    }
    out_.statements.back().changes_place = true;
  }
  pending_.clear();
}

}  // namespace owlint
