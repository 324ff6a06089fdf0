#include "limn/linking/tangent_fit.h"

#include <cmath>

#include <Eigen/Dense>

#include "limn/linking/fragment_geometry.h"

namespace limn {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// In white noise the direction error is about half the position error (radians, pixels; sigma 1.5),
// with a floor where there is no noise.
constexpr double kAngleSigmaPerPx = 0.5;
constexpr double kMinPositionSigmaPx = 0.05;
// Directions further off than this are of another curve (corner, crossing).
constexpr double kMaxAngleRad = 0.6;

// Normal equations of y = c0 + c1 x + c2 x^2 with positions and slopes observed.
class ParabolaFit {
 public:
  void Add(const Edgel& edgel, const Vector2d& origin, const Vector2d& along) {
    const Vector2d d = edgel.position_px - origin;
    const double x = d.dot(along);
    const double y = along.x() * d.y() - along.y() * d.x();
    const double sigma = std::max<double>(kMinPositionSigmaPx, edgel.position_sigma_px);
    AddRow(Vector3d(1, x, x * x), y, 1 / (sigma * sigma));
    const Vector2d tangent = edgel.Tangent();
    const double angle =
        std::atan2(along.x() * tangent.y() - along.y() * tangent.x(), along.dot(tangent));
    if (std::abs(angle) > kMaxAngleRad) return;
    const double sigma_slope = kAngleSigmaPerPx * sigma;
    AddRow(Vector3d(0, 1, 2 * x), std::tan(angle), 1 / (sigma_slope * sigma_slope));
  }

  Vector3d Solve() const { return matrix_.ldlt().solve(vector_); }

 private:
  void AddRow(const Vector3d& row, double value, double weight) {
    matrix_ += weight * row * row.transpose();
    vector_ += weight * value * row;
  }
  // A weak prior keeps the curvature of two or three edgels in bounds.
  Matrix3d matrix_ = Vector3d(0, 0, 1).asDiagonal();
  Vector3d vector_ = Vector3d::Zero();
};

}  // namespace

void RefitTangents(const CurveFragment& fragment, double arm_px, std::vector<Edgel>* edgels) {
  const FragmentPath path(*edgels, fragment);
  std::vector<double> refitted(path.size());
  for (int i = 0; i < path.size(); ++i) {
    const Edgel& center = (*edgels)[fragment.edgel_ids[i]];
    ParabolaFit fit;
    const auto add = [&](int j, double) {
      fit.Add((*edgels)[fragment.edgel_ids[j]], center.position_px, center.Tangent());
    };
    add(i, 0);
    path.Walk(i, 1, arm_px, add);
    path.Walk(i, -1, arm_px, add);
    const double turn = std::atan(fit.Solve()(1));
    refitted[i] = std::remainder(center.tangent_rad + turn, 2 * M_PI);
  }
  for (int i = 0; i < path.size(); ++i) {
    (*edgels)[fragment.edgel_ids[i]].tangent_rad = refitted[i];
  }
}

}  // namespace limn
