// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/geometry/triangle_mesh.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/curve_set.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

struct TruthOptions {
  // Number of views that must show what is kept.
  int min_views = 3;
  // A view shows what is visible in it and has edgels along it. If false: whatever is visible.
  bool require_edges = true;
  // Largest distance of an edgel from a projected curve, across the edge, or from a projected
  // point, and largest angle to a curve. Larger values tolerate errors of cameras and surfaces but
  // admit more accidental matches.
  double max_distance_px = 1.5;
  double max_angle_deg = 20;
  // How far behind the surface a visible point may be, pixel footprints. Higher: hidden edges are
  // kept; lower: edges are lost that only errors of the surface hide.
  double occlusion_px = 2;
  // Shorter gaps of a curve are closed, then shorter runs dropped; pixels in a typical view of it.
  double max_gap_px = 4;
  double min_length_px = 10;
  // Clouds: every point hides what is behind a disc of this radius, about the distance between
  // neighbors in the images. The tolerance of occlusion grows by three radii, so that surfaces up
  // to a slope of three do not hide themselves.
  double splat_px = 2;
  // Points have no direction, and images full of edgels have some near any point. A point is kept
  // if the probability that as many of the views that see it show it by accident is at most this
  // (bounded by LogChance); the probability in one view is the mean share of an image that is near
  // edgels. 1 = keep all.
  double max_chance = 0.01;

  // Throws OptionError.
  void Check() const;
};

// Length of curves, or number of points.
struct TruthAccount {
  double found = 0;    // in the input
  double visible = 0;  // visible in min_views views
  double shown = 0;    // shown by min_views views: visible, with edgels if required
  double kept = 0;     // after closing gaps and dropping short runs, or accidental points
};

struct ExtractedTruth {
  CurveSet set;
  TruthAccount account;
};

// What the views show of curves on a surface, sampled about every pixel. A view sees a sample if
// the mesh does not hide it, and shows it if edgels run along the 9 px of curve around it
// (ShowsSegment). Ends of curves that are kept do not move. `image_curves`, one per view, may be
// empty if no edges are required. Throws OptionError. Time: views times samples, and rendering the
// mesh for each view.
ExtractedTruth ExtractTruthCurves(const std::vector<Polyline3d>& curves, const TriangleMesh& mesh,
                                  const std::vector<View>& views,
                                  const std::vector<ImageCurves>& image_curves,
                                  const TruthOptions& options, const RunContext& context);

// The points of a dense cloud that are near an edgel in enough of the views that see them; the
// cloud hides itself.
ExtractedTruth ExtractTruthPoints(const std::vector<Eigen::Vector3d>& cloud,
                                  const std::vector<View>& views,
                                  const std::vector<ImageCurves>& image_curves,
                                  const TruthOptions& options, const RunContext& context);

}  // namespace limn
