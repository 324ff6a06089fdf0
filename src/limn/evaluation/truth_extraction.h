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
  // That many views must show what is kept.
  int min_views = 3;
  // A view shows what is visible in it and where edgels run along. Without: whatever is visible.
  bool require_edges = true;
  // How near an edgel must be to a projected curve, across the edge, or to a projected point, and
  // so near in direction. Larger values forgive errors of cameras and surfaces and let chance in.
  double max_distance_px = 1.5;
  double max_angle_deg = 20;
  // How far behind the surface a visible point may be, pixel footprints. Higher: hidden edges come
  // in; lower: edges vanish that are hidden by errors of the surface alone.
  double occlusion_px = 2;
  // Shorter gaps of a curve are closed, then shorter runs dropped; pixels of a typical view of it.
  double max_gap_px = 4;
  double min_length_px = 10;
  // Of a cloud: its points hide what is behind discs of this radius, about the distance between
  // neighbors in the images. The tolerance of occlusion grows by three radii: slanted surfaces
  // hide nothing of themselves up to a slope of three.
  double splat_px = 2;
  // Points have no direction, and images full of edgels show some near any point. A point is kept
  // if the chance that so many of the views that see it show it is at most this (bound by
  // LogChance); the chance in one view is the mean share of an image that is so near to edgels.
  // 1 = any.
  double max_chance = 0.01;

  // Throws OptionError.
  void Check() const;
};

// Length of curves, or number of points.
struct TruthAccount {
  double found = 0;    // that went in
  double visible = 0;  // visible in min_views views
  double shown = 0;    // shown by so many: visible, with edges if they are required
  double kept = 0;     // after closing gaps and dropping short runs, or points by chance
};

struct ExtractedTruth {
  CurveSet set;
  TruthAccount account;
};

// What the views show of curves on a surface. The curves are looked at about every pixel; a view is
// asked where the depth of the mesh does not hide the place, and shows it if edgels run along the 9
// px of curve around it (ShowsSegment). Kept ends of curves keep their positions to the last bit.
// `image_curves`, one per view, may be empty if no edges are required. Throws OptionError. Time:
// views times samples, and rendering the mesh for each view.
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
