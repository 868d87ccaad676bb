#include "analyzer/report/arc_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace owlint {
namespace {

constexpr double kWidth = 380;
constexpr double kDrawn = 210;  // the height of the drawing, above the legend
constexpr double kMargin = 34;  // room for the names of points
constexpr double kLegend = 19;  // the height of a line
constexpr double kFull = 2 * std::numbers::pi;

/// The colours are those of the audit's page. Written into the drawing, they hold wherever it is shown.
constexpr const char* kStyle =
    "<style>"
    "svg{--back:#fff;--text:#22262b;--soft:#59616b;--bad:#b3261e;--good:#2c6b35;font:13px system-ui,sans-serif}"
    "@media (prefers-color-scheme:dark){"
    "svg{--back:#1f2329;--text:#e6e3dc;--soft:#a8afb8;--bad:#ff9d94;--good:#8fd29a}}"
    ".back{fill:var(--back)}text{fill:var(--text)}.name{font-size:12px;fill:var(--soft)}"
    "path,line{fill:none;stroke-width:1.6}.point{fill:var(--text)}.cross{stroke:var(--text);stroke-width:1.8}"
    ".written{stroke:var(--bad)}.radius{stroke:var(--bad);stroke-dasharray:4 3;stroke-width:1.2}"
    ".nearest{stroke:var(--good);stroke-width:2.2}.middle{fill:var(--good)}"
    "</style>";

struct At {
  double x = 0, y = 0;
};

/// An arc as it is drawn: its angles are those of the plane.
struct Swept {
  At center;
  double radius = 0, from = 0, by = 0;

  At at(double share) const {
    return {center.x + radius * std::cos(from + by * share), center.y + radius * std::sin(from + by * share)};
  }
};

At placed(const ArcSketch::Point& point) { return {point.right, point.up}; }
double angle(At center, At point) { return std::atan2(point.y - center.y, point.x - center.x); }

/// From one angle to another one the way round that the arc goes; a full circle where they are the same.
double sweep_between(double from, double to, bool clockwise) {
  double by = std::remainder(to - from, kFull);
  if (clockwise && by >= 0) by -= kFull;
  if (!clockwise && by <= 0) by += kFull;
  return by;
}

/// Gathers the drawing, and what room it takes.
class ArcDrawing {
 public:
  explicit ArcDrawing(const ArcSketch& arc) : arc_(arc), start_(placed(arc.start)), end_(placed(arc.end)) {
    if (arc.center) {
      const At center = placed(*arc.center);
      radii_ = {{{center, start_}, {center, end_}}};
      if (arc.start_radius > 0) {
        const double from = angle(center, start_);
        const double by = arc.end_radius > 0 ? sweep_between(from, angle(center, end_), arc.clockwise) : 0;
        written_.push_back({center, arc.start_radius, from, by});
        // A piece of the other circle, so that the step between the two is seen.
        constexpr double kPiece = std::numbers::pi / 7;
        const double piece = std::min(kPiece, std::abs(by) / 2);
        if (piece > 0)
          written_.push_back({center, arc.end_radius, angle(center, end_), arc.clockwise ? piece : -piece});
      }
    } else {
      // The radius from either end towards the other one.
      const double way = angle(start_, end_);
      const At along{arc.start_radius * std::cos(way), arc.start_radius * std::sin(way)};
      radii_ = {{{start_, {start_.x + along.x, start_.y + along.y}}, {end_, {end_.x - along.x, end_.y - along.y}}}};
    }
    if (arc.nearest) {
      const At center = placed(arc.nearest->center);
      const double from = angle(center, start_);
      nearest_ = {center, arc.nearest->radius, from, sweep_between(from, angle(center, end_), arc.clockwise)};
    }
    fit();
  }

