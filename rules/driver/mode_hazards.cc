#include "rules/driver/mode_hazards.h"

#include <algorithm>
#include <array>
#include <bit>

namespace owlint::rules {
namespace {

struct MoveUnder {
  Mode mode;
  uint8_t value;
  std::string_view move;
};

constexpr std::array kMoves = {
    MoveUnder{Mode::kMotion, static_cast<uint8_t>(Motion::kG0), "is a rapid"},
    MoveUnder{Mode::kMotion, static_cast<uint8_t>(Motion::kG1), "is at the feed rate"},
    MoveUnder{Mode::kDistance, modes::kG90, "is absolute"},
    MoveUnder{Mode::kDistance, modes::kG91, "is incremental"},
    MoveUnder{Mode::kUnits, modes::kG20, "is in inches"},
    MoveUnder{Mode::kUnits, modes::kG21, "is in millimeters"},
    MoveUnder{Mode::kPlane, modes::kG17, "is in XY"},
    MoveUnder{Mode::kPlane, modes::kG18, "is in XZ"},
    MoveUnder{Mode::kPlane, modes::kG19, "is in YZ"},
    MoveUnder{Mode::kPlane, modes::kG17_1, "is in UV"},
    MoveUnder{Mode::kPlane, modes::kG18_1, "is in UW"},
    MoveUnder{Mode::kPlane, modes::kG19_1, "is in VW"},
    MoveUnder{Mode::kFeedMode, modes::kG93, "has an inverse time as `F`"},
    MoveUnder{Mode::kFeedMode, modes::kG94, "has a feed per minute"},
    MoveUnder{Mode::kFeedMode, modes::kG95, "has a feed per revolution"},
    MoveUnder{Mode::kArcDistance, modes::kG90_1, "has an absolute center"},
    MoveUnder{Mode::kArcDistance, modes::kG91_1, "has an incremental center"},
    MoveUnder{Mode::kDiameter, modes::kG7, "has a diameter as `X`"},
    MoveUnder{Mode::kDiameter, modes::kG8, "has a radius as `X`"},
    MoveUnder{Mode::kRetract, modes::kG98, "retracts to where it began"},
    MoveUnder{Mode::kRetract, modes::kG99, "retracts to `R`"},
    MoveUnder{Mode::kCompensation, modes::kG41, "is beside its path, on the left"},
    MoveUnder{Mode::kCompensation, modes::kG42, "is beside its path, on the right"},
};

struct Asking {
  Mode mode;
  std::string_view name;
};

constexpr std::array kAsking = {
    Asking{Mode::kMotion, "_motion_mode"},
    Asking{Mode::kDistance, "_absolute"},
    Asking{Mode::kDistance, "_incremental"},
    Asking{Mode::kUnits, "_metric"},
    Asking{Mode::kUnits, "_imperial"},
    Asking{Mode::kPlane, "_plane"},
    Asking{Mode::kFeedMode, "_inverse_time"},
    Asking{Mode::kFeedMode, "_units_per_minute"},
    Asking{Mode::kFeedMode, "_units_per_rev"},
    Asking{Mode::kSystem, "_coord_system"},
    Asking{Mode::kArcDistance, "_ijk_absolute_mode"},
    Asking{Mode::kArcDistance, "_ijk_incremental_mode"},
    Asking{Mode::kDiameter, "_lathe_diameter_mode"},
    Asking{Mode::kDiameter, "_lathe_radius_mode"},
    Asking{Mode::kRetract, "_retract_old_z"},
    Asking{Mode::kRetract, "_retract_r_plane"},
    Asking{Mode::kCompensation, "_ccomp"},
};

}  // namespace

std::string code_of_value(Mode mode, uint8_t value) {
  std::string name(value_name(mode, value));
  return name.starts_with('G') ? name : std::string();
}

std::string codes_of_mode(Mode mode) {
  std::string codes;
  for (ValueSet left = all_values(mode); left != 0; left &= left - 1) {
    const std::string code = code_of_value(mode, static_cast<uint8_t>(std::countr_zero(left)));
    if (!code.empty()) codes += (codes.empty() ? "" : " ") + code;
  }
  return codes;
}

std::string move_under(Mode mode, uint8_t value) {
  if (mode == Mode::kSystem) return "counts from the zero of `" + code_of_value(mode, value) + "`";
  for (const MoveUnder& row : kMoves) {
    if (row.mode == mode && row.value == value) return std::string(row.move);
  }
  return {};
}

bool asks_for_mode(const Program& program, Mode mode) {
  return std::ranges::any_of(kAsking, [&](const Asking& row) {
    return row.mode == mode && program.syntax.names.find(std::string(row.name)) != kNoName;
  });
}

Span word_of_line(const Program& program, uint32_t line, std::string_view names) {
  const Span all = program.source->line(line);
  const std::vector<WrittenWord> words = words_of(*program.source, all);
  if (const WrittenWord* word = find_word(words, names)) return word->span;
  return words.empty() ? all : Span{words.front().span.begin, words.back().span.end};
}

void relate_line(const Input& in, Finding& finding, const Program& program, uint32_t line, std::string_view names,
                 std::string message) {
  const bool here = &program == &in.program;
  finding.related.push_back({word_of_line(program, line, names), std::move(message), here ? nullptr : program.source});
}

void relate_mode(const Input& in, Finding& finding, const Hazard& hazard, uint8_t value) {
  if (hazard.set_in == nullptr) return;
  const std::string code = code_of_value(hazard.mode, value);
  const Source& source = *hazard.set_in->source;
  // M72 and the end of a sub behind M73 have no such word.
  const bool written = find_word(words_of(source, source.line(hazard.set_line)), code) != nullptr;
  // G41.1 and G42.1 do what G41 and G42 do.
  if (hazard.mode == Mode::kCompensation && !written) {
    return relate_line(in, finding, *hazard.set_in, hazard.set_line, code + ".1 M72", "compensation begins here");
  }
  relate_line(in, finding, *hazard.set_in, hazard.set_line, code + " M72",
              "`" + code + (written ? "` is set here" : "` comes back here"));
}

}  // namespace owlint::rules
