// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/junction_kind_scores.h"

#include <cmath>

#include "limn/geometry/spatial_index.h"

namespace limn {

JunctionKindScores ScoreJunctionsOfKind(const EvaluationScene& scene, JunctionKind kind,
                                        double tau) {
  const SpatialIndex of_2(NodesOfDegree(scene.reconstruction, 2));
  const SpatialIndex of_3(NodesOfDegree(scene.reconstruction, 3));
  const SpatialIndex of_4(NodesOfDegree(scene.reconstruction, 4));
  JunctionKindScores scores;
  for (const CurveNode& junction : scene.truth.nodes) {
    const Eigen::Vector3d& position = junction.position_in_world;
    if (junction.kind != kind || !scene.InRegion(position)) continue;
    const double radius = scene.options.junction_taus * tau * scene.unit_at(position);
    const auto has = [&](const SpatialIndex& nodes) {
      return nodes.size() > 0 && std::sqrt(nodes.Nearest(position).squared_distance) <= radius;
    };
    const bool is_bend = kind == JunctionKind::kCorner && junction.degree == 2;
    ++scores.num_junctions;
    scores.num_found += has(is_bend ? of_2 : of_3);
    scores.num_with_4 += has(of_4);
  }
  return scores;
}

}  // namespace limn
