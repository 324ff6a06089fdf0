#include "limn/kinds/cast_shadows.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/spatial_index.h"
#include "limn/kinds/lights.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// How well lines coincide as the light sees them.
constexpr double kCoincidePx = 3;
constexpr double kParallelRad = 12 * kDeg;

void MarkBehind(const LitScene& scene, const Light& light, std::vector<uint8_t>* behind) {
  std::vector<PlaceFromLight> seen;
  std::vector<int> place_of;
  std::vector<Eigen::Vector3d> positions;
  for (size_t k = 0; k < scene.places.size(); ++k) {
    const auto from_light = SeeFrom(light, scene, scene.places[k]);
    if (!from_light) continue;
    seen.push_back(*from_light);
    place_of.push_back(static_cast<int>(k));
    positions.emplace_back(from_light->position.x(), from_light->position.y(), 0);
  }
  const SpatialIndex index(positions);
  std::vector<SpatialIndex::Neighbor> near;
  for (size_t k = 0; k < seen.size(); ++k) {
    const LitPlace& place = scene.places[place_of[k]];
    if (!seen[k].is_lit) continue;
    // Sampled every 6 px: half of that along the line.
    index.FindWithin(positions[k], std::hypot(kCoincidePx, 3) * place.footprint, &near);
    (*behind)[place_of[k]] |= std::any_of(near.begin(), near.end(), [&](const auto& neighbor) {
      const PlaceFromLight& other = seen[neighbor.index];
      const Eigen::Vector2d offset = other.position - seen[k].position;
      const double across =
          std::abs(offset.x() * seen[k].tangent.y() - offset.y() * seen[k].tangent.x());
      return across < kCoincidePx * place.footprint &&
             scene.places[place_of[neighbor.index]].link != place.link &&
             other.height - seen[k].height > kMinCastPx * place.footprint &&
             std::abs(other.tangent.dot(seen[k].tangent)) > std::cos(kParallelRad);
    });
  }
}

}  // namespace

std::vector<double> SharesBehind(const DrawingGraph& graph, const std::vector<View>& views,
                                 const RunContext& context) {
  const LitScene scene = LitSceneOf(PlacesOfLinks(graph, views, context));
  std::vector<uint8_t> behind(scene.places.size(), 0);
  for (const Light& light : FindLights(scene, context)) MarkBehind(scene, light, &behind);
  std::vector<int> num_behind(graph.links.size(), 0);
  for (size_t k = 0; k < behind.size(); ++k) num_behind[scene.places[k].link] += behind[k];
  std::vector<double> shares(graph.links.size(), 0);
  for (size_t l = 0; l < scene.num_places_of_link.size(); ++l) {
    const int num_places = scene.num_places_of_link[l];
    if (num_places >= kMinPlacesToTell) shares[l] = static_cast<double>(num_behind[l]) / num_places;
  }
  return shares;
}

}  // namespace limn
