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
