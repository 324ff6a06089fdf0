// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/true_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <variant>

#include <Eigen/Geometry>

#include "limn/formats/read_curves.h"
#include "limn/geometry/angle_between.h"
#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"
#include "limn/util/angles.h"

namespace limn::testing {
namespace {

const double kCornerCosine = std::cos(25 * kDeg);
// The shares of a link that must be near the truth, and near one true curve.
constexpr double kMinNearShare = 0.9;
constexpr double kMinOneCurveShare = 0.8;

enum class TrueKind { kLine, kCircle, kOther };

struct TrueCurve {
  Polyline3d points;
  TrueKind kind = TrueKind::kOther;
  double radius = 0;

  Eigen::Vector3d Direction() const { return (points.back() - points.front()).normalized(); }
};

bool IsLine(const Polyline3d& points) {
  const Polyline3d chord = {points.front(), points.back()};
  const double length = Length(points);
  return (points.back() - points.front()).norm() > 0.5 * length &&
         std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& point) {
           return ClosestPoint(chord, point).squared_distance < 1e-8 * length * length;
         });
}

// The radius if all points lie on one circle, else 0.
double CircleRadius(const Polyline3d& points) {
  if (points.size() < 6) return 0;
  const Eigen::Vector3d& a = points[0];
  const Eigen::Vector3d u = points[points.size() / 3] - a;
  const Eigen::Vector3d v = points[2 * points.size() / 3] - a;
  const Eigen::Vector3d w = u.cross(v);
  if (!(w.norm() > 0)) return 0;
  const Eigen::Vector3d to_center =
      (v.squaredNorm() * w.cross(u) + u.squaredNorm() * v.cross(w)) / (2 * w.squaredNorm());
  const double radius = to_center.norm();
  const bool all_on_it =
      std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& point) {
        const Eigen::Vector3d offset = point - a - to_center;
        return std::abs(offset.norm() - radius) < 2e-3 * radius &&
               std::abs(offset.dot(w.normalized())) < 2e-3 * radius;
      });
  return all_on_it ? radius : 0;
}

std::vector<TrueCurve> CutAtCorners(const std::vector<Polyline3d>& polylines) {
  std::vector<TrueCurve> curves;
  const auto add = [&](Polyline3d points) {
    TrueCurve curve;
    curve.radius = CircleRadius(points);
    curve.kind = IsLine(points)     ? TrueKind::kLine
                 : curve.radius > 0 ? TrueKind::kCircle
                                    : TrueKind::kOther;
    curve.points = std::move(points);
    curves.push_back(std::move(curve));
  };
  for (const Polyline3d& polyline : polylines) {
    Polyline3d part = {polyline.front()};
    for (size_t k = 1; k < polyline.size(); ++k) {
      part.push_back(polyline[k]);
      if (k + 1 == polyline.size()) break;
      const Eigen::Vector3d before = (polyline[k] - polyline[k - 1]).normalized();
      const Eigen::Vector3d after = (polyline[k + 1] - polyline[k]).normalized();
      if (before.dot(after) > kCornerCosine) continue;
      add(std::move(part));
      part = {polyline[k]};
    }
    add(std::move(part));
  }
  return curves;
}

// Which true curve the links follow.
class Follower {
 public:
  Follower(const std::vector<TrueCurve>& curves, double tolerance) : tolerance_(tolerance) {
    std::vector<Eigen::Vector3d> points;
    for (size_t c = 0; c < curves.size(); ++c) {
      for (const Eigen::Vector3d& point : ResampleUniform(curves[c].points, tolerance / 4)) {
        points.push_back(point);
        owner_.push_back(c);
      }
    }
    index_ = std::make_unique<SpatialIndex>(points);
  }

  std::optional<size_t> CurveOf(const DrawingLink& link) const {
    std::map<size_t, int> votes;
    int num_near = 0;
    for (const Eigen::Vector3d& point : link.points_in_world) {
      const SpatialIndex::Neighbor nearest = index_->Nearest(point);
      if (nearest.squared_distance > tolerance_ * tolerance_) continue;
      ++num_near;
      ++votes[owner_[nearest.index]];
    }
    const auto count = static_cast<double>(link.points_in_world.size());
    if (num_near < kMinNearShare * count) return std::nullopt;
    const auto most =
        std::max_element(votes.begin(), votes.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most->second < kMinOneCurveShare * count) return std::nullopt;
    return most->first;
  }

 private:
  double tolerance_;
  std::vector<size_t> owner_;
  std::unique_ptr<SpatialIndex> index_;
};

double AngleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return Degrees(LineAngleBetween(a, b));
}

}  // namespace

ShapeAgreement CompareShapes(const DrawingGraph& graph, const std::string& truth_path,
                             double tolerance, double long_line) {
  const std::vector<TrueCurve> curves = CutAtCorners(ReadCurves(truth_path).polylines);
  const Follower follower(curves, tolerance);
  ShapeAgreement agreement;
  for (const DrawingLink& link : graph.links) {
    const auto followed = follower.CurveOf(link);
    if (!followed || !link.primitive) continue;
    const TrueCurve& truth = curves[*followed];
    const double length = Length(link.points_in_world);
    const auto* line = std::get_if<LineSegment>(&link.primitive->shape);
    const auto* arc = std::get_if<CircularArc>(&link.primitive->shape);
    if (truth.kind == TrueKind::kLine) {
      agreement.length_on_lines += length;
      if (line != nullptr) agreement.lines_as_lines += length;
      if (line != nullptr && length > long_line) {
        agreement.direction_errors_deg.push_back(
            AngleDeg((line->end - line->start).normalized(), truth.Direction()));
      }
    }
    if (truth.kind == TrueKind::kCircle) {
      agreement.length_on_circles += length;
      if (arc != nullptr) agreement.circles_as_circles += length;
      if (arc != nullptr && arc->sweep_rad > 1) {
        agreement.radius_errors.push_back(std::abs(arc->radius / truth.radius - 1));
      }
    }
  }
  return agreement;
}

}  // namespace limn::testing
