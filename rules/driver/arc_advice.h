// Numbers with which an arc that does not fit would: what the author may have meant. Each of them passes the interpreter's check
// before it is shown.
#pragma once

#include <memory>
#include <string>

#include "analyzer/findings/arc_sketch.h"
#include "rules/driver/modes.h"

namespace owlint::rules {

/// A point of the arc's plane as it is written on a line: `X10 Y0`.
std::string point_words(const ArcNumbers& arc, Flat point);
/// Adds the line on which the arc begins, where that is one line, and says if another machine may begin it elsewhere.
void tell_arc_start(const Input& in, const FlowStop& stop, Finding& finding);
/// Help for an arc whose ends are not as far from its center; relates the line of the mode that decides, if one does.
void advise_about_center(const Input& in, const FlowStop& stop, Finding& finding);
/// The same for an arc whose center is at its start or end.
void advise_about_zero_radius(const Input& in, const FlowStop& stop, Finding& finding);
/// What of the arc can be drawn; null if it has no two points that differ.
std::shared_ptr<const ArcSketch> sketch_of(const ArcNumbers& arc);
/// The least radius that reaches the end, as `R6.0001`; with the sign of the one that is written.
std::string least_radius_word(const ArcNumbers& arc);

}  // namespace owlint::rules
