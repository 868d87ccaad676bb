// OW907 limit-exceeded: a move that ends beyond a limit of the machine's axes.
// Depends on: the INI's limits, and where the machine is: that is certain for G53, and elsewhere only where the program sets the
// offsets itself. How far apart two ends are is certain wherever the zero is. Offsets of the var file are not looked at: they
// change until the program runs.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "rules/driver/mode_hazards.h"
#include "rules/driver/positions.h"

namespace owlint::rules::ow907 {
namespace {

using Needs = LimitFault::Needs;

struct Beyond {
  LimitFault fault;
  Reach reach;
  bool unproven;
};

/// `X`.
std::string axis_name(const LimitFault& fault) { return capital(kAxisOrder[fault.axis]); }

/// Of a line that every run would come to: lines behind a stop are not carried out.
Reach reach_of(const Input& in, uint32_t line) {
  Reach reach = Reach::kAlways;
  for (const FlowStop& stop : in.flow.stops) {
    if (stop.statement == kNoStatement || in.program.at(stop.statement).line > line) continue;
    if (stop.reach == Reach::kAlways) return Reach::kNever;
    reach = Reach::kMaybe;
  }
  return reach;
}

/// Of plain lines behind a statement the flow knows the furthest; LinuxCNC stops at the first that goes too far.
LimitFault first_of(const Input& in, const Hazard& hazard) {
  constexpr uint32_t kMostLines = 10'000;
  LimitFault fault = *hazard.limit;
  const Statement& s = in.program.at(hazard.statement);
  if (s.kind == LineKind::kModeLine) return fault;
  const auto beyond = [&](uint32_t line) {
    const std::vector<WrittenWord> words = words_of(*in.program.source, in.program.source->line(line));
    const WrittenWord* const word = find_word(words, axis_name(fault));
    const double by = word != nullptr && word->value ? *word->value - fault.at_limit : 0;
    return fault.greatest ? by : -by;
  };
  constexpr double kRounding = 1e-6;
  if (!(beyond(fault.line) > kRounding)) return fault;  // an incremental move
  const uint32_t last = std::min(fault.line, s.line + kMostLines);
  uint32_t line = s.line + 1;
  while (line < last && !(beyond(line) > kRounding)) ++line;
  if (line == last) return fault;
  fault.line = line;
  fault.position = fault.limit + (fault.greatest ? beyond(line) : -beyond(line)) * fault.unit;
  return fault;
}

/// Of each limit the first line that ends beyond it, in the order of the file; a proven one counts more.
std::vector<Beyond> found_in(const Input& in) {
  std::vector<Beyond> all;
  const bool runs_from_start = in.linked.files()[0].program.get() == &in.program && !in.program.sub_file;
  if (runs_from_start) {
    for (const LimitFault& fault : in.program.syntax.limit_faults)
      all.push_back({fault, reach_of(in, fault.line), false});
  }
  for (const Hazard& hazard : in.flow.hazards) {
    if (hazard.kind == HazardKind::kLimitExceeded) all.push_back({first_of(in, hazard), hazard.reach, hazard.unproven});
  }
  std::erase_if(all, [](const Beyond& one) { return one.reach == Reach::kNever; });
  std::ranges::stable_sort(all, {}, [](const Beyond& one) {
    return std::tuple(one.unproven || one.fault.needs != Needs::kNothing, one.fault.line);
  });
  std::map<std::tuple<uint8_t, bool, bool>, size_t> first;
  std::vector<Beyond> out;
  for (const Beyond& one : all) {
    const auto [known, added] =
        first.try_emplace({one.fault.axis, one.fault.greatest, one.fault.is_distance()}, out.size());
    if (added) {
      out.push_back(one);
      continue;
    }
    LimitFault& fault = out[known->second].fault;
    if (std::abs(one.fault.furthest - fault.limit) <= std::abs(fault.furthest - fault.limit)) continue;
    fault.furthest = one.fault.furthest;
    fault.furthest_line = one.fault.furthest_line;
  }
  return out;
}

class Wording {
 public:
  Wording(const Input& in, const LimitFault& fault) : in_(in), fault_(fault) {
    const WordsOfMachine machine(in.profile);
    constexpr double kInchMachine = 0.5;  // units in a millimetre
    inch_ = machine.words.units_per_mm < kInchMachine;
  }

