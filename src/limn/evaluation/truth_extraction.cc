// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/truth_extraction.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <optional>

#include "limn/evaluation/curve_samples.h"
#include "limn/evaluation/kept_runs.h"
#include "limn/model/footprint.h"
#include "limn/support/edgel_index.h"
#include "limn/support/segment_support.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "limn/visibility/render_depth.h"
#include "limn/visibility/splat_depth.h"

namespace limn {
namespace {

// Depth pixels per pixel of a mesh's depth image; of a cloud's one is enough.
constexpr double kDepthScale = 2;
// Length of curve along which edgels must run.
constexpr double kWindowPx = 9;
// Places of a curve that tell its smallest footprint, and how far below the typical one that
// counts.
constexpr int kNumFootprints = 8;
constexpr double kSmallestShare = 1.0 / 16;
constexpr double kSlantOfSplats = 3;

SupportGate GateOf(const TruthOptions& options) {
  return {options.max_distance_px, 1.0, options.max_angle_deg * kDeg};
}

void Check(const TruthOptions& options, size_t num_views) {
  options.Check();
  CheckOption(options.min_views <= static_cast<int>(num_views), "min_views", options.min_views,
              "at most the number of views");
}

// How a view is asked about the samples.
struct Inquiry {
  size_t num_samples = 0;
  std::function<Eigen::Vector3d(int sample)> position;
  std::function<DepthImage(const View&)> depth;
  double tolerance_px = 0;
  // Whether there are edges at a visible sample.
  std::function<bool(const View&, const EdgelIndex&, int sample)> has_edges;
};

// Per sample, in how many views it is visible and by how many shown.
struct ViewCounts {
  std::vector<int> visible;
  std::vector<int> shown;
};

void AddOne(int* count) { std::atomic_ref<int>(*count).fetch_add(1, std::memory_order_relaxed); }

// Views add up in any order: counts are the same whatever the threads.
ViewCounts CountViews(const Inquiry& inquiry, const std::vector<View>& views,
                      const std::vector<ImageCurves>& image_curves, const TruthOptions& options,
                      const RunContext& context) {
  ViewCounts counts;
  counts.visible.assign(inquiry.num_samples, 0);
  counts.shown.assign(inquiry.num_samples, 0);
  ParallelFor(context, "visibility of the truth", views.size(), [&](size_t v) {
    const DepthImage depth = inquiry.depth(views[v]);
    std::optional<EdgelIndex> edgels;
    if (options.require_edges) {
      edgels.emplace(image_curves[v].edge_map, LinkedEdgels(image_curves[v]));
    }
    for (size_t i = 0; i < inquiry.num_samples; ++i) {
      const int sample = static_cast<int>(i);
      if (!IsVisible(views[v], depth, inquiry.position(sample), inquiry.tolerance_px)) continue;
      AddOne(&counts.visible[i]);
      if (!edgels || inquiry.has_edges(views[v], *edgels, sample)) AddOne(&counts.shown[i]);
    }
  });
  return counts;
}

// The spacing of samples: a pixel where the curve is nearest to its views, but not far below its
// typical pixel.
double StepOf(const std::vector<View>& views, const Polyline3d& curve) {
  const double typical = FootprintOfCurve(views, curve);
  const double length = Length(curve);
  if (!(length > 0)) return typical;
  double smallest = typical;
  for (const Eigen::Vector3d& point : ResampleUniform(curve, length / kNumFootprints)) {
    smallest = std::min(smallest, PixelFootprint(views, point));
  }
  return std::max(smallest, kSmallestShare * typical);
}

// Per curve its first sample; one more at the end.
std::vector<int> FirstSamples(const CurveSamples& samples, size_t num_curves) {
  std::vector<int> first(num_curves + 1, 0);
  for (int i = 0; i < samples.size(); ++i) ++first[samples.CurveOf(i) + 1];
  for (size_t c = 0; c < num_curves; ++c) first[c + 1] += first[c];
  return first;
}

// Edgels run along the curve around a sample.
bool EdgesAlong(const View& view, const EdgelIndex& edgels, const CurveSamples& samples,
                const std::vector<int>& first_sample, int sample, const SupportGate& gate) {
  const int curve = samples.CurveOf(sample);
  const auto footprint = FootprintIn(view, samples.Position(sample));
  if (!footprint || !(samples.Weight(sample) > 0)) return false;
  const double half = std::ceil(0.5 * kWindowPx * *footprint / samples.Weight(sample));
  const auto first = static_cast<int>(std::max<double>(first_sample[curve], sample - half));
  const auto last = static_cast<int>(std::min<double>(first_sample[curve + 1] - 1, sample + half));
  return ShowsSegment(view, samples.Cell(first)[0], samples.Cell(last)[2], edgels, gate);
}

// A run of cells of a curve of `num_cells`; may go round a closed one.
Polyline3d CutRun(const Polyline3d& curve, const CellRun& run, int num_cells) {
  const double length = Length(curve);
  const double cell = length / num_cells;
  const double from = run.first * cell;
  if (run.second <= num_cells) {
    return CutPolyline(curve, from, run.second == num_cells ? length : run.second * cell);
  }
  Polyline3d part = CutPolyline(curve, from, length);
  const Polyline3d rest = CutPolyline(curve, 0, (run.second - num_cells) * cell);
  part.insert(part.end(), rest.begin() + 1, rest.end());
  return part;
}

std::vector<Polyline3d> KeptParts(const Polyline3d& curve, const std::vector<uint8_t>& flags,
                                  const std::vector<View>& views, const TruthOptions& options) {
  const double length = Length(curve);
  if (!(length > 0)) return {};
  const int num_cells = static_cast<int>(flags.size());
  const double cells_per_px = FootprintOfCurve(views, curve) * num_cells / length;
  const bool closed = curve.size() > 3 && curve.front() == curve.back();
  std::vector<Polyline3d> parts;
  for (const CellRun& run : KeptRuns(flags, closed, options.max_gap_px * cells_per_px,
                                     options.min_length_px * cells_per_px)) {
    parts.push_back(CutRun(curve, run, num_cells));
  }
  return parts;
}

// The mean over views of the share of the image that is near an edgel.
double ShareNearEdgels(const std::vector<View>& views, const std::vector<ImageCurves>& image_curves,
                       double max_distance_px, const RunContext& context) {
  constexpr double kStepPx = 3;
  std::vector<double> shares(views.size(), 0);
  ParallelFor(context, "share near edgels", views.size(), [&](size_t v) {
    const EdgelIndex edgels(image_curves[v].edge_map, LinkedEdgels(image_curves[v]));
    const ImageRegion& region = views[v].region;
    int asked = 0;
    int near = 0;
    for (double y = region.min_px.y(); y <= region.max_px.y(); y += kStepPx) {
      for (double x = region.min_px.x(); x <= region.max_px.x(); x += kStepPx) {
        if (!region.Contains({x, y})) continue;
        ++asked;
        near += edgels.AnyWithin({x, y}, max_distance_px);
      }
    }
    if (asked > 0) shares[v] = static_cast<double>(near) / asked;
  });
  double sum = 0;
  for (const double share : shares) sum += share;
  return sum / static_cast<double>(views.size());
}

double WeightOfAtLeast(const std::vector<int>& counts, int least,
                       const std::function<double(int)>& weight) {
  double sum = 0;
  for (size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] >= least) sum += weight(static_cast<int>(i));
  }
  return sum;
}

