// Depends on (measured with LinuxCNC without a screen, homing its joints): what a joint without a section moves with, which
// homing it refuses, where a joint stops whose `HOME` is beyond its limits, and which joints home one after the other.
#include "rules/driver/ini_joints.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "rules/driver/ini_values.h"
#include "rules/driver/remap_rules.h"
#include "rules/driver/start_refusals.h"

namespace owlint::rules {
namespace {

constexpr double kNoLimit = 1e99;

/// A number of a section; the default if the section does not have it. `known` is false where the value is none.
struct IniNumber {
  double value = 0;
  const IniLine* line = nullptr;
  bool known = true;
};

IniNumber number_of(const IniText& text, const std::string& section, std::string_view key, double otherwise) {
  const IniLine* const line = find_line(text, section, key);
  if (line == nullptr) return {otherwise, nullptr, true};
  const std::optional<double> value = ini_real(text.value(*line));
  return {value.value_or(otherwise), line, value.has_value()};
}

class Joints {
 public:
  Joints(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text) {}

  void run() {
    const IniLine* const line = find_line(text_, "KINS", "JOINTS");
    const std::optional<int> count = line == nullptr ? std::nullopt : ini_integer(text_.value(*line));
    constexpr int kMostJoints = 16;
    if (!count || *count < 1 || *count > kMostJoints || !is_whole_machine(in_)) return;
    check_sections(*line, *count);
    for (int joint = 0; joint < *count; ++joint) {
      if (text_.find_section(name_of_joint(joint)) == nullptr) continue;
      if (number(joint, "HOME_ABSOLUTE_ENCODER", 0).value != 0) continue;  // measured: it is not looked for
      check_speeds(joint);
      check_home(joint);
    }
    check_gantries(*count);
  }

 private:
  static std::string name_of_joint(int joint) { return fmt::format("JOINT_{}", joint); }
  IniNumber number(int joint, std::string_view key, double otherwise) const {
    return number_of(text_, name_of_joint(joint), key, otherwise);
  }
  const IniLine& section_line(const std::string& section) const {
    return text_.lines()[text_.find_section(section)->line];
  }

  /// Whether a line names the section, though it does not open one of that name: then that line is the mistake.
  bool is_named(const std::string& section) const {
    return std::ranges::any_of(text_.lines(), [&](const IniLine& line) {
      return line.kind != IniLine::Kind::kKey && line.kind != IniLine::Kind::kComment &&
          (small_letters(text_.text(line)).find(small_letters(section)) != std::string::npos ||
           (line.kind == IniLine::Kind::kSection && meant_section(text_, text_.name(line)) == section));
    });
  }

  /// Whether an axis of the machine needs the joint: a lathe may leave out the one of Y.
  bool moves_axis(int joint) const {
    const IniLine* const kinematics = find_line(text_, "KINS", "KINEMATICS");
    const std::string_view value = kinematics == nullptr ? std::string_view() : text_.value(*kinematics);
    if (!value.starts_with("trivkins")) return false;
    const std::string given = trivial_axes(value);
    const std::string letters = given.empty() ? "XYZABCUVW" : given;
    const auto at = static_cast<size_t>(joint);
    return at < letters.size() && reads_section(text_, std::string("AXIS_") + letters[at]);
  }

  /// A joint of `JOINTS` that has no section, where the next one has.
  void check_sections(const IniLine& count_line, int count) {
    if (!in_.setup.ini.missing_includes().empty()) return;
    const IniLine* beyond = nullptr;  // `[JOINT_2]` of two joints
    for (const IniText::Section& section : text_.sections()) {
      if (!section.first || !section.name.starts_with("JOINT_")) continue;
      const std::optional<int> number = ini_integer(std::string_view(section.name).substr(section.name.find('_') + 1));
      if (number && *number >= count && beyond == nullptr) beyond = &text_.lines()[section.line];
    }
    std::string missing;
    for (int joint = 0; joint < count; ++joint) {
      const std::string name = name_of_joint(joint);
      const bool of_axis = text_.find_section(fmt::format("AXIS_{}", joint)) != nullptr;  // OW414
      // Those behind the last section may be left out on purpose.
      if (text_.find_section(name_of_joint(joint + 1)) == nullptr) continue;
      if (text_.find_section(name) == nullptr && !is_named(name) && !of_axis && moves_axis(joint))
        missing += fmt::format("{}`[{}]`", missing.empty() ? "" : ", ", name);
    }
    if (missing.empty()) return;
    Finding& f = add_at(in_, out_, count_line, count_line.value,
                        fmt::format("`JOINTS` is {}, but this INI has no {}: LinuxCNC moves such a joint without "
                                    "limits and with a speed of 1 unit per second",
                                    count, missing));
    f.help = "add the section, with the limits and the speed of the joint";
    if (beyond == nullptr) return;
    f.help = "joints count from 0: rename the section that is meant, or write how many joints there are";
    f.related.push_back({beyond->span, "LinuxCNC does not read this section",
                         beyond->source == count_line.source ? nullptr : text_.source(*beyond)});
  }

