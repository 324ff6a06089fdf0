// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/view_finder.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

std::vector<View> RandomViews(int count, std::mt19937* random) {
  testing::NormalDistribution<double> normal(0, 1);
  std::vector<View> views(count);
  for (View& view : views) {
    view.camera = {500, 480, 320, 240, 640, 480};
    view.region = MakeImageRegion(view.camera, nullptr, {}, 8);
    view.cam_from_world.rotation =
        Eigen::Quaterniond(normal(*random), normal(*random), normal(*random), normal(*random))
            .normalized();
    view.cam_from_world.translation = {normal(*random), normal(*random), normal(*random)};
  }
  return views;
}

TEST(ViewFinderTest, NoViewThatContainsAPointIsLost) {
  std::mt19937 random(4);
  const std::vector<View> views = RandomViews(300, &random);
  const ViewFinder finder(views);
  testing::NormalDistribution<double> normal(0, 1);
  size_t num_near = 0;
  size_t num_containing = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d begin(3 * normal(random), 3 * normal(random), 3 * normal(random));
    const Vector3d step(0.02 * normal(random), 0.02 * normal(random), 0.02 * normal(random));
    std::vector<Vector3d> points;
    for (int k = 0; k < 20; ++k) points.push_back(begin + k * step);
    const std::vector<ViewId> near = finder.NearAnyOf(points);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    num_near += near.size();
    for (size_t v = 0; v < views.size(); ++v) {
      const bool contains = std::any_of(points.begin(), points.end(), [&](const Vector3d& point) {
        return views[v].Project(point).has_value();
      });
      num_containing += contains;
      if (contains) {
        EXPECT_TRUE(std::binary_search(near.begin(), near.end(), static_cast<ViewId>(v)));
      }
    }
  }
  EXPECT_GT(num_containing, 1000u);
  // Curves are short here: few views come near without containing.
  EXPECT_LT(num_near, 2 * num_containing);
}

TEST(ViewFinderTest, ViewsBehindOrAsideAreLeftOut) {
  const std::vector<View> views = {testing::ForwardView(640, 480, 500)};
  const ViewFinder finder(views);
  EXPECT_EQ(finder.Near({0, 0, 5}, 0).size(), 1u);
  EXPECT_TRUE(finder.Near({0, 0, -5}, 1).empty());
  EXPECT_EQ(finder.Near({0, 0, -5}, 6).size(), 1u);
  EXPECT_TRUE(finder.Near({10, 0, 5}, 1).empty());
  EXPECT_TRUE(finder.NearAnyOf({}).empty());
}

}  // namespace
}  // namespace limn
