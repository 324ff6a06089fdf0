#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"
#include "limn/visibility/depth_image.h"
#include "limn/visibility/orthographic_depth.h"

namespace limn {

// Whether something stands before a point, seen from where the picture is seen. Empty: nothing
// does.
using IsHidden = std::function<bool(const Eigen::Vector3d& point_in_world)>;

// Behind a depth image of a view (of a depth map, cloud or mesh) by more than `tolerance_px` pixel
// footprints, in its pixel and within `margin_px` to all sides: curves that are a pixel off do not
// vanish behind the outline beside them. Both are kept by the result.
IsHidden HiddenInView(View view, DepthImage depth, double tolerance_px = 4, double margin_px = 1);

// The same in parallel projection, for sheets; tolerance and margin in depth pixels.
IsHidden HiddenOnSheet(OrthographicDepth depth, double tolerance_px = 4, double margin_px = 1);

// A part of a curve, in the curve's own parameter.
struct ShownRun {
  double from = 0;
  double to = 0;
  bool hidden = false;
};

// Places of a curve, ascending, and the length of the drawn curve up to them.
struct CurveSample {
  double t = 0;
  double length_px = 0;
};

// The visible and the hidden parts of a curve, in turns, as told by its samples; borders between
// samples are found by halving. Parts shorter than `min_run_px` go with what is around them: first
// hidden ones, then visible ones, so that single wrong depths leave no gaps and no crumbs. At least
// two samples.
std::vector<ShownRun> FindRuns(const std::function<Eigen::Vector3d(double)>& point_at,
                               const std::vector<CurveSample>& samples, const IsHidden& is_hidden,
                               double min_run_px);

}  // namespace limn
