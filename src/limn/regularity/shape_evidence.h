// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/primitives/link_samples.h"
#include "limn/primitives/primitive_options.h"
#include "limn/util/parallel.h"

namespace limn {

// Evidence is in local units: 1 is about a pixel at the middle of the scene, the origin near it.
struct LocalUnit {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double length = 1;  // world units

  Eigen::Vector3d FromWorld(const Eigen::Vector3d& point) const {
    return (point - origin) / length;
  }
  Eigen::Vector3d ToWorld(const Eigen::Vector3d& point) const { return origin + length * point; }
};

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// A quadratic approximation of what the images say about a shape: (x - best)^T information (x -
// best) is the sum of squares, in units of the noise.
struct ShapeEvidence {
  LinkId link = -1;
  double length_px = 0;
  // Mean metric of deviations across the curve, px^2 per squared unit.
  Eigen::Matrix3d metric = Eigen::Matrix3d::Identity();
  Matrix6d information = Matrix6d::Identity();
};

// Of a straight link. x: its start and end.
struct LineEvidence : ShapeEvidence {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  // Of end - start, with the best middle.
  Eigen::Matrix3d chord_information = Eigen::Matrix3d::Identity();
  Matrix6d covariance = Matrix6d::Identity();

  Eigen::Vector3d Chord() const { return end - start; }
};

// Of an arc or circle. x: offsets of center (3), of the normal along the x axis and y axis of the
// arc, times the radius (2), and of the radius.
struct ArcEvidence : ShapeEvidence {
  CircularArc arc;
  Matrix6d covariance = Matrix6d::Identity();
};

struct DrawingEvidence {
  LocalUnit unit;
  std::vector<LineEvidence> lines;  // by link
  std::vector<ArcEvidence> arcs;    // by link
  // Per link, as for its primitive; empty without one, or if no view sees the link. World units.
  std::vector<LinkSamples> samples;
};

// The evidence for the lines and arcs of a drawing, of links that are neither outlines nor
// tentative (LinkSelection's default), in units of the noise of the primitives. Time: samples times
// views.
DrawingEvidence MeasureEvidence(const DrawingGraph& graph, const std::vector<View>& views,
                                const PrimitiveOptions& options, const RunContext& context);

}  // namespace limn
