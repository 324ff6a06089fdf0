#include "limn/alignment/geodetic.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(Geodetic, KnowsTheEllipsoid) {
  EXPECT_LT((EarthFixed({0, 0, 0}) - Eigen::Vector3d(6378137, 0, 0)).norm(), 1e-6);
  EXPECT_LT((EarthFixed({0, 90, 10}) - Eigen::Vector3d(0, 6378147, 0)).norm(), 1e-6);
  EXPECT_LT((EarthFixed({90, 0, 0}) - Eigen::Vector3d(0, 0, 6356752.314245)).norm(), 1e-5);
  EXPECT_LT((EarthFixed({-90, 0, 5}) - Eigen::Vector3d(0, 0, -6356757.314245)).norm(), 1e-5);
}

TEST(Geodetic, LocalFrameIsEastNorthUp) {
  const double north_deg = 1e-4, east_deg = 1e-4;  // the middle one is the origin
  const auto local = LocalFromGeo({{47.3, 8.5, 400},
                                   {47.3, 8.5, 400},
                                   {47.3, 8.5, 430},
                                   {47.3 + north_deg, 8.5, 400},
                                   {47.3, 8.5 + east_deg, 400}});
  EXPECT_LT(local[0].norm(), 1e-8);
  EXPECT_LT((local[2] - Eigen::Vector3d(0, 0, 30)).norm(), 1e-6);
  // A degree of latitude is 111.18 km there, one of longitude 75.63 km.
  EXPECT_LT((local[3] - Eigen::Vector3d(0, 11.118, 0)).norm(), 2e-3);
  EXPECT_LT((local[4] - Eigen::Vector3d(7.563, 0, 0)).norm(), 2e-3);
}

TEST(Geodetic, PlacesAcrossTheDateLineAreNeighbors) {
  const auto local = LocalFromGeo({{-17, 179.9999, 0}, {-17, -179.9999, 0}, {-17, 180, 0}});
  EXPECT_NEAR(local[1].x() - local[0].x(), 21.3, 0.2);
  EXPECT_LT(local[2].norm(), 1e-6);
}

TEST(Geodetic, OnePlaceFarOffDoesNotTurnUp) {
  const auto local = LocalFromGeo({{47, 8, 0}, {47, 8, 100}, {0, 0, 0}, {47, 8, 50}, {47, 8, 60}});
  EXPECT_LT((local[1] - local[0] - Eigen::Vector3d(0, 0, 100)).norm(), 1e-6);
}

}  // namespace
}  // namespace limn
