#include "limn/refinement/refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "limn/refinement/curve_fit.h"
#include "limn/refinement/fitted_vertices.h"
#include "limn/refinement/gauge.h"
#include "limn/refinement/pose_fit.h"
#include "limn/refinement/variance_factors.h"
#include "limn/topology/covered_links.h"
#include "limn/topology/edit_topology.h"
#include "limn/util/median.h"

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
int NumShown(const LinkMatches& matches) {
  return static_cast<int>(std::count_if(matches.begin(), matches.end(),
                                        [](const LinkSample& s) { return !s.pulls.empty(); }));
}

std::vector<uint8_t> FindFrozen(const std::vector<LinkMatches>& matches) {
  std::vector<uint8_t> frozen;
  for (const LinkMatches& of_link : matches) {
    const int shown = NumShown(of_link);
    frozen.push_back(shown == 0 || shown < kMinShownShare * static_cast<double>(of_link.size()));
  }
  return frozen;
}

void SetSupport(const LinkMatches& matches, DrawingLink* link) {
  std::map<ViewId, int> samples;
  std::vector<double> residuals;
  for (const LinkSample& sample : matches) {
    for (const EdgelPull& pull : sample.pulls) {
      ++samples[pull.ref.view];
      residuals.push_back(std::abs(pull.residual_px));
    }
  }
  const int needed = std::min(kMinSupportedSamples, (NumShown(matches) + 1) / 2);
  link->supporting_views.clear();
  for (const auto& [view, count] : samples) {
    if (count >= needed) link->supporting_views.push_back(view);
  }
  link->residual_px = Median(std::move(residuals));
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
    const int rounds_before = options_.num_rounds / 2;
    for (int round = 0; round < rounds_before; ++round) Fit(nullptr);
    if (rounds_before > 0) ChangeTopology();
    for (int round = rounds_before; round + 1 < options_.num_rounds; ++round) Fit(nullptr);
    Fit(&covariances_);
    Match(1);
    ScaleCovariances();
    SetGeometry();
    for (size_t l = 0; l < graph_.links.size(); ++l) {
      if (!frozen_[l]) SetSupport(matches_[l], &graph_.links[l]);
    }
    RemoveCovered(FindUncoveredLinks(topology_, WithVertices()));
    result.summary = Summary();
    result.graph = std::move(graph_);
    return result;
  }

 private:
  // Sets up the unknowns for the current graph.
  void TakeGraph() {
    control_ = MakeControlGraph(graph_, views_, options_.control_spacing_px);
    covariances_.assign(control_.position.size(), std::nullopt);
  }

  // `reach`: multiple of max_distance_px.
  TopologyInput Images(double reach) const {
    return {views_,
            input_.curves,
            edgels_,
            {reach * options_.max_distance_px, 1.0, options_.max_angle_deg * M_PI / 180}};
  }

  void ChangeTopology() {
    SetGeometry();
    DrawingGraph dense = WithVertices();
    const std::vector<uint8_t> keep = FindUncoveredLinks(topology_, dense);
    for (size_t l = 0; l < graph_.links.size(); ++l) {
      if (!frozen_[l]) graph_.links[l] = std::move(dense.links[l]);
    }
    RemoveCovered(keep);
    repairs_ = RepairTopology(Images(1), topology_, &graph_);
    for (DrawingLink& link : graph_.links) link.vertices.clear();
    TakeGraph();
  }

  DrawingGraph WithVertices() const {
    DrawingGraph graph = graph_;
    for (size_t l = 0; l < graph.links.size(); ++l) {
      GiveVertices(views_, frozen_[l] ? LinkMatches() : matches_[l], &graph.links[l]);
    }
    return graph;
  }

  void RemoveCovered(const std::vector<uint8_t>& keep) {
    RemoveLinks(keep, &graph_);
    std::vector<uint8_t> frozen;
    for (size_t l = 0; l < keep.size(); ++l) {
      if (keep[l]) frozen.push_back(frozen_[l]);
    }
    num_covered_ += static_cast<int64_t>(frozen_.size() - frozen.size());
    frozen_ = std::move(frozen);
  }

  void Match(double reach) { matches_ = MatchEdgels(Images(reach), control_, options_, context_); }

  RefinedCameras RefineCameras() {
    static const std::vector<ScenePoint> none;
    const std::vector<ScenePoint>& points = input_.points ? *input_.points : none;
    RefinedCameras refined;
    for (const ScenePoint& point : points) refined.points.push_back(point.position_in_world);
    CameraCorrections corrections = NoCorrections(input_.views);
    for (const double reach : kPoseRoundReach) {
      Match(reach);
      RefinementOptions options = options_;
      options.robust_residual_px *= reach;
      const bool found =
          FitPoses({input_.views, input_.curves, matches_, FindFrozen(matches_)}, points, options,
                   context_, &corrections, &control_, &refined.points);
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
    const Eigen::Affine3d back =
        GivenFromRefined(input_.views, views_, MiddleOfScene(given, *points));
    views_ = Moved(views_, back);
    for (std::vector<Eigen::Vector3d>* of : {&control_.position, points}) {
      for (Eigen::Vector3d& point : *of) point = back * point;
    }
  }

  // Medians, because some points of a sparse model are far away.
  Eigen::Vector3d MiddleOfScene(const std::vector<ScenePoint>& given,
                                const std::vector<Eigen::Vector3d>& points) const {
    std::vector<Eigen::Vector3d> known = control_.position;
    for (size_t p = 0; p < points.size(); ++p) {
      if (given[p].pixels.size() >= 2) known.push_back(points[p]);
    }
    Eigen::Vector3d middle;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const Eigen::Vector3d& point : known) values.push_back(point[axis]);
      middle[axis] = Median(std::move(values));
    }
    return middle;
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

  FitInput ToFit() const { return {views_, input_.curves, matches_, frozen_}; }

  void Fit(Covariances* covariances) {
    Match(1);
    frozen_ = FindFrozen(matches_);
    FitCurves(ToFit(), options_, context_, &control_, covariances);
  }

  void ScaleCovariances() {
    const std::vector<double> factors = VarianceFactors(ToFit(), options_, control_);
    for (size_t p = 0; p < factors.size(); ++p) {
      if (covariances_[p]) *covariances_[p] *= factors[p];
    }
  }

  // Root of the mean of the two variances across the curve; infinite before there are any.
  double Sigma(const ControlLink& link, int k) const {
    const auto& covariance = covariances_[link.points[k]];
    if (!covariance) return std::numeric_limits<double>::infinity();
    const Eigen::Vector3d tangent = Chord(control_, link, k - 1, k + 1).normalized();
    const double along = tangent.dot(*covariance * tangent);
    return std::sqrt(std::max(0.0, 0.5 * (covariance->trace() - along)));
  }

  // Unfitted links have no edgel within the gate, so their sigma is at least max_distance_px.
  double LeastSigmaUnfitted(const ControlLink& link) const {
    double largest = 0;
    for (const int id : link.points) largest = std::max(largest, control_.footprint[id]);
    return options_.max_distance_px * largest;
  }

  // Fitted links get their control points; the others keep their points and follow their nodes.
  void SetGeometry() {
    for (size_t n = 0; n < graph_.nodes.size(); ++n) {
      graph_.nodes[n].position_in_world = control_.position[n];
    }
    for (size_t l = 0; l < graph_.links.size(); ++l) {
      DrawingLink& link = graph_.links[l];
      if (frozen_[l]) {
        FollowEnds(control_.position[link.node0], control_.position[link.node1],
                   &link.points_in_world);
        const double least = LeastSigmaUnfitted(control_.links[l]);
        for (double& sigma : link.sigma) sigma = std::max(sigma, least);
        continue;
      }
      const ControlLink& fitted = control_.links[l];
      link.points_in_world.clear();
      link.sigma.clear();
      for (int k = 0; k <= fitted.NumSegments(); ++k) {
        link.points_in_world.push_back(control_.position[fitted.points[k]]);
        link.sigma.push_back(Sigma(fitted, k));
      }
    }
  }

  StageSummary Summary() const {
    const auto num_frozen = std::count(frozen_.begin(), frozen_.end(), uint8_t{1});
    StageSummary summary;
    summary.stage = "refinement";
    summary.in = {{"links", std::ssize(input_.graph.links)}};
    summary.kept = {{"links", std::ssize(graph_.links)},
                    {"links not fitted: too few views", num_frozen},
                    {"control points", std::ssize(control_.position)},
                    {"ends cut back from other links", repairs_.trimmed},
                    {"ends joined", repairs_.meetings.joined},
                    {"ends taken to nodes", repairs_.meetings.to_nodes},
                    {"ends taken to links", repairs_.meetings.to_links},
                    {"links cut at corners", repairs_.corners}};
    summary.dropped = {{"links: others run along them", num_covered_}};
    if (num_failed_pose_rounds_ > 0) {
      summary.warnings.push_back(std::to_string(num_failed_pose_rounds_) + " of " +
                                 std::to_string(std::size(kPoseRoundReach)) +
                                 " rounds of the cameras found no solution and changed nothing");
    }
    return summary;
  }

  const RefinementInput& input_;
  const RefinementOptions& options_;
  const TopologyOptions& topology_;
  const RunContext& context_;
  std::vector<View> views_;  // with refined cameras
  DrawingGraph graph_;
  std::vector<std::unique_ptr<ViewEdgels>> edgels_;
  ControlGraph control_;
  std::vector<LinkMatches> matches_;
  std::vector<uint8_t> frozen_;
  Covariances covariances_;
  RepairCounts repairs_;
  int64_t num_covered_ = 0;
  int num_failed_pose_rounds_ = 0;
};

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
  return Refiner(input, options, topology, context).Run();
}

}  // namespace limn
