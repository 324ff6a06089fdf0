#include "limn/drawing/occluding_contours.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/model/view_finder.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
constexpr double kDistance = 5;
constexpr double kRadius = 1;  // of a ball around the origin: 120 px

// Views from a quarter of a circle around the ball, 5 degrees apart.
std::vector<View> Views() {
  std::vector<View> views;
  for (int i = -9; i <= 9; ++i) {
    const double azimuth = 5 * i * kDeg;
    views.push_back(testing::LookAt(
        {kDistance * std::cos(azimuth), kDistance * std::sin(azimuth), 0}, {0, 0, 0}));
  }
  return views;
}

// Where lines of sight from a camera centre touch the ball; angle 0 is to the right of the image,
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

DraftLink LinkThrough(const Polyline3d& points) {
  DraftLink link;
  for (const Eigen::Vector3d& point : points) {
    link.position.push_back(point);
    link.information.push_back(Eigen::Matrix3d::Identity());
    link.footprint.push_back(kDistance / 600);
    link.samples.emplace_back();
  }
  return link;
}

bool IsContour(const DraftLink& link, const std::vector<View>& views,
               const std::vector<ImageCurves>& curves) {
  const SupportGate gate = DrawingOptions().Gate();
  return IsOccludingContour(link, ViewFinder(views).NearAnyOf(link.position), views, curves,
                            BuildEvidence(curves, {}), gate);
}

// An upright arc on the side of the ball, as the view in the middle sees its outline.
DraftLink OutlineLink(const std::vector<View>& views) {
  Polyline3d arc;
  for (int k = -20; k <= 20; ++k) {
    arc.push_back(RimPoint(views[views.size() / 2].CenterInWorld(), k * kDeg));
  }
  return LinkThrough(arc);
}

TEST(OccludingContourTest, OutlineOfABallIsNoEdge) {
  const auto views = Views();
  std::vector<ImageCurves> curves;
  for (const View& view : views) curves.push_back(testing::ProjectCurves(view, {Rim(view)}));
  EXPECT_TRUE(IsContour(OutlineLink(views), views, curves));
}

TEST(OccludingContourTest, AnEdgeInTheSamePlaceIsOne) {
  const auto views = Views();
  const testing::SceneCurve edge{OutlineLink(views).position, false};
  const auto curves = testing::ProjectCurves(views, {edge});
  EXPECT_FALSE(IsContour(OutlineLink(views), views, curves));
}

TEST(OccludingContourTest, AnEdgeSeenByFewViewsIsOne) {
  const auto views = Views();
  const testing::SceneCurve edge{OutlineLink(views).position, false};
  auto curves = testing::ProjectCurves(views, {edge});
  for (size_t v = 0; v < views.size(); ++v) {
    if (v + 2 < views.size() / 2 || v > views.size() / 2 + 2) curves[v] = {};
  }
  EXPECT_FALSE(IsContour(OutlineLink(views), views, curves));
}

}  // namespace
}  // namespace limn
