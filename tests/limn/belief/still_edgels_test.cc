// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/still_edgels.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "limn/belief/belief_scene.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using testing::BeliefScene;
using testing::FrontalPoint;
using testing::Segment;

// A scene that shows an edge at one place in space, and one at the same pixels in `num_views`.
struct StillScene : BeliefScene {
  explicit StillScene(size_t num_views) {
    Add(FrontalPoint(-50, 40), FrontalPoint(50, 60));
    for (size_t v = 0; v < num_views; ++v) {
      const Eigen::Vector3d center = views[v].CenterInWorld();
      const Eigen::Vector3d below(center.x(), center.y(), 0);
      shown[v].push_back(Segment(below + FrontalPoint(-30, -60), below + FrontalPoint(40, -80)));
    }
  }
};

// The share of the edgels of a view's fragment that stand still.
double ShareOfFragment(const StillEdgels& still, const std::vector<ImageCurves>& curves,
                       size_t view, size_t fragment) {
  const auto& ids = curves[view].fragments[fragment].edgel_ids;
  const auto num_still =
      std::ranges::count_if(ids, [&](EdgelId id) { return still[view][id] != 0; });
  return static_cast<double>(num_still) / static_cast<double>(ids.size());
}

TEST(StillEdgelsTest, WhatStaysAtItsPixelsIsFoundAndWhatMovesIsNot) {
  const StillScene scene(8);
  const std::vector<ImageCurves> curves = scene.Curves(/*noise_px=*/0.2);
  const StillEdgels still = FindStillEdgels(scene.views, curves, scene.graph);
  for (size_t v = 0; v < 8; ++v) {
    EXPECT_LT(ShareOfFragment(still, curves, v, 0), 0.1) << v;
    EXPECT_GT(ShareOfFragment(still, curves, v, 1), 0.8) << v;
  }
  EXPECT_GT(StillShare(still), 0.1);
  EXPECT_LT(StillShare(still), 0.5);
}

TEST(StillEdgelsTest, FiveViewsAreAccidentsAndSoIsOneOfThree) {
  StillScene five_of_eight(5);
  five_of_eight.views.resize(8);
  five_of_eight.shown.resize(8);
  std::vector<ImageCurves> curves = five_of_eight.Curves();
  EXPECT_EQ(StillShare(FindStillEdgels(five_of_eight.views, curves, five_of_eight.graph)), 0);
  const StillScene six_of_sixteen(6);
  curves = six_of_sixteen.Curves();
  EXPECT_EQ(StillShare(FindStillEdgels(six_of_sixteen.views, curves, six_of_sixteen.graph)), 0);
}

// Every view has edgels nearly everywhere, so many of them coincide.
TEST(StillEdgelsTest, DenseEdgesCoincideByChance) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 40), FrontalPoint(50, 60));
  std::mt19937 random(1);
  testing::UniformDistribution<double> jitter_px(-1, 1);
  for (size_t v = 0; v < 16; ++v) {
    const Eigen::Vector3d center = scene.views[v].CenterInWorld();
    const Eigen::Vector3d below(center.x(), center.y(), 0);
    for (int row = -20; row <= 20; ++row) {
      const double y = 4 * row + jitter_px(random);
      scene.shown[v].push_back(Segment(below + FrontalPoint(-80, y), below + FrontalPoint(80, y)));
    }
  }
  EXPECT_LT(StillShare(FindStillEdgels(scene.views, scene.Curves(), scene.graph)), 0.2);
}

TEST(StillEdgelsTest, PartsOfAPanoramaAreComparedPartByPart) {
  StillScene scene(8);
  scene.views.resize(8);
  scene.shown.resize(8);
  std::vector<View> views;
  std::vector<ImageCurves> curves;
  const std::vector<ImageCurves> of_part = scene.Curves();
  for (size_t v = 0; v < 8; ++v) {
    views.insert(views.end(), 2, scene.views[v]);
    curves.push_back(of_part[v]);
    curves.push_back(of_part[v]);
    for (Edgel& edgel : curves.back().edge_map.edgels) edgel.stored_px.x() += 100;
  }
  const StillEdgels still = FindStillEdgels(views, curves, scene.graph);
  for (size_t v = 0; v < 16; ++v) EXPECT_GT(ShareOfFragment(still, curves, v, 1), 0.8) << v;
}

TEST(StillEdgelsTest, ImagesFromOnePlaceAreOneImage) {
  StillScene scene(16);
  const std::vector<ImageCurves> curves = scene.Curves();
  for (size_t v = 0; v < scene.views.size(); ++v) {
    scene.views[v] = scene.views.front();
    scene.views[v].cam_from_world.translation.x() += 0.001 * static_cast<double>(v);
  }
  EXPECT_EQ(StillShare(FindStillEdgels(scene.views, curves, scene.graph)), 0);
}

TEST(StillEdgelsTest, EdgelsOfOtherDirectionsAreOthers) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 40), FrontalPoint(50, 60));
  for (size_t v = 0; v < 16; ++v) {
    const Eigen::Vector3d center = scene.views[v].CenterInWorld();
    const double turn = v * M_PI / 16;
    const Eigen::Vector3d along(0.1 * std::cos(turn), 0.1 * std::sin(turn), 0);
    const Eigen::Vector3d below(center.x(), center.y(), 0);
    scene.shown[v].push_back(Segment(below - along, below + along));
  }
  EXPECT_EQ(StillShare(FindStillEdgels(scene.views, scene.Curves(), scene.graph)), 0);
}

TEST(StillEdgelsTest, ImagesOfAnotherSizeAreNotCompared) {
  const StillScene scene(8);
  std::vector<ImageCurves> curves = scene.Curves();
  for (size_t v = 0; v < 4; ++v) curves[v].edge_map.width += 10;
  const StillEdgels still = FindStillEdgels(scene.views, curves, scene.graph);
  for (size_t v = 0; v < 8; ++v) EXPECT_LT(ShareOfFragment(still, curves, v, 1), 0.1) << v;
}

}  // namespace
}  // namespace limn
