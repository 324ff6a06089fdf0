// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/regularize.h"

#include <algorithm>
#include <utility>

#include "limn/regularity/settle.h"
#include "limn/util/median.h"

namespace limn {
namespace {

RegularityClasses FindClasses(const DrawingGraph& graph, const DrawingEvidence& evidence,
                              const RegularityOptions& options, const RunContext& context) {
  RegularityClasses classes;
  classes.directions = FindParallelLines(evidence.lines, options);
  FindOrthogonalClasses(options, &classes.directions);
  classes.planes = FindCommonPlanes(graph, evidence, classes.directions, options, context);
  classes.radii = FindEqualRadii(evidence.arcs, options);
  classes.axes = FindCommonAxes(evidence.arcs, options);
  return classes;
}

// Tells the graph, and its links, what is regular.
void Store(const RegularityClasses& classes, const DrawingEvidence& evidence, DrawingGraph* graph) {
  const LocalUnit& unit = evidence.unit;
  Regularities& found = graph->regularities;
  found = {};
  for (DrawingLink& link : graph->links) link.regularity.reset();
  const auto of_line = [&](int i) -> LinkRegularity& {
    auto& regularity = graph->links[evidence.lines[i].link].regularity;
    return regularity ? *regularity : regularity.emplace();
  };
  const auto of_arc = [&](int i) -> LinkRegularity& {
    auto& regularity = graph->links[evidence.arcs[i].link].regularity;
    return regularity ? *regularity : regularity.emplace();
  };
  for (const DirectionClass& of : classes.directions) {
    for (const int i : of.lines) of_line(i).direction = static_cast<int>(found.directions.size());
    found.directions.push_back({of.direction, of.orthogonal_to});
  }
  for (const PlaneClass& of : classes.planes) {
    const int plane = static_cast<int>(found.planes.size());
    for (const int i : of.lines) of_line(i).planes.push_back(plane);
    for (const int i : of.arcs) of_arc(i).planes.push_back(plane);
    found.planes.push_back(
        {of.normal, unit.length * of.offset + of.normal.dot(unit.origin), of.normal_class});
  }
  for (const RadiusClass& of : classes.radii) {
    for (const int i : of.arcs) of_arc(i).radius = static_cast<int>(found.radii.size());
    found.radii.push_back(unit.length * of.radius);
  }
  for (const AxisClass& of : classes.axes) {
    for (const int i : of.arcs) of_arc(i).axis = static_cast<int>(found.axes.size());
    found.axes.push_back({unit.ToWorld(of.point), of.direction});
  }
}

// How far ends moved, in classes.
StageSummary::Counts CountMoves(const std::vector<double>& moves_px) {
  StageSummary::Counts counts = {{"ends: moved by .1 px or less", 0},
                                 {"ends: moved by .1 to .5 px", 0},
                                 {"ends: moved by more than .5 px", 0}};
  for (const double px : moves_px) ++counts[px <= 0.1 ? 0 : px <= 0.5 ? 1 : 2].second;
  return counts;
}

StageSummary Summarize(const DrawingEvidence& evidence, size_t num_regular, size_t num_let_go,
                       const std::vector<double>& moves_px) {
  const size_t count = evidence.lines.size() + evidence.arcs.size();
  StageSummary summary;
  summary.stage = "regularities";
  summary.in = {{"lines and arcs", static_cast<int64_t>(count)},
                {"ends", static_cast<int64_t>(2 * count)}};
  summary.kept = CountMoves(moves_px);
  summary.kept.insert(summary.kept.begin(), {"regular", static_cast<int64_t>(num_regular)});
  summary.dropped = {{"follow none", static_cast<int64_t>(count - num_regular - num_let_go)},
                     {"opposed by the images", static_cast<int64_t>(num_let_go)},
                     {"ends: not moved", static_cast<int64_t>(2 * count - moves_px.size())}};
  return summary;
}

}  // namespace

RegularityResult Regularize(const DrawingGraph& graph, const std::vector<View>& views,
                            const RegularityOptions& options, const PrimitiveOptions& primitives,
                            const RunContext& context) {
  options.Check();
  primitives.Check();
  const DrawingEvidence evidence = MeasureEvidence(graph, views, primitives, context);
  const SettledRegularities settled = SettleRegularities(
      graph, evidence, options, FindClasses(graph, evidence, options, context), context);
  RegularityResult result;
  result.graph = graph;
  ApplyShapes(settled.shapes, evidence.samples, &result.graph);
  Store(settled.classes, evidence, &result.graph);
  std::vector<double> moves = MovesPx(graph, settled.shapes, evidence.samples);
  result.summary = Summarize(evidence, MembershipsOf(settled.classes, evidence).size(),
                             settled.let_go.size(), moves);
  result.moves.num_ends = static_cast<int>(moves.size());
  if (!moves.empty()) {
    result.moves.max_px = *std::max_element(moves.begin(), moves.end());
    result.moves.median_px = Median(std::move(moves));
  }
  return result;
}

std::string DescribeRegularities(const DrawingGraph& graph) {
  int in_direction = 0, in_plane = 0, of_radius = 0, of_axis = 0, num_right_angles = 0;
  for (const DrawingLink& link : graph.links) {
    if (!link.regularity) continue;
    in_direction += link.regularity->direction >= 0;
    in_plane += !link.regularity->planes.empty();
    of_radius += link.regularity->radius >= 0;
    of_axis += link.regularity->axis >= 0;
  }
  const Regularities& found = graph.regularities;
  for (const CommonDirection& of : found.directions) {
    num_right_angles += static_cast<int>(of.orthogonal_to.size());
  }
  const auto part = [](int links, size_t count, const char* what) {
    return std::to_string(links) + " links in " + std::to_string(count) + " " + what;
  };
  return part(in_direction, found.directions.size(), "directions") + " (" +
         std::to_string(num_right_angles / 2) + " right angles), " +
         part(in_plane, found.planes.size(), "planes") + ", " +
         part(of_radius, found.radii.size(), "radii") + ", " +
         part(of_axis, found.axes.size(), "axes");
}

}  // namespace limn
