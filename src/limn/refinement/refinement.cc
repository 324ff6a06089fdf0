#include "limn/refinement/refinement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "limn/geometry/median_point.h"
#include "limn/model/footprint.h"
#include "limn/refinement/edge_links.h"
#include "limn/refinement/fit_rounds.h"
#include "limn/refinement/gauge.h"
#include "limn/refinement/pose_fit.h"
#include "limn/refinement/scene_unit.h"
#include "limn/topology/covered_links.h"
#include "limn/topology/edit_topology.h"
#include "limn/topology/graph_editor.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"
#include "limn/util/name_list.h"
#include "limn/util/number_text.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// Rounds in which the cameras move: gate of the edgels as a multiple of max_distance_px. The first
// ones must exceed the errors of the cameras.
constexpr double kPoseRoundReach[] = {3, 3, 2, 1.5, 1, 1};

// Resamples a link to a point per px and gives it vertices with its footprint and, unless frozen,
// the matched edgels, as RepairTopology needs them. A link that no view sees stays unchanged.
void GiveVertices(const std::vector<View>& views, const ControlLink& fitted, DrawingLink* link) {
  const double footprint = LinkFootprint(*link, views);
  if (!(footprint > 0)) return;
  const std::vector<double> arc = CumulativeLength(link->points_in_world);
  link->points_in_world = ResampleUniform(link->points_in_world, footprint);
  // Infinite before the last fit, not read after it.
  link->sigma.assign(link->points_in_world.size(), link->sigma.front());
  link->vertices.resize(link->points_in_world.size());
  for (LinkVertex& vertex : link->vertices) vertex.footprint = footprint;
  if (fitted.frozen) return;
  const double step = arc.back() / static_cast<double>(link->size() - 1);
  for (const FitSample& sample : fitted.samples) {
    const double at = (1 - sample.t) * arc[sample.segment] + sample.t * arc[sample.segment + 1];
    LinkVertex& vertex = link->vertices[std::lround(at / step)];
    for (const EdgelPull& pull : sample.pulls) vertex.support.push_back(pull.ref);
  }
  for (LinkVertex& vertex : link->vertices) SortUnique(&vertex.support);
}

// Refines a whole drawing.
class DrawingRefiner {
 public:
  DrawingRefiner(const RefinementInput& input, const RefinementOptions& options,
                 const TopologyOptions& topology, const RunContext& context)
      : input_(input),
        options_(options),
        topology_(topology),
        context_(context),
        rounds_(input, options, context) {}

  RefinementResult Run() {
    RefinementResult result;
    if (options_.refine_poses) result.cameras = RefineCameras();
    for (int round = 0; round < options_.num_rounds; ++round) {
      if (round > 0 && round == options_.num_rounds / 2) ChangeTopology();
      rounds_.Fit(rounds_.AllLinks(), round + 1 == options_.num_rounds);
    }
    rounds_.Finish(rounds_.AllLinks());
    result.fitted = RemoveCovered(WithVertices());
    result.summary = Summary();
    result.graph = std::move(rounds_.graph);
    return result;
  }

 private:
  void ChangeTopology() {
    rounds_.SetGeometry(rounds_.AllLinks());
    const DrawingGraph dense = WithVertices();
    for (size_t l = 0; l < rounds_.graph.links.size(); ++l) {
      DrawingLink& link = rounds_.graph.links[l];
      const DrawingLink& with_vertices = dense.links[l];
      if (!rounds_.control.links[l].frozen) {
        link = with_vertices;
      } else if (!with_vertices.vertices.empty()) {
        // It keeps its points; none of these vertices has edgels.
        link.vertices.assign(link.points_in_world.size(), with_vertices.vertices.front());
      }
    }
    RemoveCovered(dense);
    repairs_ = RepairTopology(rounds_.Images(1), topology_, context_, &rounds_.graph);
    for (DrawingLink& link : rounds_.graph.links) link.vertices.clear();
    rounds_.TakeGraph();
  }

