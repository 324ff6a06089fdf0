#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"
#include "limn/refinement/refinement_options.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// `curves[v]` belongs to `views[v]`, which the supporting views of the links are ids of. The graph
// passes Validate().
struct RefinementInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const DrawingGraph& graph;
  // Of the sparse model; only used to refine poses. Null: there are none.
  const std::vector<ScenePoint>* points = nullptr;
};

// The cameras that a drawing was fitted with, when they were refined.
struct RefinedCameras {
  std::vector<View> views;              // as in the input; poses and focal lengths are new
  std::vector<Eigen::Vector3d> points;  // positions of the input's points
  // What refinement moved: the drawing's control points in the images, and the largest relative
  // change of a focal length.
  double median_shift_px = 0;
  double largest_focal_change = 0;
};

struct RefinementResult {
  DrawingGraph graph;
  // Only with refine_poses.
  std::optional<RefinedCameras> cameras;
  StageSummary summary;
};

// The drawing fitted to all images at once (ours; not in the paper). In every round each link is
// matched with the edgels near its reprojections, and then control points along all links move so
// that the reprojections pass through the tangent lines of their edgels: robust least squares over
// all views, with links that meet sharing the control point at their node, a penalty on bending
// that decides only where the edgels leave a place open, and none across corners. Only a link's
// supporting views are asked, and edgels whose brighter side is not that of nearly all others are
// left out: they belong to the other side of a thin bar. Views in which two links run so near to
// each other that their edges blur are not heard where enough others are (crowding.h). Half of the
// way links that others cover are removed and the topology is repaired (RepairTopology). The sigmas
// come from the inverse of the normal matrix, scaled by how well the views agree
// (variance_factors.h). Links that too few views show keep their shape, with sigmas of at least
// max_distance_px. The parts of a link that was cut share its members. With `refine_poses` rounds
// go before in which the cameras move too, together with curves and points (pose_fit.h), after
// which place, orientation and scale of the whole are those of the given cameras again (gauge.h).
// The result passes Validate(). Throws OptionError and Cancelled. Time: rounds times length of all
// links in px times views.
RefinementResult RefineDrawing(const RefinementInput& input, const RefinementOptions& options,
                               const TopologyOptions& topology, const RunContext& context);

}  // namespace limn
