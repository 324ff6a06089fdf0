// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/hss.h"

#include <algorithm>
#include <string>

#include "limn/geometry/assignment.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kMaxCoordinate = 1e15;
// Of AssignPoints: some minutes.
constexpr double kMaxAssignmentSteps = 2e12;

double HarmonicMean(double a, double b) { return a + b > 0 ? 2 * a * b / (a + b) : 0; }

double ShareOfCount(int part, int whole) {
  return whole > 0 ? static_cast<double>(part) / whole : 0;
}

void CheckWireframe(const Wireframe& wireframe, const char* name) {
  for (const Eigen::Vector3d& vertex : wireframe.vertices) {
    if (!(vertex.array().abs() <= kMaxCoordinate).all()) {
      throw InputError(std::string(name) +
                       ": a coordinate of a corner is not finite or beyond 1e15");
    }
  }
  const int count = static_cast<int>(wireframe.vertices.size());
  for (const auto& [a, b] : wireframe.edges) {
    if (a < 0 || b < 0 || a >= count || b >= count) {
      throw InputError(std::string(name) + ": an edge from corner " + std::to_string(a) + " to " +
                       std::to_string(b) + " of " + std::to_string(count));
    }
  }
}

std::vector<Eigen::Vector3d> CornersIn(const Wireframe& wireframe, const HssOptions& options) {
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector3d& vertex : wireframe.vertices) {
    if (!options.region || options.region->contains(vertex)) corners.push_back(vertex);
  }
  return corners;
}

std::vector<EdgeSolid> SolidsIn(const Wireframe& wireframe, const HssOptions& options) {
  std::vector<EdgeSolid> solids = ThickenEdges(wireframe, options.edge_shape, options.edge_radius);
  if (!options.region) return solids;
  std::erase_if(solids, [&](const EdgeSolid& solid) {
    return !options.region->contains(Eigen::Vector3d((solid.start + solid.end) / 2));
  });
  return solids;
}

int CountRight(const std::vector<Eigen::Vector3d>& corners,
               const std::vector<Eigen::Vector3d>& truth, double max_distance,
               const RunContext& context) {
  const auto num_corners = static_cast<double>(corners.size());
  const auto num_true = static_cast<double>(truth.size());
  const auto [smaller, larger] = std::minmax(num_corners, num_true);
  if (smaller * smaller * larger > kMaxAssignmentSteps) {
    throw InputError(std::to_string(corners.size()) + " corners are too many to assign " +
                     std::to_string(truth.size()) +
                     " true ones: reduce with a larger tolerance (--Wireframe.tolerance), or judge "
                     "a part (--box)");
  }
  const std::vector<int> target_of = AssignPoints(corners, truth, context);
  int num_right = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (target_of[i] < 0) continue;
    if ((corners[i] - truth[target_of[i]]).norm() <= max_distance) ++num_right;
  }
  return num_right;
}

}  // namespace

HssScores ScoreHss(const Wireframe& drawn, const Wireframe& truth, const HssOptions& options,
                   const RunContext& context) {
  options.Check();
  CheckWireframe(drawn, "wireframe");
  CheckWireframe(truth, "true wireframe");
  const auto corners = CornersIn(drawn, options), true_corners = CornersIn(truth, options);
  const auto solids = SolidsIn(drawn, options), true_solids = SolidsIn(truth, options);
  HssScores scores;
  scores.num_corners = static_cast<int>(corners.size());
  scores.num_true_corners = static_cast<int>(true_corners.size());
  scores.num_edges = static_cast<int>(solids.size());
  scores.num_true_edges = static_cast<int>(true_solids.size());
  scores.num_right_corners = CountRight(corners, true_corners, options.corner_distance, context);
  scores.corner_precision = ShareOfCount(scores.num_right_corners, scores.num_corners);
  scores.corner_recall = ShareOfCount(scores.num_right_corners, scores.num_true_corners);
  scores.corner_f1 = HarmonicMean(scores.corner_precision, scores.corner_recall);
  scores.edges = MeasureOverlap(solids, true_solids, options.max_change, context);
  scores.edge_iou = scores.edges.Share();
  scores.hss = HarmonicMean(scores.corner_f1, scores.edge_iou);
  return scores;
}

}  // namespace limn
