#include "limn/topology/occluding_contours.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/model/view_finder.h"
#include "limn/support/view_edgels.h"
#include "limn/topology/edit_topology.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/graph_fixture.h"
#include "limn/topology/verify_links.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kDistance = 5;
constexpr double kRadius = 1;  // of a ball around the origin: 120 px

// Views from a quarter of a circle around the ball, 5 degrees apart.
std::vector<View> Views() {
  std::vector<View> views;
  for (int i = -9; i <= 9; ++i) views.push_back(testing::RingView(5 * i, kDistance));
  return views;
}

// Where lines of sight from a camera center touch the ball; angle 0 is to the right of the image,
// a quarter turn up.
Eigen::Vector3d RimPoint(const Eigen::Vector3d& center, double angle) {
  const Eigen::Vector3d toward = center.normalized();
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d right = up.cross(toward);
  const double height = kRadius * kRadius / kDistance;
  const double radius = std::sqrt(kRadius * kRadius - height * height);
  return height * toward + radius * (std::cos(angle) * right + std::sin(angle) * up);
}

testing::SceneCurve Rim(const View& view) {
  testing::SceneCurve rim;
  rim.closed = true;
  for (int k = 0; k < 720; ++k) {
    rim.points.push_back(RimPoint(view.CenterInWorld(), 0.5 * k * kDeg));
  }
  return rim;
}

std::optional<double> Confidence(const Polyline3d& points, const std::vector<View>& views,
                                 const std::vector<ImageCurves>& curves) {
  DrawingLink link;
  link.points_in_world = points;
  const auto support = BuildViewEdgels(curves, {});
  const TopologyInput input = {views, curves, support, {1.0, 1.0, 15 * kDeg}};
  return ContourConfidence(input, link, ViewFinder(views).NearAnyOf(points));
}

bool IsContour(const Polyline3d& points, const std::vector<View>& views,
               const std::vector<ImageCurves>& curves) {
  return Confidence(points, views, curves).has_value();
}

// An upright arc on the side of the ball, as the view in the middle sees its outline.
Polyline3d OutlineLink(const std::vector<View>& views) {
  Polyline3d arc;
  for (int k = -20; k <= 20; ++k) {
    arc.push_back(RimPoint(views[views.size() / 2].CenterInWorld(), k * kDeg));
  }
  return arc;
}

TEST(OccludingContourTest, OutlineOfABallIsNoEdge) {
  const auto views = Views();
  std::vector<ImageCurves> curves;
  for (const View& view : views) curves.push_back(testing::ProjectCurves(view, {Rim(view)}));
  EXPECT_TRUE(IsContour(OutlineLink(views), views, curves));
}

// A sketch curve of each of these primary views, which are merged into the link.
CurveSketch SketchOf(const std::vector<ViewId>& primaries, DrawingLink* link) {
  CurveSketch sketch;
  for (const ViewId view : primaries) {
    const auto curve = static_cast<int>(sketch.curves.size());
    sketch.curves.emplace_back();
    sketch.curves.back().anchor.view = view;
    for (int k = 0; k < link->size(); ++k) {
      sketch.curves.back().points_in_world.push_back(link->points_in_world[k]);
      link->vertices[k].samples.push_back({curve, k});
    }
  }
  return sketch;
}

TEST(OccludingContourTest, OutlinesAreKeptAsContoursThatNothingJoins) {
  const auto views = Views();
  std::vector<ImageCurves> curves;
  for (const View& view : views) curves.push_back(testing::ProjectCurves(view, {Rim(view)}));
  const auto support = BuildViewEdgels(curves, {});
  const TopologyInput input = {views, curves, support, {1.0, 1.0, 15 * kDeg}};
  DrawingLink link;
  link.points_in_world = OutlineLink(views);
  link.sigma.assign(link.points_in_world.size(), 0.01);
  for (int k = 0; k < link.size(); ++k) {
    LinkVertex vertex;
    vertex.information = Eigen::Matrix3d::Identity();
    vertex.footprint = kDistance / 600;
    vertex.agreeing_views = 4;
    vertex.support = {{9, 0}};
    link.vertices.push_back(vertex);
  }
  const CurveSketch sketch = SketchOf({8, 9, 10}, &link);
  DrawingGraph graph;
  GraphEditor(&graph).Add(link);
  const LinkVerdicts verdicts = VerifyLinks(input, sketch, {}, graph, {});
  EXPECT_EQ(verdicts.verdicts, std::vector<uint8_t>{kIsContour});
  EXPECT_EQ(verdicts.contour_confidence,
            std::vector<double>{Confidence(link.points_in_world, views, curves).value()});
  SampleFates fates;
  for (const Curve3D& curve : sketch.curves) fates.emplace_back(curve.size(), EdgelFate::kDrawn);
  const CompletionCounts counts = CompleteDrawing(input, sketch, {}, {}, &graph, &fates);
  testing::ExpectValid(graph);
  ASSERT_EQ(graph.links.size(), 1u);
  EXPECT_EQ(graph.links[0].kind, LinkKind::kContour);
  EXPECT_EQ(graph.links[0].kind_confidence, verdicts.contour_confidence[0]);
  EXPECT_EQ(counts.samples_doubtful, 0);
  for (const std::vector<EdgelFate>& of_curve : fates) {
    for (const EdgelFate fate : of_curve) EXPECT_EQ(fate, EdgelFate::kDrawn);
  }
}

