// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// The pixel footprint rho of a point: depth / focal length, that is, the width of a pixel there in
// world units. The only unit of length in space. Defined for views that have the point in front of
// them; occlusion is ignored.

// Nothing if the point is behind the camera.
std::optional<double> FootprintIn(const View& view, const Eigen::Vector3d& point_in_world);

// Median over some of the views; 0 if none of them has the point in front.
double MedianFootprint(const Eigen::Vector3d& point_in_world, std::span<const ViewId> of_views,
                       const std::vector<View>& views);

// At a point of a link: the median over its supporting views, or over all if none of those has it
// in front; 0 if no view has.
double LinkFootprint(const DrawingLink& link, const Eigen::Vector3d& point_in_world,
                     const std::vector<View>& views);

// At the link's middle point: one footprint for the whole link.
double LinkFootprint(const DrawingLink& link, const std::vector<View>& views);

// At a point without known supporting views: the median over the views that contain it, else over
// those that have it in front; behind all cameras, the smallest distance / focal length. Always
// positive. Linear in the number of views. Precondition: there is a view.
double PixelFootprint(const std::vector<View>& views, const Eigen::Vector3d& point_in_world);

// PixelFootprint at the middle of the curve's length; 1 for a curve without points.
double FootprintOfCurve(const std::vector<View>& views, const Polyline3d& curve);

}  // namespace limn
