// Where the machine stands, and what else of positions and sizes the checks of the interpreter need: offsets, stored points, and
// the heights of canned cycles. Lines change it (mode_run.h). Source: measured with rs274, see docs/interpreter.md.
#pragma once

#include <array>
#include <cstdint>

#include "analyzer/geometry/compensated_path.h"
#include "analyzer/syntax/coordinate.h"

namespace owlint {

enum class Axis : uint8_t { kX, kY, kZ, kA, kB, kC, kU, kV, kW };
inline constexpr size_t kAxisCount = 9;
inline constexpr const char* kAxisOrder = "xyzabcuvw";
inline constexpr size_t kSystemCount = 9;  ///< G54 to G59.3
/// Units of the machine in a millimetre: those of `rs274` without an INI are inches.
inline constexpr double kStandAloneUnits = 0.03937007874016;
/// A, B and C are angles.
constexpr bool is_length(size_t axis) { return axis < 3 || axis > 5; }

struct Point {
  std::array<Coordinate, kAxisCount> axes{};

  Coordinate& operator[](size_t axis) { return axes[axis]; }
  Coordinate operator[](size_t axis) const { return axes[axis]; }
  Coordinate& operator[](Axis axis) { return axes[static_cast<size_t>(axis)]; }
  Coordinate operator[](Axis axis) const { return axes[static_cast<size_t>(axis)]; }
  bool operator==(const Point&) const = default;

  /// Turned about Z.
  Point turned(Coordinate degrees) const;
  static Point unknown();
};
Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);

struct CoordinateSystem {
  Point origin{};
  Coordinate rotation{};

  bool operator==(const CoordinateSystem&) const = default;
};

struct Place {
  /// The current point, in the units and the coordinate system in effect; on a compensated path the programmed one.
  Point at{};

  // In the units in effect.
  CoordinateSystem system{};  ///< that in effect
  Point offset{};             ///< of G92 and G52
  Point tool{};               ///< the offset of G43
  // In units of the machine, as parameters.
  std::array<CoordinateSystem, kSystemCount> systems{};
  Point stored_offset{};
  Coordinate has_offset{};  ///< 1 while the stored offset is in effect, else 0
  Point home{}, home30{};   ///< of G28 and G30

  // Numbers of the last canned cycle, as they were written.
  Coordinate clearance{};      ///< R
  Coordinate bottom{};         ///< the word of the axis along the hole
  Coordinate height{};         ///< where that axis was when the cycles began
  bool keeps_height = false;   ///< cycles have begun
  bool tools_changed = false;  ///< lines have set numbers of the tool table
  /// The tool that T has chosen, and the one in the spindle, by number.
  static constexpr int32_t kUnknownTool = -1;
  int32_t chosen_tool = kUnknownTool, loaded_tool = kUnknownTool;

  /// The last control point of a NURBS.
  Coordinate curve_x{}, curve_y{};

  /// With compensation on, if it is known: else it is off.
  CompensatedPath path{};
  bool path_from_start = false;  ///< it depends on where a machine stands that was just started

  bool operator==(const Place&) const = default;

  /// Nothing is known of a compensated path.
  void lose_path() { path = {}; }
  /// The interpreter asks the machine where it is. The stand-alone one has a machine that knows neither tool offsets nor a
  /// rotation (measured); `may_move`: others may have gone elsewhere for a tool change.
  void ask_machine(bool may_move);
  /// The machine is somewhere.
  void lose_point();
  /// The same, and its offsets are no longer known.
  void lose_offsets();
  /// A line writes a numbered parameter, which some later line may read; what it holds now stays in effect until then.
  void write_parameter(int32_t number, Coordinate value);
  /// A line writes a parameter whose number is not known.
  void lose_parameters();
  /// Takes coordinates that are not known for numbers that count from somewhere.
  void settle();

  /// That of an interpreter that was just started, in G21; `units_per_mm`: of the machine.
  static Place started(double units_per_mm = kStandAloneUnits);
  static Place unknown();
};

/// Whether a parameter is one of the numbers that a place has: #5161 to #5390.
constexpr bool is_place_parameter(double number) { return number > 5160 && number < 5391; }

/// What is known in both.
Place join(const Place& a, const Place& b);

}  // namespace owlint