  DrawingGraph WithVertices() const {
    DrawingGraph graph = rounds_.graph;
    for (size_t l = 0; l < graph.links.size(); ++l) {
      GiveVertices(rounds_.views, rounds_.control.links[l], &graph.links[l]);
    }
    return graph;
  }

  // `dense`: the graph, with vertices. Returns which of the links that remain are fitted.
  std::vector<uint8_t> RemoveCovered(const DrawingGraph& dense) {
    const std::vector<uint8_t> keep = FindUncoveredLinks(topology_, dense);
    std::vector<uint8_t> fitted;
    for (size_t l = 0; l < keep.size(); ++l) {
      num_covered_ += !keep[l];
      if (keep[l]) fitted.push_back(!rounds_.control.links[l].frozen);
    }
    num_frozen_ = std::ranges::count(fitted, 0);
    RemoveLinks(keep, &rounds_.graph);
    return fitted;
  }

  RefinedCameras RefineCameras() {
    const std::vector<ScenePoint>& points = input_.scene.hints.points;
    RefinedCameras refined;
    for (const ScenePoint& point : points) refined.points.push_back(point.position_in_world);
    CameraCorrections corrections(input_.scene.views);
    for (const double reach : kPoseRoundReach) {
      rounds_.Match(reach);
      RefinementOptions options = options_;
      options.robust_residual_px *= reach;
      rounds_.FindFrozen();
      const bool found = FitPoses(input_.scene.views, points, options, context_, &corrections,
                                  &rounds_.control, &refined.points);
      num_failed_pose_rounds_ += !found;
      rounds_.views = Corrected(input_.scene.views, corrections);
    }
    BringBack(points, &refined.points);
    refined.views = rounds_.views;
    refined.median_shift_px = MedianShiftPx();
    for (const auto& [camera_index, log_focal] : corrections.log_focal) {
      refined.largest_focal_change =
          std::max(refined.largest_focal_change, std::abs(std::expm1(log_focal)));
    }
    return refined;
  }

  // Restores place, orientation and scale, which images do not determine, to those of the given
  // cameras.
  void BringBack(const std::vector<ScenePoint>& given, std::vector<Eigen::Vector3d>* points) {
    std::vector<Eigen::Vector3d> scene = rounds_.control.position;
    for (size_t p = 0; p < given.size(); ++p) {
      if (given[p].pixels.size() >= 2) scene.push_back((*points)[p]);
    }
    // Some points of a sparse model are far away.
    gauge_ = FindGauge(input_.scene.views, rounds_.views, MedianPoint(scene));
    const Eigen::Affine3d& back = gauge_.given_from_refined;
    rounds_.views = Moved(rounds_.views, back);
    for (std::vector<Eigen::Vector3d>* of : {&rounds_.control.position, points}) {
      for (Eigen::Vector3d& point : *of) point = back * point;
    }
  }

  // Shift of the images of control points by the refinement of the cameras: median over views of
  // the median over points.
  double MedianShiftPx() const {
    std::vector<double> shifts;
    for (size_t v = 0; v < rounds_.views.size(); ++v) {
      std::vector<double> of_view;
      for (const Eigen::Vector3d& point : rounds_.control.position) {
        const auto before = input_.scene.views[v].Project(point);
        const auto after = rounds_.views[v].Project(point);
        if (before && after) of_view.push_back((*after - *before).norm());
      }
      if (!of_view.empty()) shifts.push_back(Median(std::move(of_view)));
    }
    return Median(std::move(shifts));
  }

  std::string FarMoves() const {
    std::vector<NamedNumber> moves;
    for (const FarMove& move : gauge_.moved_far) {
      moves.push_back({input_.scene.views[move.view].name, move.px});
    }
    std::ranges::sort(moves, std::greater{}, &NamedNumber::number);
    return "the cameras of " + std::to_string(moves.size()) + " of " +
           std::to_string(rounds_.views.size()) +
           " images seem wrong and moved far: " + ListNumbers(moves, "px") + "; the median is " +
           ShortNumber(gauge_.typical_move_px) + " px: look at their overlays";
  }

