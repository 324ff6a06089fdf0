// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/view.h"

#include <memory>

#include <gtest/gtest.h>

#include "limn/model/toy_lens.h"

namespace limn {
namespace {

const PinholeCamera kCamera = {100, 100, 50, 40, 101, 81};

TEST(MakeImageRegion, WithoutLensAndMaskIsTheRectangleLessTheMargin) {
  const ImageRegion region = MakeImageRegion(kCamera, nullptr, {}, 8);
  EXPECT_TRUE(region.Contains({8, 8}));
  EXPECT_TRUE(region.Contains({92, 72}));
  EXPECT_FALSE(region.Contains({7.9, 40}));
  EXPECT_FALSE(region.Contains({50, 72.1}));
  EXPECT_FALSE(region.Contains({NAN, 40}));
}

TEST(MakeImageRegion, MaskedPixelsAreOut) {
  std::vector<unsigned char> mask(101 * 81, 255);
  for (int y = 0; y < 81; ++y) {
    for (int x = 50; x < 101; ++x) mask[y * 101 + x] = 0;
  }
  const ImageRegion region = MakeImageRegion(kCamera, nullptr, mask, 0);
  EXPECT_TRUE(region.Contains({20, 40}));
  EXPECT_TRUE(region.Contains({44, 40}));
  // The grid's cells are 4 px wide.
  EXPECT_FALSE(region.Contains({56, 40}));
  EXPECT_FALSE(region.Contains({100, 0}));
}

TEST(MakeImageRegion, LensGivesTheVirtualRegion) {
  // The stored image shows twice enlarged what is within 30 stored px of the center.
  const ToyLens lens({50, 40}, 2, 0, 30);
  const ImageRegion region = MakeImageRegion(kCamera, &lens, {}, 0);
  EXPECT_TRUE(region.Contains({50, 40}));
  EXPECT_TRUE(region.Contains({61, 40}));
  EXPECT_FALSE(region.Contains({66, 40}));
  EXPECT_FALSE(region.Contains({62, 52}));  // in the box, outside the disc
}

TEST(View, ProjectsWhatIsInFrontAndInside) {
  View view;
  view.camera = kCamera;
  view.region = MakeImageRegion(kCamera, nullptr, {}, 0);
  view.cam_from_world.translation = {0, 0, 1};
  ASSERT_TRUE(view.Project({0, 0, 1}));
  EXPECT_EQ(*view.Project({0, 0, 1}), Eigen::Vector2d(50, 40));
  EXPECT_FALSE(view.Project({0, 0, -2}));
  EXPECT_FALSE(view.Project({0, 0, -1}));  // at the center itself
  EXPECT_FALSE(view.Project({5, 0, 1}));
  EXPECT_LT((view.CenterInWorld() - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
}

TEST(View, StoredPixelsGoThroughTheLens) {
  View view;
  view.camera = kCamera;
  EXPECT_EQ(*view.StoredFromVirtual({3, 4}), Eigen::Vector2d(3, 4));
  view.lens = std::make_shared<ToyLens>(Eigen::Vector2d(50, 40), 2, 0, 30);
  EXPECT_LT((*view.StoredFromVirtual({55, 40}) - Eigen::Vector2d(60, 40)).norm(), 1e-12);
  EXPECT_FALSE(view.StoredFromVirtual({80, 40}));
}

}  // namespace
}  // namespace limn
