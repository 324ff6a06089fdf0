// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/drawing_span.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <regex>
#include <variant>

#include "limn/geometry/polyline.h"
#include "limn/util/errors.h"
#include "limn/util/median.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

std::optional<ImagePoint> PixelOf(const std::string& image, const std::string& x,
                                  const std::string& y) {
  const auto column = ParseNumber<double>(x), row = ParseNumber<double>(y);
  if (!column || !row) return std::nullopt;
  return ImagePoint{image, {*column, *row}};
}

struct SpanEnd {
  Eigen::Vector3d position;
  Eigen::Matrix3d covariance;
};
struct SpanEnds {
  SpanEnd from, to;
};

SpanEnd AtNode(const DrawingGraph& graph, NodeId node) {
  return {graph.nodes[node].position_in_world, graph.nodes[node].covariance};
}

SpanEnd EndOfLink(const DrawingGraph& graph, const DrawingLink& link, int end) {
  SpanEnd result = AtNode(graph, link.NodeAt(end));
  const auto* line = link.primitive ? std::get_if<LineSegment>(&link.primitive->shape) : nullptr;
  if (line) result.position = end == 0 ? line->start : line->end;
  return result;
}

// At a place of the drawing: of the node there, else by the sigma of the nearest point; zero if
// that is unknown.
Eigen::Matrix3d CovarianceAt(const DrawingGraph& graph, const Eigen::Vector3d& place) {
  for (const DrawingNode& node : graph.nodes) {
    if (node.position_in_world == place) return node.covariance;
  }
  double nearest = std::numeric_limits<double>::infinity(), sigma = 0;
  for (const DrawingLink& link : graph.links) {
    if (link.kind == LinkKind::kContour) continue;
    for (size_t i = 0; i < link.sigma.size(); ++i) {
      const double distance = (link.points_in_world[i] - place).squaredNorm();
      if (!(distance < nearest)) continue;
      nearest = distance;
      sigma = link.sigma[i];
    }
  }
  if (!std::isfinite(sigma)) return Eigen::Matrix3d::Zero();
  return sigma * sigma * Eigen::Matrix3d::Identity();
}

double ShapeLength(const DrawingLink& link) {
  if (link.primitive) {
    const CurveShape& shape = link.primitive->shape;
    if (const auto* line = std::get_if<LineSegment>(&shape)) {
      return (line->end - line->start).norm();
    }
    if (const auto* arc = std::get_if<CircularArc>(&shape)) return arc->radius * arc->sweep_rad;
  }
  return Length(link.points_in_world);
}

// By how much a link grows with its radius if it returns to where it begins, or is an arc.
double TurnOf(const DrawingLink& link) {
  if (link.node0 == link.node1) return 2 * std::numbers::pi;
  const auto* arc = link.primitive ? std::get_if<CircularArc>(&link.primitive->shape) : nullptr;
  return arc ? arc->sweep_rad : 0;
}

double SigmaOfRadius(const DrawingLink& link) {
  if (link.sigma.empty()) return 0;
  const double sigma = Median(link.sigma);
  return std::isfinite(sigma) ? sigma : 0;
}

double SigmaBetween(const SpanEnd& from, const SpanEnd& to) {
  const Eigen::Vector3d way = to.position - from.position;
  if (from.covariance.isZero(0) || to.covariance.isZero(0) || !(way.norm() > 0)) return 0;
  const Eigen::Vector3d direction = way.normalized();
  const double variance = direction.dot((from.covariance + to.covariance) * direction);
  return std::sqrt(std::max(0.0, variance));
}

void CheckIsThere(const char* what, int id, size_t count) {
  if (id < static_cast<int>(count)) return;
  throw InputError("the drawing has no " + std::string(what) + " " + std::to_string(id) +
                   ", only " + std::to_string(count));
}

