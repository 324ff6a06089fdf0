// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/tangent_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "limn/linking/fragment_geometry.h"

namespace limn {
namespace {

using Eigen::Vector2d;

// In white noise the direction error is about half the position error (radians, pixels; sigma 1.5),
// with a floor where there is no noise.
constexpr double kAngleSigmaPerPx = 0.5;
constexpr double kMinPositionSigmaPx = 0.05;
// Directions further off than this are of another curve (corner, crossing).
constexpr double kMaxAngleRad = 0.6;
const double kMaxSlope = std::tan(kMaxAngleRad);

// An edgel of a fragment.
struct Vertex {
  Vector2d position;
  Vector2d tangent;
  double weight;  // of its position: one over its variance
};

// Normal equations of y = c0 + c1 x + c2 x^2 with positions and slopes observed.
class ParabolaFit {
 public:
  // The frame of the parabola is that of `center`.
  void Add(const Vertex& vertex, const Vertex& center) {
    const Vector2d& along = center.tangent;
    const Vector2d d = vertex.position - center.position;
    const double x = d.dot(along);
    const double y = along.x() * d.y() - along.y() * d.x();
    AddRow({1, x, x * x}, y, vertex.weight);
    const double rise = along.x() * vertex.tangent.y() - along.y() * vertex.tangent.x();
    const double run = along.dot(vertex.tangent);
    if (std::abs(rise) > kMaxSlope * run) return;
    AddRow({0, 1, 2 * x}, rise / run, vertex.weight / (kAngleSigmaPerPx * kAngleSigmaPerPx));
  }

  // c1.
  double Slope() const { return matrix_.inverse().row(1).dot(vector_); }

 private:
  void AddRow(const Eigen::Vector3d& row, double value, double weight) {
    matrix_ += weight * row * row.transpose();
    vector_ += weight * value * row;
  }
  // A weak prior keeps the curvature of two or three edgels in bounds.
  Eigen::Matrix3d matrix_ = Eigen::Vector3d(0, 0, 1).asDiagonal();
  Eigen::Vector3d vector_ = Eigen::Vector3d::Zero();
};

std::vector<Vertex> Vertices(const CurveFragment& fragment, const std::vector<Edgel>& edgels) {
  std::vector<Vertex> vertices;
  vertices.reserve(fragment.edgel_ids.size());
  for (const EdgelId id : fragment.edgel_ids) {
    const Edgel& edgel = edgels[id];
    const double sigma = std::max<double>(kMinPositionSigmaPx, edgel.position_sigma_px);
    vertices.push_back({edgel.position_px, edgel.Tangent(), 1 / (sigma * sigma)});
  }
  return vertices;
}

}  // namespace

void RefitTangents(const CurveFragment& fragment, double arm_px, std::vector<Edgel>* edgels) {
  const FragmentPath path(*edgels, fragment);
  const std::vector<Vertex> vertices = Vertices(fragment, *edgels);
  for (int i = 0; i < path.size(); ++i) {
    ParabolaFit fit;
    const auto add = [&](int j, double) { fit.Add(vertices[j], vertices[i]); };
    add(i, 0);
    path.Walk(i, 1, arm_px, add);
    path.Walk(i, -1, arm_px, add);
    double& tangent_rad = (*edgels)[fragment.edgel_ids[i]].tangent_rad;
    tangent_rad = std::remainder(tangent_rad + std::atan(fit.Slope()), 2 * M_PI);
  }
}

}  // namespace limn
