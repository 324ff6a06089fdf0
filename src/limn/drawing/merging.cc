#include "limn/drawing/merging.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "limn/drawing/vertex_grid.h"
#include "limn/support/edgel_residual.h"
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
        primitives_(samples, options, &merged_.graph),
        grid_(kSearchPx),
        home_(samples.NumSamples(), -1),
        min_cosine_(std::cos(options.max_link_angle_deg * M_PI / 180)) {}

  MergedCurves Run(const RunContext& context) {
    for (const int curve : LongestFirst()) {
      ThrowIfCancelled(context);
      MergeCurve(curve);
    }
    primitives_.MergeSamples(home_);
    merged_.counts = primitives_.counts();
    return std::move(merged_);
  }

 private:
  std::vector<int> LongestFirst() const {
    std::vector<std::pair<double, int>> order;
    for (int c = 0; c < samples_.NumCurves(); ++c) {
      order.push_back({-ArcPx(samples_, c).back(), c});
    }
    std::sort(order.begin(), order.end());
    std::vector<int> curves;
    for (const auto& [length, curve] : order) curves.push_back(curve);
    return curves;
  }

  // Median over the supporting views of the distance, across the curve, between the reprojections.
  double ReprojectedDistancePx(int sample, int vertex_sample) const {
    std::vector<double> distances;
    const Eigen::Vector3d& position = samples_.position[sample];
    for (const EdgelRef& ref : samples_.support.Of(sample)) {
      const View& view = views_[ref.view];
      const Eigen::Vector3d a = view.cam_from_world * position;
      const Eigen::Vector3d b = view.cam_from_world * samples_.position[vertex_sample];
      const auto direction = ProjectedDirection(view, position, samples_.tangent[sample]);
      if (!(a.z() > 0 && b.z() > 0) || !direction) continue;
      const Eigen::Vector2d offset = view.camera.Project(b) - view.camera.Project(a);
      distances.push_back(
          std::abs(std::sin(*direction) * offset.x() - std::cos(*direction) * offset.y()));
    }
    if (distances.empty()) return std::numeric_limits<double>::infinity();
    return Median(std::move(distances));
  }

  struct Best {
    int vertex = -1;
    double squared = std::numeric_limits<double>::infinity();
  };

  void Consider(int sample, int vertex, Best* best) const {
    vertex = primitives_.Resolve(vertex);
    const double squared = (samples_.position[vertex] - samples_.position[sample]).squaredNorm();
    if (squared > best->squared || (squared == best->squared && vertex >= best->vertex)) return;
    if (std::abs(samples_.tangent[vertex].dot(samples_.tangent[sample])) < min_cosine_) return;
    *best = {vertex, squared};
  }

  // The existing vertex that stands for a sample; -1 if there is none.
  int FindHome(int curve, int k) const {
    const int s = samples_.curve_begin[curve] + k;
    Best best;
    for (const CurveOverlap& overlap : network_.overlaps[curve]) {
      const int partner = overlap.partner[k];
      if (partner >= 0 && home_[partner] >= 0) Consider(s, home_[partner], &best);
    }
    if (best.vertex >= 0 && Covers(s, best)) return best.vertex;
    best = {};
    grid_.ForEachNear(samples_.position[s], samples_.footprint[s],
                      [&](int vertex) { Consider(s, vertex, &best); });
    return best.vertex >= 0 && Covers(s, best) ? best.vertex : -1;
  }

  bool Covers(int sample, const Best& best) const {
    const int other = best.vertex;
    const double footprint = samples_.footprint[sample];
    if (best.squared > std::pow(kSearchPx * footprint, 2)) return false;
    // Along the curve a vertex stands for its neighborhood only.
    const double along = std::abs(
        samples_.tangent[sample].dot(samples_.position[other] - samples_.position[sample]));
    if (along > options_.junction_distance_px * footprint) return false;
    return ReprojectedDistancePx(sample, other) <= options_.merge_distance_px;
  }

  void MergeCurve(int curve) {
    const int size = samples_.Size(curve);
    std::vector<int> home(size);
    for (int k = 0; k < size; ++k) home[k] = FindHome(curve, k);
    AbsorbShortRuns(ArcPx(samples_, curve), &home);
    for (int k = 0; k < size; ++k) {
      if (home[k] >= 0) home_[samples_.curve_begin[curve] + k] = home[k];
    }
    const bool whole = samples_.origins[curve].closed &&
                       std::all_of(home.begin(), home.end(), [](int h) { return h < 0; });
    if (whole) {
      ++primitives_.counts().released;
      AddRun(curve, 0, size, true);
      return;
    }
    for (int begin = 0; begin < size;) {
      if (home[begin] >= 0) {
        ++begin;
        continue;
      }
      int end = begin;
      while (end < size && home[end] < 0) ++end;
      const int before = begin > 0 ? home[begin - 1] : -1;
      const int after = end < size ? home[end] : -1;
      MergeRun(curve, begin, end, before, after);
      begin = end;
    }
  }

  // A short stretch without a home between two that have one is noise in the overlap.
  void AbsorbShortRuns(const std::vector<double>& arc, std::vector<int>* home) const {
    int last = -1;
    for (int k = 0; k < static_cast<int>(home->size()); ++k) {
      if ((*home)[k] < 0) continue;
      if (last >= 0 && k > last + 1 && arc[k] - arc[last] <= kMinRunPx) {
        for (int i = last + 1; i < k; ++i) (*home)[i] = (*home)[i - last <= k - i ? last : k];
      }
      last = k;
    }
  }

  LinkId AddRun(int curve, int begin, int end, bool closed) {
    std::vector<int> run(end - begin);
    std::iota(run.begin(), run.end(), samples_.curve_begin[curve] + begin);
    for (const int sample : run) {
      home_[sample] = sample;
      grid_.Add(sample, samples_.position[sample], samples_.footprint[sample]);
    }
    return primitives_.AddRun(run, closed);
  }

  // `before` and `after`: the vertices where the curve leaves and rejoins existing links; -1 if it
  // does not.
  void MergeRun(int curve, int begin, int end, int before, int after) {
    double length_px = 0;
    for (int k = begin + 1; k < end; ++k) {
      const int s = samples_.curve_begin[curve] + k;
      length_px += (samples_.position[s] - samples_.position[s - 1]).norm() / samples_.footprint[s];
    }
    if (before < 0 && after < 0) {
      ++primitives_.counts().released;
      AddRun(curve, begin, end, false);
      return;
    }
    if (length_px < kMinRunPx || (before >= 0 && after >= 0 && Near(before, after) &&
                                  length_px < options_.min_branch_length_px)) {
      for (int k = begin; k < end; ++k) {
        home_[samples_.curve_begin[curve] + k] = before >= 0 ? before : after;
      }
      return;
    }
    const bool same_link =
        before >= 0 && after >= 0 && primitives_.LinkOf(before) == primitives_.LinkOf(after);
    MergingCounts& counts = primitives_.counts();
    const int64_t rejoined_before = counts.rejoined;
    const LinkId link = AddRun(curve, begin, end, false);
    if (before >= 0) primitives_.Attach(link, 0, before);
    const int last = samples_.curve_begin[curve] + end - 1;
    const int last_end = after < 0 ? -1 : primitives_.EndOf(last);
    if (last_end >= 0) primitives_.Attach(primitives_.LinkOf(last), last_end, after);
    if (before < 0 || after < 0) return;
    counts.bridged += !same_link;
    // Attach counts a run that closes a loop itself.
    counts.rejoined += same_link && counts.rejoined == rejoined_before;
  }

  bool Near(int vertex_a, int vertex_b) const {
    const int a = primitives_.Resolve(vertex_a);
    const int b = primitives_.Resolve(vertex_b);
    return (samples_.position[a] - samples_.position[b]).norm() <=
           options_.min_branch_length_px * samples_.footprint[a];
  }

  const SampleSet& samples_;
  const CurveConsistency& network_;
  const std::vector<View>& views_;
  const DrawingOptions& options_;
  MergedCurves merged_;
  MergingPrimitives primitives_;
  VertexGrid grid_;
  std::vector<int> home_;  // per sample: the vertex it is merged into, -1 if none
  double min_cosine_;
};

}  // namespace

MergedCurves MergeCurves(const SampleSet& samples, const CurveConsistency& network,
                         const std::vector<View>& views, const DrawingOptions& options,
                         const RunContext& context) {
  return CurveMerger(samples, network, views, options).Run(context);
}

}  // namespace limn
