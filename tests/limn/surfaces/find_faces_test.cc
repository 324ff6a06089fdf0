// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/find_faces.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limn/belief/belief_scene.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using testing::BeliefScene;
using testing::FrontalPoint;
using testing::kFrontalPx;
using testing::Segment;

constexpr double kHalf = 60 * kFrontalPx;

Eigen::Vector3d SquareCorner(int k, double z) {
  return {k % 4 == 0 || k % 4 == 3 ? -kHalf : kHalf, k % 4 < 2 ? -kHalf : kHalf, z};
}

// Sixteen views from above of a square, whose side `k` view `v` shows if shows(v, k).
template <typename Shows>
BeliefScene SquareScene(double z, Shows&& shows) {
  BeliefScene scene;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d from = SquareCorner(k, z), to = SquareCorner(k + 1, z);
    scene.Draw({from, to});
    for (size_t v = 0; v < scene.views.size(); ++v) {
      if (shows(v, k)) scene.shown[v].push_back(Segment(from, to));
    }
  }
  return scene;
}
BeliefScene SquareScene(double z) {
  return SquareScene(z, [](size_t, int) { return true; });
}

SurfaceResult FacesOf(const BeliefScene& scene, const std::vector<ScenePoint>& points = {},
                      int num_threads = 1) {
  RunContext context;
  context.num_threads = num_threads;
  const std::vector<ImageCurves> curves = scene.Curves();
  SurfaceResult result =
      FindFaces({scene.views, curves, {points}}, testing::kShowingGate, scene.graph, {}, context);
  testing::ExpectValid(result.graph);
  return result;
}
size_t NumFaces(const BeliefScene& scene, const std::vector<ScenePoint>& points = {}) {
  return FacesOf(scene, points).graph.faces.size();
}

TEST(FindFaces, ASquareInSight) {
  const BeliefScene scene = SquareScene(1);
  const SurfaceResult result = FacesOf(scene);
  ASSERT_EQ(result.graph.faces.size(), 1u);
  const DrawingFace& face = result.graph.faces[0];
  EXPECT_NEAR(AreaOf(face), 4 * kHalf * kHalf, 1e-9);
  EXPECT_NEAR(face.normal.z(), 1, 1e-9);  // towards the views
  EXPECT_NEAR(face.offset, 1, 1e-9);
  EXPECT_EQ(face.views.size(), 16u);
  EXPECT_GT(face.confidence, 0.8);
  for (const auto& [a, b, c] : face.triangles) {
    EXPECT_GT((face.vertices[b] - face.vertices[a])
                  .cross(face.vertices[c] - face.vertices[a])
                  .dot(face.normal),
              0);
  }
  EXPECT_EQ(result.graph.links.size(), scene.graph.links.size());
}

// Over the square between bows that rise on all sides.
BeliefScene DomeScene(double shown_share) {
  BeliefScene scene;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d from = SquareCorner(k, 0.5), to = SquareCorner(k + 1, 0.5);
    Polyline3d bow;
    for (int i = 0; i <= 20; ++i) {
      const double t = i / 20.0;
      bow.push_back(from + t * (to - from));
      bow.back().z() += 0.6 * kHalf * t * (1 - t);
    }
    scene.Draw(bow);
    const int num_shown = static_cast<int>(shown_share * 20);
    for (int i = 0; i < num_shown; ++i) scene.Show(Segment(bow[i], bow[i + 1]));
  }
  return scene;
}

TEST(FindFaces, APatchMustBeSeenWhole) {
  const SurfaceResult result = FacesOf(DomeScene(1));
  ASSERT_EQ(result.graph.faces.size(), 1u);
  EXPECT_EQ(result.graph.faces[0].surface, FaceSurface::kPatch);
  EXPECT_EQ(result.graph.faces[0].views.size(), 16u);
  EXPECT_EQ(NumFaces(DomeScene(0.6)), 0u);
}

// Of a section of a solid each view shows the near half of the border.
TEST(FindFaces, NoViewShowsMoreThanHalfOfTheBorder) {
  EXPECT_EQ(NumFaces(SquareScene(1, [](size_t v, int k) { return v % 2 == 0 ? k < 2 : k >= 2; })),
            0u);
  EXPECT_EQ(NumFaces(SquareScene(1, [](size_t v, int k) { return k < 3 || v % 2 == 0; })), 1u);
}

