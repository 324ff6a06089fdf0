// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/surfaces/surface_options.h"

namespace limn {

// A link that may bound a face.
struct FaceLink {
  LinkId link = -1;
  double footprint = 0;  // world units per px
  double length_px = 0;
  // Evenly spaced along it, three at least.
  Polyline3d samples;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  // Unit vectors along which the samples are spread most and least.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  // How far the samples are from a line and from a plane, px.
  double bend_px = 0;
  double twist_px = 0;

  bool IsStraight(double tolerance_px) const { return bend_px <= tolerance_px; }
};

// The links that may bound faces: neither tentative, nor outlines of smooth bodies, nor too short.
std::vector<FaceLink> MeasureFaceLinks(const DrawingGraph& graph, const std::vector<View>& views,
                                       const SurfaceOptions& options);

// Whether all samples are within `tolerance_px` of the plane normal . x = offset. Stops at the
// first sample outside: constant time for most links of a drawing.
bool LiesIn(const FaceLink& link, const Eigen::Vector3d& normal, double offset,
            double tolerance_px);

}  // namespace limn
