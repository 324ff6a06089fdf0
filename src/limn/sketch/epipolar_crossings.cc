#include "limn/sketch/epipolar_crossings.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Crossings flatter than this say nothing about depth.
constexpr double kMinSine = 0.02;
// Points this near the other camera's plane, as a share of the largest depth there, are left out.
constexpr double kMinRelativeDepth = 1e-3;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

CrossingFinder::CrossingFinder(const View& primary, const View& other,
                               const ImageCurves& curves_of_other)
    : relative_(MakeRelativeProjection(primary.camera, primary.cam_from_world, other.camera,
                                       other.cam_from_world)),
      chords_(primary, other, curves_of_other) {}

void CrossingFinder::Find(const FragmentRays& fragment, size_t vertex, double min_inverse_depth,
                          double max_inverse_depth, int rank,
                          std::vector<EpipolarCrossing>* crossings) {
  // With w the inverse depth, the sample projects to (a + w e) up to scale.
  const Eigen::Vector3d a =
      relative_.infinite_homography * fragment.positions_px[vertex].homogeneous();
  const Eigen::Vector3d& e = relative_.epipole;
  double near = max_inverse_depth;
  double far = min_inverse_depth;
  const double margin = kMinRelativeDepth * (std::abs(a.z()) + std::abs(e.z()) * near);
  // a.z + w e.z >= margin
  if (e.z() > 0) far = std::max(far, (margin - a.z()) / e.z());
  if (e.z() < 0) near = std::min(near, (margin - a.z()) / e.z());
  if (e.z() == 0 && a.z() < margin) return;
  if (!(far < near)) return;
  on_line_.clear();
  chords_.Find(fragment.positions_px[vertex], &on_line_);
  const Eigen::Vector3d step = relative_.infinite_homography.leftCols<2>() *
                               fragment.tangents_px[vertex];  // of a, per px along the fragment
  for (const LineCrossing& crossing : on_line_) {
    const Eigen::Vector2d& pixel = crossing.position_px;
    const Eigen::Vector2d line = e.head<2>() - pixel * e.z();
    const double w = (pixel * a.z() - a.head<2>()).dot(line) / line.squaredNorm();
    if (!(w >= far && w <= near)) continue;
    const double depth = a.z() + w * e.z();
    const Eigen::Vector2d motion = line / depth;
    const double speed = motion.norm();
    const double across = Cross(motion, crossing.tangent);
    if (!(std::abs(across) > kMinSine * speed)) continue;
    const Eigen::Vector2d along = (step.head<2>() - pixel * step.z()) / depth;
    const double slope = -Cross(along, crossing.tangent) / across;
    const double turn_speed = (along + slope * motion).norm();
    if (!(turn_speed > 0)) continue;  // seen end on
    EpipolarCrossing found;
    found.view = rank;
    found.inverse_depth = static_cast<float>(w);
    found.slope_per_px = static_cast<float>(slope);
    found.across_px_per_inverse_depth = static_cast<float>(std::abs(across));
    found.rad_per_slope = static_cast<float>(std::abs(across) / turn_speed);
    found.px_per_inverse_depth = static_cast<float>(speed);
    crossings->push_back(found);
  }
}

}  // namespace limn
