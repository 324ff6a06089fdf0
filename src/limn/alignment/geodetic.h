// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace limn {

// A satellite position (WGS84).
struct GeoPosition {
  double latitude_deg = 0;
  double longitude_deg = 0;
  double altitude_m = 0;  // above the ellipsoid
};

// Earth-centered, earth-fixed coordinates, m.
Eigen::Vector3d EarthFixed(const GeoPosition& position);

// Its inverse, to a micrometer, for places within 1,000 km of the ground.
GeoPosition GeoFromEarthFixed(const Eigen::Vector3d& earth_fixed);

// Whether coordinates in meters are earth-fixed ones rather than those of a frame with z up: at
// least two of three are on the ground, or less than 20 km above it, and more than 20 km from the
// plane of the equator, where no height in a grid is. Those nearer to it are not recognized. Linear
// time.
bool AreEarthFixed(const std::vector<Eigen::Vector3d>& positions);

// East, north and up of all positions, m, in a frame around the median of latitudes, longitudes and
// altitudes, which positions far off do not move. Linear time.
std::vector<Eigen::Vector3d> LocalFromGeo(const std::vector<GeoPosition>& positions);

}  // namespace limn