TruthAccount AccountOf(const ViewCounts& counts, int min_views,
                       const std::function<double(int)>& weight) {
  TruthAccount account;
  account.found = WeightOfAtLeast(counts.visible, 0, weight);
  account.visible = WeightOfAtLeast(counts.visible, min_views, weight);
  account.shown = WeightOfAtLeast(counts.shown, min_views, weight);
  return account;
}

}  // namespace

void TruthOptions::Check() const {
  LIMN_CHECK_RANGE(min_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(max_distance_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_angle_deg, > 0, <= 180);
  LIMN_CHECK_RANGE(occlusion_px, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(max_gap_px, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(min_length_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(splat_px, > 0, <= 100);
  LIMN_CHECK_RANGE(max_chance, > 0, <= 1);
}

ExtractedTruth ExtractTruthCurves(const std::vector<Polyline3d>& curves, const TriangleMesh& mesh,
                                  const std::vector<View>& views,
                                  const std::vector<ImageCurves>& image_curves,
                                  const TruthOptions& options, const RunContext& context) {
  Check(options, views.size());
  CurveSet set;
  set.polylines = curves;
  const CurveSamples samples(set, [&](const Polyline3d& curve) { return StepOf(views, curve); });
  const std::vector<int> first_sample = FirstSamples(samples, curves.size());
  const SupportGate gate = GateOf(options);
  Inquiry inquiry;
  inquiry.num_samples = static_cast<size_t>(samples.size());
  inquiry.position = [&](int sample) { return samples.Position(sample); };
  inquiry.depth = [&](const View& view) { return RenderDepth(mesh, view, kDepthScale); };
  inquiry.tolerance_px = options.occlusion_px;
  inquiry.has_edges = [&](const View& view, const EdgelIndex& edgels, int sample) {
    return EdgesAlong(view, edgels, samples, first_sample, sample, gate);
  };
  const ViewCounts counts = CountViews(inquiry, views, image_curves, options, context);

  ExtractedTruth truth;
  truth.account =
      AccountOf(counts, options.min_views, [&](int sample) { return samples.Weight(sample); });
  for (size_t c = 0; c < curves.size(); ++c) {
    std::vector<uint8_t> flags;
    for (int i = first_sample[c]; i < first_sample[c + 1]; ++i) {
      flags.push_back(counts.shown[i] >= options.min_views);
    }
    for (Polyline3d& part : KeptParts(curves[c], flags, views, options)) {
      truth.account.kept += Length(part);
      truth.set.polylines.push_back(std::move(part));
    }
  }
  return truth;
}

ExtractedTruth ExtractTruthPoints(const std::vector<Eigen::Vector3d>& cloud,
                                  const std::vector<View>& views,
                                  const std::vector<ImageCurves>& image_curves,
                                  const TruthOptions& options, const RunContext& context) {
  Check(options, views.size());
  Inquiry inquiry;
  inquiry.num_samples = cloud.size();
  inquiry.position = [&](int sample) { return cloud[sample]; };
  inquiry.depth = [&](const View& view) { return SplatDepth(cloud, view, 1, options.splat_px); };
  inquiry.tolerance_px = options.occlusion_px + kSlantOfSplats * options.splat_px;
  inquiry.has_edges = [&](const View& view, const EdgelIndex& edgels, int sample) {
    const auto pixel = view.Project(cloud[sample]);
    return pixel && edgels.AnyWithin(*pixel, options.max_distance_px);
  };
  const ViewCounts counts = CountViews(inquiry, views, image_curves, options, context);

  ExtractedTruth truth;
  truth.account = AccountOf(counts, options.min_views, [](int) { return 1.0; });
  const double share = options.require_edges
                           ? ShareNearEdgels(views, image_curves, options.max_distance_px, context)
                           : 0;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const bool by_chance =
        LogChance(counts.shown[i], counts.visible[i], share) > std::log(options.max_chance);
    if (counts.shown[i] >= options.min_views && !by_chance) truth.set.points.push_back(cloud[i]);
  }
  truth.account.kept = static_cast<double>(truth.set.points.size());
  return truth;
}

}  // namespace limn
