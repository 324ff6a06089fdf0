#include "limn/linking/curvelets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {

using Eigen::Vector2d;
using Eigen::Vector2f;

CurveletBuilder::CurveletBuilder(const std::vector<Edgel>& edgels, const LinkingOptions& options)
    : options_(options), grid_(edgels, options.neighbour_radius_px) {
  samples_.reserve(edgels.size());
  for (const Edgel& edgel : edgels) samples_.push_back(MakeArcSample(edgel, options));
}

// Edgels of a curvelet must follow each other: an edgel beside another one is a second strand, and
// linking across would make a zig-zag.
bool CurveletBuilder::Follow(const Neighbour& a, const Neighbour& b) {
  const Vector2f d = b.offset - a.offset;
  return std::abs(d.x()) >= std::abs(d.y());
}

void CurveletBuilder::FindNeighbours(const Neighbour& anchor) {
  const ArcSample& from = samples_[anchor.id];
  const Vector2f& along = from.tangent;
  near_.clear();
  grid_.Near(from.position, options_.neighbour_radius_px, &near_);
  neighbours_.clear();
  for (const EdgelId id : near_) {
    if (id == anchor.id || along.dot(samples_[id].tangent) <= 0) continue;
    const Vector2d d = samples_[id].position - from.position;
    const Vector2f offset = d.cast<float>();
    const float across = along.x() * offset.y() - along.y() * offset.x();
    const Neighbour neighbour{id, d.squaredNorm(), {offset.dot(along), across}};
    if (Follow(anchor, neighbour)) neighbours_.push_back(neighbour);
  }
  std::sort(neighbours_.begin(), neighbours_.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                    : a.id < b.id;
  });
}

void CurveletBuilder::FindBundles(EdgelId anchor) {
  const ArcAnchor arcs(samples_[anchor], options_.max_curvature);
  bundles_.resize(neighbours_.size());
  size_t count = 0;
  for (const Neighbour& neighbour : neighbours_) {
    if (!arcs.ArcsTo(samples_[neighbour.id], neighbour.offset, &bundles_[count])) continue;
    neighbours_[count++] = neighbour;
  }
  neighbours_.resize(count);
}

void CurveletBuilder::GroupFrom(size_t seed, const Neighbour& anchor) {
  ArcBundle bundles[2];  // the one so far, where there is more than the seed, and a narrower one
  const ArcBundle* arcs = &bundles_[seed];
  int free = 0;
  members_.clear();
  members_.push_back(anchor);
  members_.push_back(neighbours_[seed]);
  for (size_t j = 0; j < neighbours_.size(); ++j) {
    const Neighbour& candidate = neighbours_[j];
    const auto follows = [&](const Neighbour& member) { return Follow(member, candidate); };
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
            [](const Neighbour& a, const Neighbour& b) { return a.offset.x() < b.offset.x(); });
  const double extent_px =
      (samples_[members_.back().id].position - samples_[members_.front().id].position).norm();
  if (extent_px < options_.min_curvelet_px) return;
  if (num_curvelets_ == curvelets_.size()) curvelets_.emplace_back();
  Curvelet& curvelet = curvelets_[num_curvelets_++];
  curvelet.clear();
  for (const Neighbour& member : members_) curvelet.push_back(member.id);
}

std::span<const Curvelet> CurveletBuilder::Around(EdgelId anchor_id) {
  const Neighbour anchor{anchor_id, 0, {0, 0}};
  FindNeighbours(anchor);
  FindBundles(anchor_id);
  grouped_.assign(neighbours_.size(), 0);
  num_curvelets_ = 0;
  for (size_t seed = 0; seed < neighbours_.size(); ++seed) {
    if (grouped_[seed]) continue;
    GroupFrom(seed, anchor);
    KeepMembers();
  }
  return {curvelets_.data(), num_curvelets_};
}

}  // namespace limn
