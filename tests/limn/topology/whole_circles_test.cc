// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/whole_circles.h"

#include <cmath>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::FrontalScene;
using testing::PxLine;
using testing::Ray;
using testing::Unit;

constexpr double kRadiusPx = 12;

using Radius = std::function<double(double angle_rad)>;

// A curve around the origin between two angles.
PxLine Around(const Radius& radius_px, double from_rad, double to_rad) {
  PxLine line;
  const int count = static_cast<int>(std::ceil(50 * (to_rad - from_rad)));
  for (int k = 0; k <= count; ++k) {
    const double angle = from_rad + (to_rad - from_rad) * k / count;
    line.push_back(radius_px(angle) * Unit(angle));
  }
  return line;
}
PxLine Arc(double from_rad, double to_rad, double radius_px = kRadiusPx) {
  return Around([&](double) { return radius_px; }, from_rad, to_rad);
}
PxLine Ring(double radius_px = kRadiusPx) {
  PxLine ring = Arc(0, 2 * M_PI, radius_px);
  ring.back() = ring.front();
  return ring;
}

CircleCounts Complete(FrontalScene* scene) {
  return scene->Run([](const auto& input, GraphEditor* editor) {
    return CompleteCircles(input, RunContext(), editor);
  });
}

void ExpectRing(const FrontalScene& scene, double radius_px) {
  ASSERT_EQ(scene.graph.links.size(), 1u);
  const DrawingLink& link = scene.graph.links[0];
  EXPECT_TRUE(link.closed);
  for (const Eigen::Vector3d& point : link.points_in_world) {
    EXPECT_NEAR((point - testing::FrontalPoint(0, 0)).norm(), radius_px * testing::kFrontalPx,
                0.05 * testing::kFrontalPx);
  }
}

TEST(CompleteCirclesTest, ArcsBecomeOneClosedLink) {
  FrontalScene scene;
  scene.Show(Ring());
  scene.Draw(Arc(0, 2.5));
  scene.Draw(Arc(3, 5.5));
  const CircleCounts counts = Complete(&scene);
  EXPECT_EQ(counts.added, 1);
  EXPECT_EQ(counts.replaced, 2);
  ExpectRing(scene, kRadiusPx);
  EXPECT_EQ(scene.graph.links[0].supporting_views.size(), scene.views().size());
  EXPECT_EQ(Complete(&scene).added, 0);
}

// Bolt holes are drawn as polygons at first.
TEST(CompleteCirclesTest, ChordsOfASmallOneToo) {
  constexpr double kHolePx = 4;
  FrontalScene scene;
  scene.Show(Ring(kHolePx));
  for (int side = 0; side < 5; ++side) {
    scene.Draw({kHolePx * Unit(0.4 * M_PI * side), kHolePx * Unit(0.4 * M_PI * (side + 1))});
  }
  const CircleCounts counts = Complete(&scene);
  EXPECT_EQ(counts.added, 1);
  EXPECT_EQ(counts.replaced, 5);
  ExpectRing(scene, kHolePx);
}

TEST(CompleteCirclesTest, PolygonsAndWhatIsNotRoundStay) {
  FrontalScene hexagon;
  for (int side = 0; side < 6; ++side) {
    hexagon.ShowAndDraw(
        {kRadiusPx * Unit(M_PI / 3 * side), kRadiusPx * Unit(M_PI / 3 * (side + 1))});
  }
  EXPECT_EQ(Complete(&hexagon).added, 0);

  const auto added = [](double off_px) {
    const Radius radius_px = [&](double angle) { return 8 + off_px * std::cos(4 * angle); };
    FrontalScene scene;
    scene.Show(Around(radius_px, 0, 2 * M_PI));
    scene.Draw(Around(radius_px, 0, 2.5));
    scene.Draw(Around(radius_px, 3, 5.5));
    return Complete(&scene).added;
  };
  EXPECT_EQ(added(0.3), 1);
  EXPECT_EQ(added(0.5), 0);
}

