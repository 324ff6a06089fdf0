// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "limn/evaluation/edge_solids.h"
#include "limn/evaluation/volume_overlap.h"
#include "limn/model/wireframe.h"
#include "limn/util/option_fields.h"
#include "limn/util/parallel.h"

namespace limn {

struct HssOptions {
  // Meters.
  double corner_distance = 0.5;
  double edge_radius = 0.5;
  EdgeShape edge_shape = EdgeShape::kCylinder;
  // MeasureOverlap's max_change.
  double max_change = 1e-4;
  // Corners inside and edges whose middle is inside count, meters. None: everything counts.
  std::optional<Eigen::AlignedBox3d> region = std::nullopt;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("corner_distance", self.corner_distance, Between(1e-9, 1e9),
          "how near a corner must be to the true one, m");
    visit("edge_radius", self.edge_radius, Between(1e-9, 1e9), "to which edges are thickened, m");
    visit("edge_shape", self.edge_shape, OneOf({"cylinder", "hoho2025"}),
          "what edges are thickened to: round cylinders, or the prisms that hoho2025's program "
          "makes, to compare with its figures");
    visit("max_change", self.max_change, Between(1e-6, 0.1),
          "how exactly the overlap of the edges is measured: it is, when lines twice "
          "as dense change it by less");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

// Shares are in [0, 1]; 0 where there is nothing to divide by.
struct HssScores {
  int num_corners = 0, num_true_corners = 0, num_right_corners = 0;
  int num_edges = 0, num_true_edges = 0;  // that have a solid
  double corner_precision = 0, corner_recall = 0, corner_f1 = 0;
  VolumeOverlap edges;  // cubic meters: drawn, true, both
  double edge_iou = 0;
  // Harmonic mean of corner_f1 and edge_iou.
  double hss = 0;
};

// The Hybrid Structure Score of the S23DR challenge (algorithm/evaluation.md#hss), of wireframes in
// meters. All corners count, also those of no edge, and copies each. Corners are assigned one to
// one so that the sum of distances is smallest, near or not, and are right if that distance is at
// most corner_distance. Nothing drawn, or no truth, scores 0, both together, too.
// Throws OptionError, InputError if a coordinate of a corner is not finite or beyond 1e15, there
// are too many corners (s^2 l > 2e12 for s and l, the smaller and the larger number), an index of
// an edge is none of a corner or edges are too long for their radius (MeasureOverlap), and
// Cancelled. Time: AssignPoints and MeasureOverlap.
HssScores ScoreHss(const Wireframe& drawn, const Wireframe& truth, const HssOptions& options = {},
                   const RunContext& context = {});

}  // namespace limn
