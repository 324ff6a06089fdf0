// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/curvelets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {

using Eigen::Vector2d;
using Eigen::Vector2f;

CurveletBuilder::CurveletBuilder(const std::vector<Edgel>& edgels, const LinkingOptions& options)
    : options_(options), grid_(edgels, options.neighbor_radius_px) {
  samples_.reserve(edgels.size());
  for (const Edgel& edgel : edgels) samples_.push_back(MakeArcSample(edgel, options));
}

// Edgels of a curvelet must follow each other: an edgel beside another one is a second strand, and
// linking across would make a zig-zag.
bool CurveletBuilder::Follow(const Neighbor& a, const Neighbor& b) {
  const Vector2f d = b.offset - a.offset;
  return std::abs(d.x()) >= std::abs(d.y());
}

void CurveletBuilder::FindNeighbors(const Neighbor& anchor) {
  const ArcSample& from = samples_[anchor.id];
  const Vector2f& along = from.tangent;
  near_.clear();
  grid_.Near(from.position, options_.neighbor_radius_px, &near_);
  neighbors_.clear();
  for (const EdgelId id : near_) {
    if (id == anchor.id || along.dot(samples_[id].tangent) <= 0) continue;
    const Vector2d d = samples_[id].position - from.position;
    const Vector2f offset = d.cast<float>();
    const float across = along.x() * offset.y() - along.y() * offset.x();
    const Neighbor neighbor{id, d.squaredNorm(), {offset.dot(along), across}};
    if (Follow(anchor, neighbor)) neighbors_.push_back(neighbor);
  }
  std::sort(neighbors_.begin(), neighbors_.end(), [](const Neighbor& a, const Neighbor& b) {
    return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                    : a.id < b.id;
  });
}

void CurveletBuilder::FindBundles(EdgelId anchor) {
  const ArcAnchor arcs(samples_[anchor], options_.max_curvature);
  bundles_.resize(neighbors_.size());
  size_t count = 0;
  for (const Neighbor& neighbor : neighbors_) {
    if (!arcs.ArcsTo(samples_[neighbor.id], neighbor.offset, &bundles_[count])) continue;
    neighbors_[count++] = neighbor;
  }
  neighbors_.resize(count);
}

void CurveletBuilder::GroupFrom(size_t seed, const Neighbor& anchor) {
  ArcBundle bundles[2];  // the one so far, where there is more than the seed, and a narrower one
  const ArcBundle* arcs = &bundles_[seed];
  int free = 0;
  members_.clear();
  members_.push_back(anchor);
  members_.push_back(neighbors_[seed]);
  for (size_t j = 0; j < neighbors_.size(); ++j) {
    const Neighbor& candidate = neighbors_[j];
    const auto follows = [&](const Neighbor& member) { return Follow(member, candidate); };
    if (j == seed || !std::all_of(members_.begin(), members_.end(), follows)) continue;
    if (!Intersect(*arcs, bundles_[j], &bundles[free])) continue;
    arcs = &bundles[free];
    free = 1 - free;
    members_.push_back(candidate);
    grouped_[j] = 1;
  }
}

void CurveletBuilder::KeepMembers() {
  if (members_.size() < 3) return;
  std::sort(members_.begin(), members_.end(),
            [](const Neighbor& a, const Neighbor& b) { return a.offset.x() < b.offset.x(); });
  const double extent_px =
      (samples_[members_.back().id].position - samples_[members_.front().id].position).norm();
  if (extent_px < options_.min_curvelet_px) return;
  if (num_curvelets_ == curvelets_.size()) curvelets_.emplace_back();
  Curvelet& curvelet = curvelets_[num_curvelets_++];
  curvelet.clear();
  for (const Neighbor& member : members_) curvelet.push_back(member.id);
}

std::span<const Curvelet> CurveletBuilder::Around(EdgelId anchor_id) {
  const Neighbor anchor{anchor_id, 0, {0, 0}};
  FindNeighbors(anchor);
  FindBundles(anchor_id);
  grouped_.assign(neighbors_.size(), 0);
  num_curvelets_ = 0;
  for (size_t seed = 0; seed < neighbors_.size(); ++seed) {
    if (grouped_[seed]) continue;
    GroupFrom(seed, anchor);
    KeepMembers();
  }
  return {curvelets_.data(), num_curvelets_};
}

}  // namespace limn
