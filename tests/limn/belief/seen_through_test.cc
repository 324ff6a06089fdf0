// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/seen_through.h"

#include <gtest/gtest.h>

#include "limn/belief/belief_scene.h"

namespace limn {
namespace {

using testing::BeliefScene;
using testing::FrontalPoint;
using testing::Segment;

constexpr double kSureEvidence = 10;
const Eigen::Vector3d kFarBegin = FrontalPoint(-60, 0);
const Eigen::Vector3d kFarEnd = FrontalPoint(60, 0);

// Crosses the far link at x = 0 when seen from above.
Polyline3d Near(double height) {
  return {Eigen::Vector3d(0, -0.3, height), Eigen::Vector3d(0, 0.3, height)};
}

std::vector<int> ViewsThrough(const BeliefScene& scene) {
  const std::vector<ImageCurves> curves = scene.Curves();
  const auto edgels = BuildViewEdgels(curves, {});
  return CountViewsThrough(scene.Input(curves, edgels), scene.Evidence(), kSureEvidence, {});
}

using Views = std::vector<int>;

TEST(CountViewsThroughTest, ALinkThatIsNotThere) {
  BeliefScene scene;
  scene.Add(kFarBegin, kFarEnd);
  scene.Draw(Near(1));
  EXPECT_EQ(ViewsThrough(scene), (Views{0, 16}));
}

TEST(CountViewsThroughTest, AThinBarShowsItself) {
  BeliefScene scene;
  scene.Add(kFarBegin, kFarEnd);
  scene.Add(Near(1).front(), Near(1).back());
  EXPECT_EQ(ViewsThrough(scene), (Views{0, 0}));
}

TEST(CountViewsThroughTest, ABorderHidesWhatIsBehindIt) {
  BeliefScene scene;
  for (size_t v = 0; v < scene.views.size(); ++v) {
    // Seen from the view at x, a point of height 1 above x = 0 is before -x / 4 of the plane.
    const double crossing = -scene.views[v].CenterInWorld().x() / 4;
    scene.shown[v].push_back(Segment(kFarBegin, {crossing, 0, 0}));
  }
  scene.Draw({kFarBegin, kFarEnd});
  scene.Draw(Near(1));
  EXPECT_EQ(ViewsThrough(scene), (Views{0, 0}));
}

TEST(CountViewsThroughTest, LinksOnOneSurface) {
  BeliefScene scene;
  scene.Add(kFarBegin, kFarEnd);
  scene.Draw(Near(0));
  // Less than 60 footprints of about 1 / 128 apart.
  scene.Draw(Near(0.3));
  EXPECT_EQ(ViewsThrough(scene), (Views{0, 0, 0}));
}

TEST(CountViewsThroughTest, OnlySureLinksContradict) {
  BeliefScene scene;
  scene.Add(kFarBegin, kFarEnd, 2);
  scene.Draw(Near(1));
  ASSERT_LT(scene.Evidence()[0].evidence, kSureEvidence);
  EXPECT_EQ(ViewsThrough(scene), (Views{0, 0}));
}

TEST(CountViewsThroughTest, OnlyViewsThatShowTheFarLink) {
  BeliefScene scene;
  scene.Add(kFarBegin, kFarEnd, 9);
  scene.Draw(Near(1));
  ASSERT_GE(scene.Evidence()[0].evidence, kSureEvidence);
  EXPECT_EQ(ViewsThrough(scene), (Views{0, 9}));
}

}  // namespace
}  // namespace limn
