#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "limn/model/scene_hints.h"
#include "limn/refinement/edgel_matches.h"
#include "limn/util/parallel.h"

namespace limn {

// How the cameras differ from those that were given.
struct CameraCorrections {
  // Per view: x_in_cam = Exp(w) * (given x_in_cam) + t, as w (rad), t (world units).
  std::vector<std::array<double, 6>> motion;
  // Per view the index into log_focal; views of one camera have the same.
  std::vector<int> camera_of_view;
  // Logarithm of the factor on the focal length.
  std::vector<double> log_focal;
};

// Corrections that change nothing.
CameraCorrections NoCorrections(const std::vector<View>& views);

// The corrected views. The factor acts on the virtual pinhole camera: exact without lens
// distortion; with it, rays off the axis differ by about twice the distortion in px times the
// relative change of the focal length: 0.04 px where it is 20 px, for a change of 0.1 %.
std::vector<View> Corrected(const std::vector<View>& views, const CameraCorrections& corrections);

struct PoseFitInput {
  const std::vector<View>& views;  // as given, not corrected
  const std::vector<ImageCurves>& curves;
  const std::vector<LinkMatches>& matches;
  // Per link: nonzero = it only follows its nodes and says nothing of the cameras.
  const std::vector<uint8_t>& frozen;
  const std::vector<ScenePoint>& points;
  // Residuals of curves much beyond this hardly count (Cauchy), px.
  double robust_px = 0.5;
};

// Move cameras, control points and scene points together to minimize the sum of FitCurves, with
//   sum over pixels of points of Cauchy(distance to the projected point / 0.5 px), stored px,
// and a weak hold of every camera where it was given: a change of 10 px in the image of the scene
// is one standard deviation. That fixes what images do not tell: place, orientation and scale of
// the whole. `positions` are of `points`; here those stay that fewer than two views see, or all
// from nearly the same direction, and those that would end behind a view. False, and nothing
// changed, if the solver fails. With Ceres, one sparse system, one thread. Deterministic. Throws
// Cancelled. Time per step: unknowns of the curves times the square of those of the cameras.
bool FitPoses(const PoseFitInput& input, const RefinementOptions& options,
              const RunContext& context, CameraCorrections* corrections, ControlGraph* control,
              std::vector<Eigen::Vector3d>* positions);

}  // namespace limn
