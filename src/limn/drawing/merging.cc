#include "limn/drawing/merging.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/drawing/vertex_grid.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

// Vertices further than this from a sample are not compared with it, px.
constexpr double kSearchPx = 6;
// Uncovered runs shorter than this between covered ones are noise in the overlap, px.
constexpr double kMinRunPx = 4;

class CurveMerger {
 public:
  CurveMerger(const SampleSet& samples, const CurveConsistency& network,
              const std::vector<View>& views, const DrawingOptions& options)
      : samples_(samples),
        network_(network),
        views_(views),
        options_(options),
        builder_(samples, options),
        grid_(kSearchPx),
        home_(samples.NumSamples(), -1),
        min_cosine_(std::cos(options.max_link_angle_deg * M_PI / 180)) {}

  MergedCurves Run(const RunContext& context) {
    for (const int curve : LongestFirst()) {
      ThrowIfCancelled(context);
      MergeCurve(curve);
    }
    MergedCurves merged;
    for (int& vertex : home_) {
      if (vertex >= 0) vertex = builder_.Resolve(vertex);
    }
    merged.links = builder_.links();
    for (int v = 0; v < builder_.num_vertices(); ++v) {
      merged.vertex_sample.push_back(builder_.SampleOf(v));
    }
    merged.home = std::move(home_);
    merged.num_nodes = builder_.num_nodes();
    merged.counts = builder_.counts();
    return merged;
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
    const auto middle = distances.begin() + distances.size() / 2;
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
  }

  struct Best {
    int vertex = -1;
    double squared = std::numeric_limits<double>::infinity();
  };

  void Consider(int sample, int vertex, Best* best) const {
    vertex = builder_.Resolve(vertex);
    const int other = builder_.SampleOf(vertex);
    const double squared = (samples_.position[other] - samples_.position[sample]).squaredNorm();
    if (squared > best->squared || (squared == best->squared && vertex >= best->vertex)) return;
    if (std::abs(samples_.tangent[other].dot(samples_.tangent[sample])) < min_cosine_) return;
    *best = {vertex, squared};
  }

  // The vertex that stands for a sample already, -1 if it is new.
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
    const int other = builder_.SampleOf(best.vertex);
    const double footprint = samples_.footprint[sample];
    if (best.squared > std::pow(kSearchPx * footprint, 2)) return false;
    // Along the curve a vertex speaks for its neighbourhood only.
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
      ++builder_.counts().released;
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

  int AddRun(int curve, int begin, int end, bool closed) {
    std::vector<int> run;
    for (int k = begin; k < end; ++k) run.push_back(samples_.curve_begin[curve] + k);
    const int first_vertex = builder_.num_vertices();
    const int link = builder_.AddLink(run, closed);
    for (size_t i = 0; i < run.size(); ++i) {
      const int vertex = first_vertex + static_cast<int>(i);
      home_[run[i]] = vertex;
      grid_.Add(vertex, samples_.position[run[i]], samples_.footprint[run[i]]);
    }
    return link;
  }

  // `before` and `after`: the vertices at which the curve comes from and goes on along existing
  // links.
  void MergeRun(int curve, int begin, int end, int before, int after) {
    double length_px = 0;
    for (int k = begin + 1; k < end; ++k) {
      const int s = samples_.curve_begin[curve] + k;
      length_px += (samples_.position[s] - samples_.position[s - 1]).norm() / samples_.footprint[s];
    }
    if (before < 0 && after < 0) {
      ++builder_.counts().released;
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
        before >= 0 && after >= 0 && builder_.LinkOf(before) == builder_.LinkOf(after);
    const int64_t rejoined_before = builder_.counts().rejoined;
    int link = AddRun(curve, begin, end, false);
    const int first = home_[samples_.curve_begin[curve] + begin];
    const int last = home_[samples_.curve_begin[curve] + end - 1];
    if (before >= 0) builder_.Attach(link, EndOf(first, link), before);
    if (after >= 0) {
      link = builder_.LinkOf(last);
      const int last_end = EndOf(last, link);
      if (last_end >= 0) builder_.Attach(link, last_end, after);
    }
    if (before < 0 || after < 0) return;
    if (!same_link) ++builder_.counts().bridged;
    // A run that closed a loop has been counted.
    if (same_link && builder_.counts().rejoined == rejoined_before) ++builder_.counts().rejoined;
  }

  bool Near(int vertex_a, int vertex_b) const {
    const int a = builder_.SampleOf(builder_.Resolve(vertex_a));
    const int b = builder_.SampleOf(builder_.Resolve(vertex_b));
    return (samples_.position[a] - samples_.position[b]).norm() <=
           options_.min_branch_length_px * samples_.footprint[a];
  }

  // Which end of the link a vertex is, -1 if neither.
  int EndOf(int vertex, int link) const {
    const auto& vertices = builder_.links()[link].vertices;
    if (vertices.back() == vertex && vertices.size() > 1) return 1;
    if (vertices.front() == vertex) return 0;
    return -1;
  }

  const SampleSet& samples_;
  const CurveConsistency& network_;
  const std::vector<View>& views_;
  const DrawingOptions& options_;
  LinkBuilder builder_;
  VertexGrid grid_;
  std::vector<int> home_;
  double min_cosine_;
};

}  // namespace

MergedCurves MergeCurves(const SampleSet& samples, const CurveConsistency& network,
                         const std::vector<View>& views, const DrawingOptions& options,
                         const RunContext& context) {
  return CurveMerger(samples, network, views, options).Run(context);
}

}  // namespace limn