  /// `50 mm`.
  std::string size(double value) const {
    if (is_length(fault_.axis)) return length(value, inch_);
    return number_text(value) + " degrees";
  }
  std::string message(const WrittenWord* word) const;
  std::string help() const;
  std::string interpreter() const;
  void relate_limits(Finding& f) const;

 private:
  const Ini::Entry* entry(bool greatest) const { return limit_entry(in_.profile.setup->ini, fault_.axis, greatest); }
  std::string place(double value) const { return axis_name(fault_) + number_text(value); }

  const Input& in_;
  const LimitFault& fault_;
  bool inch_ = false;
};

std::string Wording::message(const WrittenWord* word) const {
  const std::string axis = axis_name(fault_);
  if (fault_.is_distance())
    return fmt::format("the moves from line {} on go {} along {}, and the machine has {}", fault_.from_line,
                       size(fault_.position), axis, size(fault_.limit));
  const std::string written = word == nullptr ? "this line" : "`" + shown(*in_.program.source, word->span) + "`";
  const double distance = std::abs(fault_.position - fault_.limit);
  const std::string beyond = number_text(distance) == "0" ? "just" : size(distance);
  const std::string limit =
      fmt::format("the {} limit of {}, {}", fault_.greatest ? "positive" : "negative", axis, size(fault_.limit));
  const bool same = word != nullptr && word->value && number_text(*word->value) == number_text(fault_.position);
  if (same) return fmt::format("{} ends {} beyond {}", written, beyond, limit);
  return fmt::format("{} ends at {} of the machine, {} beyond {}", written, place(fault_.position), beyond, limit);
}

std::string Wording::help() const {
  if (fault_.is_distance())
    return "one end is beyond a limit wherever the zero of the part is: turn the part, or split the program";
  const Ini::Entry* const least = entry(false);
  const Ini::Entry* const greatest = entry(true);
  const std::string axis = axis_name(fault_);
  const std::string room = least != nullptr && greatest != nullptr
      ? "between " + axis + least->value + " and " + axis + greatest->value
      : least != nullptr ? "above " + axis + least->value
                         : "below " + axis + greatest->value;
  return "end moves " + room + " of the machine; if it can go further, change the limit in the INI";
}

std::string Wording::interpreter() const {
  // With which of its ends a long way stops depends on the zero.
  if (fault_.is_distance()) return {};
  static constexpr std::string_view kKinds[] = {"Linear", "Linear", "Circular", "Probe", "Rigid tap"};
  const std::string& section = entry(fault_.greatest)->section;
  constexpr std::string_view kJoint = "JOINT_";
  const std::string who = section.starts_with(kJoint) ? "joint " + section.substr(kJoint.size()) : axis_name(fault_);
  return fmt::format("{} move on line {} would exceed {}'s {} limit", kKinds[static_cast<size_t>(fault_.kind)],
                     fault_.line, who, fault_.greatest ? "positive" : "negative");
}

void Wording::relate_limits(Finding& f) const {
  for (const bool greatest : {false, true}) {
    if (!fault_.is_distance() && greatest != fault_.greatest) continue;
    const Ini::Entry* const limit = entry(greatest);
    f.related.push_back({limit->span,
                         fmt::format("the {} limit of {}", greatest ? "positive" : "negative", axis_name(fault_)),
                         limit->source});
  }
}

/// Whether the program moves in a mode that it has not set, at the line or before.
bool assumes(const Input& in, Mode mode, uint32_t line) {
  return std::ranges::any_of(in.flow.hazards, [&](const Hazard& hazard) {
    return hazard.kind == HazardKind::kModeAssumed && hazard.mode == mode && hazard.needed_line <= line;
  });
}

/// Whether a move that is beyond a limit in millimetres is so in inches, too.
bool is_beyond_in_inches(const LimitFault& fault) {
  constexpr double kInch = 25.4;
  if (fault.is_distance() || !is_length(fault.axis)) return true;
  const double position = fault.position * kInch;
  return fault.greatest ? position > fault.limit : position < fault.limit;
}

void add_doubts(const Input& in, const LimitFault& fault, Finding& f) {
  if (fault.needs == Needs::kNoOffsets) {
    f.message += ", if the machine has no other offset or tool";
    f.unproven = true;
  } else if (fault.needs == Needs::kNoRotation) {
    f.message += ", unless the coordinate system is turned";
    f.unproven = true;
  }
  if (assumes(in, Mode::kUnits, fault.line) && !is_beyond_in_inches(fault)) {
    f.message += ", if the machine starts in millimeters";
    f.unproven = true;
  }
  if (!fault.machine && assumes(in, Mode::kDistance, fault.line)) {
    f.message += ", if the machine starts in `G90`";
    f.unproven = true;
  }
}

void check(const Input& in, Reporter& out) {
  if (in.profile.setup == nullptr) return;
  for (const Beyond& beyond : found_in(in)) {
    const LimitFault& fault = beyond.fault;
    const Wording wording(in, fault);
    const std::string axis = axis_name(fault);
    const std::vector<WrittenWord> words = words_of(*in.program.source, in.program.source->line(fault.line));
    const WrittenWord* const word = find_word(words, axis);
    Finding& f = out.add(word_of_line(in.program, fault.line, axis), wording.message(word));
    f.help = wording.help();
    f.interpreter = wording.interpreter();
    f.reach = beyond.reach;
    f.stops = true;
    f.unproven = beyond.unproven;
    add_doubts(in, fault, f);
    if (fault.is_distance()) relate_line(in, f, in.program, fault.from_line, axis, "the other end is here");
    wording.relate_limits(f);
    if (fault.furthest_line != fault.line)
      relate_line(in, f, in.program, fault.furthest_line, axis, "the furthest end is here");
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW907",
    .name = "limit-exceeded",
    .summary = "a move that ends beyond a limit of the machine",
    .group = Group::kGeometry,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A move that ends beyond `MIN_LIMIT` or `MAX_LIMIT` of its axis in the INI: a `G53` move, or another
one where the program sets the offsets itself. A program whose moves are further apart along an axis
than the two limits: it does not fit, wherever its zero is. Of an arc only the end counts, of a
drilling cycle the end of each move.)",
            .why = R"(LinuxCNC looks at the end of each move, and stops with
`Linear move on line N would exceed X's positive limit`; for arcs the message begins with
`Circular`, for `G38.2` to `G38.5` with `Probe`, for `G33.1` with `Rigid tap`. LinuxCNC also drops
the moves before it that it has read but not made yet: a short program stops at its beginning. It
checks the limits whether the machine is homed or not.

Only LinuxCNC itself checks the limits: the interpreter alone and most previews run the program to
its end. The zero of the part may change before the program runs, so owlint does not look at the
offsets that the machine has now. `owlint extents` shows how far a program goes.)",
            .bad = R"(G21 G90
G53 G0 Z5
G0 X0 Y0
M2
; file: machine.ini
[TRAJ]
COORDINATES = X Y Z
LINEAR_UNITS = mm
[AXIS_Z]
MIN_LIMIT = -100
MAX_LIMIT = 0
)",
            .good = R"(G21 G90
G53 G0 Z0
G0 X0 Y0
M2
; file: machine.ini
[TRAJ]
COORDINATES = X Y Z
LINEAR_UNITS = mm
[AXIS_Z]
MIN_LIMIT = -100
MAX_LIMIT = 0
)",
            .fix =
                R"(End the move within the limits. Many machines have their `Z0` at the top, so that `G53 G0 Z5` never
runs there: write `G53 G0 Z0`. A program that does not fit needs another machine, or a part that
lies in another direction.)",
            .level_reason = "Error if a run gets here: the program stops. Warning if that depends on offsets, a tool, "
                            "a rotation, a unit or a distance mode that the program does not set.",
            .interpreter = "Linear move on line N would exceed Z's positive limit",
            .options = "--ini machine.ini",
        },
    .check = check,
};

}  // namespace owlint::rules::ow907