// A link's are those of its primitive if that is a line.
SpanEnds EndsOf(const DrawingGraph& graph, const DrawingSpan& span) {
  if (!span.places.empty()) {
    const auto& from = span.places.front();
    const auto& to = span.places.back();
    return {{from.position, from.covariance}, {to.position, to.covariance}};
  }
  if (span.link >= 0) {
    CheckIsThere("link", span.link, graph.links.size());
    const DrawingLink& link = graph.links[span.link];
    return {EndOfLink(graph, link, 0), EndOfLink(graph, link, 1)};
  }
  for (const NodeId node : {span.node0, span.node1}) {
    CheckIsThere("node", node, graph.nodes.size());
  }
  return {AtNode(graph, span.node0), AtNode(graph, span.node1)};
}

}  // namespace

std::optional<DrawingSpan> ParseSpan(const std::string& text) {
  static const std::regex graph_pattern(
      R"(\s*(?:link\s+(\d{1,9})|from\s+(\d{1,9})\s+to\s+(\d{1,9}))\s*)");
  static const std::regex pixel_pattern(
      R"(\s*(?:from\s+)?(\S.*?)\s+([0-9.]{1,20}),([0-9.]{1,20})\s+to\s+(\S.*?)\s+([0-9.]{1,20}),([0-9.]{1,20})\s*)");
  // Long texts overflow the stack of std::regex.
  if (text.size() > 600) return std::nullopt;
  DrawingSpan span;
  std::smatch match;
  if (std::regex_match(text, match, graph_pattern)) {
    if (match[1].matched) {
      span.link = *ParseNumber<int>(match.str(1));
    } else {
      span.node0 = *ParseNumber<int>(match.str(2));
      span.node1 = *ParseNumber<int>(match.str(3));
    }
    return span;
  }
  if (!std::regex_match(text, match, pixel_pattern)) return std::nullopt;
  const auto from = PixelOf(match[1], match[2], match[3]);
  const auto to = PixelOf(match[4], match[5], match[6]);
  if (!from || !to) return std::nullopt;
  span.pixels = {*from, *to};
  return span;
}

Eigen::Vector3d WayOf(const DrawingGraph& graph, const DrawingSpan& span) {
  const auto [from, to] = EndsOf(graph, span);
  if (from.position == to.position) throw InputError("both places are the same");
  return to.position - from.position;
}

MeasuredLength MeasureSpan(const DrawingGraph& graph, const DrawingSpan& span) {
  const auto [from, to] = EndsOf(graph, span);
  MeasuredLength measured{(to.position - from.position).norm(), SigmaBetween(from, to)};
  if (span.link >= 0) {
    const DrawingLink& link = graph.links[span.link];
    measured.length = ShapeLength(link);
    const double of_radius = TurnOf(link) * SigmaOfRadius(link);
    if (link.node0 == link.node1) {
      measured.sigma = of_radius;
    } else if (measured.sigma > 0) {
      measured.sigma = std::hypot(measured.sigma, of_radius);
    }
  }
  if (!(measured.length > 0)) throw InputError("both places are the same");
  return measured;
}

MeasuredLength MeasureBetween(const DrawingGraph& graph, const Eigen::Vector3d& from,
                              const Eigen::Vector3d& to) {
  const SpanEnd start = {from, CovarianceAt(graph, from)}, end = {to, CovarianceAt(graph, to)};
  return {(to - from).norm(), SigmaBetween(start, end)};
}

void MeasureDimensions(const Alignment& alignment, DrawingGraph* graph) {
  for (DrawingDimension& dimension : graph->dimensions) {
    const MeasuredLength in_model = MeasureBetween(*graph, dimension.from, dimension.to);
    dimension.sigma = InWorld(in_model, alignment).sigma / alignment.world_from_model.scale;
  }
}

MeasuredLength InWorld(const MeasuredLength& in_model, const Alignment& alignment) {
  MeasuredLength in_world;
  in_world.length = alignment.world_from_model.scale * in_model.length;
  const bool is_known = !alignment.IsMetric() || alignment.scale_sigma > 0;
  if (in_model.sigma > 0 && is_known) {
    in_world.sigma = std::hypot(alignment.world_from_model.scale * in_model.sigma,
                                alignment.scale_sigma * in_world.length);
  }
  return in_world;
}

}  // namespace limn
