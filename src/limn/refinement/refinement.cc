#include "limn/refinement/refinement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "limn/geometry/median_point.h"
#include "limn/model/footprint.h"
#include "limn/refinement/curve_fit.h"
#include "limn/refinement/edgel_matches.h"
#include "limn/refinement/gauge.h"
#include "limn/refinement/pose_fit.h"
#include "limn/refinement/scene_unit.h"
#include "limn/refinement/variance_factors.h"
#include "limn/topology/covered_links.h"
#include "limn/topology/edit_topology.h"
#include "limn/topology/graph_editor.h"
#include "limn/util/median.h"
#include "limn/util/name_list.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// A link is fitted if enough views show this share of its samples.
constexpr double kMinShownShare = 0.3;
// A view supports a link if it shows this many of its samples, or half of them.
constexpr int kMinSupportedSamples = 3;

// Rounds in which the cameras move: gate of the edgels as a multiple of max_distance_px. The first
// ones must exceed the errors of the cameras.
constexpr double kPoseRoundReach[] = {3, 3, 2, 1.5, 1, 1};

// Samples that enough views show.
int NumShown(const ControlLink& link) {
  return static_cast<int>(
      std::ranges::count_if(link.samples, [](const LinkSample& s) { return !s.pulls.empty(); }));
}

void FindFrozen(ControlGraph* control) {
  for (ControlLink& link : control->links) {
    const int shown = NumShown(link);
    link.frozen = shown == 0 || shown < kMinShownShare * static_cast<double>(link.samples.size());
  }
}

void SetSupport(const ControlLink& fitted, DrawingLink* link) {
  std::map<ViewId, int> samples;
  std::vector<double> residuals;
  for (const LinkSample& sample : fitted.samples) {
    for (const EdgelPull& pull : sample.pulls) {
      ++samples[pull.ref.view];
      residuals.push_back(std::abs(pull.residual_px));
    }
  }
  const int needed = std::min(kMinSupportedSamples, (NumShown(fitted) + 1) / 2);
  link->supporting_views.clear();
  for (const auto& [view, count] : samples) {
    if (count >= needed) link->supporting_views.push_back(view);
  }
  link->residual_px = Median(std::move(residuals));
}

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
  for (const LinkSample& sample : fitted.samples) {
    const double at = (1 - sample.t) * arc[sample.segment] + sample.t * arc[sample.segment + 1];
    LinkVertex& vertex = link->vertices[std::lround(at / step)];
    for (const EdgelPull& pull : sample.pulls) vertex.support.push_back(pull.ref);
  }
  for (LinkVertex& vertex : link->vertices) SortUnique(&vertex.support);
}

class Refiner {
 public:
  Refiner(const RefinementInput& input, const RefinementOptions& options,
          const TopologyOptions& topology, const RunContext& context)
      : input_(input),
        options_(options),
        topology_(topology),
        context_(context),
        views_(input.views),
        graph_(input.graph),
        edgels_(BuildViewEdgels(input.curves, context)) {
    TakeGraph();
  }

  RefinementResult Run() {
    RefinementResult result;
    if (options_.refine_poses) result.cameras = RefineCameras();
    for (int round = 0; round < options_.num_rounds; ++round) {
      if (round > 0 && round == options_.num_rounds / 2) ChangeTopology();
      Match(1);
      FindFrozen(&control_);
      const bool is_last = round + 1 == options_.num_rounds;
      FitCurves(views_, options_, context_, is_last, &control_);
    }
    Match(1);
    ScaleCovariances();
    SetGeometry();
    for (size_t l = 0; l < graph_.links.size(); ++l) {
      const ControlLink& fitted = control_.links[l];
      if (!fitted.frozen) SetSupport(fitted, &graph_.links[l]);
    }
    result.fitted = RemoveCovered(WithVertices());
    result.summary = Summary();
    result.graph = std::move(graph_);
    return result;
  }

