#include "limn/regularity/regularize.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "limn/primitives/shape_fit.h"
#include "limn/regularity/apply_shapes.h"
#include "limn/regularity/regular_fit.h"
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

NewShapes ShapesByLink(const RegularShapes& shapes, const DrawingEvidence& evidence,
                       size_t num_links) {
  const LocalUnit& unit = evidence.unit;
  const auto to_world = [&](const CurveShape& shape) {
    return Transformed(shape, unit.length, Eigen::Matrix3d::Identity(), unit.origin);
  };
  NewShapes by_link(num_links);
  for (const auto& [i, line] : shapes.lines) by_link[evidence.lines[i].link] = to_world(line);
  for (const auto& [i, arc] : shapes.arcs) by_link[evidence.arcs[i].link] = to_world(arc);
  return by_link;
}

// Per link; 0 where there is no evidence. Root mean squares, px.
std::vector<double> ResidualsOf(const DrawingGraph& graph, const DrawingEvidence& evidence) {
  std::vector<double> residuals;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const LinkSamples& samples = evidence.samples[l];
    residuals.push_back(
        samples.samples.empty() ? 0 : ResidualOf(graph.links[l].primitive->shape, samples).RmsPx());
  }
  return residuals;
}

// Links whose residual grows too much, of these the worst: others may be well without them.
std::set<LinkId> Opposed(const std::vector<double>& rms_before, const NewShapes& shapes,
                         const DrawingEvidence& evidence, const RegularityOptions& options) {
  constexpr double kAsBad = 0.5;  // share of the worst growth
  std::vector<double> growth(shapes.size(), 0);
  double worst = 0;
  for (size_t l = 0; l < shapes.size(); ++l) {
    if (!shapes[l]) continue;
    growth[l] = ResidualOf(*shapes[l], evidence.samples[l]).RmsPx() - rms_before[l];
    if (!ValidateShape(*shapes[l]).empty() || !std::isfinite(growth[l])) {
      growth[l] = std::numeric_limits<double>::infinity();
    }
    worst = std::max(worst, growth[l]);
  }
  std::set<LinkId> opposed;
  for (size_t l = 0; l < shapes.size(); ++l) {
    if (growth[l] > options.max_growth_px && growth[l] >= kAsBad * worst) {
      opposed.insert(static_cast<LinkId>(l));
    }
  }
  return opposed;
}

// The links that follow a regularity, of some that are opposed; where none does, those that end at
// their nodes, too.
std::set<LinkId> ToLetGo(const std::set<LinkId>& opposed, const DrawingGraph& graph,
                         const std::set<LinkId>& members) {
  std::set<LinkId> links;
  for (const LinkId l : opposed) {
    if (members.contains(l)) links.insert(l);
  }
  if (!links.empty()) return links;
  for (const LinkId l : opposed) {
    for (const NodeId node : {graph.links[l].node0, graph.links[l].node1}) {
      for (const LinkEnd& at : graph.nodes[node].incident) {
        if (members.contains(at.link)) links.insert(at.link);
      }
    }
  }
  return links;
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

StageSummary Summarize(const DrawingEvidence& evidence, size_t num_regular, size_t num_let_go) {
  const size_t count = evidence.lines.size() + evidence.arcs.size();
  StageSummary summary;
  summary.stage = "regularities";
  summary.in = {{"lines and arcs", static_cast<int64_t>(count)}};
  summary.kept = {{"regular", static_cast<int64_t>(num_regular)}};
  summary.dropped = {{"follow none", static_cast<int64_t>(count - num_regular - num_let_go)},
                     {"opposed by the images", static_cast<int64_t>(num_let_go)}};
  return summary;
}

}  // namespace

RegularityResult Regularize(const DrawingGraph& graph, const std::vector<View>& views,
                            const RegularityOptions& options, const RunContext& context) {
  options.Check();
  const DrawingEvidence evidence = MeasureEvidence(graph, views, options, context);
  RegularityClasses classes = FindClasses(graph, evidence, options, context);
  RegularityResult result;
  result.graph = graph;
  const std::vector<double> rms_before = ResidualsOf(graph, evidence);
  std::set<LinkId> let_go;
  NewShapes shapes;
  // Ends: every round lets links go.
  while (true) {
    ThrowIfCancelled(context);
    shapes =
        ShapesByLink(FitRegularShapes(graph, evidence, &classes), evidence, graph.links.size());
    const std::set<LinkId> links = ToLetGo(Opposed(rms_before, shapes, evidence, options), graph,
                                           MembersOf(classes, evidence));
    if (links.empty()) break;
    LetGo(links, evidence, &classes);
    let_go.insert(links.begin(), links.end());
  }
  const std::set<LinkId> regular = MembersOf(classes, evidence);
  std::erase_if(let_go, [&](LinkId l) { return regular.contains(l); });
  ApplyShapes(shapes, evidence.samples, &result.graph);
  Store(classes, evidence, &result.graph);
  std::vector<double> moves = MovesPx(graph, shapes, evidence.samples);
  result.moves.num_ends = static_cast<int>(moves.size());
  if (!moves.empty()) {
    result.moves.max_px = *std::max_element(moves.begin(), moves.end());
    result.moves.median_px = Median(std::move(moves));
  }
  result.summary = Summarize(evidence, regular.size(), let_go.size());
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
