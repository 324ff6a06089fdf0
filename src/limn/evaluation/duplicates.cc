// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/duplicates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

const double kMinCosine = std::cos(30.0 * kDeg);
// Steps are a fraction of the tolerance where the unit of length is smallest along a curve. Where
// it is hundreds of times as large, the cameras are not those of the curves. Of one curve: a sketch
// has many copies of an edge.
constexpr ptrdiff_t kMaxNeighbors = 4000;

struct Approach {
  int sample = -1;
  PolylinePoint place;
};

// Of the neighbors [begin, end), all of one curve, the nearest point on their cells.
Approach NearestApproach(const AlongsideSearch& search, const Eigen::Vector3d& query,
                         const SpatialIndex::Neighbor* begin, const SpatialIndex::Neighbor* end) {
  Approach best;
  best.place.squared_distance = std::numeric_limits<double>::infinity();
  for (const SpatialIndex::Neighbor* neighbor = begin; neighbor != end; ++neighbor) {
    const PolylinePoint place = ClosestPoint(search.samples.Cell(neighbor->index), query);
    if (place.squared_distance < best.place.squared_distance) best = {neighbor->index, place};
  }
  return best;
}

// The end (0 or 1) of its curve at which the approach is nearest, or -1.
int EndOfApproach(const CurveSamples& samples, const Approach& approach) {
  if (samples.IsFirst(approach.sample) && approach.place.segment == 0 && approach.place.t == 0) {
    return 0;
  }
  if (samples.IsLast(approach.sample) && approach.place.segment == 1 && approach.place.t == 1) {
    return 1;
  }
  return -1;
}

bool IsAlongside(const AlongsideSearch& search, int sample, double radius,
                 const Approach& approach) {
  const CurveSamples& samples = search.samples;
  if (approach.place.squared_distance > radius * radius) return false;
  const double cosine = samples.Direction(sample).dot(samples.Direction(approach.sample));
  if (!(std::abs(cosine) >= kMinCosine)) return false;
  const int end = EndOfApproach(samples, approach);
  if (end < 0) return true;
  const int node = search.topology.end_nodes[samples.CurveOf(approach.sample)][end];
  for (const int own : search.topology.end_nodes[samples.CurveOf(sample)]) {
    if (search.node_groups[own] == search.node_groups[node]) return false;
  }
  return true;
}

}  // namespace

bool RunsAlongsideAnother(const AlongsideSearch& search, int sample, double radius,
                          std::vector<SpatialIndex::Neighbor>* scratch) {
  const CurveSamples& samples = search.samples;
  const Eigen::Vector3d& query = samples.Position(sample);
  samples.FindNear(query, radius, scratch);
  const SpatialIndex::Neighbor* const end = scratch->data() + scratch->size();
  // Ascending order keeps the samples of one curve together.
  for (const SpatialIndex::Neighbor* begin = scratch->data(); begin != end;) {
    const int curve = samples.CurveOf(begin->index);
    const SpatialIndex::Neighbor* next = begin;
    while (next != end && samples.CurveOf(next->index) == curve) ++next;
    if (next - begin > kMaxNeighbors) {
      throw InputError("a pixel covers so much more at one place of a curve than at another that " +
                       std::to_string(next - begin) +
                       " steps are within one tolerance: are the cameras those of the drawing?");
    }
    if (curve != samples.CurveOf(sample) &&
        IsAlongside(search, sample, radius, NearestApproach(search, query, begin, next))) {
      return true;
    }
    begin = next;
  }
  return false;
}

std::vector<int> GroupNodes(const std::vector<Polyline3d>& polylines, const CurveTopology& topology,
                            const std::function<double(const Polyline3d&)>& scale_of) {
  UnionFind groups(static_cast<int>(topology.nodes.size()));
  for (size_t curve = 0; curve < polylines.size(); ++curve) {
    const auto& [first, last] = topology.end_nodes[curve];
    if (first >= 0 && Length(polylines[curve]) < scale_of(polylines[curve]))
      groups.Union(first, last);
  }
  std::vector<int> representatives(topology.nodes.size());
  for (size_t node = 0; node < representatives.size(); ++node) {
    representatives[node] = groups.Find(static_cast<int>(node));
  }
  return representatives;
}

}  // namespace limn
