// SPDX-License-Identifier: BSD-3-Clause
// A solid whose edges, as detectors find them, end before its corners: the drawing closes them.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "limn/cache/result_cache.h"
#include "limn/formats/temporary_folder.h"
#include "limn/pipeline/drawing_stages.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

const double kGolden = 0.5 * (1 + std::sqrt(5.0));
// Of the cube of the corners (1, 1, 1) and so on.
constexpr double kHalfSide = 0.5;

// (0, +-a, +-b) and its cyclic permutations.
std::vector<Vector3d> Permuted(double a, double b) {
  std::vector<Vector3d> points;
  for (const double y : {-a, a}) {
    for (const double z : {-b, b}) {
      for (const Vector3d& point : {Vector3d(0, y, z), Vector3d(y, z, 0), Vector3d(z, 0, y)}) {
        points.push_back(point);
      }
    }
  }
  return points;
}

struct SolidEdge {
  Vector3d from, to;
  std::vector<Vector3d> normals;  // of its two faces
};

std::vector<Vector3d> CornersOfSolid() {
  std::vector<Vector3d> corners = Permuted(1 / kGolden, kGolden);
  for (const Vector3d& corner : testing::CubeCorners(1)) corners.push_back(corner);
  for (Vector3d& corner : corners) corner *= kHalfSide;
  return corners;
}

std::vector<SolidEdge> EdgesOfSolid() {
  const std::vector<Vector3d> corners = CornersOfSolid();
  std::vector<SolidEdge> edges;
  for (size_t i = 0; i < corners.size(); ++i) {
    for (size_t j = i + 1; j < corners.size(); ++j) {
      if ((corners[i] - corners[j]).norm() > 1.01 * kHalfSide * 2 / kGolden) continue;
      SolidEdge edge = {corners[i], corners[j], {}};
      for (const Vector3d& normal : Permuted(kGolden, 1)) {
        const auto height = [&](const Vector3d& point) { return point.dot(normal); };
        const double top = height(*std::ranges::max_element(corners, {}, height));
        if (std::min(height(corners[i]), height(corners[j])) > top - 1e-9) {
          edge.normals.push_back(normal.normalized());
        }
      }
      edges.push_back(edge);
    }
  }
  return edges;
}

// What a view sees of the edges; they end so far before the corners, px.
std::vector<testing::SceneCurve> SeenBy(const View& view, double gap_px) {
  const Vector3d eye = view.CenterInWorld();
  std::vector<testing::SceneCurve> seen;
  for (const SolidEdge& edge : EdgesOfSolid()) {
    const bool is_seen = std::ranges::any_of(
        edge.normals, [&](const Vector3d& normal) { return normal.dot(eye - edge.from) > 0; });
    if (!is_seen) continue;
    const double length_px = (*view.Project(edge.to) - *view.Project(edge.from)).norm();
    const Vector3d gap = (edge.to - edge.from) * std::min(0.3, gap_px / length_px);
    seen.push_back(testing::Segment(edge.from + gap, edge.to - gap));
  }
  return seen;
}

TEST(DodecahedronTest, IsClosed) {
  ASSERT_EQ(CornersOfSolid().size(), 20u);
  ASSERT_EQ(EdgesOfSolid().size(), 30u);
  for (const SolidEdge& edge : EdgesOfSolid()) ASSERT_EQ(edge.normals.size(), 2u);
  std::vector<View> views = testing::DomeViews(24, 5);
  // From below, too: otherwise no view sees the edges there.
  for (View view : testing::DomeViews(24, 5)) {
    const Vector3d eye = view.CenterInWorld();
    views.push_back(testing::LookAt({eye.x(), eye.y(), -eye.z()}, Vector3d::Zero()));
  }
  std::vector<ImageCurves> curves;
  unsigned seed = 0;
  for (const View& view : views) {
    curves.push_back(testing::ProjectCurves(view, SeenBy(view, 2.5), 0.15, ++seed));
  }
  const auto ignore = [](const StageSummary&) {};
  const PipelineOptions options;
  const TemporaryFolder folder;
  ResultCache cache(folder.Path("cache"));
  const DrawnCurves drawn = DrawCurves({views, curves}, options, &cache, {}, ignore);
  const DrawingGraph graph =
      RefineAndJudge({{views, curves}, drawn.drawing.graph}, options, {}, ignore);
  EXPECT_EQ(graph.links.size(), 30u);
  ASSERT_EQ(graph.nodes.size(), 20u);
  const double footprint = 5.0 / 600;
  for (const Vector3d& corner : CornersOfSolid()) {
    const auto distance = [&](const DrawingNode& node) {
      return (node.position_in_world - corner).norm();
    };
    const DrawingNode& nearest = *std::ranges::min_element(graph.nodes, {}, distance);
    EXPECT_EQ(nearest.Degree(), 3);
    EXPECT_LT(distance(nearest), 0.5 * footprint);
  }
}

}  // namespace
}  // namespace limn
