// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view_finder.h"
#include "limn/topology/topology_input.h"

namespace limn {

// A place on a link, about 1.5 px from the next.
struct EvidenceSample {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();  // unit
};

// An edgel that runs along a link at a sample.
struct SampleHit {
  int sample = -1;
  EdgelId edgel = kInvalidEdgel;
  float residual_px = 0;
  // Whether no better link explains the edgel (FindClaims).
  bool own = true;
  // If not its own: whether the better link is at another depth in this view.
  bool elsewhere = false;
};

// What one view shows of a link; hits ascend by sample.
struct LinkSight {
  ViewId view = -1;
  std::vector<SampleHit> hits;
};

// What the images say for a link (algorithm/belief.md#evidence). Means are over the samples; they,
// and the evidence, are zero for a link without extent.
struct ImageEvidence {
  std::vector<EvidenceSample> samples;
  double footprint = 0;           // world units per px
  std::vector<LinkSight> sights;  // of the views that may contain the link, ascending
  double containing_views = 0;
  double showing_views = 0;
  // Negative logarithm of the probability that this many views show it by chance.
  double evidence = 0;

  // Share of the hits that are its own; 1 if there are none.
  double OwnShare() const;
  // Share of the hits that better links at other depths explain.
  double ElsewhereShare() const;
};

// The gate of the input is the widest of three: half and a quarter of its distance are tried, too.
// Time: samples times the views near the link, seven times that for at most 60 samples.
ImageEvidence FindEvidence(const TopologyInput& input, const ViewFinder& finder,
                           const DrawingLink& link);

}  // namespace limn
