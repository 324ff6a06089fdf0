#include "limn/drawing/draft.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/drawing/drawing_fixture.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::DrawingSceneTest;
using testing::Path;
using testing::Picture;
using testing::Polar;

class LinkEditsTest : public DrawingSceneTest {};

TEST_P(LinkEditsTest, LineAtAnEndLeavesItsRoundedTipOut) {
  // The last 1.8 px bend away by 45 degrees.
  scene_.AddLink(Path({{-40, 0, 0}, {0, 0, 0}, Polar(0.9, 45), Polar(1.8, 45)}));
  const EndLine line = scene_.LineAt(Polar(1.8, 45));
  EXPECT_NEAR(line.outward.dot(Vector3d::UnitX()), 1, 1e-9);
  // The foot of the tip on the line.
  EXPECT_NEAR((line.point - Vector3d(Polar(1.8, 45).x(), 0, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR(line.footprint / GetParam().footprint, 1, 1e-9);
}

TEST_P(LinkEditsTest, LineAtAnEndIsOfItsLastPixelsOnly) {
  // The link bends 15 px before its end: 12 px follow the 2 px of the tip.
  scene_.AddLink(Path({{-15, -40, 0}, {-15, 0, 0}, {0, 0, 0}}));
  const EndLine line = scene_.LineAt({0, 0, 0});
  EXPECT_NEAR(line.outward.dot(Vector3d::UnitX()), 1, 1e-9);
  EXPECT_NEAR(line.point.norm(), 0, 1e-6);
}

TEST_P(LinkEditsTest, LineAtAnEndAveragesOverTheseTwelvePixels) {
  // Zigzag by 0.2 px: a direction of the last step alone would be off by 22 degrees.
  auto points = Path({{-40, 0, 0}, {0, 0, 0}});
  for (size_t i = 0; i < points.size(); ++i) points[i].y() += i % 2 ? 0.2 : -0.2;
  scene_.AddLink(points);
  const Vector3d outward = scene_.LineAt(points.back()).outward;
  EXPECT_GT(outward.x(), std::cos(2 * M_PI / 180));
}

TEST_P(LinkEditsTest, ShortLinkHasALineToo) {
  scene_.AddLink(Path({{0, 0, 0}, {0, 2, 0}}));
  EXPECT_NEAR(scene_.LineAt({0, 2, 0}).outward.dot(Vector3d::UnitY()), 1, 1e-9);
  EXPECT_NEAR(scene_.LineAt({0, 0, 0}).outward.dot(Vector3d::UnitY()), -1, 1e-9);
}

TEST_P(LinkEditsTest, SplitMakesTwoThatMeet) {
  scene_.AddLink(Path({{-20, 0, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{0, 0, 0}, {0, 40, 0}}));
  scene_.ShareNode({0, 0, 0});
  scene_.Split({0, 30, 0});
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 3);
  EXPECT_EQ(picture.DegreeAt({0, 0, 0}), 2);
  EXPECT_EQ(picture.DegreeAt({0, 30, 0}), 2);
  EXPECT_NEAR(picture.LengthPxAt({0, 10, 0}), 30, 1e-6);
  EXPECT_NEAR(picture.LengthPxAt({0, 35, 0}), 10, 1e-6);
  EXPECT_TRUE(picture.EndsCoincide());
  EXPECT_EQ(picture.NumSamples(), scene_.NumSketchSamples());
  scene_.Assemble();
}

TEST_P(LinkEditsTest, PartsOfAGrownLinkAreGrown) {
  scene_.AddLink(Path({{0, 0, 0}, {40, 0, 0}}), {.grown = true});
  scene_.Split({10, 0, 0});
  const Picture picture = scene_.Look();
  ASSERT_EQ(picture.NumLinks(), 2);
  EXPECT_TRUE(picture.links[0].grown);
  EXPECT_TRUE(picture.links[1].grown);
}

TEST_P(LinkEditsTest, EndThatIsLeftAloneIsFree) {
  for (const double angle : {0, 120, 240}) scene_.AddLink(Path({{0, 0, 0}, Polar(40, angle)}));
  scene_.ShareNode({0, 0, 0});
  scene_.Remove(Polar(30, 120));
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
  scene_.Remove(Polar(30, 0));
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({0, 0, 0}));
}

TEST_P(LinkEditsTest, ArcLengthIsInPixels) {
  scene_.AddLink(Path({{0, 0, 0}, {30, 0, 0}, {30, 10, 0}}));
  const bool backwards = GetParam().even_backwards;
  EXPECT_NEAR(scene_.ArcPxTo({30, 0, 0}), backwards ? 10 : 30, 1e-6);
  EXPECT_NEAR(scene_.ArcPxTo({30, 10, 0}), backwards ? 0 : 40, 1e-6);
}

LIMN_ALL_VARIANTS(LinkEditsTest);

}  // namespace
}  // namespace limn
