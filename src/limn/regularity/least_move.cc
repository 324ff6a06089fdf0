// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/least_move.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "limn/geometry/tangent_frame.h"

namespace limn {
namespace {

// Of the constraints, 1/px: they hold to about 1e-3 px, and may contradict or repeat each other.
constexpr double kWeight = 1000;

// The least squares of evidence, (x - 0)^T information (x - 0), under constraints.
class LeastSquares {
 public:
  explicit LeastSquares(const Matrix6d& information) : information_(information) {}

  // row . x = value
  void Constrain(const Vector6d& row, double value) {
    information_ += kWeight * kWeight * row * row.transpose();
    right_ += kWeight * kWeight * value * row;
  }
  Vector6d Solve() const { return information_.ldlt().solve(right_); }

 private:
  Matrix6d information_;
  Vector6d right_ = Vector6d::Zero();
};

Vector6d Row(const Eigen::Vector3d& head, const Eigen::Vector3d& tail) {
  Vector6d row;
  row << head, tail;
  return row;
}

CurveShape LeastMoveOfLine(const LineEvidence& line, std::span<const Membership> memberships,
                           const RegularityClasses& classes) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  LeastSquares squares(line.information);
  for (const Membership& of : memberships) {
    if (of.kind == RegularityKind::kDirection) {
      const auto frame = TangentFrame(classes.directions[of.index].direction);
      for (int k = 0; k < 2; ++k) {
        const Eigen::Vector3d across = frame.col(k);
        squares.Constrain(Row(-across, across), -across.dot(line.Chord()));
      }
    } else {
      const PlaneClass& plane = classes.planes[of.index];
      squares.Constrain(Row(plane.normal, none), plane.offset - plane.normal.dot(line.start));
      squares.Constrain(Row(none, plane.normal), plane.offset - plane.normal.dot(line.end));
    }
  }
  const Vector6d move = squares.Solve();
  return LineSegment{line.start + move.head<3>(), line.end + move.tail<3>()};
}

// Turns the normal towards another one, either way.
void ConstrainNormal(const CircularArc& arc, const Eigen::Vector3d& normal, LeastSquares* squares) {
  const double along = normal.dot(arc.Normal());
  squares->Constrain(Vector6d::Unit(3), arc.radius * normal.dot(arc.x_axis) / along);
  squares->Constrain(Vector6d::Unit(4), arc.radius * normal.dot(arc.y_axis) / along);
}

CircularArc Moved(const CircularArc& arc, const Vector6d& move) {
  CircularArc moved = arc;
  moved.center += move.head<3>();
  moved.radius += move[5];
  const Eigen::Vector3d normal =
      (arc.Normal() + (move[3] * arc.x_axis + move[4] * arc.y_axis) / arc.radius).normalized();
  moved.x_axis = (arc.x_axis - normal * normal.dot(arc.x_axis)).normalized();
  moved.y_axis = normal.cross(moved.x_axis);
  return moved;
}

CurveShape LeastMoveOfArc(const ArcEvidence& evidence, std::span<const Membership> memberships,
                          const RegularityClasses& classes) {
  const CircularArc& arc = evidence.arc;
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  LeastSquares squares(evidence.information);
  for (const Membership& of : memberships) {
    if (of.kind == RegularityKind::kPlane) {
      const PlaneClass& plane = classes.planes[of.index];
      squares.Constrain(Row(plane.normal, none), plane.offset - plane.normal.dot(arc.center));
      ConstrainNormal(arc, plane.normal, &squares);
    } else if (of.kind == RegularityKind::kRadius) {
      squares.Constrain(Vector6d::Unit(5), classes.radii[of.index].radius - arc.radius);
    } else {
      const AxisClass& axis = classes.axes[of.index];
      const auto frame = TangentFrame(axis.direction);
      for (int k = 0; k < 2; ++k) {
        const Eigen::Vector3d across = frame.col(k);
        squares.Constrain(Row(across, none), across.dot(axis.point - arc.center));
      }
      ConstrainNormal(arc, axis.direction, &squares);
    }
  }
  return Moved(arc, squares.Solve());
}

}  // namespace

CurveShape LeastMove(std::span<const Membership> memberships, const RegularityClasses& classes,
                     const DrawingEvidence& evidence) {
  const Membership& first = memberships.front();
  const size_t i = first.member;
  if (i < evidence.lines.size() && evidence.lines[i].link == first.link) {
    return LeastMoveOfLine(evidence.lines[i], memberships, classes);
  }
  return LeastMoveOfArc(evidence.arcs[i], memberships, classes);
}

}  // namespace limn
