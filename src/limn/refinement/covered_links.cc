#include "limn/refinement/covered_links.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/geometry/spatial_index.h"

namespace limn {
namespace {

constexpr double kDistancePx = 1;
constexpr double kMaxAngleRad = 25 * M_PI / 180;
constexpr double kCoveredShare = 0.8;

// Places about 1 px apart along all links.
struct Places {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> direction;
  std::vector<double> footprint;
  std::vector<int> link;
  std::vector<int> begin = {0};  // per link its first place; one more than links
};

void AddSegment(const ControlGraph& control, int link, int from, int to, Places* places) {
  const Eigen::Vector3d chord = control.position[to] - control.position[from];
  const double footprint = 0.5 * (control.footprint[from] + control.footprint[to]);
  const double length = chord.norm();
  if (!(footprint > 0) || !(length > 0)) return;
  const int count = std::max(1, static_cast<int>(std::lround(length / footprint)));
  for (int k = 0; k < count; ++k) {
    places->position.push_back(control.position[from] + chord * ((k + 0.5) / count));
    places->direction.push_back(chord / length);
    places->footprint.push_back(footprint);
    places->link.push_back(link);
  }
}

Places MakePlaces(const ControlGraph& control) {
  Places places;
  for (size_t l = 0; l < control.links.size(); ++l) {
    const std::vector<int>& points = control.links[l].points;
    for (size_t k = 1; k < points.size(); ++k) {
      AddSegment(control, static_cast<int>(l), points[k - 1], points[k], &places);
    }
    places.begin.push_back(static_cast<int>(places.position.size()));
  }
  return places;
}

bool IsCovered(const Places& places, const SpatialIndex& index, int link,
               const std::vector<uint8_t>& keep) {
  const double min_cosine = std::cos(kMaxAngleRad);
  int covered = 0;
  std::vector<SpatialIndex::Neighbor> found;
  for (int p = places.begin[link]; p < places.begin[link + 1]; ++p) {
    index.FindWithin(places.position[p], kDistancePx * places.footprint[p], &found);
    covered += std::any_of(found.begin(), found.end(), [&](const SpatialIndex::Neighbor& near) {
      const int other = places.link[near.index];
      return other != link && keep[other] &&
             std::abs(places.direction[p].dot(places.direction[near.index])) > min_cosine;
    });
  }
  const int count = places.begin[link + 1] - places.begin[link];
  return count > 0 && covered >= kCoveredShare * count;
}

}  // namespace

std::vector<uint8_t> FindUncoveredLinks(const ControlGraph& control) {
  const Places places = MakePlaces(control);
  std::vector<uint8_t> keep(control.links.size(), 1);
  if (places.position.empty()) return keep;
  const SpatialIndex index(places.position);
  std::vector<std::pair<int, int>> by_length;  // px
  for (size_t l = 0; l < keep.size(); ++l) {
    by_length.push_back({places.begin[l + 1] - places.begin[l], static_cast<int>(l)});
  }
  std::sort(by_length.begin(), by_length.end());
  for (const auto& [length, link] : by_length) keep[link] = !IsCovered(places, index, link, keep);
  return keep;
}

}  // namespace limn
