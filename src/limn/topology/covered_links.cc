// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/covered_links.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/geometry/spatial_index.h"
#include "limn/topology/link_geometry.h"
#include "limn/topology/meetings.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Links within this distance lie side by side, px; up to the second distance if the point's
// covariance allows it.
constexpr double kBesidePx = 1;
constexpr double kMaxUncertainPx = 1.4;
constexpr double kMaxChiSquared = 9;
// A link that was cut back to this length or less is removed, px.
constexpr double kMinRestPx = 6;

// Tells which points of links have another link beside them.
class SideBySide {
 public:
  SideBySide(const TopologyOptions& options, const DrawingGraph& graph)
      : graph_(graph),
        min_cosine_(std::cos(options.min_junction_angle_deg * kDeg)),
        places_(CollectPlaces(graph)),
        index_(places_.position) {}

  // Returns whether another link, at an index for which counts(link, index) holds, lies beside a
  // point.
  template <typename Counts>
  bool At(LinkId id, int k, Counts&& counts) {
    const DrawingLink& link = graph_.links[id];
    const LinkVertex& vertex = link.vertices[k];
    const Eigen::Vector3d direction = TangentAt(link, k);
    // Along the link, the nearest point of the other one is at most half the spacing away.
    const double radius = std::hypot(kMaxUncertainPx, kHalfSpacingPx) * vertex.footprint;
    index_.FindWithin(link.points_in_world[k], radius, &near_);
    return std::any_of(near_.begin(), near_.end(), [&](const SpatialIndex::Neighbor& neighbor) {
      const auto& [other, at] = places_.point[neighbor.index];
      if (other == id || !counts(other, at)) return false;
      const Eigen::Vector3d offset = places_.position[neighbor.index] - link.points_in_world[k];
      return IsNear(offset - offset.dot(direction) * direction, vertex) &&
             std::abs(TangentAt(graph_.links[other], at).dot(direction)) > min_cosine_;
    });
  }

 private:
  // Points of links are up to 2 px apart.
  static constexpr double kHalfSpacingPx = 1.2;

  static bool IsNear(const Eigen::Vector3d& across, const LinkVertex& vertex) {
    const double distance_px = across.norm() / vertex.footprint;
    return distance_px <= kBesidePx ||
           (distance_px <= kMaxUncertainPx && vertex.information.trace() > 0 &&
            across.dot(vertex.information * across) < kMaxChiSquared);
  }

  const DrawingGraph& graph_;
  double min_cosine_;
  Places places_;
  SpatialIndex index_;
  std::vector<SpatialIndex::Neighbor> near_;
};

// The points of a link that remain: [begin, end).
struct Rest {
  int begin = 0;
  int end = 0;

  bool Contains(int k) const { return k >= begin && k < end; }
  bool operator==(const Rest&) const = default;
};

}  // namespace

int64_t TrimEnds(const TopologyOptions& options, GraphEditor* editor) {
  SideBySide beside(options, editor->graph());
  std::vector<Rest> rest;
  for (LinkId id = 0; id < editor->NumLinks(); ++id) rest.push_back({0, editor->link(id).size()});
  int64_t num_trimmed = 0;
  for (const LinkEnd& free : editor->FreeEnds()) {
    if (editor->link(free.link).vertices.empty()) continue;
    Rest& own = rest[free.link];
    const auto is_covered = [&](int k) {
      return beside.At(free.link, k,
                       [&](LinkId other, int at) { return rest[other].Contains(at); });
    };
    const Rest before = own;
    if (free.end == 0) {
      while (own.begin < own.end && is_covered(own.begin)) ++own.begin;
    } else {
      while (own.begin < own.end && is_covered(own.end - 1)) --own.end;
    }
    if (own == before) continue;
    ++num_trimmed;
    if (ArcPx(editor->link(free.link), own.begin, own.end - 1) <= kMinRestPx) own = {0, 0};
  }
  for (LinkId id = 0; id < static_cast<LinkId>(rest.size()); ++id) {
    if (rest[id].end == 0) {
      editor->Remove(id);
    } else {
      editor->CutTo(id, rest[id].begin, rest[id].end);
    }
  }
  editor->Compact();
  return num_trimmed;
}

std::vector<uint8_t> FindUncoveredLinks(const TopologyOptions& options, const DrawingGraph& graph) {
  std::vector<uint8_t> keep(graph.links.size(), 1);
  std::vector<std::pair<double, LinkId>> by_length;  // px
  for (size_t l = 0; l < keep.size(); ++l) {
    if (graph.links[l].vertices.empty()) continue;
    by_length.push_back({LengthPx(graph.links[l]), static_cast<LinkId>(l)});
  }
  SideBySide beside(options, graph);
  std::sort(by_length.begin(), by_length.end());
  for (const auto& [length, id] : by_length) {
    int covered = 0;
    const int size = graph.links[id].size();
    for (int k = 0; k < size; ++k) {
      covered += beside.At(id, k, [&](LinkId other, int) { return keep[other] != 0; });
    }
    keep[id] = covered < options.covered_share * size;
  }
  return keep;
}

}  // namespace limn