  void check_speeds(int joint) {
    const IniNumber search = number(joint, "HOME_SEARCH_VEL", 0), latch = number(joint, "HOME_LATCH_VEL", 0);
    if (!search.known || !latch.known) return;
    if (search.value != 0 && latch.value == 0) {
      Finding& f = add_at(in_, out_, *search.line,
                          latch.line == nullptr
                              ? "`HOME_SEARCH_VEL` without `HOME_LATCH_VEL`: LinuxCNC cannot home this joint"
                              : "`HOME_LATCH_VEL` is 0 beside this `HOME_SEARCH_VEL`: LinuxCNC cannot home this joint");
      f.help = "write the speed and direction in which the switch's place is taken exactly as `HOME_LATCH_VEL`";
      f.interpreter = "invalid homing config: non-zero SEARCH_VEL needs LATCH_VEL";
      if (latch.line != nullptr) relate(f, *latch.line, *search.line, "the other speed");
      return;
    }
    const IniLine* const index = find_line(text_, name_of_joint(joint), "HOME_USE_INDEX");
    const bool uses_index = index != nullptr && ini_truth(text_.value(*index)).value_or(true);
    if (search.value != 0 || latch.value == 0 || uses_index) return;
    Finding& f = add_at(in_, out_, *latch.line,
                        "`HOME_LATCH_VEL` without `HOME_SEARCH_VEL` or `HOME_USE_INDEX`: LinuxCNC cannot home this "
                        "joint");
    f.help = "write `HOME_SEARCH_VEL` for a joint with a switch; for a joint without one write 0 for both";
    f.interpreter = "invalid homing config: non-zero LATCH_VEL needs either SEARCH_VEL or USE_INDEX";
  }

  void check_home(int joint) {
    const IniNumber home = number(joint, "HOME", 0);
    const IniNumber low = number(joint, "MIN_LIMIT", -kNoLimit), high = number(joint, "MAX_LIMIT", kNoLimit);
    if (!home.known || !low.known || !high.known || low.value > high.value) return;
    const bool below = home.value < low.value;
    if (!below && home.value <= high.value) return;
    // One that nobody homes need not have a place.
    if (home.line == nullptr && find_line(text_, name_of_joint(joint), "HOME_SEQUENCE") == nullptr) return;
    const IniLine& limit = below ? *low.line : *high.line;
    const std::string limit_words =
        fmt::format("{} `{}` of {}", below ? "below" : "above", text_.name(limit), text_.value(limit));
    Finding& f = home.line != nullptr
        ? add_at(in_, out_, *home.line,
                 fmt::format("`HOME` of {} is {}: the joint goes beyond its limit when it is homed",
                             text_.value(*home.line), limit_words))
        : add_at(in_, out_, limit,
                 fmt::format("this joint has no `HOME`, and 0 is {}: the joint goes beyond its limit when it is homed",
                             limit_words));
    f.help = "write a `HOME` between the limits";
    f.interpreter = fmt::format("Exceeded {} soft limit ({:.5f}) on joint {}", below ? "NEGATIVE" : "POSITIVE",
                                below ? low.value : high.value, joint);
    if (home.line != nullptr) relate(f, limit, *home.line, "the limit");
  }

  /// Two joints of one axis whose places in the order of homing differ.
  void check_gantries(int count) {
    const IniLine* const kinematics = find_line(text_, "KINS", "KINEMATICS");
    const std::string letters = kinematics == nullptr ? "" : trivial_axes(text_.value(*kinematics));
    for (int joint = 0; joint < count && static_cast<size_t>(joint) < letters.size(); ++joint) {
      const auto letter =
          static_cast<char>(std::toupper(static_cast<unsigned char>(letters[static_cast<size_t>(joint)])));
      for (int other = 0; other < joint; ++other) {
        const char same =
            static_cast<char>(std::toupper(static_cast<unsigned char>(letters[static_cast<size_t>(other)])));
        if (same == letter && check_gantry(other, joint, letter)) break;
      }
    }
  }

