// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Geom_Curve.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

#include "limn/model/drawing_graph.h"

namespace limn {

// Curves of links as OpenCASCADE's; only for the writer of STEP files.

inline gp_Pnt ToPnt(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }
inline gp_Dir ToDir(const Eigen::Vector3d& axis) { return {axis.x(), axis.y(), axis.z()}; }
inline Eigen::Vector3d FromPnt(const gp_Pnt& point) { return {point.X(), point.Y(), point.Z()}; }

// A line, a circle (its parameter is the angle from the x axis) or a cubic B-spline. Throws
// Standard_Failure if OpenCASCADE rejects it.
opencascade::handle<Geom_Curve> GeomCurveOf(const CurveShape& shape);

// A B-spline of degree 1 in which every segment of the polyline has a knot interval of length 1.
opencascade::handle<Geom_Curve> GeomCurveOf(const std::vector<Eigen::Vector3d>& points);

// The primitive, or the points of a link without one.
opencascade::handle<Geom_Curve> GeomCurveOf(const DrawingLink& link);

// Where that curve begins (0) or ends (1).
Eigen::Vector3d EndOfCurve(const DrawingLink& link, int end);

// The position where the links of a node meet. A single end, and the start of a closed link, is at
// the end of its curve: a primitive need not pass through such nodes.
Eigen::Vector3d PositionOfVertex(const DrawingGraph& graph, const DrawingNode& node);

}  // namespace limn
