// SPDX-License-Identifier: BSD-3-Clause
#include "limn/tiles/changed_places.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"
#include "limn/model/footprint.h"
#include "limn/util/median.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// Curves this near to each other show the same, px.
constexpr double kSamePx = 2;
// And samples of such curves: kSamePx across, half the distance of samples along.
constexpr double kSameSamplesPx = 2.7;
// Number of views that agree on a curve from which it may be drawn, and from which it would have
// been.
constexpr int kMayBeDrawn = 2;
constexpr int kIsKnown = 3;
// Changes this near to each other are drawn together, px.
constexpr double kTogetherPx = 20;
// Number of vertices of image curves, about 1 px apart, of the shortest change.
constexpr int kMinVertices = 14;
// Of the core around its changes, and of the reach around the core, px.
constexpr double kCoreMarginPx = 10;
constexpr double kReachPx = 50;

struct ChangeSample {
  Eigen::Vector3d position;
  double footprint = 0;
  ViewId view = -1;      // that shows it; -1: of a lost link
  int num_vertices = 1;  // of the image curve that it stands for
  bool is_drawn = false;
  int old_views = 0;  // others that show it
  int new_views = 0;
  ViewId last_view = -1;  // counted last
};

std::vector<Eigen::Vector3d> Positions(const std::vector<ChangeSample>& samples) {
  std::vector<Eigen::Vector3d> positions;
  for (const ChangeSample& sample : samples) positions.push_back(sample.position);
  return positions;
}

// What new views show.
class NewSamples {
 public:
  explicit NewSamples(const ChangedScene& scene)
      : scene_(scene), samples_(Collect(scene)), index_(Positions(samples_)) {
    MarkDrawn();
    for (const Curve3D& curve : scene.sketch.curves) Count(curve);
  }

  // Those on which enough views agree only now, and which are not drawn.
  std::vector<ChangeSample> Undrawn() const {
    std::vector<ChangeSample> undrawn;
    for (const ChangeSample& sample : samples_) {
      const int before = sample.old_views;
      const int now = before + sample.new_views + 1;
      if (!sample.is_drawn && before < kIsKnown && now >= kMayBeDrawn) undrawn.push_back(sample);
    }
    return undrawn;
  }

 private:
  static std::vector<ChangeSample> Collect(const ChangedScene& scene) {
    std::vector<ChangeSample> samples;
    for (const Curve3D& curve : scene.sketch.curves) {
      const ViewId view = curve.anchor.view;
      if (!scene.is_new[view]) continue;
      for (const Eigen::Vector3d& point : curve.points_in_world) {
        const auto footprint = FootprintIn(scene.views[view], point);
        if (footprint) samples.push_back({point, *footprint, view, curve.anchor.step});
      }
    }
    return samples;
  }

  void MarkDrawn() {
    for (size_t l = 0; l < scene_.graph.links.size(); ++l) {
      const DrawingLink& link = scene_.graph.links[l];
      const double footprint = LinkFootprint(link, scene_.views);
      if (scene_.lost[l] || !(footprint > 0)) continue;
      for (const Eigen::Vector3d& point : ResampleUniform(link.points_in_world, footprint)) {
        index_.FindWithin(point, kSamePx * footprint, &near_);
        for (const SpatialIndex::Neighbor& neighbor : near_) {
          samples_[neighbor.index].is_drawn = true;
        }
      }
    }
  }

  void Count(const Curve3D& curve) {
    const ViewId view = curve.anchor.view;
    for (const Eigen::Vector3d& point : curve.points_in_world) {
      const auto footprint = FootprintIn(scene_.views[view], point);
      if (!footprint) continue;
      index_.FindWithin(point, kSameSamplesPx * *footprint, &near_);
      for (const SpatialIndex::Neighbor& neighbor : near_) {
        ChangeSample& sample = samples_[neighbor.index];
        if (sample.view == view || sample.last_view == view) continue;
        sample.last_view = view;
        ++(scene_.is_new[view] ? sample.new_views : sample.old_views);
      }
    }
  }