  /// Whether homing moves a joint at all.
  bool moves(int joint) const {
    const IniNumber home = number(joint, "HOME", 0), offset = number(joint, "HOME_OFFSET", 0);
    return number(joint, "HOME_ABSOLUTE_ENCODER", 0).value == 0 &&
        (number(joint, "HOME_SEARCH_VEL", 0).value != 0 || home.value != offset.value);
  }

  bool check_gantry(int first, int second, char letter) {
    const IniNumber a = number(first, "HOME_SEQUENCE", 0), b = number(second, "HOME_SEQUENCE", 0);
    if (a.line == nullptr || b.line == nullptr || !a.known || !b.known) return false;
    if (std::abs(a.value) == std::abs(b.value) || (!moves(first) && !moves(second))) return false;
    Finding& f = add_at(in_, out_, *b.line,
                        fmt::format("joints {} and {} both move {}, but LinuxCNC homes one after the other: one side "
                                    "of the gantry moves while the other stands still",
                                    first, second, letter));
    f.help = "give both joints the same negative `HOME_SEQUENCE`, such as `-1`: then they are homed together";
    relate(f, *a.line, *b.line, fmt::format("the `HOME_SEQUENCE` of joint {}", first));
    return true;
  }

  void relate(Finding& f, const IniLine& line, const IniLine& from, std::string message) const {
    f.related.push_back({line.span, std::move(message), line.source == from.source ? nullptr : text_.source(line)});
  }

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
};

}  // namespace

std::string trivial_axes(std::string_view kinematics) {
  constexpr std::string_view kOption = "coordinates=";
  const size_t at = kinematics.find(kOption);
  if (!kinematics.starts_with("trivkins") || at == std::string_view::npos) return {};
  const std::string_view letters = kinematics.substr(at + kOption.size());
  return std::string(letters.substr(0, letters.find_first_of(" \t")));
}

void check_ini_joints(const SetupInput& in, Reporter& out) { Joints(in, out).run(); }

void check_change_position_limits(const SetupInput& in, Reporter& out) {
  const IniText& text = in.setup.text;
  const IniLine* const line = find_line(text, "EMCIO", "TOOL_CHANGE_POSITION");
  if (line == nullptr || !is_whole_machine(in)) return;
  // A sub in place of M6 moves where it wants.
  for (const Remap& remap : remaps_of(text)) {
    if (small_letters(remap.read.code).starts_with("m6") || small_letters(remap.read.code).starts_with("m06")) return;
  }
  constexpr std::string_view kAxes = "XYZABCUVW";
  const std::string_view value = text.value(*line);
  size_t axis = 0;
  for (size_t at = value.find_first_not_of(" \t"); at < value.size() && axis < kAxes.size(); ++axis) {
    const size_t end = std::min(value.find_first_of(" \t", at), value.size());
    const std::string_view word = value.substr(at, end - at);
    const std::string section = fmt::format("AXIS_{}", kAxes[axis]);
    const Span span{line->value.begin + at, line->value.begin + end};
    at = value.find_first_not_of(" \t", end);
    const std::optional<double> place = ini_real(word);
    if (!place) return;
    if (!reads_section(text, section)) continue;
    const IniNumber low = number_of(text, section, "MIN_LIMIT", -kNoLimit);
    const IniNumber high = number_of(text, section, "MAX_LIMIT", kNoLimit);
    if (!low.known || !high.known || low.value > high.value) continue;
    const bool below = *place < low.value;
    if (!below && *place <= high.value) continue;
    const IniLine& limit = below ? *low.line : *high.line;
    Finding& f = add_at(in, out, *line, span,
                        fmt::format("`TOOL_CHANGE_POSITION` has {} at {}, {} its `{}` of {}: each tool change stops",
                                    kAxes[axis], word, below ? "below" : "above", text.name(limit), text.value(limit)));
    f.help = "write a place between the limits, in machine coordinates";
    f.interpreter =
        fmt::format("Linear move on line N would exceed {}'s {} limit", kAxes[axis], below ? "negative" : "positive");
    f.related.push_back({limit.span, "the limit", limit.source == line->source ? nullptr : text.source(limit)});
    return;
  }
}

}  // namespace owlint::rules
