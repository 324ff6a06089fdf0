// SPDX-License-Identifier: BSD-3-Clause
#include "limn/tiles/tile_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using ::testing::Le;
using ::testing::SizeIs;

struct Scene {
  std::vector<View> views;
  SceneHints hints;
};

void AddPoints(int count, const Eigen::Vector3d& low, const Eigen::Vector3d& high, Scene* scene) {
  std::mt19937 random(3);
  testing::UniformDistribution<double> share(0, 1);
  while (static_cast<int>(scene->hints.points.size()) < count) {
    Eigen::Vector3d point;
    for (int i = 0; i < 3; ++i) point[i] = low[i] + (high[i] - low[i]) * share(random);
    ScenePoint seen{point, {}};
    for (size_t v = 0; v < scene->views.size(); ++v) {
      if (scene->views[v].Project(point)) seen.views.push_back(static_cast<ViewId>(v));
    }
    if (!seen.views.empty()) scene->hints.points.push_back(std::move(seen));
  }
}

// Along a street; a point is seen by some 8 views.
Scene Street(int num_views) {
  Scene scene;
  for (int i = 0; i < num_views; ++i) {
    const double x = i;
    scene.views.push_back(testing::LookAt({x, -8, 1}, {x, 0, 1}));
  }
  AddPoints(4000, {-3, -1, -1}, {num_views + 3., 1, 3}, &scene);
  return scene;
}

std::vector<Tile> Plan(const Scene& scene, int max_views) {
  TileOptions options;
  options.max_views = max_views;
  options.reach_px = 50;
  return PlanTiles(scene.views, scene.hints, std::nullopt, options);
}

int NumCoresWith(const Eigen::Vector3d& point, const std::vector<Tile>& tiles) {
  int count = 0;
  for (const Tile& tile : tiles) count += tile.core.contains(point);
  return count;
}

TEST(TilePlan, FewViewsAreOneTile) {
  const Scene scene = Street(30);
  const auto tiles = Plan(scene, 30);
  ASSERT_THAT(tiles, SizeIs(1));
  EXPECT_THAT(tiles[0].views, SizeIs(30));
  EXPECT_TRUE(tiles[0].core.contains(Eigen::Vector3d(1e9, -1e9, 1e9)));
  EXPECT_THAT(Plan(scene, 0), SizeIs(1));
}

TEST(TilePlan, CoresFillSpaceAndViewsAreThoseThatSeeThem) {
  const Scene scene = Street(200);
  const auto tiles = Plan(scene, 40);
  // Of 40 views some 10 are of the neighbors, too.
  EXPECT_GE(tiles.size(), 6u);
  EXPECT_LE(tiles.size(), 10u);
  std::set<ViewId> used;
  for (const Tile& tile : tiles) {
    EXPECT_THAT(tile.views, SizeIs(Le(40u)));
    used.insert(tile.views.begin(), tile.views.end());
    for (const ScenePoint& point : scene.hints.points) {
      if (!tile.core.contains(point.position_in_world)) continue;
      EXPECT_TRUE(tile.reach.contains(point.position_in_world));
      EXPECT_TRUE(std::includes(tile.views.begin(), tile.views.end(), point.views.begin(),
                                point.views.end()));
    }
  }
  EXPECT_THAT(used, SizeIs(200));
  for (const ScenePoint& point : scene.hints.points) {
    EXPECT_EQ(NumCoresWith(point.position_in_world, tiles), 1);
  }
  EXPECT_EQ(NumCoresWith({-1e6, 1e6, 0.1}, tiles), 1);
}

// 8 m are 50 px of margin at 600 px focal length: .67 m.
TEST(TilePlan, ReachIsInPixels) {
  const auto tiles = Plan(Street(200), 40);
  for (const Tile& tile : tiles) {
    const double margin = tile.reach.max().x() - tile.core.max().x();
    if (std::isfinite(margin)) {
      EXPECT_NEAR(margin, 50 * 8 / 600., 0.02);
    }
  }
}

TEST(TilePlan, StaysInTheBox) {
  const Scene scene = Street(200);
  TileOptions options;
  options.max_views = 40;
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0, -9, -9), Eigen::Vector3d(190, 9, 9));
  const auto tiles = PlanTiles(scene.views, scene.hints, box, options);
  EXPECT_GE(tiles.size(), 6u);
  for (const Tile& tile : tiles) {
    EXPECT_TRUE(box.contains(tile.reach));
  }
}

TEST(TilePlan, OfViewsOfOnePlaceTheBestAreChosen) {
  Scene scene;
  scene.views = testing::DomeViews(120, 5);
  AddPoints(2000, {-1, -1, -1}, {1, 1, 1}, &scene);
  const auto tiles = Plan(scene, 24);
  for (const Tile& tile : tiles) {
    EXPECT_THAT(tile.views, SizeIs(Le(24u)));
    for (const ScenePoint& point : scene.hints.points) {
      if (!tile.core.contains(point.position_in_world)) continue;
      std::vector<ViewId> seeing;
      std::set_intersection(point.views.begin(), point.views.end(), tile.views.begin(),
                            tile.views.end(), std::back_inserter(seeing));
      EXPECT_GE(seeing.size(), 15u);
    }
  }
}

TEST(TilePlan, WithHardlyAnyPointsThereIsNothingToCutBy) {
  Scene scene = Street(200);
  scene.hints.points.resize(20);
  const auto tiles = Plan(scene, 40);
  ASSERT_THAT(tiles, SizeIs(1));
  EXPECT_THAT(tiles[0].views, SizeIs(200));
}

// Many points in one plane, which is a border of tiles: cutting there again would not end.
TEST(TilePlan, PointsInOnePlaneDoNotMatter) {
  Scene scene = Street(200);
  for (size_t i = 0; i < scene.hints.points.size(); i += 2) {
    scene.hints.points[i].position_in_world.x() = 100;
    scene.hints.points[i].views = {97, 98, 99, 100, 101, 102, 103};
  }
  const auto tiles = Plan(scene, 40);
  EXPECT_GE(tiles.size(), 3u);
  EXPECT_LE(tiles.size(), 20u);
}

// What hardly any view tracks makes no tile of its own.
TEST(TilePlan, ManyPointsOfFewViewsDoNotUnbalanceIt) {
  Scene scene = Street(200);
  const size_t num_near = scene.hints.points.size();
  for (size_t i = 0; i < num_near; ++i) {
    const ScenePoint& near = scene.hints.points[i];
    scene.hints.points.push_back(
        {near.position_in_world + Eigen::Vector3d(0, 900, 0), {near.views.front()}});
  }
  for (const Tile& tile : Plan(scene, 40)) EXPECT_THAT(tile.views, SizeIs(Le(40u)));
}

TEST(TilePlan, RefusesBadOptions) {
  TileOptions options;
  options.max_views = 3;
  EXPECT_THROW(options.Check(), OptionError);
  options = {};
  options.reach_px = 5;
  EXPECT_THROW(options.Check(), OptionError);
}

}  // namespace
}  // namespace limn
