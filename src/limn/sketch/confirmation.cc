// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/confirmation.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "limn/geometry/angle_between.h"
#include "limn/sketch/tangency.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// A hypothesis that none of the first views supports anywhere is given up.
constexpr size_t kFirstViews = 8;
// Half length of the stretch of curve that decides whether a view supports a sample, px, and the
// share of its samples that must be inliers: a single edgel may be there by chance.
constexpr double kSupportWindowPx = 4;
constexpr double kMinWindowSupport = 0.7;

// Marks in `supporting` the samples around which, in a window of arc length, enough of the samples
// that the view contains are inliers.
void SmoothAlongCurve(uint32_t bit, const FragmentRays& fragment, const CurveHypothesis& hypothesis,
                      HypothesisSupport* support) {
  const auto arc = [&](size_t j) { return fragment.arc_px[hypothesis.samples[j].vertex]; };
  const size_t count = hypothesis.samples.size();
  size_t begin = 0;
  size_t end = 0;
  int contained = 0;
  int inliers = 0;
  for (size_t j = 0; j < count; ++j) {
    for (; end < count && arc(end) <= arc(j) + kSupportWindowPx; ++end) {
      contained += (support->contained[end] & bit) != 0;
      inliers += (support->inliers[end] & bit) != 0;
    }
    for (; arc(begin) < arc(j) - kSupportWindowPx; ++begin) {
      contained -= (support->contained[begin] & bit) != 0;
      inliers -= (support->inliers[begin] & bit) != 0;
    }
    if (inliers > 0 && inliers >= kMinWindowSupport * contained) {
      support->supporting[j] |= bit;
    }
  }
}

}  // namespace

ConfirmationViews::ConfirmationViews(ViewId primary, const std::vector<ViewId>& confirmation_views,
                                     const std::vector<View>& views,
                                     const std::vector<std::unique_ptr<OrientationMask>>& masks) {
  const View& from = views[primary];
  for (const ViewId id : confirmation_views) {
    const View& to = views[id];
    const Rigid3d to_from = to.cam_from_world * Inverse(from.cam_from_world);
    views_.push_back(
        {id, MakeRelativeProjection(from.camera, from.cam_from_world, to.camera, to.cam_from_world),
         to.camera.Calibration() * to_from.rotation.toRotationMatrix(),
         Inverse(to_from).translation, &to.region, masks[id].get()});
  }
}

void ConfirmationViews::ConfirmInView(const Entry& entry, uint32_t bit,
                                      const FragmentRays& fragment,
                                      const CurveHypothesis& hypothesis,
                                      std::vector<Inlier>* inliers,
                                      HypothesisSupport* support) const {
  const Eigen::Matrix3d& homography = entry.from_primary.infinite_homography;
  const Eigen::Vector3d& epipole = entry.from_primary.epipole;
  for (size_t j = 0; j < hypothesis.samples.size(); ++j) {
    const HypothesisSample& sample = hypothesis.samples[j];
    const Eigen::Vector3d projected =
        sample.depth * (homography * fragment.positions_px[sample.vertex].homogeneous()) + epipole;
    if (!(projected.z() > 0)) continue;
    const double inverse = 1 / projected.z();
    const Eigen::Vector2d pixel(projected.x() * inverse, projected.y() * inverse);
    if (!entry.region->Contains(pixel)) continue;
    support->contained[j] |= bit;
    const Eigen::Vector3d direction = entry.direction_from_primary * sample.tangent_in_cam;
    const double dx = direction.x() - pixel.x() * direction.z();
    const double dy = direction.y() - pixel.y() * direction.z();
    if (!entry.mask->Supports(pixel.x(), pixel.y(), dx, dy)) continue;
    support->inliers[j] |= bit;
    // d pixel / d inverse depth; projected / depth = at_infinity + inverse_depth * epipole.
    const double scale = sample.depth * inverse;
    (*inliers)[j] = {dx, dy, (epipole.x() - pixel.x() * epipole.z()) * scale,
                     (epipole.y() - pixel.y() * epipole.z()) * scale};
  }
}

void ConfirmationViews::AddWeights(uint32_t bit, const std::vector<Inlier>& inliers,
                                   HypothesisSupport* support) const {
  const double sin_low = std::sin(kMinEpipolarAngleDeg * kDeg);
  const double sin_high = std::sin(kMaxEpipolarAngleDeg * kDeg);
  for (size_t j = 0; j < inliers.size(); ++j) {
    if (!(support->supporting[j] & bit)) continue;
    double weight = kMinTangencyWeight;
    if (support->inliers[j] & bit) {
      const Inlier& in = inliers[j];
      const double speed = std::sqrt(in.motion_x * in.motion_x + in.motion_y * in.motion_y);
      const double norm = std::sqrt(in.dx * in.dx + in.dy * in.dy) * speed;
      const double sine = norm > 0 ? std::abs(in.dx * in.motion_y - in.dy * in.motion_x) / norm : 0;
      weight = std::clamp((sine - sin_low) / (sin_high - sin_low), kMinTangencyWeight, 1.0);
      support->px_per_inverse_depth[j] += speed;
    }
    support->weighted[j] += weight;
  }
}

std::optional<HypothesisSupport> ConfirmationViews::Confirm(const FragmentRays& fragment,
                                                            const CurveHypothesis& hypothesis,
                                                            ViewId second) const {
  const size_t count = hypothesis.samples.size();
  HypothesisSupport support;
  support.contained.assign(count, 0);
  support.inliers.assign(count, 0);
  support.supporting.assign(count, 0);
  support.weighted.assign(count, 0);
  support.px_per_inverse_depth.assign(count, 0);
  std::vector<Inlier> inliers(count);
  for (size_t k = 0; k < views_.size(); ++k) {
    if (views_[k].id == second) continue;
    const uint32_t bit = 1u << k;
    ConfirmInView(views_[k], bit, fragment, hypothesis, &inliers, &support);
    SmoothAlongCurve(bit, fragment, hypothesis, &support);
    AddWeights(bit, inliers, &support);
    const bool hopeless = k + 1 == kFirstViews && views_.size() > 2 * kFirstViews &&
                          std::all_of(support.supporting.begin(), support.supporting.end(),
                                      [](uint32_t mask) { return mask == 0; });
    if (hopeless) return std::nullopt;
  }
  for (size_t j = 0; j < count; ++j) {
    const uint32_t both = support.supporting[j] & support.inliers[j];
    support.px_per_inverse_depth[j] /= std::max(1, std::popcount(both));
  }
  return support;
}

double ConfirmationViews::MaxAngleDeg(const Eigen::Vector3d& point_in_cam, uint32_t mask) const {
  double max_angle = 0;
  for (size_t k = 0; k < views_.size(); ++k) {
    if (!(mask >> k & 1)) continue;
    const Eigen::Vector3d ray = point_in_cam - views_[k].center_in_primary;
    max_angle = std::max(max_angle, AngleBetween(point_in_cam, ray) / kDeg);
  }
  return max_angle;
}

}  // namespace limn
