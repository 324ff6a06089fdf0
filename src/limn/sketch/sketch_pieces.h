// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "limn/sketch/depth_modes.h"
#include "limn/sketch/sketch.h"
#include "limn/support/edgel_index.h"

namespace limn {

// Depths of all vertices of a fragment from those of some of them: linear in arc length between
// neighboring ones that both have a depth.
std::vector<FusedDepth> ExpandDepths(const FragmentRays& fragment, const std::vector<int>& vertices,
                                     const std::vector<FusedDepth>& depths);

// Fills gaps of up to 2.5 px, and epipolar-tangent (uncertain) stretches between certain ends of up
// to 30 px, by inverse depths linear in arc length, which are marked uncertain
// (algorithm/sketch.md#pieces).
void InterpolateGaps(const FragmentRays& fragment, std::vector<FusedDepth>* depths);

// Replaces every depth and slope by those of a line fitted, weighted, to the depths
// within `half_window_px` that no jump separates from it.
void SmoothDepths(const FragmentRays& fragment, double half_window_px,
                  std::vector<FusedDepth>* depths);

// Consecutive vertices of a fragment that form one 3D curve. A closed fragment without a break
// gives one run with closed = true; in other closed fragments runs may pass the last vertex: take
// indices modulo the size.
struct VertexRun {
  int begin = 0;
  int size = 0;
  bool closed = false;
};

// Cuts at vertices without depth and at jumps in depth that the slope of neither side explains;
// drops runs shorter than 8 px.
std::vector<VertexRun> FindRuns(const FragmentRays& fragment,
                                const std::vector<FusedDepth>& depths);

// Unit tangent, in the camera, of a curve through a vertex of a fragment at this inverse depth.
Eigen::Vector3d TangentInCam(const PinholeCamera& camera, const FragmentRays& fragment, int vertex,
                             double inverse_depth, double slope_per_px);

// The 3D curve of every `step`-th vertex of a run, without support.
Curve3D MakeCurve(const View& view, const FragmentRays& fragment,
                  const std::vector<FusedDepth>& depths, const VertexRun& run, int step = 1);

// Sets the support of every sample of a curve: its own edgel in the primary view and the best edgel
// within the gate in each of the given views (ascending, without the primary view).
void CollectSupport(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                    const std::vector<std::unique_ptr<EdgelIndex>>& edgels,
                    const std::vector<ViewId>& candidate_views, const SupportGate& gate,
                    Curve3D* curve);

}  // namespace limn