TEST(OccludingContourTest, AnEdgeInTheSamePlaceIsOne) {
  const auto views = Views();
  const testing::SceneCurve edge{OutlineLink(views), false};
  const auto curves = testing::ProjectCurves(views, {edge});
  EXPECT_FALSE(IsContour(OutlineLink(views), views, curves));
}

TEST(OccludingContourTest, AnEdgeSeenByFewViewsIsOne) {
  const auto views = Views();
  const testing::SceneCurve edge{OutlineLink(views), false};
  auto curves = testing::ProjectCurves(views, {edge});
  for (size_t v = 0; v < views.size(); ++v) {
    if (v + 2 < views.size() / 2 || v > views.size() / 2 + 2) curves[v] = {};
  }
  EXPECT_FALSE(IsContour(OutlineLink(views), views, curves));
}

// An upright edge that some of the views show in its place. Others show one that is moved to the
// right in their image by so many px, or nothing.
class MovedEdge {
 public:
  MovedEdge() : views_(Views()), line_(OutlineLink(views_)) {}

  size_t NumViews() const { return views_.size(); }
  void ShowInPlace(size_t view) { Show(view, 0, false); }
  void ShowMoved(size_t view, double px, bool dark_is_bright = false) {
    Show(view, px, dark_is_bright);
  }
  bool IsTakenForAContour() const { return ConfidenceOfContour().has_value(); }
  std::optional<double> ConfidenceOfContour() const {
    std::vector<ImageCurves> curves;
    for (size_t v = 0; v < views_.size(); ++v) {
      curves.push_back(testing::ProjectCurves(views_[v], shown_[v]));
    }
    return Confidence(line_, views_, curves);
  }

 private:
  void Show(size_t view, double px, bool reversed) {
    const Eigen::Vector3d right =
        views_[view].cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitX();
    testing::SceneCurve edge;
    for (const Eigen::Vector3d& point : line_) {
      edge.points.push_back(point + px * kDistance / 600 * right);
    }
    if (reversed) std::reverse(edge.points.begin(), edge.points.end());
    shown_[view] = {edge};
  }

  std::vector<View> views_;
  Polyline3d line_;
  std::vector<std::vector<testing::SceneCurve>> shown_ =
      std::vector<std::vector<testing::SceneCurve>>(Views().size());
};

// The five views in the middle of nineteen.
bool InTheMiddle(size_t view) { return view >= 7 && view <= 11; }

TEST(OccludingContourTest, NarrowSupportAndMovedToOneSideIsAnOutline) {
  for (const double px : {4.0, -4.0}) {
    MovedEdge edge;
    for (size_t v = 0; v < edge.NumViews(); ++v) {
      InTheMiddle(v) ? edge.ShowInPlace(v) : edge.ShowMoved(v, px);
    }
    EXPECT_TRUE(edge.IsTakenForAContour());
  }
}

TEST(OccludingContourTest, MovedToOneSideButSupportedWidelyIsAnEdge) {
  MovedEdge edge;
  for (size_t v = 0; v < edge.NumViews(); ++v)
    v % 3 == 0 ? edge.ShowInPlace(v) : edge.ShowMoved(v, 4);
  EXPECT_FALSE(edge.IsTakenForAContour());
}

TEST(OccludingContourTest, SupportedNarrowlyButMovedToBothSidesIsAnEdge) {
  MovedEdge edge;
  for (size_t v = 0; v < edge.NumViews(); ++v) {
    InTheMiddle(v) ? edge.ShowInPlace(v) : edge.ShowMoved(v, v < 7 ? 4 : -4);
  }
  EXPECT_FALSE(edge.IsTakenForAContour());
}

TEST(OccludingContourTest, HalfOfTheViewsBesideMustShowItMoved) {
  // Of the views beside, every third.
  MovedEdge edge;
  for (size_t v = 0; v < edge.NumViews(); ++v) {
    if (InTheMiddle(v)) edge.ShowInPlace(v);
    if (!InTheMiddle(v) && v % 3 == 0) edge.ShowMoved(v, 4);
  }
  EXPECT_FALSE(edge.IsTakenForAContour());
}

TEST(OccludingContourTest, ConfidenceIsTheShareOfViewsBesideThatShowItMoved) {
  for (const size_t num_without : {0, 2}) {
    MovedEdge edge;
    for (size_t v = 0; v < edge.NumViews(); ++v) {
      if (InTheMiddle(v)) edge.ShowInPlace(v);
      // Eight views are within 20 degrees of those in the middle, the outermost just so.
      if (!InTheMiddle(v) && v >= 3 + num_without) edge.ShowMoved(v, 4);
    }
    // Half of those without an outline would show it on this side.
    const double num_same_side = 8 - 0.5 * static_cast<double>(num_without);
    EXPECT_NEAR(edge.ConfidenceOfContour().value(), (num_same_side + 1) / 10, 0.03);
  }
}

TEST(OccludingContourTest, MovedEdgeHasTheSameBrighterSide) {
  MovedEdge edge;
  for (size_t v = 0; v < edge.NumViews(); ++v) {
    InTheMiddle(v) ? edge.ShowInPlace(v) : edge.ShowMoved(v, 4, /*dark_is_bright=*/true);
  }
  EXPECT_FALSE(edge.IsTakenForAContour());
}

TEST(OccludingContourTest, ItMovesByAFewPixelsOnly) {
  MovedEdge edge;
  for (size_t v = 0; v < edge.NumViews(); ++v) {
    InTheMiddle(v) ? edge.ShowInPlace(v) : edge.ShowMoved(v, 14);
  }
  EXPECT_FALSE(edge.IsTakenForAContour());
}

}  // namespace
}  // namespace limn