// A line behind the square, in the views that show it from one side of the square to the other, or
// as far as the square does not hide it.
void AddLineBehind(bool is_hidden, BeliefScene* scene) {
  const Eigen::Vector3d left = FrontalPoint(-140, 5), right = FrontalPoint(140, 5);
  scene->Draw({left, right});
  for (size_t v = 0; v < scene->views.size(); ++v) {
    if (!is_hidden) {
      scene->shown[v].push_back(Segment(left, right));
      continue;
    }
    const double eye = scene->views[v].CenterInWorld().x();
    const auto shadow = [&](double x) {  // on z = 0 of a place at z = 1
      return Eigen::Vector3d(eye + (x - eye) * 5 / 4, left.y(), 0);
    };
    scene->shown[v].push_back(Segment(left, shadow(-kHalf)));
    scene->shown[v].push_back(Segment(shadow(kHalf), right));
  }
}

TEST(FindFaces, CurvesBehindAreHiddenOrSeenThrough) {
  for (const bool is_hidden : {true, false}) {
    BeliefScene scene = SquareScene(1);
    AddLineBehind(is_hidden, &scene);
    EXPECT_EQ(NumFaces(scene), is_hidden ? 1u : 0u);
  }
}

TEST(FindFaces, PointsSeenThroughIt) {
  const BeliefScene scene = SquareScene(1);
  std::vector<ViewId> all;
  for (ViewId v = 0; v < 16; ++v) all.push_back(v);
  const auto points = [&](double z, double x) {
    std::vector<ScenePoint> made;
    for (int i = 0; i < 4; ++i) made.push_back({{x, 0.1 * i, z}, all});
    return made;
  };
  EXPECT_EQ(NumFaces(scene, points(0, 0)), 0u);
  EXPECT_EQ(NumFaces(scene, points(2, 0)), 1u);          // in front
  EXPECT_EQ(NumFaces(scene, points(1, 0)), 1u);          // on it
  EXPECT_EQ(NumFaces(scene, points(0, 3 * kHalf)), 1u);  // beside it
}

// A link behind the square that views claim to see, too few and unlike the others to matter.
TEST(FindFaces, LinksBehindFacesAreTold) {
  BeliefScene scene = SquareScene(1);
  std::vector<ViewId> all;
  for (ViewId v = 0; v < 16; ++v) all.push_back(v);
  for (DrawingLink& link : scene.graph.links) link.supporting_views = all;
  const LinkId behind =
      testing::DrawLink({FrontalPoint(-20, 0), FrontalPoint(20, 0)}, all, &scene.graph);
  testing::DrawLink({FrontalPoint(120, 0), FrontalPoint(160, 0)}, all, &scene.graph);
  const SurfaceResult result = FacesOf(scene);
  ASSERT_EQ(result.graph.faces.size(), 1u);
  EXPECT_EQ(result.links_behind, std::vector<LinkId>{behind});
}

TEST(FindFaces, TheSameWithAnyNumberOfThreads) {
  BeliefScene scene = SquareScene(1);
  AddLineBehind(true, &scene);
  const DrawingGraph one = FacesOf(scene, {}, 1).graph;
  const DrawingGraph four = FacesOf(scene, {}, 4).graph;
  ASSERT_EQ(one.faces.size(), four.faces.size());
  EXPECT_EQ(one.faces[0].vertices, four.faces[0].vertices);
  EXPECT_EQ(one.faces[0].confidence, four.faces[0].confidence);
}

TEST(FindFaces, EarlierFacesAreReplacedAndBadOptionsRefused) {
  BeliefScene scene = SquareScene(1, [](size_t, int) { return false; });
  scene.graph.faces.resize(1);
  scene.graph.faces[0].loops = {{FaceEdge{0, 0, 1, {}}}};
  EXPECT_EQ(NumFaces(scene), 0u);
  SurfaceOptions options;
  options.min_views = 0;
  const std::vector<ImageCurves> curves = scene.Curves();
  EXPECT_THROW(FindFaces({scene.views, curves}, testing::kShowingGate, scene.graph, options, {}),
               OptionError);
}

TEST(FindFaces, NothingToLookAt) {
  for (const bool has_links : {true, false}) {
    const DrawingGraph graph = has_links ? SquareScene(1).graph : DrawingGraph();
    const SurfaceResult result = FindFaces({{}, {}}, testing::kShowingGate, graph, {}, {});
    EXPECT_TRUE(result.graph.faces.empty());
    EXPECT_EQ(result.graph.links.size(), graph.links.size());
  }
}

TEST(FindFaces, OneViewIsNotEnough) {
  BeliefScene scene = SquareScene(1);
  scene.views.resize(1);
  scene.shown.resize(1);
  EXPECT_EQ(NumFaces(scene), 0u);
}

}  // namespace
}  // namespace limn
