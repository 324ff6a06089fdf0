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

// East, north and up of all positions, m, in a frame around the median of latitudes, longitudes and
// altitudes, which positions far off do not move. Linear time.
std::vector<Eigen::Vector3d> LocalFromGeo(const std::vector<GeoPosition>& positions);

}  // namespace limn
