// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/geodetic.h"

#include <algorithm>
#include <cmath>

#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Of the ellipsoid WGS84: equatorial radius, m, and flattening.
constexpr double kEquatorM = 6378137;
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);

// Of places where photographs are taken, above the ellipsoid.
constexpr double kLowestM = -1000, kHighestM = 20000;

// Longitudes across the date line are neighbors, too.
double NearestTurn(double longitude_deg, double near_deg) {
  return near_deg + std::remainder(longitude_deg - near_deg, 360);
}

GeoPosition MedianPosition(const std::vector<GeoPosition>& positions) {
  std::vector<double> latitudes, longitudes, altitudes;
  for (const GeoPosition& position : positions) {
    latitudes.push_back(position.latitude_deg);
    longitudes.push_back(NearestTurn(position.longitude_deg, positions.front().longitude_deg));
    altitudes.push_back(position.altitude_m);
  }
  return {Median(latitudes), Median(longitudes), Median(altitudes)};
}

// Rows: east, north, up.
Eigen::Matrix3d LocalAxes(const GeoPosition& at) {
  const double sin_lat = std::sin(at.latitude_deg * kDeg),
               cos_lat = std::cos(at.latitude_deg * kDeg);
  const double sin_lon = std::sin(at.longitude_deg * kDeg);
  const double cos_lon = std::cos(at.longitude_deg * kDeg);
  Eigen::Matrix3d axes;
  axes << -sin_lon, cos_lon, 0,                         //
      -sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat,  //
      cos_lat * cos_lon, cos_lat * sin_lon, sin_lat;
  return axes;
}

// From the ellipsoid along its normal to the axis of the earth.
double NormalLength(double latitude) {
  return kEquatorM / std::sqrt(1 - kEccentricity2 * std::sin(latitude) * std::sin(latitude));
}

bool IsEarthFixed(const Eigen::Vector3d& position) {
  const double altitude_m = GeoFromEarthFixed(position).altitude_m;
  return std::abs(position.z()) > kHighestM && altitude_m > kLowestM && altitude_m < kHighestM;
}

}  // namespace

Eigen::Vector3d EarthFixed(const GeoPosition& position) {
  const double latitude = position.latitude_deg * kDeg, longitude = position.longitude_deg * kDeg;
  const double normal = NormalLength(latitude);
  const double across = (normal + position.altitude_m) * std::cos(latitude);
  return {across * std::cos(longitude), across * std::sin(longitude),
          (normal * (1 - kEccentricity2) + position.altitude_m) * std::sin(latitude)};
}

GeoPosition GeoFromEarthFixed(const Eigen::Vector3d& earth_fixed) {
  // Each step divides the error by 1 / e^2 = 150 and more.
  constexpr int kNumSteps = 7;
  const double across = earth_fixed.head<2>().norm();
  double latitude = std::atan2(earth_fixed.z(), across * (1 - kEccentricity2));
  double normal = 0, above_center = 0;  // above the middle of the normal, on the axis
  for (int step = 0; step < kNumSteps; ++step) {
    normal = NormalLength(latitude);
    above_center = earth_fixed.z() + kEccentricity2 * normal * std::sin(latitude);
    latitude = std::atan2(above_center, across);
  }
  return {latitude / kDeg, std::atan2(earth_fixed.y(), earth_fixed.x()) / kDeg,
          std::hypot(across, above_center) - normal};
}

bool AreEarthFixed(const std::vector<Eigen::Vector3d>& positions) {
  const auto num_fixed = std::ranges::count_if(positions, IsEarthFixed);
  return num_fixed > 0 && 3 * static_cast<size_t>(num_fixed) >= 2 * positions.size();
}

std::vector<Eigen::Vector3d> LocalFromGeo(const std::vector<GeoPosition>& positions) {
  if (positions.empty()) return {};
  const GeoPosition origin = MedianPosition(positions);
  const Eigen::Matrix3d axes = LocalAxes(origin);
  const Eigen::Vector3d center = EarthFixed(origin);
  std::vector<Eigen::Vector3d> local;
  for (const GeoPosition& position : positions) {
    local.push_back(axes * (EarthFixed(position) - center));
  }
  return local;
}

}  // namespace limn
