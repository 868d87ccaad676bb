#include "analyzer/machine/check_config.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace owlint {
namespace {

/// The whole text as a number; nothing if it is none.
std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A value in the words of the message: as an element of a Tcl list.
std::string shown(std::string_view value) {
  const bool plain = !value.empty() && value.find_first_of(" \t") == std::string_view::npos;
  return plain ? std::string(value) : fmt::format("{{{}}}", value);
}

/// Measured: as numbers if both are, otherwise as the text that the message shows, so that `300 < {}` and `300 < {100 # mm}`.
bool is_less(std::string_view a, std::string_view b) {
  const auto x = number_in(a);
  const auto y = number_in(b);
  return x && y ? *x < *y : shown(a) < shown(b);
}

class Checker {
 public:
  explicit Checker(const IniText& text) : text_(text) {}

  std::vector<StartRefusal> run() {
    if (!read()) return std::move(out_);
    check_kinematics();
    return std::move(out_);
  }

 private:
  using Values = std::vector<const IniLine*>;

  /// False where it stops at a line before any section.
  bool read() {
    std::string section;
    for (const IniLine& line : text_.lines()) {
      if (is_checked_section(text_, line)) {
        section = text_.name(line);
        continue;
      }
      const std::string_view body = text_.text(line);
      const size_t equals = body.find('=');
      if (body.starts_with('#') || equals == std::string_view::npos) continue;
      if (section.empty()) {
        out_.push_back(
            {StartRefusal::Kind::kBeforeSection, &line, nullptr, "", "", "can't read \"section\": no such variable"});
        return false;
      }
      const std::string_view key = body.substr(0, body.find_last_not_of(" \t", equals == 0 ? 0 : equals - 1) + 1);
      values_[section][std::string(key)].push_back(&line);
    }
    return true;
  }

  const Values& values(const std::string& section, const std::string& key) const {
    static const Values none;
    const auto in = values_.find(section);
    if (in == values_.end()) return none;
    const auto found = in->second.find(key);
    return found == in->second.end() ? none : found->second;
  }

  void check_kinematics() {
    const Values& kinematics = values("KINS", "KINEMATICS");
    const Values& joints = values("KINS", "JOINTS");
    const auto add = [&](StartRefusal::Kind kind, const IniLine* line, const char* message) {
      out_.push_back({kind, line, nullptr, "", "", message});
    };
    if (kinematics.empty()) add(StartRefusal::Kind::kNoKinematics, nullptr, "Missing [KINS]KINEMATICS=");
    if (joints.empty()) add(StartRefusal::Kind::kNoJoints, nullptr, "Missing [KINS]JOINTS=");
    if (kinematics.empty() || joints.empty()) return;
    const std::string_view count = text_.value(*joints.front());
    int most = 0;
    std::from_chars(count.data(), count.data() + count.size(), most);
    if (!number_in(count)) {
      add(StartRefusal::Kind::kEndlessJoints, joints.front(), "");
      return;
    }
    check_limits(text_.value(*kinematics.back()), most);
  }

  /// Of trivkins only: each letter of `coordinates=` has the joint of its place.
  void check_limits(std::string_view kinematics, int joints) {
    if (!kinematics.starts_with("trivkins")) return;
    constexpr std::string_view kOption = "coordinates=";
    std::string_view letters = "XYZABCUVW";
    if (const size_t at = kinematics.find(kOption); at != std::string_view::npos) {
      letters = kinematics.substr(at + kOption.size());
      letters = letters.substr(0, letters.find_first_of(" \t"));
    }
    for (int joint = 0; joint < joints && static_cast<size_t>(joint) < letters.size(); ++joint) {
      const char letter =
          static_cast<char>(std::toupper(static_cast<unsigned char>(letters[static_cast<size_t>(joint)])));
      const std::string names[] = {fmt::format("JOINT_{}", joint), fmt::format("AXIS_{}", letter)};
      compare(names[0], names[1], true);
      compare(names[0], names[1], false);
    }
  }

  void compare(const std::string& joint, const std::string& axis, bool min) {
    const char* const key = min ? "MIN_LIMIT" : "MAX_LIMIT";
    const Values& of_joint = values(joint, key);
    const Values& of_axis = values(axis, key);
    if (of_joint.size() != 1 || of_axis.size() > 1) return;
    const std::string_view a = text_.value(*of_joint[0]);
    const std::string_view b = of_axis.empty() ? (min ? "-1e99" : "+1e99") : text_.value(*of_axis[0]);
    if (!(min ? is_less(b, a) : is_less(a, b))) return;
    out_.push_back({min ? StartRefusal::Kind::kMinLimit : StartRefusal::Kind::kMaxLimit, of_joint[0],
                    of_axis.empty() ? nullptr : of_axis[0], joint, axis,
                    fmt::format("[{}]{} {} [{}]{} ({} {} {})", joint, key, min ? '>' : '<', axis, key, shown(a),
                                min ? '>' : '<', shown(b))});
  }

  const IniText& text_;
  std::map<std::string, std::map<std::string, Values>> values_;
  std::vector<StartRefusal> out_;
};

}  // namespace

bool is_checked_section(const IniText& text, const IniLine& line) {
  return line.kind == IniLine::Kind::kSection && text.text(line).ends_with(']') &&
      text.name(line).size() + 2 == text.text(line).size();
}

std::vector<StartRefusal> check_config(const IniText& text) { return Checker(text).run(); }

}  // namespace owlint
