// SPDX-License-Identifier: BSD-3-Clause
#include "limn/primitives/link_samples.h"

#include <algorithm>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

constexpr double kSpacingPx = 2;
constexpr int kMinSteps = 4;
// Tangents are measured over this many samples before and after.
constexpr size_t kTangentReach = 3;
// Weight of offsets along the curve: they only keep the ends in place.
constexpr double kAlongWeight = 0.1;

// The supporting views, or those that show the point if there are none: a camera that looks aside
// may be arbitrarily near to it.
std::vector<ViewId> ViewsOf(const DrawingLink& link, const Eigen::Vector3d& point,
                            const std::vector<View>& views) {
  if (!link.supporting_views.empty()) return link.supporting_views;
  std::vector<ViewId> showing;
  for (size_t v = 0; v < views.size(); ++v) {
    if (views[v].Project(point)) showing.push_back(static_cast<ViewId>(v));
  }
  return showing;
}

// The gradient of the distance across the projected curve; nothing if the curve is not seen.
std::optional<Eigen::Vector3d> AcrossGradient(const View& view, const Eigen::Vector3d& point,
                                              const Eigen::Vector3d& tangent) {
  const auto direction = ProjectedDirection(view, point, tangent);
  if (!direction) return std::nullopt;
  const Eigen::Vector3d in_cam = view.cam_from_world * point;
  const double z = in_cam.z();
  const PinholeCamera& camera = view.camera;
  const Eigen::Vector2d normal(-direction->y(), direction->x());
  const Eigen::Vector2d scaled(normal.x() * camera.fx / z, normal.y() * camera.fy / z);
  const Eigen::Vector3d gradient_in_cam(scaled.x(), scaled.y(),
                                        -(scaled.x() * in_cam.x() + scaled.y() * in_cam.y()) / z);
  return view.cam_from_world.rotation.conjugate() * gradient_in_cam;
}

Eigen::Matrix3d Across(const Eigen::Vector3d& point, const Eigen::Vector3d& tangent,
                       const std::vector<View>& views, const std::vector<ViewId>& of_link,
                       double footprint) {
  Eigen::Matrix3d metric = Eigen::Matrix3d::Zero();
  int count = 0;
  for (const ViewId v : of_link) {
    if (const auto gradient = AcrossGradient(views[v], point, tangent)) {
      metric += *gradient * gradient->transpose();
      ++count;
    }
  }
  if (count > 0) {
    metric /= count;
  } else {
    metric = Eigen::Matrix3d::Identity() / (footprint * footprint);
  }
  const double along = kAlongWeight / footprint;
  metric += along * along * tangent * tangent.transpose();
  // The root; eigenvalues below zero are rounding.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(metric);
  return eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace

LinkSamples SampleLink(const DrawingLink& link, const std::vector<View>& views) {
  LinkSamples result;
  const double length = Length(link.points_in_world);
  if (!(length > 0)) return result;
  const double footprint = LinkFootprint(link, views);
  if (!(footprint > 0)) return result;
  result.length_px = length / footprint;
  result.footprint = footprint;
  const double spacing = std::min(kSpacingPx * footprint, length / kMinSteps);
  const Polyline3d points = ResampleUniform(link.points_in_world, spacing);
  const size_t last = points.size() - 1;
  for (size_t k = 0; k <= last; ++k) {
    const Eigen::Vector3d tangent =
        (points[std::min(k + kTangentReach, last)] - points[k - std::min(k, kTangentReach)])
            .normalized();
    LinkSample3d sample;
    sample.position = points[k];
    sample.t = static_cast<double>(k) / static_cast<double>(last);
    sample.across = Across(points[k], tangent, views, ViewsOf(link, points[k], views), footprint);
    sample.tangent = tangent;
    result.samples.push_back(sample);
  }
  return result;
}

void DiscountEnds(const std::array<bool, 2>& ends, double zone_px, LinkSamples* link) {
  constexpr double kWeight = 0.02;
  constexpr double kMaxZone = 0.25;  // of the link
  const double zone = std::min(zone_px / link->length_px, kMaxZone);
  for (LinkSample3d& sample : link->samples) {
    const bool is_near = (ends[0] && sample.t < zone) || (ends[1] && sample.t > 1 - zone);
    sample.weight = is_near ? kWeight : 1;
  }
}

}  // namespace limn