  // Fits some links only (RefitLinks).
  RefitResult Refit(const std::vector<uint8_t>& refit) {
    refit_ = &refit;
    HoldOthers();
    for (int round = 0; round < options_.num_rounds; ++round) {
      Match(1);
      FindFrozen(&control_);
      for (size_t l = 0; l < refit.size(); ++l) control_.links[l].frozen |= !refit[l];
      FitCurves(views_, options_, context_, round + 1 == options_.num_rounds, &control_);
    }
    Match(1);
    ScaleCovariances();
    SetGeometry();
    RefitResult result;
    for (size_t l = 0; l < refit.size(); ++l) {
      const ControlLink& fitted = control_.links[l];
      if (!fitted.frozen) SetSupport(fitted, &graph_.links[l]);
      result.fitted.push_back(!fitted.frozen);
      auto& shown = result.shown.emplace_back();
      if (!refit[l]) continue;
      for (const LinkSample& sample : fitted.samples) {
        shown.push_back({sample.position, static_cast<int>(sample.pulls.size())});
      }
    }
    result.graph = std::move(graph_);
    return result;
  }

 private:
  bool IsAsked(size_t link) const { return !refit_ || (*refit_)[link]; }

  // Nodes of links that stay are as uncertain as the ends of these links.
  void HoldOthers() {
    control_.held.resize(control_.position.size());
    for (size_t l = 0; l < graph_.links.size(); ++l) {
      if (IsAsked(l)) continue;
      const DrawingLink& link = graph_.links[l];
      for (const int end : {0, 1}) {
        const NodeId node = link.NodeAt(end);
        const double sigma = end == 0 ? link.sigma.front() : link.sigma.back();
        const double unknown = options_.max_distance_px * control_.footprint[node];
        std::optional<double>& held = control_.held[node];
        held = std::min(held.value_or(std::numeric_limits<double>::infinity()),
                        std::isfinite(sigma) && sigma > 0 ? sigma : unknown);
      }
    }
  }

  // Sets up the unknowns for the current graph.
  void TakeGraph() { control_ = MakeControlGraph(graph_, views_, options_.control_spacing_px); }

  // `reach`: multiple of max_distance_px.
  TopologyInput Images(double reach) const {
    return {views_,
            input_.curves,
            edgels_,
            {reach * options_.max_distance_px, 1.0, options_.max_angle_deg * M_PI / 180}};
  }

  void Match(double reach) { MatchEdgels(Images(reach), options_, context_, &control_); }

  void ChangeTopology() {
    SetGeometry();
    const DrawingGraph dense = WithVertices();
    for (size_t l = 0; l < graph_.links.size(); ++l) {
      DrawingLink& link = graph_.links[l];
      const DrawingLink& with_vertices = dense.links[l];
      if (!control_.links[l].frozen) {
        link = with_vertices;
      } else if (!with_vertices.vertices.empty()) {
        // It keeps its points; none of these vertices has edgels.
        link.vertices.assign(link.points_in_world.size(), with_vertices.vertices.front());
      }
    }
    RemoveCovered(dense);
    repairs_ = RepairTopology(Images(1), topology_, context_, &graph_);
    for (DrawingLink& link : graph_.links) link.vertices.clear();
    TakeGraph();
  }

  DrawingGraph WithVertices() const {
    DrawingGraph graph = graph_;
    for (size_t l = 0; l < graph.links.size(); ++l) {
      GiveVertices(views_, control_.links[l], &graph.links[l]);
    }
    return graph;
  }

  // `dense`: the graph, with vertices. Returns which of the links that remain are fitted.
  std::vector<uint8_t> RemoveCovered(const DrawingGraph& dense) {
    const std::vector<uint8_t> keep = FindUncoveredLinks(topology_, dense);
    std::vector<uint8_t> fitted;
    for (size_t l = 0; l < keep.size(); ++l) {
      num_covered_ += !keep[l];
      if (keep[l]) fitted.push_back(!control_.links[l].frozen);
    }
    num_frozen_ = std::ranges::count(fitted, 0);
    RemoveLinks(keep, &graph_);
    return fitted;
  }

