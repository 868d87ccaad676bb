// Rotary axes of a kind that the INI declares: those that wrap, and those that index.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analyzer/syntax/mode_place.h"

namespace owlint::places {
namespace {

constexpr StopKind kConflict = StopKind::kModeConflict;
constexpr std::string_view kRotary = "abc";
constexpr double kTurn = 360;

bool is_in(uint32_t letters, char letter) { return (letters & letter_set({&letter, 1})) != 0; }
char capital(char letter) { return static_cast<char>(letter - 'a' + 'A'); }

/// It is for its numbers that the line is carried out.
bool stop_for_numbers(ModeLine& line, std::string message, uint8_t word, uint8_t other) {
  line.stop(kConflict, std::move(message), word, other);
  line.faults()->back().by_place = true;
  return true;
}

bool indexes(ModeLine& line, Motion motion, char letter) {
  const uint8_t word = line.at(letter);
  if (motion != Motion::kG0)
    return stop_for_numbers(line, fmt::format("Indexing axis {} can only be moved with G0", capital(letter)), word,
                            line.mover());
  for (const char other : std::string_view(kAxisOrder)) {
    if (other == letter || !line.has(other)) continue;
    return stop_for_numbers(line, fmt::format("Indexing axis {} can only be moved alone", capital(letter)), word,
                            line.at(other));
  }
  const bool polar = line.words().has_polar_words();
  constexpr const char* kMovesAlong = "BUG: An axis incorrectly moved along with an indexer";
  if (polar) return stop_for_numbers(line, kMovesAlong, line.at(line.has('@') ? '@' : '^'), word);
  return line.stop_in({kCompensationMoves, {Mode::kEntry, value_bit(modes::kMade)}}, kConflict, kMovesAlong, word);
}

}  // namespace

bool moves_indexing_axis(ModeLine& line, Motion motion) {
  if (line.machine().indexing == 0 || motion == Motion::kNone || motion == Motion::kG80) return false;
  for (const char letter : kRotary) {
    if (is_in(line.machine().indexing, letter) && line.has(letter)) return indexes(line, motion, letter);
  }
  return false;
}

bool names_indexing_axis(const ModeLine& line) {
  return std::ranges::any_of(kRotary,
                             [&](char letter) { return is_in(line.machine().indexing, letter) && line.has(letter); });
}

bool goes_round(ModeLine& line, Positions are, Point* point) {
  constexpr BadMode kAbsolute{Mode::kDistance, value_bit(modes::kG90)};
  const uint32_t wrapped = line.machine().wrapped;
  if (wrapped == 0) return false;
  for (const char letter : kRotary) {
    if (!is_in(wrapped, letter) || !line.has(letter)) continue;
    const double* const value = line.value(letter);
    if (value != nullptr && std::abs(*value) >= kTurn) {
      const std::string message =
          fmt::format("Invalid absolute position {:5.2f} for wrapped rotary axis {}", *value, capital(letter));
      const uint8_t word = line.at(letter), other = line.at(GGroup::kNonModal);
      if (are == Positions::kAbsolute ? stop_for_numbers(line, message, word, other)
                                      : line.stop_in({kAbsolute}, kConflict, message, word, other))
        return true;
    }
    // How many turns it makes is not followed.
    if (point != nullptr && (are == Positions::kAbsolute || line.only(Mode::kDistance) != modes::kG91))
      (*point)[std::string_view(kAxisOrder).find(letter)] = Coordinate::unknown();
  }
  return false;
}

}  // namespace owlint::places
