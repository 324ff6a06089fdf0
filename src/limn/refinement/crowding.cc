// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/crowding.h"

#include <cmath>

#include "limn/util/angles.h"

namespace limn {
namespace {

const double kMinCosine = std::cos(20 * kDeg);

EdgelIndex IndexOf(const std::vector<ImagePlace>& places) {
  EdgeMap map;
  map.edgels.resize(places.size());
  for (size_t i = 0; i < places.size(); ++i) map.edgels[i].position_px = places[i].pixel;
  return EdgelIndex(map, std::vector<bool>(places.size(), true));
}

}  // namespace

Crowding::Crowding(std::vector<ImagePlace> places)
    : places_(std::move(places)), index_(IndexOf(places_)) {}

bool Crowding::At(const ImagePlace& place, double distance_px, double half_step_px) const {
  bool crowded = false;
  index_.ForEachWithin(place.pixel, std::hypot(distance_px, half_step_px), [&](EdgelId id) {
    const ImagePlace& other = places_[id];
    if (other.link == place.link) return;
    const Eigen::Vector2d offset = other.pixel - place.pixel;
    const double across_px =
        std::abs(offset.x() * place.direction.y() - offset.y() * place.direction.x());
    crowded |=
        across_px <= distance_px && std::abs(other.direction.dot(place.direction)) > kMinCosine;
  });
  return crowded;
}

}  // namespace limn