  StageSummary Summary() const {
    StageSummary summary;
    summary.stage = "refinement";
    summary.in = {{"links", std::ssize(input_.graph.links)}};
    summary.kept = {{"links", std::ssize(rounds_.graph.links)},
                    {"links not fitted: too few views", num_frozen_},
                    {"control points", std::ssize(rounds_.control.position)},
                    {"long edges drawn anew", repairs_.long_edges.added},
                    {"ends cut back from other links", repairs_.trimmed},
                    {"ends joined", repairs_.meetings.joined},
                    {"ends taken to nodes", repairs_.meetings.to_nodes},
                    {"ends taken to links", repairs_.meetings.to_links},
                    {"links cut at corners", repairs_.splits},
                    {"edges grown between nodes", repairs_.grown},
                    {"short edges between nodes", repairs_.short_edges},
                    {"dissolved nodes", repairs_.dissolved_nodes}};
    summary.dropped = {{"links: others run along them", num_covered_},
                       {"links: pieces of long edges", repairs_.long_edges.replaced}};
    if (num_failed_pose_rounds_ > 0) {
      summary.warnings.push_back(std::to_string(num_failed_pose_rounds_) + " of " +
                                 std::to_string(std::size(kPoseRoundReach)) +
                                 " rounds of the cameras found no solution and changed nothing");
    }
    if (!gauge_.moved_far.empty()) summary.warnings.push_back(FarMoves());
    return summary;
  }

  const RefinementInput& input_;
  const RefinementOptions& options_;
  const TopologyOptions& topology_;
  const RunContext& context_;
  FitRounds rounds_;
  RepairCounts repairs_;
  Gauge gauge_;
  int64_t num_covered_ = 0;
  int64_t num_frozen_ = 0;  // of the links that remain
  int num_failed_pose_rounds_ = 0;
};

// Adds the outlines of smooth bodies of another graph as they are.
void AddContours(const DrawingGraph& from, DrawingGraph* graph) {
  GraphEditor editor(graph);
  for (DrawingLink link : from.links) {
    if (link.kind != LinkKind::kContour) continue;
    link.node0 = link.node1 = -1;
    editor.Add(std::move(link));
  }
}

// Refines in units of the scene.
RefinementResult RefineEdges(const RefinementInput& input, const RefinementOptions& options,
                             const TopologyOptions& topology, const RunContext& context) {
  const double unit = SceneUnit(input.scene.views, input.graph);
  const std::vector<View> views = Scaled(input.scene.views, 1 / unit);
  const DrawingGraph graph = Scaled(input.graph, 1 / unit);
  // Only cameras are refined by points.
  SceneHints hints;
  if (options.refine_poses) hints = input.scene.hints;
  for (ScenePoint& point : hints.points) point.position_in_world /= unit;
  RefinementResult result =
      DrawingRefiner({{views, input.scene.curves, hints}, graph}, options, topology, context).Run();
  result.graph = Scaled(std::move(result.graph), unit);
  if (result.cameras) {
    result.cameras->views = Scaled(std::move(result.cameras->views), unit);
    for (Eigen::Vector3d& point : result.cameras->points) point *= unit;
  }
  return result;
}

}  // namespace

RefinementResult RefineDrawing(const RefinementInput& input, const RefinementOptions& options,
                               const TopologyOptions& topology, const RunContext& context) {
  options.Check();
  topology.Check();
  if (options.num_rounds == 0) {
    RefinementResult unchanged;
    unchanged.graph = input.graph;
    unchanged.summary.stage = "refinement";
    return unchanged;
  }
  DrawingGraph edges = input.graph;
  RemoveLinks(AreEdges(input.graph), &edges);
  RefinementResult result = RefineEdges({input.scene, edges}, options, topology, context);
  AddContours(input.graph, &result.graph);
  return result;
}

}  // namespace limn
