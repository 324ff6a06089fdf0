// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/shape_evidence.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "limn/geometry/median_point.h"
#include "limn/model/link_selection.h"
#include "limn/primitives/continuity.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// The metric of a sample in local units, and the share of an independent measurement that it is.
struct Weighted {
  Eigen::Matrix3d metric;  // px^2
  double weight;           // over the variance of the noise
};

Weighted WeightOf(const LinkSample3d& sample, const LinkSamples& link, const LocalUnit& unit,
                  const PrimitiveOptions& options) {
  const double step_px = link.length_px / static_cast<double>(link.samples.size() - 1);
  const double independent = std::min(1.0, step_px / kCurveCorrelationPx);
  return {unit.length * unit.length * sample.across.transpose() * sample.across,
          sample.weight * independent / (options.noise_px * options.noise_px)};
}

// Keeps what no sample determines where it is, weakly: a thousandth of a pixel's pull.
constexpr double kHold = 1e-3;

LineEvidence EvidenceOfLine(const LineSegment& line, const LinkSamples& samples,
                            const LocalUnit& unit, const PrimitiveOptions& options) {
  LineEvidence evidence;
  evidence.length_px = samples.length_px;
  const Eigen::Vector3d start = unit.FromWorld(line.start);
  const Eigen::Vector3d end = unit.FromWorld(line.end);
  Matrix6d information = kHold * Matrix6d::Identity();
  Vector6d right = Vector6d::Zero();  // of offsets from the line
  Eigen::Matrix3d metric = Eigen::Matrix3d::Zero();
  for (const LinkSample3d& sample : samples.samples) {
    const Weighted at = WeightOf(sample, samples, unit, options);
    const Eigen::Matrix3d w = at.weight * at.metric;
    const double s = 1 - sample.t, t = sample.t;
    information.topLeftCorner<3, 3>() += s * s * w;
    information.topRightCorner<3, 3>() += s * t * w;
    information.bottomLeftCorner<3, 3>() += s * t * w;
    information.bottomRightCorner<3, 3>() += t * t * w;
    const Eigen::Vector3d pull = w * (unit.FromWorld(sample.position) - (s * start + t * end));
    right.head<3>() += s * pull;
    right.tail<3>() += t * pull;
    metric += at.metric;
  }
  const Vector6d offset = information.ldlt().solve(right);
  evidence.start = start + offset.head<3>();
  evidence.end = end + offset.tail<3>();
  evidence.metric = metric / static_cast<double>(samples.samples.size());
  evidence.information = information;
  evidence.covariance = information.inverse();
  const Eigen::Matrix3d& cross = evidence.covariance.topRightCorner<3, 3>();
  const Eigen::Matrix3d chord_covariance = evidence.covariance.topLeftCorner<3, 3>() +
                                           evidence.covariance.bottomRightCorner<3, 3>() - cross -
                                           cross.transpose();
  evidence.chord_information = chord_covariance.inverse();
  return evidence;
}

ArcEvidence EvidenceOfArc(const CircularArc& arc, const LinkSamples& samples, const LocalUnit& unit,
                          const PrimitiveOptions& options) {
  ArcEvidence evidence;
  evidence.length_px = samples.length_px;
  evidence.arc = arc;
  evidence.arc.center = unit.FromWorld(arc.center);
  evidence.arc.radius = arc.radius / unit.length;
  const Eigen::Vector3d normal = arc.Normal();
  evidence.information = kHold * Matrix6d::Identity();
  Eigen::Matrix3d metric = Eigen::Matrix3d::Zero();
  for (const LinkSample3d& sample : samples.samples) {
    const Weighted at = WeightOf(sample, samples, unit, options);
    Eigen::Vector3d radial = sample.position - arc.center;
    radial = (radial - normal * normal.dot(radial)).normalized();
    // How the circle moves there, across itself.
    Eigen::Matrix<double, 3, 6> move;
    move.leftCols<3>() = radial * radial.transpose() + normal * normal.transpose();
    move.col(3) = -normal * radial.dot(arc.x_axis);
    move.col(4) = -normal * radial.dot(arc.y_axis);
    move.col(5) = radial;
    evidence.information += at.weight * move.transpose() * at.metric * move;
    metric += at.metric;
  }
  evidence.metric = metric / static_cast<double>(samples.samples.size());
  evidence.covariance = evidence.information.inverse();
  return evidence;
}

LocalUnit UnitOf(const DrawingGraph& graph, const std::vector<LinkSamples>& samples) {
  std::vector<double> footprints;
  std::vector<Eigen::Vector3d> middles;
  for (size_t l = 0; l < samples.size(); ++l) {
    if (samples[l].samples.empty()) continue;
    footprints.push_back(samples[l].footprint);
    const auto& points = graph.links[l].points_in_world;
    middles.push_back(points[points.size() / 2]);
  }
  LocalUnit unit;
  if (footprints.empty()) return unit;
  unit.length = Median(std::move(footprints));
  unit.origin = MedianPoint(middles);
  return unit;
}

}  // namespace

DrawingEvidence MeasureEvidence(const DrawingGraph& graph, const std::vector<View>& views,
                                const PrimitiveOptions& options, const RunContext& context) {
  DrawingEvidence evidence;
  evidence.samples.resize(graph.links.size());
  const std::vector<EndConditions> ends = EndsOfLinks(graph);
  ParallelFor(context, "measuring shapes", graph.links.size(), [&](size_t l) {
    if (!graph.links[l].primitive) return;
    evidence.samples[l] = SampleLink(graph.links[l], views);
    DiscountEnds({ends[l][0].held, ends[l][1].held}, kEndZonePx, &evidence.samples[l]);
  });
  evidence.unit = UnitOf(graph, evidence.samples);
  const LinkSelection selection;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const DrawingLink& link = graph.links[l];
    const LinkSamples& samples = evidence.samples[l];
    if (samples.samples.empty() || !selection.Has(link)) continue;
    if (const auto* line = std::get_if<LineSegment>(&link.primitive->shape)) {
      evidence.lines.push_back(EvidenceOfLine(*line, samples, evidence.unit, options));
      evidence.lines.back().link = static_cast<LinkId>(l);
    } else if (const auto* arc = std::get_if<CircularArc>(&link.primitive->shape)) {
      evidence.arcs.push_back(EvidenceOfArc(*arc, samples, evidence.unit, options));
      evidence.arcs.back().link = static_cast<LinkId>(l);
    }
  }
  return evidence;
}

}  // namespace limn
