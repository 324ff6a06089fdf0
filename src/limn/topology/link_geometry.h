#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"

namespace limn {

// The straight line on which a link leaves at an end, fitted to its last pixels without the
// outermost ones, which corners round.
struct LinkTip {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // of the line, nearest to the end
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();  // unit; zero for a link without extent
  double footprint = 1;                               // at the end
};
LinkTip TipOf(const DrawingLink& link, int end, double footprint);

// With the footprint of the link's vertices; without direction if it has none.
LinkTip TipOf(const DrawingLink& link, int end);

// The end's position.
const Eigen::Vector3d& EndPoint(const DrawingLink& link, int end);

// The rest needs the link's vertices.

// Arc length between two points of a link, from <= to, px.
double ArcPx(const DrawingLink& link, int from, int to);
double LengthPx(const DrawingLink& link);

// Unit direction of the link at a point; zero where it has no extent.
Eigen::Vector3d TangentAt(const DrawingLink& link, int index);

// At most `count` points of a link, evenly spread, by which it is judged.
std::vector<int> ProbePoints(const DrawingLink& link, int count);

// Inverse covariance of what is not known at all, per direction across the curve: it decides only
// where no sample does.
double WeakInformation(double footprint);

// Standard deviation across a curve: the root of the mean of the two variances, of which none is
// known worse than that.
double SigmaAcross(const Eigen::Matrix3d& information, double footprint);

// Number of the sketch's samples in a link.
int64_t NumSketchSamples(const DrawingLink& link);

// The angle between two unit directions, rad, and the angle between the lines along them.
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);
double LineAngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace limn
