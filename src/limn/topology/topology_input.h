// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve3d.h"
#include "limn/support/edgel_residual.h"
#include "limn/support/point_fit.h"
#include "limn/support/view_edgels.h"

namespace limn {

// The images, as the topology stages see them. `curves[v]` and `edgels[v]` belong to `views[v]`.
struct TopologyInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const std::vector<std::unique_ptr<ViewEdgels>>& edgels;
  // How near an edgel must be to a curve to support it.
  SupportGate gate;
  // Links do not grow out of this box.
  std::optional<Eigen::AlignedBox3d> box = std::nullopt;

  const Edgel& EdgelOf(const EdgelRef& ref) const {
    return curves[ref.view].edge_map.edgels[ref.edgel];
  }
  EdgelLine LineOf(const EdgelRef& ref) const {
    return {EdgelOf(ref).position_px, edgels[ref.view]->across[ref.edgel].cast<double>()};
  }
  // The distance of a point from an edgel; empty if it is behind the camera.
  std::optional<EdgelResidual> Residual(const EdgelRef& ref, const Eigen::Vector3d& point) const {
    return ResidualToEdgel(views[ref.view], LineOf(ref), point);
  }
  // An edgel as a target for a point of a curve.
  EdgelTarget TargetOf(const EdgelRef& ref) const {
    return {views[ref.view], LineOf(ref), ResidualVariance(EdgelOf(ref))};
  }
  // What edgels say about the position of a point, world units: their inverse variances along the
  // gradients of their residuals.
  Eigen::Matrix3d Information(const std::vector<EdgelRef>& refs,
                              const Eigen::Vector3d& point) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const EdgelRef& ref : refs) {
      const auto residual = Residual(ref, point);
      if (!residual) continue;
      const Eigen::Vector3d& gradient = residual->gradient;
      sum += gradient * gradient.transpose() / ResidualVariance(EdgelOf(ref));
    }
    return sum;
  }
  // The edgel that best supports a point of a curve with this tangent, if the view shows one.
  std::optional<EdgelRef> EdgelAt(ViewId view, const Eigen::Vector3d& point,
                                  const Eigen::Vector3d& tangent, const SupportGate& within) const {
    const auto sight = See(views[view], point, tangent);
    if (!sight) return std::nullopt;
    const auto match = edgels[view]->edgels.Best(sight->position_px, sight->direction, within);
    return match ? std::optional(EdgelRef{view, match->edgel}) : std::nullopt;
  }
};

}  // namespace limn
