#include "limn/belief/node_covariance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "limn/belief/covariance_across.h"
#include "limn/model/footprint.h"

namespace limn {
namespace {

// Where an edge ends along itself, px: it fades, and is linked to what is near.
constexpr double kEndSigmaPx = 3;
// What is off in all views alike, px.
constexpr double kCommonSigmaPx = 0.05;
// The direction of a link at its end is that to this point.
constexpr int kDirectionPoints = 4;
// Of the other direction across, where views tell it exactly, relative to the variance.
constexpr double kLeastVariance = 1e-4;

double SigmaAt(const DrawingLink& link, int end) {
  if (link.sigma.empty() || link.kind == LinkKind::kContour) return 0;
  const double sigma = end == 0 ? link.sigma.front() : link.sigma.back();
  return std::isfinite(sigma) ? sigma : 0;
}

std::optional<Eigen::Vector3d> DirectionAt(const DrawingLink& link, int end) {
  const auto& points = link.points_in_world;
  const size_t step = std::min<size_t>(kDirectionPoints, points.size() - 1);
  const Eigen::Vector3d direction = end == 0 ? Eigen::Vector3d(points[step] - points.front())
                                             : points[points.size() - 1 - step] - points.back();
  if (!(direction.norm() > 0)) return std::nullopt;
  return direction.normalized();
}

// What a link tells across itself about where it ends; zero: nothing.
Eigen::Matrix3d InformationOf(const DrawingLink& link, int end, const std::vector<View>& views) {
  const double sigma = SigmaAt(link, end);
  const auto tangent = DirectionAt(link, end);
  if (!(sigma > 0) || !tangent) return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d& point =
      end == 0 ? link.points_in_world.front() : link.points_in_world.back();
  const Eigen::Matrix3d along = *tangent * tangent->transpose();
  const Eigen::Matrix3d across = CovarianceAcross(link, point, *tangent, sigma, views) +
                                 kLeastVariance * sigma * sigma * Eigen::Matrix3d::Identity();
  // The inverse in the plane across: along, what is inverted is taken away again.
  const Eigen::Matrix3d whole = across + sigma * sigma * along;
  const double variance_along = (1 + kLeastVariance) * sigma * sigma;
  return whole.inverse() - along / variance_along;
}

}  // namespace

void MeasureNodes(const std::vector<View>& views, DrawingGraph* graph) {
  for (DrawingNode& node : graph->nodes) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double footprint = 0;
    for (const LinkEnd& at : node.incident) {
      const DrawingLink& link = graph->links[at.link];
      information += InformationOf(link, at.end, views);
      footprint = std::max(footprint, LinkFootprint(link, node.position_in_world, views));
    }
    node.covariance.setZero();
    if (!(information.trace() > 0) || !(footprint > 0)) continue;
    const double along = kEndSigmaPx * footprint, common = kCommonSigmaPx * footprint;
    information += Eigen::Matrix3d::Identity() / (along * along);
    node.covariance = information.inverse() + common * common * Eigen::Matrix3d::Identity();
  }
}

}  // namespace limn
