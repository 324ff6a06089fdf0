// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limn/geometry/bezier.h"

namespace limn {
namespace {

// Fitting as P. J. Schneider describes it (Graphics Gems, 1990): least squares with given end
// tangents, better parameters by Newton's method, a split where the distance is largest.

using Points = std::vector<Eigen::Vector2d>;

constexpr double kCornerCosine = 0.8660254037844387;  // 30 degrees
// Distance of the points that a curve is fitted to, and reach of a tangent, in tolerances.
constexpr double kStep = 10;
constexpr int kTangentPoints = 3;
constexpr int kNewtonRounds = 6;
constexpr double kFarTolerances = 16;

Eigen::Vector2d At(const CubicBezier2d& c, double t) {
  const double s = 1 - t;
  return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}

Eigen::Vector2d First(const CubicBezier2d& c, double t) {
  const double s = 1 - t;
  return 3 * (s * s * (c[1] - c[0]) + 2 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
}

Eigen::Vector2d Second(const CubicBezier2d& c, double t) {
  return 6 * ((1 - t) * (c[2] - 2 * c[1] + c[0]) + t * (c[3] - 2 * c[2] + c[1]));
}

double DistanceToSegment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (a + t * along - point).norm();
}

class SectionFitter {
 public:
  // Points of a section without corners, close to each other.
  SectionFitter(const Points& points, double tolerance, std::vector<FittedPiece>* pieces)
      : points_(points), tolerance_(tolerance), pieces_(pieces) {}

  void Fit(const Eigen::Vector2d& start_tangent, const Eigen::Vector2d& end_tangent) {
    Fit(0, points_.size() - 1, start_tangent, end_tangent);
  }

 private:
  // Points [begin, end], both included; tangents point into the section.
  void Fit(size_t begin, size_t end, const Eigen::Vector2d& start_tangent,
           const Eigen::Vector2d& end_tangent) {
    if (IsStraight(begin, end)) {
      const Eigen::Vector2d third = (points_[end] - points_[begin]) / 3;
      pieces_->push_back(
          {{points_[begin], points_[begin] + third, points_[end] - third, points_[end]}, true});
      return;
    }
    SetParameters(begin, end);
    size_t worst = begin;
    for (int round = 0; round < kNewtonRounds; ++round) {
      const CubicBezier2d curve = LeastSquares(begin, end, start_tangent, end_tangent);
      const double distance = LargestDistance(curve, begin, end, &worst);
      if (distance <= tolerance_) {
        pieces_->push_back({curve, false});
        return;
      }
      // A curve that is far off does not come near by better parameters.
      if (distance > kFarTolerances * tolerance_) break;
      ImproveParameters(curve, begin, end);
    }
    worst = std::clamp(worst, begin + 1, end - 1);
    const Eigen::Vector2d tangent = TangentAt(worst, begin, end);
    Fit(begin, worst, start_tangent, -tangent);
    Fit(worst, end, tangent, end_tangent);
  }

  bool IsStraight(size_t begin, size_t end) const {
    for (size_t i = begin + 1; i < end; ++i) {
      if (DistanceToSegment(points_[begin], points_[end], points_[i]) > tolerance_) return false;
    }
    return true;
  }

  void SetParameters(size_t begin, size_t end) {
    t_.assign(end - begin + 1, 0);
    for (size_t i = 1; i < t_.size(); ++i) {
      t_[i] = t_[i - 1] + (points_[begin + i] - points_[begin + i - 1]).norm();
    }
    for (double& t : t_) t /= t_.back();
    t_.back() = 1;
  }

  CubicBezier2d LeastSquares(size_t begin, size_t end, const Eigen::Vector2d& start_tangent,
                             const Eigen::Vector2d& end_tangent) const {
    const Eigen::Vector2d& p0 = points_[begin];
    const Eigen::Vector2d& p3 = points_[end];
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (size_t i = 0; i < t_.size(); ++i) {
      const double t = t_[i];
      const double s = 1 - t;
      const Eigen::Vector2d a = 3 * s * s * t * start_tangent;
      const Eigen::Vector2d b = 3 * s * t * t * end_tangent;
      const Eigen::Vector2d rest =
          points_[begin + i] - (s * s * s + 3 * s * s * t) * p0 - (t * t * t + 3 * s * t * t) * p3;
      normal(0, 0) += a.dot(a);
      normal(0, 1) += a.dot(b);
      normal(1, 1) += b.dot(b);
      right += Eigen::Vector2d(a.dot(rest), b.dot(rest));
    }
    normal(1, 0) = normal(0, 1);
    const double chord = (p3 - p0).norm();
    Eigen::Vector2d reach = normal.inverse() * right;
    // Handles that point backwards or make loops do not describe these points.
    const bool is_good =
        reach.allFinite() && reach.minCoeff() > 1e-3 * chord && reach.maxCoeff() < 4 * chord;
    if (!is_good) reach.setConstant(chord / 3);
    return {p0, p0 + reach[0] * start_tangent, p3 + reach[1] * end_tangent, p3};
  }