TEST(CompleteCirclesTest, ImagesShowTheRest) {
  const auto added = [](double shown_rad) {
    FrontalScene scene;
    scene.Show(Arc(0, shown_rad));
    scene.Draw(Arc(0, 3.5));
    return Complete(&scene).added;
  };
  EXPECT_EQ(added(5.6), 1);
  EXPECT_EQ(added(5.2), 0);  // a gap of 62 degrees
  EXPECT_EQ(added(3.5), 0);
}

TEST(CompleteCirclesTest, ThreeViewsShowIt) {
  const auto added = [](ViewId num_views) {
    FrontalScene scene;
    scene.Show(Ring(), scene.Views(0, num_views));
    scene.Draw(Arc(0, 5), scene.Views(0, num_views));
    return Complete(&scene).added;
  };
  EXPECT_EQ(added(2), 0);
  EXPECT_EQ(added(3), 1);
}

TEST(CompleteCirclesTest, EnoughOfItIsDrawn) {
  const auto added = [](double drawn_rad) {
    FrontalScene scene;
    scene.Show(Ring());
    scene.Draw(Arc(0, drawn_rad));
    return Complete(&scene).added;
  };
  EXPECT_EQ(added(2.0), 0);
  EXPECT_EQ(added(2.8), 1);
}

TEST(CompleteCirclesTest, LinksThatEndOnItStayThere) {
  FrontalScene scene;
  scene.Show(Ring());
  scene.Draw(Arc(0, 2));
  scene.Draw(Arc(2, 5));
  scene.ShowAndDraw({kRadiusPx * Unit(2), 40 * Unit(2)});
  scene.ShowAndDraw({kRadiusPx * Unit(5), 40 * Unit(5)});
  const CircleCounts counts = Complete(&scene);
  EXPECT_EQ(counts.added, 1);
  EXPECT_EQ(counts.replaced, 2);
  ASSERT_EQ(scene.graph.links.size(), 4u);  // two arcs and two spokes
  for (const double angle : {2.0, 5.0}) {
    const Eigen::Vector2d place = kRadiusPx * Unit(angle);
    EXPECT_EQ(scene.Degree(place.x(), place.y(), 0.6), 3);
  }
  EXPECT_NEAR(scene.TotalPx(), 2 * M_PI * kRadiusPx + 2 * (40 - kRadiusPx), 1);
}

// Of a link that runs along the circle and leaves it, the rest remains, with a free end.
TEST(CompleteCirclesTest, TailsStay) {
  FrontalScene scene;
  scene.Show(Ring());
  scene.Draw(Arc(3.4, 5.8));
  PxLine link = Arc(0, 3);
  const PxLine tail = Ray(link.back(), 3 + M_PI / 2, 40);
  scene.Show(tail);
  link.push_back(tail.back());
  scene.Draw(link);
  const CircleCounts counts = Complete(&scene);
  EXPECT_EQ(counts.added, 1);
  EXPECT_EQ(counts.replaced, 1);
  ASSERT_EQ(scene.graph.links.size(), 2u);
  EXPECT_FALSE(scene.graph.links[0].closed);
  EXPECT_NEAR(scene.LengthPx(0), 40, 9);
  EXPECT_TRUE(scene.graph.links[1].closed);
  EXPECT_NEAR(scene.LengthPx(1), 2 * M_PI * kRadiusPx, 0.5);
}

TEST(CompleteCirclesTest, LoopsAndFrozenLinksAreLeftAlone) {
  FrontalScene loop;
  loop.ShowAndDraw(Ring());
  EXPECT_EQ(Complete(&loop).added, 0);
  FrontalScene frozen;
  frozen.Show(Ring());
  frozen.Draw(Arc(0, 4));
  frozen.Freeze(0);
  EXPECT_EQ(Complete(&frozen).added, 0);
}

}  // namespace
}  // namespace limn
