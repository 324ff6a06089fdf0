#include "limn/alignment/geodetic.h"

#include <cmath>

#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Of the ellipsoid WGS84: equatorial radius, m, and flattening.
constexpr double kEquatorM = 6378137;
constexpr double kFlattening = 1 / 298.257223563;

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

}  // namespace

Eigen::Vector3d EarthFixed(const GeoPosition& position) {
  constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);
  const double latitude = position.latitude_deg * kDeg, longitude = position.longitude_deg * kDeg;
  const double normal =
      kEquatorM / std::sqrt(1 - kEccentricity2 * std::sin(latitude) * std::sin(latitude));
  const double across = (normal + position.altitude_m) * std::cos(latitude);
  return {across * std::cos(longitude), across * std::sin(longitude),
          (normal * (1 - kEccentricity2) + position.altitude_m) * std::sin(latitude)};
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
