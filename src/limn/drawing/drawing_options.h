// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/drawing/trace_curves.h"
#include "limn/support/edgel_index.h"
#include "limn/topology/topology_options.h"
#include "limn/util/angles.h"
#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

struct DrawingOptions {
  // The views that must support a sample after re-triangulation, the primary one included: a share
  // of those that contain it, at least min and at most max.
  int min_supporting_views = 3;
  int max_supporting_views = 5;

  // Set by tests only.
  double supporting_views_share = 0.25;
  // Edgels within this distance across the edge and this angle support a sample.
  double max_support_distance_px = 1.0;
  double max_support_angle_deg = 15;
  // Re-triangulation: residuals beyond this count linearly (Huber), px.
  double robust_residual_px = 0.6;
  // Strength of the smoothing along a curve: standard deviation of the change of direction from one
  // sample to the next, px. Smaller is smoother; well determined samples prevail over it.
  double bending_sigma_px = 0.03;
  // Shorter pieces are dropped after re-triangulation, px.
  double min_piece_length_px = 4;

  TracingOptions tracing = {};
  // Edits after tracing, and between the fits of the refinement.
  TopologyOptions topology = {};

  SupportGate Gate() const { return {max_support_distance_px, 1.0, max_support_angle_deg * kDeg}; }

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("min_supporting_views", self.min_supporting_views, Between(2, 1e6),
          BasicOption("curves supported by fewer views are not drawn"));
    visit("max_supporting_views", self.max_supporting_views, Between(2, 1e6),
          "upper limit of the number of views that must support a curve");
    TopologyOptions::VisitFields(self.topology, visit);
  }
  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
