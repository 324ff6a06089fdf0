// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/kinds/lit_places.h"
#include "limn/util/parallel.h"

namespace limn {

// Where places lie around their middle.
struct LitScene {
  std::vector<LitPlace> places;
  std::vector<int> num_places_of_link;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0;     // nine tenths of the places are within it
  double footprint = 0;  // median
};

LitScene LitSceneOf(std::vector<LitPlace> places);

// A lamp or, at inverse distance 0, the sun.
struct Light {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // to the light, from the scene's center
  double inverse_distance = 0;                           // 1 / radius of the scene
};

// A place as the light sees it.
struct PlaceFromLight {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // world units at the scene's center
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();   // unit
  double height = 0;                                   // towards the light, world units
  double footprint = 0;                                // of the place, in the units of `position`
  // The light falls on the surface from the side that the views see, and does not graze it.
  bool is_lit = false;
};

// What a light sees. Holds the scene, which must have a radius.
class LightView {
 public:
  LightView(const Light& light, const LitScene& scene);

  // Nothing if the place is beside or behind the light, or its link runs along the ray.
  std::optional<PlaceFromLight> See(const LitPlace& place) const;
  // From a place to the light, unit.
  Eigen::Vector3d DirectionFrom(const LitPlace& place) const;

 private:
  const LitScene& scene_;
  Eigen::Vector3d direction_;
  double nearness_;                     // 1 / world units
  Eigen::Matrix<double, 3, 2> across_;  // to the direction
};

// The least height of what casts a shadow above it, px.
constexpr double kMinCastPx = 12;
// A link of fewer places does not tell.
constexpr int kMinPlacesToTell = 3;

// The lights of a scene, at most three: seen from there, twice as many places are on links that lie
// behind others, on lines that coincide, than from any direction around (ours;
// algorithm/kinds.md#cast-shadows). None if that is so from nowhere. Time: up to 3,600 directions
// and distances, and some hundred around the best ones, n log n in the number of places for each.
std::vector<Light> FindLights(const LitScene& scene, const RunContext& context);

}  // namespace limn
