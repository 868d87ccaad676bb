// The one drawing of an arc that does not fit, for the hover of an editor and the page of an audit; and what it says, in words.
#pragma once

#include <string>
#include <vector>

#include "analyzer/findings/arc_sketch.h"

namespace owlint {

/// A line of the legend.
struct ArcFact {
  const char* mark;  ///< the class of what it is about in the drawing
  std::string name;  ///< `start`
  std::string words;
};
std::vector<ArcFact> arc_facts(const ArcSketch& arc);

/// All facts in one sentence, for those who do not see the drawing.
std::string arc_sentence(const ArcSketch& arc);

/// An SVG that stands for itself: with its own colours, light or dark as its reader has them, and with the facts as a legend.
std::string arc_svg(const ArcSketch& arc);

}  // namespace owlint
