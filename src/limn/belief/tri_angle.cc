// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/tri_angle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limn/belief/covariance_across.h"
#include "limn/belief/node_covariance.h"
#include "limn/util/angles.h"
#include "limn/util/map_items.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr int kMaxSpreadPlaces = 9;

// What a view sees of a point of a curve; unit vectors.
struct SightLine {
  Eigen::Vector3d ray;
  Eigen::Vector3d normal;  // of the plane through the view and the tangent
};

// Planes of a curve that points at the cameras turn by more than the rays do, and tell no more.
double CosineBetween(const SightLine& a, const SightLine& b) {
  return std::max(std::abs(a.normal.dot(b.normal)), std::abs(a.ray.dot(b.ray)));
}

struct SpreadPlace {
  Eigen::Vector3d position;
  Eigen::Vector3d tangent;
  double sigma;
};

// Evenly along a link.
std::vector<SpreadPlace> SpreadPlaces(const DrawingLink& link) {
  const auto& points = link.points_in_world;
  const int last = link.size() - 1;
  const int num_places = std::min(kMaxSpreadPlaces, last);
  std::vector<SpreadPlace> places;
  for (int i = 0; i < num_places; ++i) {
    const int k = (2 * i + 1) * last / (2 * num_places);
    const Eigen::Vector3d step = points[k + 1] - points[k];
    if (!(step.norm() > 0)) continue;
    places.push_back({0.5 * (points[k] + points[k + 1]), step.normalized(),
                      0.5 * (link.sigma[k] + link.sigma[k + 1])});
  }
  return places;
}

double SpreadAt(const SpreadPlace& place, const std::vector<Eigen::Vector3d>& centers) {
  std::vector<SightLine> sights;
  double least_cosine = 1;
  for (const Eigen::Vector3d& center : centers) {
    const Eigen::Vector3d ray = (place.position - center).normalized();
    const Eigen::Vector3d normal = ray.cross(place.tangent);
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
  std::vector<double> spreads;
  for (const SpreadPlace& place : SpreadPlaces(link)) spreads.push_back(SpreadAt(place, centers));
  return spreads.empty() ? 0 : Degrees(Median(spreads));
}

std::vector<double> TriAnglesDeg(const DrawingGraph& graph, const std::vector<View>& views,
                                 const RunContext& context) {
  return MapItems(context, "angles between views", graph.links.size(),
                  [&](size_t l) { return TriAngleDeg(graph.links[l], views); });
}

double DepthSigma(const DrawingLink& link, const std::vector<View>& views) {
  if (link.supporting_views.size() < 2 || link.kind == LinkKind::kContour) return -1;
  std::vector<double> sigmas;
  for (const SpreadPlace& place : SpreadPlaces(link)) {
    if (!std::isfinite(place.sigma)) continue;
    const Eigen::Matrix3d covariance =
        CovarianceAcross(link, place.position, place.tangent, place.sigma, views);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
    sigmas.push_back(std::sqrt(axes.eigenvalues()[2]));
  }
  return sigmas.empty() ? -1 : Median(std::move(sigmas));
}

void MeasureSigmas(const std::vector<View>& views, const RunContext& context, DrawingGraph* graph) {
  ParallelFor(context, "depths", graph->links.size(),
              [&](size_t l) { graph->links[l].depth_sigma = DepthSigma(graph->links[l], views); });
  MeasureNodes(views, context, graph);
}

void MeasureDepth(const std::vector<View>& views, const RunContext& context, DrawingGraph* graph) {
  const std::vector<double> angles_deg = TriAnglesDeg(*graph, views, context);
  for (size_t l = 0; l < graph->links.size(); ++l) graph->links[l].tri_angle_deg = angles_deg[l];
  MeasureSigmas(views, context, graph);
}

}  // namespace limn