  RefinedCameras RefineCameras() {
    const std::vector<ScenePoint>& points = *input_.points;
    RefinedCameras refined;
    for (const ScenePoint& point : points) refined.points.push_back(point.position_in_world);
    CameraCorrections corrections(input_.views);
    for (const double reach : kPoseRoundReach) {
      Match(reach);
      RefinementOptions options = options_;
      options.robust_residual_px *= reach;
      FindFrozen(&control_);
      const bool found = FitPoses(input_.views, points, options, context_, &corrections, &control_,
                                  &refined.points);
      num_failed_pose_rounds_ += !found;
      views_ = Corrected(input_.views, corrections);
    }
    BringBack(points, &refined.points);
    refined.views = views_;
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
    std::vector<Eigen::Vector3d> scene = control_.position;
    for (size_t p = 0; p < given.size(); ++p) {
      if (given[p].pixels.size() >= 2) scene.push_back((*points)[p]);
    }
    // Some points of a sparse model are far away.
    gauge_ = FindGauge(input_.views, views_, MedianPoint(scene));
    const Eigen::Affine3d& back = gauge_.given_from_refined;
    views_ = Moved(views_, back);
    for (std::vector<Eigen::Vector3d>* of : {&control_.position, points}) {
      for (Eigen::Vector3d& point : *of) point = back * point;
    }
  }

  // Shift of the images of control points by the refinement of the cameras: median over views of
  // the median over points.
  double MedianShiftPx() const {
    std::vector<double> shifts;
    for (size_t v = 0; v < views_.size(); ++v) {
      std::vector<double> of_view;
      for (const Eigen::Vector3d& point : control_.position) {
        const auto before = input_.views[v].Project(point);
        const auto after = views_[v].Project(point);
        if (before && after) of_view.push_back((*after - *before).norm());
      }
      if (!of_view.empty()) shifts.push_back(Median(std::move(of_view)));
    }
    return Median(std::move(shifts));
  }

  void ScaleCovariances() {
    const std::vector<double> factors = VarianceFactors(options_, control_);
    for (size_t p = 0; p < factors.size(); ++p) {
      if (control_.covariance[p]) *control_.covariance[p] *= factors[p];
    }
  }

  // Fitted links get their control points; the others keep their shape and follow their nodes.
  void SetGeometry() {
    for (size_t n = 0; n < graph_.nodes.size(); ++n) {
      graph_.nodes[n].position_in_world = control_.position[n];
    }
    for (size_t l = 0; l < graph_.links.size(); ++l) {
      if (!IsAsked(l)) continue;
      const ControlLink& fitted = control_.links[l];
      if (fitted.frozen) {
        KeepShape(fitted, &graph_.links[l]);
      } else {
        SetPoints(fitted, &graph_.links[l]);
      }
    }
  }

  // No edgel of an unfitted link is within the gate, so its sigma is at least max_distance_px.
  void KeepShape(const ControlLink& unfitted, DrawingLink* link) const {
    FollowEnds(control_.position[link->node0], control_.position[link->node1],
               &link->points_in_world);
    double footprint = 0;
    for (const int id : unfitted.points) footprint = std::max(footprint, control_.footprint[id]);
    const double least = options_.max_distance_px * footprint;
    for (double& sigma : link->sigma) {
      sigma = std::isfinite(sigma) ? std::max(sigma, least) : least;
    }
  }

  void SetPoints(const ControlLink& fitted, DrawingLink* link) const {
    link->points_in_world.clear();
    link->sigma.clear();
    for (int k = 0; k <= fitted.NumSegments(); ++k) {
      link->points_in_world.push_back(control_.position[fitted.points[k]]);
      link->sigma.push_back(Sigma(fitted, k));
    }
  }

  // Root of the mean of the two variances across the curve; infinite before there are any.
  double Sigma(const ControlLink& link, int k) const {
    const auto& covariance = control_.covariance[link.points[k]];
    if (!covariance) return std::numeric_limits<double>::infinity();
    const Eigen::Vector3d tangent = Tangent(control_, link, k - 1, k + 1);
    const double along = tangent.dot(*covariance * tangent);
    return std::sqrt(std::max(0.0, 0.5 * (covariance->trace() - along)));
  }

  std::string FarMoves() const {
    std::vector<NamedNumber> moves;
    for (const FarMove& move : gauge_.moved_far) {
      moves.push_back({input_.views[move.view].name, move.px});
    }
    std::ranges::sort(moves, std::greater{}, &NamedNumber::number);
    return "the cameras of " + std::to_string(moves.size()) + " of " +
           std::to_string(views_.size()) +
           " images seem wrong and moved far: " + ListNumbers(moves, "px") + "; the median is " +
           ShortNumber(gauge_.typical_move_px) + " px: look at their overlays";
  }

