#include "limn/linking/curvelets.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;

// An edgel in the anchor's frame.
struct Neighbour {
  EdgelId id;
  double squared_distance;
  Vector2f offset;

  bool operator<(const Neighbour& other) const {
    return squared_distance != other.squared_distance ? squared_distance < other.squared_distance
                                                      : id < other.id;
  }
};

// Edgels of a curvelet must follow each other: an edgel beside another one is a second strand, and
// linking across would make a zig-zag.
bool Follow(const Neighbour& a, const Neighbour& b) {
  const Vector2f d = b.offset - a.offset;
  return std::abs(d.x()) >= std::abs(d.y());
}

// The edgels among `near` that can be in a curvelet with the anchor, nearest first.
std::vector<Neighbour> NeighboursOf(const Neighbour& anchor, const std::vector<EdgelId>& near,
                                    const std::vector<ArcSample>& samples) {
  const ArcSample& from = samples[anchor.id];
  std::vector<Neighbour> neighbours;
  neighbours.reserve(near.size());
  for (const EdgelId id : near) {
    if (id == anchor.id || from.tangent.dot(samples[id].tangent) <= 0) continue;
    const Vector2d d = samples[id].position - from.position;
    const Vector2f offset = d.cast<float>();
    const Vector2f& along = from.tangent;
    const Neighbour neighbour{
        id, d.squaredNorm(), {offset.dot(along), along.x() * offset.y() - along.y() * offset.x()}};
    if (Follow(anchor, neighbour)) neighbours.push_back(neighbour);
  }
  std::sort(neighbours.begin(), neighbours.end());
  return neighbours;
}

Curvelet InOrder(std::vector<Neighbour>* members) {
  std::sort(members->begin(), members->end(),
            [](const Neighbour& a, const Neighbour& b) { return a.offset.x() < b.offset.x(); });
  Curvelet curvelet;
  curvelet.reserve(members->size());
  for (const Neighbour& member : *members) curvelet.push_back(member.id);
  return curvelet;
}

}  // namespace

CurveletBuilder::CurveletBuilder(const std::vector<Edgel>& edgels, const LinkingOptions& options)
    : options_(options), grid_(edgels, options.neighbour_radius_px) {
  samples_.reserve(edgels.size());
  for (const Edgel& edgel : edgels) samples_.push_back(MakeArcSample(edgel, options));
}

std::vector<Curvelet> CurveletBuilder::Around(EdgelId anchor_id) const {
  const ArcAnchor arcs(samples_[anchor_id], options_.max_curvature);
  const Neighbour anchor{anchor_id, 0, {0, 0}};
  std::vector<EdgelId> near;
  grid_.Near(samples_[anchor_id].position, options_.neighbour_radius_px, &near);
  const std::vector<Neighbour> neighbours = NeighboursOf(anchor, near, samples_);
  std::vector<ArcBundle> bundles(neighbours.size());
  for (size_t i = 0; i < neighbours.size(); ++i) {
    bundles[i] = arcs.ArcsTo(samples_[neighbours[i].id], neighbours[i].offset);
  }

  std::vector<Curvelet> curvelets;
  std::vector<uint8_t> grouped(neighbours.size(), 0);
  std::vector<Neighbour> members;
  ArcBundle bundle;
  ArcBundle narrower;
  for (size_t seed = 0; seed < neighbours.size(); ++seed) {
    if (grouped[seed] || !Intersect(arcs.AllArcs(), bundles[seed], &bundle)) continue;
    members = {anchor, neighbours[seed]};
    for (size_t j = 0; j < neighbours.size(); ++j) {
      const auto follows = [&](const Neighbour& member) { return Follow(member, neighbours[j]); };
      if (j == seed || !std::all_of(members.begin(), members.end(), follows)) continue;
      if (!Intersect(bundle, bundles[j], &narrower)) continue;
      bundle = narrower;
      members.push_back(neighbours[j]);
      grouped[j] = 1;
    }
    Curvelet curvelet = InOrder(&members);
    const double extent_px =
        (samples_[curvelet.back()].position - samples_[curvelet.front()].position).norm();
    if (curvelet.size() < 3 || extent_px < options_.min_curvelet_px) continue;
    curvelets.push_back(std::move(curvelet));
  }
  return curvelets;
}

}  // namespace limn
