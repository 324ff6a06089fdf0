#include "limn/drawing/merging.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "limn/geometry/spatial_index.h"
#include "limn/support/edgel_residual.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Vertices farther than this from a sample are not compared with it, px.
constexpr double kSearchPx = 6;
// Shorter free runs between absorbed samples are noise in the overlap, px.
constexpr double kMinRunPx = 4;

class CurveMerger {
 public:
  CurveMerger(const SampleSet& samples, const CurveConsistency& network,
              const std::vector<View>& views, const DrawingOptions& options)
      : samples_(samples),
        network_(network),
        views_(views),
        options_(options),
        primitives_(samples, options, &graph_),
        index_(samples.position) {}

  DrawingGraph Run(const RunContext& context, MergingCounts* counts) {
    for (const int curve : LongestFirst()) {
      ThrowIfCancelled(context);
      MergeCurve(curve);
    }
    primitives_.ListSamples();
    *counts = primitives_.counts();
    return std::move(graph_);
  }

 private:
  std::vector<int> LongestFirst() const {
    std::vector<double> length;
    for (int c = 0; c < samples_.NumCurves(); ++c) length.push_back(ArcPx(samples_, c).back());
    std::vector<int> curves(length.size());
    std::iota(curves.begin(), curves.end(), 0);
    std::ranges::stable_sort(curves, std::greater(), [&](int c) { return length[c]; });
    return curves;
  }

  // Median over the supporting views of the distance, across the curve, between the reprojections.
  double ReprojectedDistancePx(int sample, int vertex) const {
    std::vector<double> distances;
    const Eigen::Vector3d& position = samples_.position[sample];
    for (const EdgelRef& ref : samples_.support.Of(sample)) {
      const View& view = views_[ref.view];
      const auto direction = ProjectedDirection(view, position, samples_.tangent[sample]);
      if (!direction) continue;
      const EdgelLine line(view.camera.Project(view.cam_from_world * position),
                           {std::sin(*direction), -std::cos(*direction)});
      const auto residual = ResidualToEdgel(view, line, samples_.position[vertex]);
      if (residual) distances.push_back(std::abs(residual->residual_px));
    }
    if (distances.empty()) return std::numeric_limits<double>::infinity();
    return Median(std::move(distances));
  }

  // A vertex that may stand for a sample. The nearest is the best.
  struct Candidate {
    double squared_distance = std::numeric_limits<double>::infinity();
    int vertex = -1;

    auto operator<=>(const Candidate&) const = default;
  };

  void Consider(int sample, int vertex, Candidate* best) const {
    const Candidate candidate = {
        (samples_.position[vertex] - samples_.position[sample]).squaredNorm(), vertex};
    if (candidate >= *best) return;
    const double angle = LineAngleBetween(samples_.tangent[vertex], samples_.tangent[sample]);
    if (angle <= options_.max_link_angle_deg * kDeg) *best = candidate;
  }

  // The existing vertex that stands for a sample; -1 if there is none.
  int FindHome(int curve, int k) const {
    const int s = samples_.curve_begin[curve] + k;
    Candidate best;
    for (const CurveOverlap& overlap : network_.overlaps[curve]) {
      const int home = overlap.partner[k] < 0 ? -1 : primitives_.HomeOf(overlap.partner[k]);
      if (home >= 0) Consider(s, home, &best);
    }
    if (Covers(s, best)) return best.vertex;
    best = {};
    std::vector<SpatialIndex::Neighbor> near;
    index_.FindWithin(samples_.position[s], kSearchPx * samples_.footprint[s], &near);
    for (const SpatialIndex::Neighbor& other : near) {
      if (primitives_.IsVertex(other.index) && MayMerge(curve, other.index)) {
        Consider(s, other.index, &best);
      }
    }
    return Covers(s, best) ? best.vertex : -1;
  }

  // The paper merges the curves of a cluster only.
  bool MayMerge(int curve, int vertex) const {
    return !options_.IsPaper() ||
           network_.cluster_of[curve] == network_.cluster_of[samples_.curve_of[vertex]];
  }

  bool Covers(int sample, const Candidate& best) const {
    const double footprint = samples_.footprint[sample];
    if (best.squared_distance > std::pow(kSearchPx * footprint, 2)) return false;
    // Along the curve a vertex stands for its neighborhood only.
    const double along = std::abs(
        samples_.tangent[sample].dot(samples_.position[best.vertex] - samples_.position[sample]));
    if (along > options_.junction_distance_px * footprint) return false;
    return ReprojectedDistancePx(sample, best.vertex) <= options_.merge_distance_px;
  }

  void MergeCurve(int curve) {
    const int first = samples_.curve_begin[curve];
    const int size = samples_.Size(curve);
    std::vector<int> home;
    for (int k = 0; k < size; ++k) home.push_back(FindHome(curve, k));
    const auto is_free = [&](int k) { return home[k] < 0; };
    for (int k = 0; k < size; ++k) primitives_.SetHome(first + k, home[k]);
    ForEachRun(size, is_free, [&](int begin, int end) {
      MergeRun(curve, begin, end, begin > 0 ? home[begin - 1] : -1, end < size ? home[end] : -1);
    });
  }

  // `before` and `after`: the vertices where the curve leaves and rejoins existing links; -1 if it
  // does not.
  void MergeRun(int curve, int begin, int end, int before, int after) {
    std::vector<int> run(end - begin);
    std::iota(run.begin(), run.end(), samples_.curve_begin[curve] + begin);
    MergingCounts& counts = primitives_.counts();
    if (before < 0 && after < 0) {
      ++counts.released;
      primitives_.AddRun(run, samples_.origins[curve].closed);
      return;
    }
    const double length_px = LengthPx(samples_, run.front(), run.back() + 1);
    const bool is_between = before >= 0 && after >= 0;
    if (length_px < kMinRunPx ||
        (is_between && length_px < options_.min_branch_length_px && Near(before, after))) {
      const size_t to_before = after < 0 ? run.size() : before < 0 ? 0 : (run.size() + 1) / 2;
      for (size_t i = 0; i < run.size(); ++i) {
        primitives_.SetHome(run[i], i < to_before ? before : after);
      }
      return;
    }
    if (is_between) {
      const bool same_link = primitives_.LinkOf(before) == primitives_.LinkOf(after);
      int64_t& count = same_link ? counts.rejoined : counts.bridged;
      ++count;
    }
    primitives_.AddRun(run, false);
    if (before >= 0) primitives_.Attach(run.front(), before);
    if (after >= 0) primitives_.Attach(run.back(), after);
  }

  bool Near(int vertex_a, int vertex_b) const {
    const int a = primitives_.HomeOf(vertex_a);
    const int b = primitives_.HomeOf(vertex_b);
    return (samples_.position[a] - samples_.position[b]).norm() <=
           options_.min_branch_length_px * samples_.footprint[a];
  }

  const SampleSet& samples_;
  const CurveConsistency& network_;
  const std::vector<View>& views_;
  const DrawingOptions& options_;
  DrawingGraph graph_;
  MergingPrimitives primitives_;
  SpatialIndex index_;  // of the samples; only some are vertices
};

}  // namespace

DrawingGraph MergeCurves(const SampleSet& samples, const CurveConsistency& network,
                         const std::vector<View>& views, const DrawingOptions& options,
                         const RunContext& context, MergingCounts* counts) {
  return CurveMerger(samples, network, views, options).Run(context, counts);
}

}  // namespace limn