  StageSummary Summary() const {
    StageSummary summary;
    summary.stage = "refinement";
    summary.in = {{"links", std::ssize(input_.graph.links)}};
    summary.kept = {{"links", std::ssize(graph_.links)},
                    {"links not fitted: too few views", num_frozen_},
                    {"control points", std::ssize(control_.position)},
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
  std::vector<View> views_;                      // with refined cameras
  const std::vector<uint8_t>* refit_ = nullptr;  // per link whether to fit it; null: all
  DrawingGraph graph_;
  std::vector<std::unique_ptr<ViewEdgels>> edgels_;
  ControlGraph control_;
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
  const double unit = SceneUnit(input.views, input.graph);
  const std::vector<View> views = Scaled(input.views, 1 / unit);
  const DrawingGraph graph = Scaled(input.graph, 1 / unit);
  std::vector<ScenePoint> points;
  if (input.points) points = *input.points;
  for (ScenePoint& point : points) point.position_in_world /= unit;
  RefinementResult result =
      Refiner({views, input.curves, graph, &points}, options, topology, context).Run();
  result.graph = Scaled(std::move(result.graph), unit);
  if (result.cameras) {
    result.cameras->views = Scaled(std::move(result.cameras->views), unit);
    for (Eigen::Vector3d& point : result.cameras->points) point *= unit;
  }
  return result;
}

// The links that a fit takes: all but the outlines of smooth bodies.
std::vector<uint8_t> AreEdges(const DrawingGraph& graph) {
  std::vector<uint8_t> are_edges;
  for (const DrawingLink& link : graph.links) are_edges.push_back(link.kind != LinkKind::kContour);
  return are_edges;
}

// Puts a fitted link into a drawing that has its ends at nodes of its own.
void PutFitted(const DrawingLink& from, const std::vector<DrawingNode>& nodes, LinkId id,
               DrawingGraph* graph) {
  DrawingLink& link = graph->links[id];
  link.points_in_world = from.points_in_world;
  link.sigma = from.sigma;
  link.supporting_views = from.supporting_views;
  link.residual_px = from.residual_px;
  graph->nodes[link.node0].position_in_world = nodes[from.node0].position_in_world;
  graph->nodes[link.node1].position_in_world = nodes[from.node1].position_in_world;
}

}  // namespace

RefitResult RefitLinks(const RefinementInput& input, const std::vector<uint8_t>& refit,
                       const RefinementOptions& options, const RunContext& context) {
  options.Check();
  const size_t num_links = input.graph.links.size();
  RefitResult result = {input.graph, std::vector<uint8_t>(num_links, 0), {}};
  result.shown.resize(num_links);
  if (options.num_rounds == 0) return result;
  const std::vector<uint8_t> are_edges = AreEdges(input.graph);
  DrawingGraph edges = input.graph;
  RemoveLinks(are_edges, &edges);
  std::vector<LinkId> ids;  // of the edges
  std::vector<uint8_t> refit_edges;
  for (size_t l = 0; l < num_links; ++l) {
    if (!are_edges[l]) continue;
    ids.push_back(static_cast<LinkId>(l));
    refit_edges.push_back(refit[l]);
  }
  const double unit = SceneUnit(input.views, edges);
  const std::vector<View> views = Scaled(input.views, 1 / unit);
  edges = Scaled(std::move(edges), 1 / unit);
  const TopologyOptions unused;
  RefitResult fitted =
      Refiner({views, input.curves, edges}, options, unused, context).Refit(refit_edges);
  fitted.graph = Scaled(std::move(fitted.graph), unit);
  for (size_t e = 0; e < ids.size(); ++e) {
    if (!refit_edges[e]) continue;
    PutFitted(fitted.graph.links[e], fitted.graph.nodes, ids[e], &result.graph);
    result.fitted[ids[e]] = fitted.fitted[e];
    for (ShownPlace& place : fitted.shown[e]) place.position *= unit;
    result.shown[ids[e]] = std::move(fitted.shown[e]);
  }
  // Outlines end where their nodes have gone.
  for (size_t l = 0; l < num_links; ++l) {
    DrawingLink& link = result.graph.links[l];
    FollowEnds(result.graph.nodes[link.node0].position_in_world,
               result.graph.nodes[link.node1].position_in_world, &link.points_in_world);
  }
  return result;
}

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
  RefinementResult result =
      RefineEdges({input.views, input.curves, edges, input.points}, options, topology, context);
  AddContours(input.graph, &result.graph);
  return result;
}

}  // namespace limn
