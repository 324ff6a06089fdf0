// SPDX-License-Identifier: BSD-3-Clause
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
                               const FragmentChords& chords_of_other)
    : relative_(MakeRelativeProjection(primary.camera, primary.cam_from_world, other.camera,
                                       other.cam_from_world)),
      chords_(primary, other, chords_of_other) {}

CrossingFinder::SeenVertex CrossingFinder::See(const FragmentRays& fragment, size_t vertex,
                                               const InverseDepthRange& range) const {
  SeenVertex seen;
  seen.at_infinity = relative_.infinite_homography * fragment.positions_px[vertex].homogeneous();
  seen.in_front = range;
  auto& [far, near] = seen.in_front;
  const double a = seen.at_infinity.z();
  const double e = relative_.epipole.z();
  const double margin = kMinRelativeDepth * (std::abs(a) + std::abs(e) * near);
  // a + w e >= margin
  if (e > 0) far = std::max(far, (margin - a) / e);
  if (e < 0) near = std::min(near, (margin - a) / e);
  if (e == 0 && a < margin) near = far;
  return seen;
}

void CrossingFinder::Find(const FragmentRays& fragment, size_t vertex,
                          const InverseDepthRange& range, int rank,
                          std::vector<EpipolarCrossing>* crossings) {
  const SeenVertex seen = See(fragment, vertex, range);
  if (!(seen.in_front.from < seen.in_front.to)) return;
  on_line_.clear();
  chords_.Find(fragment.positions_px[vertex], {&seen.in_front, 1}, &on_line_);
  Append(fragment, vertex, seen, rank, crossings);
}

void CrossingFinder::FindNear(const FragmentRays& fragment, size_t vertex,
                              const InverseDepthRange& range, std::span<const DepthPlace> places,
                              int rank, std::vector<EpipolarCrossing>* crossings) {
  const SeenVertex seen = See(fragment, vertex, range);
  const auto& [far, near] = seen.in_front;
  if (!(far < near)) return;
  const Eigen::Vector3d& e = relative_.epipole;
  ranges_.clear();
  for (const DepthPlace& place : places) {
    const double w = place.inverse_depth;
    if (!(w >= far && w <= near)) continue;
    const Eigen::Vector3d projected = seen.at_infinity + w * e;
    const Eigen::Vector2d pixel = projected.hnormalized();
    const double speed = (e.head<2>() - pixel * e.z()).norm() / projected.z();
    ranges_.push_back({std::max(far, w - kNearPx / speed), std::min(near, w + kNearPx / speed)});
  }
  if (ranges_.empty()) return;
  on_line_.clear();
  chords_.Find(fragment.positions_px[vertex], ranges_, &on_line_);
  Append(fragment, vertex, seen, rank, crossings);
}

void CrossingFinder::Append(const FragmentRays& fragment, size_t vertex, const SeenVertex& seen,
                            int rank, std::vector<EpipolarCrossing>* crossings) const {
  const Eigen::Vector3d& a = seen.at_infinity;
  const Eigen::Vector3d& e = relative_.epipole;
  const auto& [far, near] = seen.in_front;
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
