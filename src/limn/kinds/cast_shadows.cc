// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/cast_shadows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "limn/geometry/spatial_index.h"
#include "limn/kinds/lights.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// How well lines coincide as the light sees them.
constexpr double kCoincidePx = 3;
constexpr double kParallelRad = 12 * kDeg;

bool Covers(const PlaceFromLight& other, const PlaceFromLight& place) {
  const Eigen::Vector2d offset = other.position - place.position;
  const double along = std::abs(offset.dot(place.tangent));
  const double across = std::abs(offset.x() * place.tangent.y() - offset.y() * place.tangent.x());
  // Both stand for half a step on either side.
  return along <= 0.5 * kPlaceStepPx * (other.footprint + place.footprint) &&
         across < kCoincidePx * place.footprint &&
         std::abs(other.tangent.dot(place.tangent)) > std::cos(kParallelRad);
}

// Per link, how many of its places lie behind other links.
std::vector<int> CountBehind(const LitScene& scene, const Light& light, const RunContext& context) {
  std::vector<PlaceFromLight> seen;
  std::vector<int> place_of;
  std::vector<Eigen::Vector3d> positions;
  double largest_footprint = 0;
  const LightView view(light, scene);
  for (size_t k = 0; k < scene.places.size(); ++k) {
    const auto from_light = view.See(scene.places[k]);
    if (!from_light) continue;
    seen.push_back(*from_light);
    place_of.push_back(static_cast<int>(k));
    positions.emplace_back(from_light->position.x(), from_light->position.y(), 0);
    largest_footprint = std::max(largest_footprint, from_light->footprint);
  }
  const SpatialIndex index(positions);
  std::vector<uint8_t> is_behind(seen.size(), 0);
  ParallelFor(context, "cast shadows", seen.size(), [&](size_t k) {
    if (!seen[k].is_lit) return;
    const LitPlace& place = scene.places[place_of[k]];
    const double along = 0.5 * kPlaceStepPx * (seen[k].footprint + largest_footprint);
    std::vector<SpatialIndex::Neighbor> near;
    index.FindWithin(positions[k], std::hypot(kCoincidePx * seen[k].footprint, along), &near);
    is_behind[k] = std::any_of(near.begin(), near.end(), [&](const auto& neighbor) {
      return scene.places[place_of[neighbor.index]].link != place.link &&
             seen[neighbor.index].height - seen[k].height > kMinCastPx * place.footprint &&
             Covers(seen[neighbor.index], seen[k]);
    });
  });
  std::vector<int> num_behind(scene.num_places_of_link.size(), 0);
  for (size_t k = 0; k < seen.size(); ++k) {
    num_behind[scene.places[place_of[k]].link] += is_behind[k];
  }
  return num_behind;
}

}  // namespace

std::vector<double> SharesBehind(const DrawingGraph& graph, const std::vector<View>& views,
                                 const RunContext& context) {
  const LitScene scene = LitSceneOf(PlacesOfLinks(graph, views, context));
  std::vector<double> shares(graph.links.size(), 0);
  for (const Light& light : FindLights(scene, context)) {
    const std::vector<int> num_behind = CountBehind(scene, light, context);
    for (size_t l = 0; l < num_behind.size(); ++l) {
      const int num_places = scene.num_places_of_link[l];
      if (num_places < kMinPlacesToTell) continue;
      shares[l] = std::max(shares[l], static_cast<double>(num_behind[l]) / num_places);
    }
  }
  return shares;
}

}  // namespace limn
