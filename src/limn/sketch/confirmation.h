// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "limn/geometry/epipolar.h"
#include "limn/sketch/fragment_rays.h"
#include "limn/sketch/sketch_options.h"
#include "limn/support/orientation_mask.h"

namespace limn {

// How the confirmation views see the samples of one hypothesis (algorithm/sketch.md#confirmation).
// Bit k of a mask stands for the k-th confirmation view of the plan (at most 32).
struct HypothesisSupport {
  // Views whose image contains the sample.
  std::vector<uint32_t> contained;
  // Views with an edgel at the sample's place and direction.
  std::vector<uint32_t> inliers;
  // Views in which enough of the samples around this one are inliers: local support (ECCV 2016,
  // section 2).
  std::vector<uint32_t> supporting;
  // Sum of the tangency weights of the supporting views: 1 where the curve crosses the epipolar
  // lines of the primary view, small where it runs along them and would be supported at any depth.
  std::vector<double> weighted;
  // Mean image motion over the supporting views per unit of inverse depth, px.
  std::vector<double> px_per_inverse_depth;
};

// The second view of a hypothesis that was not made with a single one.
constexpr ViewId kNoView = -1;

// The confirmation views of one primary view, prepared for queries.
class ConfirmationViews {
 public:
  ConfirmationViews(ViewId primary, const std::vector<ViewId>& confirmation_views,
                    const std::vector<View>& views,
                    const std::vector<std::unique_ptr<OrientationMask>>& masks);

  // Support of a hypothesis made with `second`, which does not confirm its own hypothesis. Empty if
  // the first views, the most diverse ones, support it nowhere.
  std::optional<HypothesisSupport> Confirm(const FragmentRays& fragment,
                                           const CurveHypothesis& hypothesis, ViewId second) const;

  // Largest angle, degrees, between the primary ray to `point_in_cam` and the rays of the views in
  // `mask`.
  double MaxAngleDeg(const Eigen::Vector3d& point_in_cam, uint32_t mask) const;

  size_t size() const { return views_.size(); }

 private:
  struct Entry {
    ViewId id;
    RelativeProjection from_primary;
    Eigen::Matrix3d direction_from_primary;  // K R: homogeneous image direction of a 3D direction
    Eigen::Vector3d center_in_primary;
    const ImageRegion* region;
    const OrientationMask* mask;
  };
  // An inlier sample in one view: image directions of the tangent and of the motion with inverse
  // depth.
  struct Inlier {
    double dx = 0;
    double dy = 0;
    double motion_x = 0;
    double motion_y = 0;
  };
  void ConfirmInView(const Entry& entry, uint32_t bit, const FragmentRays& fragment,
                     const CurveHypothesis& hypothesis, std::vector<Inlier>* inliers,
                     HypothesisSupport* support) const;
  void AddWeights(uint32_t bit, const std::vector<Inlier>& inliers,
                  HypothesisSupport* support) const;

  std::vector<Entry> views_;
};

}  // namespace limn