  const ChangedScene& scene_;
  std::vector<ChangeSample> samples_;
  SpatialIndex index_;
  std::vector<SpatialIndex::Neighbor> near_;
};

void AddLostLinks(const ChangedScene& scene, std::vector<ChangeSample>* samples) {
  for (size_t l = 0; l < scene.graph.links.size(); ++l) {
    if (!scene.lost[l]) continue;
    const DrawingLink& link = scene.graph.links[l];
    const double footprint = LinkFootprint(link, scene.views);
    if (!(footprint > 0)) continue;
    for (const Eigen::Vector3d& point : ResampleUniform(link.points_in_world, footprint)) {
      samples->push_back({point, footprint});
    }
  }
}

// Samples that are near to each other, and enough of them or of a lost link.
std::vector<std::vector<ChangeSample>> Groups(const std::vector<ChangeSample>& samples) {
  const SpatialIndex index(Positions(samples));
  UnionFind sets(static_cast<int>(samples.size()));
  std::vector<SpatialIndex::Neighbor> near;
  for (int i = 0; i < static_cast<int>(samples.size()); ++i) {
    index.FindWithin(samples[i].position, kTogetherPx * samples[i].footprint, &near);
    for (const SpatialIndex::Neighbor& neighbor : near) sets.Union(i, neighbor.index);
  }
  std::map<int, std::vector<ChangeSample>> by_set;
  for (int i = 0; i < static_cast<int>(samples.size()); ++i) {
    by_set[sets.Find(i)].push_back(samples[i]);
  }
  std::vector<std::vector<ChangeSample>> groups;
  for (auto& [set, group] : by_set) {
    const bool is_lost =
        std::ranges::any_of(group, [](const ChangeSample& sample) { return sample.view < 0; });
    int num_vertices = 0;
    for (const ChangeSample& sample : group) num_vertices += sample.num_vertices;
    if (is_lost || num_vertices >= kMinVertices) groups.push_back(std::move(group));
  }
  return groups;
}

Eigen::AlignedBox3d Widened(const Eigen::AlignedBox3d& box, double margin) {
  return {box.min().array() - margin, box.max().array() + margin};
}

ChangedPlace PlaceAround(const std::vector<ChangeSample>& group) {
  Eigen::AlignedBox3d box;
  std::vector<double> footprints;
  for (const ChangeSample& sample : group) {
    box.extend(sample.position);
    footprints.push_back(sample.footprint);
  }
  const double footprint = Median(std::move(footprints));
  const Eigen::AlignedBox3d core = Widened(box, kCoreMarginPx * footprint);
  return {core, Widened(core, kReachPx * footprint)};
}

// Unites places whose cores overlap until none do.
std::vector<ChangedPlace> Disjoint(std::vector<ChangedPlace> places) {
  std::vector<ChangedPlace> disjoint;
  while (!places.empty()) {
    ChangedPlace place = std::move(places.back());
    places.pop_back();
    const auto overlapping = std::ranges::find_if(
        disjoint, [&](const ChangedPlace& other) { return other.core.intersects(place.core); });
    if (overlapping == disjoint.end()) {
      disjoint.push_back(std::move(place));
      continue;
    }
    place.core.extend(overlapping->core);
    place.reach.extend(overlapping->reach);
    disjoint.erase(overlapping);
    places.push_back(std::move(place));
  }
  return disjoint;
}

}  // namespace

std::vector<ChangedPlace> FindChangedPlaces(const ChangedScene& scene) {
  std::vector<ChangeSample> changes = NewSamples(scene).Undrawn();
  AddLostLinks(scene, &changes);
  std::vector<ChangedPlace> places;
  if (changes.empty()) return places;
  for (const auto& group : Groups(changes)) places.push_back(PlaceAround(group));
  return Disjoint(std::move(places));
}

}  // namespace limn
