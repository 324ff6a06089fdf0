#include "limn/belief/tri_angle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "limn/util/angles.h"
#include "limn/util/map_items.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kMaxPoints = 9;
// A view that looks along the curve within this angle does not tell its plane.
constexpr double kMinAngleToCurve = 3 * kDeg;

// What a view sees of a point of a curve; unit vectors.
struct SightLine {
  Eigen::Vector3d ray;
  Eigen::Vector3d normal;  // of the plane through the view and the tangent
};

// Planes of a curve that points at the cameras turn by more than the rays do, and tell no more.
double CosineBetween(const SightLine& a, const SightLine& b) {
  return std::max(std::abs(a.normal.dot(b.normal)), std::abs(a.ray.dot(b.ray)));
}

double SpreadAt(const Eigen::Vector3d& point, const Eigen::Vector3d& tangent,
                const std::vector<Eigen::Vector3d>& centers) {
  std::vector<SightLine> sights;
  double least_cosine = 1;
  for (const Eigen::Vector3d& center : centers) {
    const Eigen::Vector3d ray = (point - center).normalized();
    const Eigen::Vector3d normal = ray.cross(tangent);
    if (!(normal.norm() > std::sin(kMinAngleToCurve))) continue;
    sights.push_back({ray, normal.normalized()});
    for (const SightLine& other : sights) {
      least_cosine = std::min(least_cosine, CosineBetween(other, sights.back()));
    }
  }
  return std::acos(least_cosine);
}

}  // namespace

double TriAngleDeg(const DrawingLink& link, const std::vector<View>& views) {
  std::vector<Eigen::Vector3d> centers;
  for (const ViewId view : link.supporting_views) centers.push_back(views[view].CenterInWorld());
  if (centers.size() < 2) return -1;
  const auto& points = link.points_in_world;
  const int last = link.size() - 1;
  const int num_points = std::min(kMaxPoints, last);
  std::vector<double> spreads;
  for (int i = 0; i < num_points; ++i) {
    const int k = (2 * i + 1) * last / (2 * num_points);
    const Eigen::Vector3d step = points[k + 1] - points[k];
    if (!(step.norm() > 0)) continue;
    spreads.push_back(SpreadAt(0.5 * (points[k] + points[k + 1]), step.normalized(), centers));
  }
  return spreads.empty() ? 0 : Degrees(Median(spreads));
}

std::vector<double> TriAnglesDeg(const DrawingGraph& graph, const std::vector<View>& views,
                                 const RunContext& context) {
  return MapItems(context, "angles between views", graph.links.size(),
                  [&](size_t l) { return TriAngleDeg(graph.links[l], views); });
}

void MeasureTriAngles(const std::vector<View>& views, const RunContext& context,
                      DrawingGraph* graph) {
  const std::vector<double> angles_deg = TriAnglesDeg(*graph, views, context);
  for (size_t l = 0; l < graph->links.size(); ++l) graph->links[l].tri_angle_deg = angles_deg[l];
}

}  // namespace limn
