// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polygon2d.h"
#include "limn/geometry/polyline.h"
#include "limn/surfaces/face_planes.h"

namespace limn {

// Coordinates in a plane.
struct PlaneFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();
  Eigen::Vector3d y_axis = Eigen::Vector3d::UnitY();

  Eigen::Vector3d Normal() const;
  Eigen::Vector2d Flat(const Eigen::Vector3d& point) const {
    return {x_axis.dot(point - origin), y_axis.dot(point - origin)};
  }
  Eigen::Vector3d InSpace(const Eigen::Vector2d& flat) const {
    return origin + flat.x() * x_axis + flat.y() * y_axis;
  }
};

// A link in a plane, or a bridge.
struct PlaneStroke {
  LinkId link = -1;  // -1: a bridge
  Polyline2d points;
  // Of a link, where each point is along it: index of a point.
  std::vector<double> at;
  // Of a link, all its points; z = 0.
  Polyline3d course = {};
};

// A link projected onto the plane of a frame. Every point that is kept is a point of the link.
PlaneStroke MakeStroke(const FaceLink& link, const DrawingGraph& graph, const PlaneFrame& frame);

// At a position: index of a point plus fraction.
Eigen::Vector2d PointOn(const PlaneStroke& stroke, double position);
// The position on the link of a position on its stroke: of the same place, as the points of a link
// may be at any distances. Time: points of the link between two of the stroke.
double PositionOnLink(const PlaneStroke& stroke, double position);

// What may bound faces in a plane: the links in it, then bridges.
struct PlaneStrokes {
  PlaneFrame frame;
  double footprint = 0;              // median over the links, world units per px
  std::vector<PlaneStroke> strokes;  // links ascending
};

// The strokes of a plane (ours; algorithm/surfaces.md#strokes-and-cells): all links within
// plane_tolerance_px of it that are in the rectangle around its members, widened by
// max_extension_px. An end that meets none of these gets a bridge to the nearest within
// max_bridge_px, or straight on to the first that it meets, and another to where two ends cross
// that both go straight on. Whether a bridge bounds anything shows in the arrangement. Time: ends
// times links in the plane, and points in reach.
PlaneStrokes MakeStrokes(const FacePlane& plane, const std::vector<FaceLink>& links,
                         const DrawingGraph& graph, const SurfaceOptions& options);

}  // namespace limn
