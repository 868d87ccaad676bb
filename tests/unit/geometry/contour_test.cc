// Lathe contours: shapes that are cut, and those that are not.
#include "analyzer/geometry/contour.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace owlint {
namespace {

struct Recorded : ContourMoves {
  std::vector<ContourMove> all;
  bool feeds = true;

  bool move(const ContourMove& move) override {
    if (!feeds && move.kind != ContourMove::Kind::kRapid) return false;
    all.push_back(move);
    return true;
  }
};

/// Lines through these points, Z and X.
std::vector<ContourElement> lines(std::vector<PlanePoint> points) {
  std::vector<ContourElement> elements;
  for (size_t i = 1; i < points.size(); ++i) {
    ContourElement line;
    line.start = points[i - 1];
    line.end = points[i];
    elements.push_back(line);
  }
  return elements;
}

ContourWords words(ContourWords::Cut cut, double allowance = 0) {
  ContourWords out;
  out.cut = cut;
  out.d = allowance;
  return out;
}

std::string said(const std::vector<ContourElement>& elements, const ContourWords& words) {
  Recorded moves;
  const ContourOutcome outcome = cut_contour(elements, words, moves);
  return outcome.message == nullptr ? "" : outcome.message;
}

constexpr auto kLayers = ContourWords::Cut::kPocketsAtOnce;

}  // namespace

TEST_CASE("a finishing cut goes along X where it goes back in Z") {
  CHECK(said(lines({{2, 30}, {-1, 10}, {-5, 13}, {-4.5, 13}}), words(ContourWords::Cut::kFinish)).empty());
  CHECK(said(lines({{2, 30}, {-1, 10}, {-5, 13}, {-4.5, 12.5}}), words(ContourWords::Cut::kFinish)) ==
        "G7X error: Not monotonic");
}

TEST_CASE("a single arc is finished only towards the axis") {
  std::vector<ContourElement> elements = lines({{2, 30}, {1, 5}, {1, 7}});
  elements[1].kind = ContourElement::Kind::kClockwise;
  elements[1].by_radius = true;
  elements[1].size = 2;
  CHECK(said(elements, words(ContourWords::Cut::kFinish)) == "G7X error: Not monotonic");
  elements[1].end = {1, 3};
  CHECK(said(elements, words(ContourWords::Cut::kFinish)).empty());
}

TEST_CASE("a finishing cut follows the contour") {
  Recorded moves;
  const ContourOutcome outcome =
      cut_contour(lines({{1, 30}, {-5, 10}, {-20, 20}}), words(ContourWords::Cut::kFinish), moves);
  CHECK(outcome.end == ContourEnd::kDone);
  REQUIRE(moves.all.size() == 3);
  CHECK(moves.all[1].kind == ContourMove::Kind::kRapid);
  CHECK(moves.all[1].end == PlanePoint{-5, 10});
  CHECK(moves.all[2].kind == ContourMove::Kind::kFeed);
  CHECK(moves.all[2].end == PlanePoint{-20, 20});
}

TEST_CASE("layers end at the height of the start") {
  Recorded moves;
  const ContourOutcome outcome = cut_contour(lines({{1, 30}, {-5, 10}, {-20, 20}}), words(kLayers), moves);
  CHECK(outcome.end == ContourEnd::kDone);
  CHECK(moves.all.back().end == PlanePoint{-20, 30});
}

TEST_CASE("a move that is refused ends the cut") {
  Recorded moves;
  moves.feeds = false;
  const ContourOutcome outcome = cut_contour(lines({{1, 30}, {-5, 10}, {-20, 20}}), words(kLayers), moves);
  CHECK(outcome.end == ContourEnd::kRefused);
}

TEST_CASE("contours that are not cut") {
  CHECK(said(lines({{1, 30}, {-5, 10}, {-3, 12}, {-20, 20}}), words(kLayers)) == "G7X error: Not monotonic");
  CHECK(said(lines({{1, 30}, {-5, 10}, {-4.9991, 12}, {-20, 20}}), words(kLayers)).empty());
  CHECK(said(lines({{3, 10}, {3, 5}, {-2, 5}, {-5, 5}}), words(kLayers)).empty());
  CHECK(said(lines({{3, 10}, {3, 5}, {-2, 5}, {-5, 5}}), words(kLayers, 0.2)) ==
        "G7X error: Cannot intersect parallel lines");
  ContourWords no_depth = words(kLayers);
  no_depth.i = 0;
  CHECK(said(lines({{1, 30}, {-5, 10}, {-20, 20}}), no_depth) == "G7X error: I must be greater than zero.");
}

TEST_CASE("one line is no contour") {
  Recorded moves;
  CHECK(cut_contour(lines({{1, 30}, {-5, 10}}), words(kLayers), moves).end == ContourEnd::kDone);
  CHECK(moves.all.empty());
}

TEST_CASE("a half circle at the end is looked for without end") {
  std::vector<ContourElement> elements = lines({{1, 30}, {0, 30}});
  ContourElement arc;
  arc.kind = ContourElement::Kind::kCounterclockwise;
  arc.start = {0, 30};
  arc.end = {-5, 30};
  arc.center = {-2.5, 30};
  elements.push_back(arc);
  Recorded moves;
  CHECK(cut_contour(elements, words(kLayers), moves).end == ContourEnd::kNeverEnds);
}

}  // namespace owlint
