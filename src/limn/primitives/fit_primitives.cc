// SPDX-License-Identifier: BSD-3-Clause
#include "limn/primitives/fit_primitives.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <Eigen/Cholesky>

#include "limn/geometry/polyline.h"
#include "limn/model/link_shape.h"
#include "limn/primitives/continuity.h"
#include "limn/primitives/link_samples.h"
#include "limn/primitives/shape_choice.h"

namespace limn {
namespace {

// State of a link between the steps.
struct Fit {
  LinkSamples samples;
  std::optional<FittedShape> fitted;
};

// A link that returns to its start has a closed shape, also where others end there.
bool ReturnsToStart(const DrawingLink& link) { return link.node0 == link.node1; }

const CubicBSpline* SplineOf(const Fit& fit) {
  return fit.fitted ? std::get_if<CubicBSpline>(&fit.fitted->shape) : nullptr;
}

// The same knots with the directions that the ends share. The joint of a closed spline is held
// where the first fit has put it.
void FitAgain(const EndConditions& ends, bool closed, const PrimitiveOptions& options, Fit* fit) {
  const CubicBSpline& before = *SplineOf(*fit);
  LinkSamples samples = fit->samples;
  if (closed) {
    samples.samples.front().position = before.control_points.front();
    samples.samples.back().position = before.control_points.front();
  }
  const CubicBSpline spline = FitSpline(samples, ends, closed, before.knots);
  for (const int end : {0, 1}) {
    // The spline would turn back; a small bend is better than a loop.
    if (!ends[end].direction) continue;
    const auto& points = spline.control_points;
    const Eigen::Vector3d leg =
        end == 0 ? points[1] - points[0] : points[points.size() - 2] - points.back();
    if (!(leg.dot(*ends[end].direction) > 0)) return;
  }
  const int num_parameters =
      NumParameters(static_cast<int>(spline.control_points.size()), ends, closed);
  FittedShape again = Judge(spline, num_parameters, fit->samples, options);
  if (again.max_px <= std::max(options.max_residual_px, fit->fitted->max_px)) {
    fit->fitted = std::move(again);
  }
}

std::vector<Fit> SampleLinks(const DrawingGraph& graph, const std::vector<uint8_t>& refit,
                             const std::vector<View>& views, const RunContext& context) {
  std::vector<Fit> fits(graph.links.size());
  const std::vector<EndConditions> ends = EndsOfLinks(graph);
  ParallelFor(context, "sampling links", fits.size(), [&](size_t l) {
    if (!refit[l]) return;
    fits[l].samples = SampleLink(graph.links[l], views);
    DiscountEnds({ends[l][0].held, ends[l][1].held}, kEndZonePx, &fits[l].samples);
  });
  return fits;
}

void Choose(const std::vector<EndConditions>& ends, const DrawingGraph& graph,
            const PrimitiveOptions& options, const RunContext& context, std::vector<Fit>* fits) {
  ParallelFor(context, "fitting primitives", fits->size(), [&](size_t l) {
    Fit& fit = (*fits)[l];
    if (fit.samples.samples.empty()) return;
    fit.fitted = ChooseShape(fit.samples, ends[l], ReturnsToStart(graph.links[l]), options);
  });
}

// The shape of a link that stays, if others can only follow its direction: no spline.
const CurveShape* StiffShape(const DrawingLink& link) {
  const bool is_stiff =
      link.primitive && !std::holds_alternative<CubicBSpline>(link.primitive->shape);
  return is_stiff ? &link.primitive->shape : nullptr;
}

void Join(const DrawingGraph& graph, const std::vector<uint8_t>& refit,
          std::vector<EndConditions> ends, const PrimitiveOptions& options,
          const RunContext& context, std::vector<Fit>* fits) {
  std::vector<const CurveShape*> shapes;
  for (size_t l = 0; l < fits->size(); ++l) {
    const Fit& fit = (*fits)[l];
    shapes.push_back(!refit[l]    ? StiffShape(graph.links[l])
                     : fit.fitted ? &fit.fitted->shape
                                  : nullptr);
  }
  ShareDirections(graph, shapes, &ends);
  ParallelFor(context, "joining primitives", fits->size(), [&](size_t l) {
    const bool joined = ends[l][0].direction || ends[l][1].direction;
    if (joined) FitAgain(ends[l], ReturnsToStart(graph.links[l]), options, &(*fits)[l]);
  });
}

// Of the sample next to an end that counts.
const Eigen::Matrix3d& AcrossNear(const LinkSamples& link, int end) {
  const auto counts = [](const LinkSample3d& sample) { return sample.weight == 1; };
  if (end == 0) return std::find_if(link.samples.begin(), link.samples.end(), counts)->across;
  return std::find_if(link.samples.rbegin(), link.samples.rend(), counts)->across;
}

// Where the shapes at a node meet, in the least squares of what their views see; nothing without
// two shapes, or if it is farther than this (world units) from where the node is.
std::optional<Eigen::Vector3d> MeetingPoint(const DrawingNode& node, const std::vector<Fit>& fits,
                                            double max_shift) {
  // Pull of the present place, 1/px: holds the node along a line that all its links share.
  constexpr double kPriorWeight = 0.2;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double footprint = 0;
  int count = 0;
  for (const LinkEnd& at : node.incident) {
    const Fit& fit = fits[at.link];
    if (!fit.fitted) continue;
    const Eigen::Matrix3d& across = AcrossNear(fit.samples, at.end);
    const Eigen::Matrix3d weight = across.transpose() * across;
    normal += weight;
    right += weight * (PointAt(fit.fitted->shape, at.end) - node.position_in_world);
    footprint += fit.samples.footprint;
    ++count;
  }
  if (count < 2) return std::nullopt;
  footprint /= count;
  const double prior = kPriorWeight / footprint;
  normal += prior * prior * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d shift = normal.ldlt().solve(right);
  if (!(shift.norm() <= max_shift)) return std::nullopt;
  return node.position_in_world + shift;
}

// Moves an end of a polyline; what is within the zone goes along, less and less.
void MoveEnd(const Eigen::Vector3d& position, bool first, double zone, Polyline3d* points) {
  const size_t count = points->size();
  const Eigen::Vector3d shift = position - (first ? points->front() : points->back());
  double distance = 0;
  for (size_t k = 0; k < count && distance < zone; ++k) {
    const size_t at = first ? k : count - 1 - k;
    const size_t next = first ? k + 1 : count - 2 - k;
    const double step = k + 1 < count ? ((*points)[next] - (*points)[at]).norm() : 0;
    (*points)[at] += (1 - distance / zone) * shift;
    distance += step;
  }
  (first ? points->front() : points->back()) = position;
}

void MoveNodes(const std::vector<Fit>& fits, double zone_px, DrawingGraph* graph) {
  std::vector<double> zones;
  for (size_t l = 0; l < fits.size(); ++l) {
    zones.push_back(
        std::min(zone_px * fits[l].samples.footprint, Length(graph->links[l].points_in_world) / 4));
  }
  for (DrawingNode& node : graph->nodes) {
    if (node.kind == NodeKind::kLoopAnchor) continue;
    // Less than a quarter of every link, so that none collapses.
    double max_shift = std::numeric_limits<double>::infinity();
    for (const LinkEnd& at : node.incident) max_shift = std::min(max_shift, zones[at.link]);
    const auto position = MeetingPoint(node, fits, max_shift);
    if (!position) continue;
    node.position_in_world = *position;
    for (const LinkEnd& at : node.incident) {
      MoveEnd(*position, at.end == 0, zones[at.link], &graph->links[at.link].points_in_world);
    }
  }
}

StageSummary Summarize(const DrawingGraph& graph) {
  StageSummary summary;
  summary.stage = "primitives";
  summary.in = {{"links", static_cast<int64_t>(graph.links.size())}};
  for (const PrimitiveStatistics::Kind& kind : Describe(graph).kinds) {
    auto& counts = std::strcmp(kind.name, "none") == 0 ? summary.dropped : summary.kept;
    const char* text = std::strcmp(kind.name, "none") == 0 ? "links without" : kind.name;
    counts.push_back({text, kind.count});
  }
  return summary;
}

// The graph with new primitives of some links.
DrawingGraph Fitted(const DrawingGraph& graph, const std::vector<uint8_t>& refit,
                    const std::vector<View>& views, const PrimitiveOptions& options,
                    const RunContext& context) {
  DrawingGraph result = graph;
  std::vector<Fit> fits = SampleLinks(graph, refit, views, context);
  // Fit freely first: the shapes tell where the curves meet.
  const std::vector<EndConditions> ends = EndsOfLinks(graph);
  Choose(std::vector<EndConditions>(ends.size()), graph, options, context, &fits);
  MoveNodes(fits, kEndZonePx, &result);
  for (size_t l = 0; l < fits.size(); ++l) {
    if (fits[l].samples.samples.empty()) continue;
    fits[l].samples.samples.front().position = result.links[l].points_in_world.front();
    fits[l].samples.samples.back().position = result.links[l].points_in_world.back();
  }
  Choose(ends, graph, options, context, &fits);
  Join(graph, refit, ends, options, context, &fits);
  for (size_t l = 0; l < fits.size(); ++l) {
    if (!refit[l]) continue;
    result.links[l].primitive.reset();
    result.links[l].regularity.reset();
    const std::optional<FittedShape>& fitted = fits[l].fitted;
    if (!fitted || !ValidateShape(fitted->shape).empty() ||
        !IsAlongLink(fitted->shape, result.links[l].points_in_world)) {
      continue;
    }
    LinkPrimitive& primitive = result.links[l].primitive.emplace();
    primitive.shape = fitted->shape;
    primitive.rms_px = fitted->rms_px;
    primitive.max_px = fitted->max_px;
  }
  return result;
}

}  // namespace

PrimitiveResult FitPrimitives(const DrawingGraph& graph, const std::vector<View>& views,
                              const PrimitiveOptions& options, const RunContext& context) {
  options.Check();
  PrimitiveResult result;
  result.graph =
      Fitted(graph, std::vector<uint8_t>(graph.links.size(), 1), views, options, context);
  result.graph.regularities = {};
  result.graph.faces.clear();
  result.summary = Summarize(result.graph);
  return result;
}

DrawingGraph RefitPrimitives(const DrawingGraph& graph, const std::vector<uint8_t>& refit,
                             const std::vector<View>& views, const PrimitiveOptions& options,
                             const RunContext& context) {
  options.Check();
  return Fitted(graph, refit, views, options, context);
}

PrimitiveStatistics Describe(const DrawingGraph& graph) {
  PrimitiveStatistics statistics;
  for (const char* name : {"line", "arc", "circle", "spline", "none"}) {
    statistics.kinds.push_back({name, 0, 0});
  }
  double sum = 0;
  double whole = 0;
  for (const DrawingLink& link : graph.links) {
    const char* name = link.primitive ? ShapeName(link.primitive->shape) : "none";
    const double length = Length(link.points_in_world);
    for (PrimitiveStatistics::Kind& kind : statistics.kinds) {
      if (std::strcmp(kind.name, name) != 0) continue;
      ++kind.count;
      kind.length += length;
    }
    statistics.numbers_before += 3 * link.points_in_world.size();
    if (!link.primitive) continue;
    statistics.numbers_after += NumNumbers(link.primitive->shape);
    sum += length * link.primitive->rms_px * link.primitive->rms_px;
    whole += length;
    statistics.max_px = std::max(statistics.max_px, link.primitive->max_px);
  }
  if (whole > 0) statistics.rms_px = std::sqrt(sum / whole);
  return statistics;
}

}  // namespace limn