  std::string svg() {
    const std::vector<ArcFact> facts = arc_facts(arc_);
    const double height = kDrawn + kLegend * static_cast<double>(facts.size()) + 12;
    std::string out = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:g}" height="{1:g}" viewBox="0 0 {0:g} {1:g}">{2})"
        R"(<rect width="{0:g}" height="{1:g}" rx="8" class="back"/>)",
        kWidth, height, kStyle);
    if (arc_.nearest) out += curve("nearest", nearest_);
    for (const Swept& swept : written_) out += curve("written", swept);
    for (const auto& [from, to] : radii_) {
      const At a = shown(from), b = shown(to);
      out +=
          fmt::format(R"(<line class="radius" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)", a.x, a.y, b.x, b.y);
    }
    // The center that fits may be far away, where an arc is nearly straight.
    if (arc_.nearest && is_inside(shown(nearest_.center))) out += dot("middle", shown(nearest_.center), 2.5);
    if (arc_.center) out += cross(shown(placed(*arc_.center)));
    const At start = shown(start_), end = shown(end_);
    out += dot("point", start, 4) + dot("point", end, 4);
    if (std::hypot(start.x - end.x, start.y - end.y) < 8) {
      out += name("start, end", start);
    } else {
      out += name("start", start) + name("end", end);
    }
    if (arc_.center) out += name("center", shown(placed(*arc_.center)), true);
    return out + legend(facts) + "</svg>";
  }

 private:
  /// Where everything fits into the room for the drawing.
  void fit() {
    std::vector<At> all{start_, end_};
    const auto add = [&all](const Swept& swept) {
      constexpr int kSteps = 24;
      for (int i = 0; i <= kSteps; ++i) all.push_back(swept.at(static_cast<double>(i) / kSteps));
    };
    for (const auto& [from, to] : radii_) all.insert(all.end(), {from, to});
    for (const Swept& swept : written_) add(swept);
    if (arc_.nearest) add(nearest_);
    const auto [left, right] = std::ranges::minmax(all, {}, &At::x);
    const auto [low, high] = std::ranges::minmax(all, {}, &At::y);
    const double wide = right.x - left.x, tall = high.y - low.y;
    scale_ = std::min((kWidth - 2 * kMargin) / std::max(wide, 1e-9), (kDrawn - 2 * kMargin) / std::max(tall, 1e-9));
    middle_ = {(left.x + right.x) / 2, (low.y + high.y) / 2};
  }

  At shown(At at) const { return {kWidth / 2 + (at.x - middle_.x) * scale_, kDrawn / 2 - (at.y - middle_.y) * scale_}; }

  static bool is_inside(At at) { return at.x > 5 && at.x < kWidth - 5 && at.y > 5 && at.y < kDrawn - 5; }

  /// As two pieces, neither of which is more than half a circle.
  std::string curve(const char* kind, const Swept& swept) const {
    const At from = shown(swept.at(0)), half = shown(swept.at(0.5)), to = shown(swept.at(1));
    const double radius = swept.radius * scale_;
    const int way = swept.by < 0 ? 1 : 0;
    return fmt::format(
        R"(<path class="{0}" d="M{1:.1f} {2:.1f}A{3:.1f} {3:.1f} 0 0 {4} {5:.1f} {6:.1f}A{3:.1f} {3:.1f} 0 0 {4} {7:.1f} {8:.1f}"/>)",
        kind, from.x, from.y, radius, way, half.x, half.y, to.x, to.y);
  }

  static std::string dot(const char* kind, At at, double radius) {
    return fmt::format(R"(<circle class="{}" cx="{:.1f}" cy="{:.1f}" r="{:g}"/>)", kind, at.x, at.y, radius);
  }
  static std::string cross(At at) {
    return fmt::format(R"(<path class="cross" d="M{:.1f} {:.1f}h10m-5 -5v10"/>)", at.x - 5, at.y);
  }

  struct Box {
    double left, top, right, bottom;

    bool meets(const Box& other) const {
      return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
  };

  /// A point's name, on the side where there is room for it; below or above, if possible, where lines come from the sides.
  std::string name(std::string_view text, At at, bool between = false) {
    const double wide = 6.3 * static_cast<double>(text.size());
    constexpr double kTall = 13, kAway = 9;
    const double outwards = at.x < kWidth / 2 ? -wide - kAway : kAway;
    const double inwards = outwards < 0 ? kAway : -wide - kAway;
    std::array<At, 6> tries{{{outwards, 4},
                             {-wide / 2, kAway + kTall - 3},
                             {-wide / 2, -kAway},
                             {inwards, 4},
                             {outwards, kAway + kTall},
                             {outwards, -kAway - 3}}};
    if (between) std::rotate(tries.begin(), tries.begin() + 1, tries.begin() + 3);
    At chosen = tries[0];
    for (const At by : tries) {
      const Box box{at.x + by.x, at.y + by.y - kTall + 2, at.x + by.x + wide, at.y + by.y + 2};
      const bool inside = box.left > 2 && box.right < kWidth - 2 && box.top > 2 && box.bottom < kDrawn;
      if (!inside || std::ranges::any_of(names_, [&box](const Box& other) { return box.meets(other); })) continue;
      chosen = by;
      names_.push_back(box);
      break;
    }
    const double x = std::clamp(at.x + chosen.x, 2.0, kWidth - wide - 2);
    return fmt::format(R"(<text class="name" x="{:.1f}" y="{:.1f}">{}</text>)", x, at.y + chosen.y, text);
  }

  static std::string legend(const std::vector<ArcFact>& facts) {
    std::string out;
    double y = kDrawn + 12;
    for (const ArcFact& fact : facts) {
      const std::string_view mark = fact.mark;
      if (mark == "point") {
        out += dot("point", {20, y - 4}, 4);
      } else if (mark == "cross") {
        out += cross({20, y - 4});
      } else {
        out += fmt::format(R"(<line class="{}" x1="10" y1="{:g}" x2="30" y2="{:g}"/>)", mark, y - 4, y - 4);
      }
      out += fmt::format(R"(<text x="40" y="{:g}">{}: {}</text>)", y, fact.name, fact.words);
      y += kLegend;
    }
    return out;
  }

  const ArcSketch& arc_;
  At start_, end_;
  std::array<std::pair<At, At>, 2> radii_{};
  std::vector<Swept> written_;
  Swept nearest_;
  double scale_ = 1;
  At middle_;
  std::vector<Box> names_;
};

}  // namespace

std::vector<ArcFact> arc_facts(const ArcSketch& arc) {
  std::vector<ArcFact> facts{{"point", "start", arc.start.words}, {"point", "end", arc.end.words}};
  if (arc.center) {
    facts.push_back({"cross", "center, as written", arc.center->words});
    facts.push_back({"radius", "from the center to the start", arc.start_radius_words});
    facts.push_back({"radius", "from the center to the end", arc.end_radius_words});
  } else {
    facts.push_back({"radius", "radius, as written", arc.start_radius_words});
  }
  if (arc.nearest) {
    facts.push_back({"nearest", "center that fits", arc.nearest->center.words});
    facts.push_back({"nearest", arc.center ? "radius that fits" : "least radius that fits", arc.nearest->words});
  }
  return facts;
}

std::string arc_sentence(const ArcSketch& arc) {
  std::string out;
  for (const ArcFact& fact : arc_facts(arc))
    out += fmt::format("{}{}: {}", out.empty() ? "" : "; ", fact.name, fact.words);
  return out;
}

std::string arc_svg(const ArcSketch& arc) { return ArcDrawing(arc).svg(); }

}  // namespace owlint
