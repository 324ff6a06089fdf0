#pragma once

#include <set>
#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Views after and before refinement, and the refined positions of the hints' points.
struct RefinedScene {
  const std::vector<View>& views;
  const std::vector<View>& given_views;
  const SceneHints& hints;
  const std::vector<Eigen::Vector3d>& points;
};

// Applies refined cameras to the model that the given views and hints were made from. Focal lengths
// are multiplied by the factor by which those of the views changed; distortion and principal points
// stay, images without a view keep their poses. The errors of the points become unknown. Throws
// IoError, and changes nothing, if this is another model. Rigs and frames are left as they are.
void ApplyRefinement(const RefinedScene& refined, SparseModel* model);

// How far the points of each of these images (indices), in the median, move when its pose in `from`
// becomes that in `to`, px: for images that see points, in their order. Precondition: the models
// differ in poses only.
std::vector<double> PoseShiftsPx(const std::set<size_t>& images, const SparseModel& from,
                                 const SparseModel& to);

}  // namespace limn::colmap_ext
