#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve_fragment.h"
#include "limn/model/curve_set.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

struct ShownTruthOptions {
  // A view shows a point of the truth if a linked edgel is this near across the edge, px, and so
  // near in direction (points of no curve have none). Occlusion is not known, so chance counts too.
  double max_distance_px = 1.5;
  double max_angle_deg = 15;
  // That many views must show it.
  int min_views = 3;
  // Only what is inside. None: everything.
  std::optional<Eigen::AlignedBox3d> region;

  void Check() const;
};

// The points of the truth, every half pixel footprint of its curves, that the image curves show:
// the recall of these points is a ceiling for what any reconstruction from the same image curves
// can reach. Throws OptionError. Time: points times views.
CurveSet ShownTruth(const CurveSet& truth, const std::vector<View>& views,
                    const std::vector<ImageCurves>& curves, const ShownTruthOptions& options,
                    const RunContext& context);

}  // namespace limn