  // Of the points to the curve, and of places between the parameters to the polyline.
  double LargestDistance(const CubicBezier2d& curve, size_t begin, size_t end,
                         size_t* worst) const {
    double largest = 0;
    for (size_t i = begin + 1; i <= end; ++i) {
      const double t = t_[i - begin];
      const double between = 0.5 * (t + t_[i - begin - 1]);
      const double distance =
          std::max((At(curve, t) - points_[i]).norm(),
                   DistanceToSegment(points_[i - 1], points_[i], At(curve, between)));
      if (distance > largest) {
        largest = distance;
        *worst = i;
      }
    }
    return largest;
  }

  void ImproveParameters(const CubicBezier2d& curve, size_t begin, size_t end) {
    for (size_t i = begin + 1; i < end; ++i) {
      double& t = t_[i - begin];
      const Eigen::Vector2d away = At(curve, t) - points_[i];
      const Eigen::Vector2d first = First(curve, t);
      const double slope = first.squaredNorm() + away.dot(Second(curve, t));
      if (slope > 0) t = std::clamp(t - away.dot(first) / slope, 0.0, 1.0);
    }
    std::sort(t_.begin(), t_.end());
  }

  Eigen::Vector2d TangentAt(size_t at, size_t begin, size_t end) const {
    const size_t reach = std::min({static_cast<size_t>(kTangentPoints), at - begin, end - at});
    const Eigen::Vector2d across = points_[at + reach] - points_[at - reach];
    const double length = across.norm();
    return length > 0 ? Eigen::Vector2d(across / length)
                      : Eigen::Vector2d((points_[at + 1] - points_[at]).normalized());
  }

  const Points& points_;
  double tolerance_;
  std::vector<FittedPiece>* pieces_;
  std::vector<double> t_;
};

bool IsCorner(const Eigen::Vector2d& before, const Eigen::Vector2d& at,
              const Eigen::Vector2d& after) {
  const Eigen::Vector2d in = at - before;
  const Eigen::Vector2d out = after - at;
  return in.dot(out) < kCornerCosine * in.norm() * out.norm();
}

Points WithoutRepetitions(std::span<const Eigen::Vector2d> points) {
  Points result;
  for (const Eigen::Vector2d& point : points) {
    if (result.empty() || point != result.back()) result.push_back(point);
  }
  return result;
}

// Points of [begin, end] at most `step` apart.
Points Densified(const Points& points, size_t begin, size_t end, double step) {
  constexpr double kMaxParts = 4096;
  Points result = {points[begin]};
  for (size_t i = begin + 1; i <= end; ++i) {
    const Eigen::Vector2d from = points[i - 1];
    const Eigen::Vector2d along = points[i] - from;
    const int parts = static_cast<int>(std::clamp(std::ceil(along.norm() / step), 1.0, kMaxParts));
    for (int k = 1; k < parts; ++k) result.push_back(from + k * along / parts);
    result.push_back(points[i]);
  }
  return result;
}

// Into the section at its start: of the parabola through three points.
Eigen::Vector2d StartTangent(const Points& points) {
  const size_t reach = std::min<size_t>(kTangentPoints, (points.size() - 1) / 2);
  if (reach == 0) return (points[1] - points[0]).normalized();
  const Eigen::Vector2d parabola = 4 * points[reach] - points[2 * reach] - 3 * points[0];
  const Eigen::Vector2d chord = points[reach] - points[0];
  return parabola.dot(chord) > 0 ? parabola.normalized() : (points[1] - points[0]).normalized();
}

Eigen::Vector2d EndTangent(Points points) {
  std::reverse(points.begin(), points.end());
  return StartTangent(points);
}

}  // namespace

std::vector<FittedPiece> FitBeziers(std::span<const Eigen::Vector2d> points, double tolerance) {
  const Points vertices = WithoutRepetitions(points);
  std::vector<FittedPiece> pieces;
  if (vertices.size() < 2) return pieces;
  std::vector<size_t> corners = {0};
  for (size_t i = 1; i + 1 < vertices.size(); ++i) {
    if (IsCorner(vertices[i - 1], vertices[i], vertices[i + 1])) corners.push_back(i);
  }
  corners.push_back(vertices.size() - 1);
  const bool is_smooth_ring =
      vertices.size() > 3 && vertices.front() == vertices.back() &&
      !IsCorner(vertices[vertices.size() - 2], vertices.front(), vertices[1]);
  Eigen::Vector2d ring_tangent = Eigen::Vector2d::Zero();
  if (is_smooth_ring) {
    ring_tangent = ((vertices[1] - vertices[0]).normalized() +
                    (vertices[0] - vertices[vertices.size() - 2]).normalized())
                       .normalized();
  }
  for (size_t k = 0; k + 1 < corners.size(); ++k) {
    const Points section = Densified(vertices, corners[k], corners[k + 1], kStep * tolerance);
    const bool at_start = is_smooth_ring && k == 0;
    const bool at_end = is_smooth_ring && k + 2 == corners.size();
    SectionFitter(section, tolerance, &pieces)
        .Fit(at_start ? ring_tangent : StartTangent(section),
             at_end ? Eigen::Vector2d(-ring_tangent) : EndTangent(section));
  }
  return pieces;
}

}  // namespace limn
