// SPDX-License-Identifier: BSD-3-Clause
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

TEST(Geodetic, EarthFixedPlacesHaveLatitudeLongitudeAndAltitude) {
  for (const double latitude : {-89.9, -33.2, 0.0, 1e-3, 47.3, 89.9}) {
    for (const double longitude : {-179.0, -12.5, 0.0, 100.0}) {
      for (const double altitude : {-400.0, 0.0, 8848.0, 4e5}) {
        const GeoPosition back = GeoFromEarthFixed(EarthFixed({latitude, longitude, altitude}));
        EXPECT_NEAR(back.latitude_deg, latitude, 1e-11);
        EXPECT_NEAR(back.longitude_deg, longitude, 1e-11);
        EXPECT_NEAR(back.altitude_m, altitude, 1e-6);
      }
    }
  }
}

TEST(Geodetic, EarthFixedPlacesAreToldFromGrids) {
  const Eigen::Vector3d zurich = EarthFixed({47.3, 8.5, 400});
  EXPECT_TRUE(AreEarthFixed({zurich, zurich, EarthFixed({47.3, 8.6, 4000})}));
  EXPECT_TRUE(AreEarthFixed({zurich, zurich, {0, 0, 0}}));  // a position that was not measured
  EXPECT_FALSE(AreEarthFixed({zurich, {0, 0, 0}}));
  EXPECT_FALSE(AreEarthFixed({}));
  EXPECT_FALSE(AreEarthFixed({{0, 0, 0}, {3, 4, 5}}));
  EXPECT_FALSE(AreEarthFixed({{500000, 5240000, 400}}));  // UTM
  // Easting and northing of a grid may be as long as the radius of the earth.
  EXPECT_FALSE(AreEarthFixed({{3500000, 5332000, 400}}));
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
