// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/given_edgels.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

EdgeMap OneEdgel(const Eigen::Vector2d& position, double tangent_rad) {
  EdgeMap map;
  map.width = 80;
  map.height = 60;
  map.edgels.resize(1);
  map.edgels[0].position_px = position;
  map.edgels[0].tangent_rad = tangent_rad;
  map.edgels[0].position_sigma_px = 0.2f;
  return map;
}

TEST(GivenEdgels, ResizingKeepsCornersAndChangesDirections) {
  EdgeMap map = OneEdgel({39.5, 59.5}, M_PI / 4);
  ResizeEdgeMap(40, 60, &map);
  EXPECT_EQ(map.width, 40);
  EXPECT_EQ(map.height, 60);
  EXPECT_NEAR(map.edgels[0].position_px.x(), 19.5, 1e-12);
  EXPECT_NEAR(map.edgels[0].position_px.y(), 59.5, 1e-12);
  EXPECT_NEAR(map.edgels[0].tangent_rad, std::atan2(1, 0.5), 1e-12);
  EXPECT_NEAR(map.edgels[0].position_sigma_px, 0.2 * std::sqrt(0.5), 1e-6);
  EXPECT_EQ(map.edgels[0].stored_px, map.edgels[0].position_px.cast<float>());
}

TEST(GivenEdgels, TheSameSizeChangesNoBit) {
  EdgeMap map = OneEdgel({1.0 / 3, 7.1}, -2.1);
  ResizeEdgeMap(80, 60, &map);
  SetUnknownSigmas(&map);
  EXPECT_EQ(map.edgels[0].position_px, Eigen::Vector2d(1.0 / 3, 7.1));
  EXPECT_EQ(map.edgels[0].tangent_rad, -2.1);
  EXPECT_EQ(map.edgels[0].position_sigma_px, 0.2f);
}

EdgeMap EdgelsAt(const std::vector<Eigen::Vector3d>& places_and_strengths) {
  EdgeMap map = OneEdgel({0, 0}, 0);
  map.edgels.clear();
  for (const Eigen::Vector3d& place : places_and_strengths) {
    map.edgels.push_back(OneEdgel(place.head<2>(), 0).edgels[0]);
    map.edgels.back().strength = static_cast<float>(place.z());
  }
  return map;
}

TEST(GivenEdgels, TheStrongestOfAPixelStays) {
  // Two of a pixel, one of the next too near them, one of no strength, two outside the image.
  EdgeMap map = EdgelsAt(
      {{20, 9, 0}, {10.2, 5, 1}, {10.4, 5, 2}, {10.6, 5, 1}, {-0.9, 5, 3}, {80, 5, 3}, {2, 5, 1}});
  ThinEdgels(&map);
  ASSERT_EQ(map.edgels.size(), 3u);
  EXPECT_EQ(map.edgels[0].position_px, Eigen::Vector2d(2, 5));
  EXPECT_EQ(map.edgels[1].position_px, Eigen::Vector2d(10.4, 5));
  EXPECT_EQ(map.edgels[1].strength, 2);
  EXPECT_EQ(map.edgels[2].position_px, Eigen::Vector2d(20, 9));
}

TEST(GivenEdgels, TextureIsThatOfDetection) {
  EdgeMap map = EdgelsAt({});
  map.width = map.height = 60;
  for (int y = 10; y < 50; y += 2) {
    for (int x = 10; x < 50; x += 2) {
      map.edgels.push_back(OneEdgel({x + 0.3, y + 0.2}, 0).edgels[0]);
      // Neighbors, also those two steps away, differ by more than 30 degrees, undirected.
      map.edgels.back().tangent_rad = 0.8 * (x / 2) + 1.6 * (y / 2);
    }
  }
  MarkTexture(0.15, &map);
  EXPECT_GT(map.texture.size(), map.edgels.size() / 2);
  map.texture.clear();
  MarkTexture(0, &map);
  EXPECT_TRUE(map.texture.empty());
  MarkTexture(0.3, &map);
  EXPECT_TRUE(map.texture.empty()) << "a quarter per pixel";
}

TEST(GivenEdgels, TheFirstEightOfAPixelAreNoCrowd) {
  EdgeMap map = EdgelsAt(std::vector<Eigen::Vector3d>(9, {10.2, 5, 1}));
  map.edgels.push_back(OneEdgel({11, 5}, 0).edgels[0]);
  std::vector<bool> outside(10, true);
  outside[8] = false;
  EXPECT_EQ(OutsideCrowds(map), outside);
}

TEST(GivenEdgels, UnknownSigmasAreThoseOfAPixel) {
  EdgeMap map = OneEdgel({1, 1}, 0);
  map.edgels[0].position_sigma_px = 0;
  SetUnknownSigmas(&map);
  EXPECT_EQ(map.edgels[0].position_sigma_px, kUnknownSigmaPx);
}

TEST(GivenEdgels, MaskedPixelsAreToldByTheNearestPixel) {
  EdgeMap map = OneEdgel({2.4, 1}, 0);
  map.edgels.push_back(map.edgels[0]);
  map.edgels[1].position_px = {2.6, 1};
  map.edgels.push_back(map.edgels[0]);
  map.edgels[2].position_px = {-0.9, 60};
  std::vector<unsigned char> mask(80 * 60, 1);
  mask[80 + 3] = 0;
  EXPECT_EQ(OutsideMask(map, mask), (std::vector<bool>{true, false, true}));
  EXPECT_EQ(OutsideMask(map, {}), (std::vector<bool>{true, true, true}));
}

}  // namespace
}  // namespace limn
