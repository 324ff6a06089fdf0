// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/model/curve_set.h"

namespace limn {

// The protocol by which EMAP (CVPR 2024) and later works evaluate edges of ABC objects, which fill
// the unit cube: point sets and distances to the nearest point, in the unit of the object. The
// lengths below are the published ones; a "mm" in the literature is 0.001.
struct EmapOptions {
  // Spacing of the points of a reconstructed curve; shorter curves get none.
  double spacing = 0.005;
  // Replace the reconstructed points in each cell of a grid by their mean, as EMAP does but others
  // do not. The grid has `voxels_per_axis` cells over [-1, 1] and continues beyond.
  bool average_voxels = false;
  int voxels_per_axis = 256;
  // Spacing of the true points. Published scripts take 0.005 in the units of the CAD file, from
  // 0.00003 to 0.0009 of the cube; finer changes nothing.
  double true_spacing = 0.0005;
  std::vector<double> thresholds = {0.005, 0.01, 0.02};

  void Check() const;
};

struct EmapScores {
  struct Row {
    double threshold = 0;
    // Shares of the points nearer than the threshold, in [0, 1]; f is 0 if both are.
    double precision = 0, recall = 0, f = 0;
  };
  // Mean distance of reconstructed points to true ones, and of true points to reconstructed ones.
  double accuracy = 0;
  double completeness = 0;
  std::vector<Row> rows;  // as options.thresholds
  int num_points = 0;
};

// Nothing if the reconstruction has no points: published means omit such objects. Throws
// OptionError, or InputError if the truth has no points.
std::optional<EmapScores> EvaluateByEmap(const CurveSet& reconstruction, const CurveSet& truth,
                                         const EmapOptions& options = {});

// Means of the points in each cell of the grid, ordered by cell.
std::vector<Eigen::Vector3d> AverageVoxels(const std::vector<Eigen::Vector3d>& points,
                                           int voxels_per_axis);

}  // namespace limn
