// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/retriangulation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "limn/drawing/curve_smoothing.h"
#include "limn/model/footprint.h"
#include "limn/model/view_finder.h"
#include "limn/support/point_fit.h"
#include "limn/support/required_views.h"
#include "limn/util/map_items.h"
#include "limn/util/runs.h"

namespace limn {
namespace {

constexpr int kRounds = 3;
constexpr int kGaussNewtonSteps = 3;
// Standard deviation of the weak pull to the start of a step, px. It decides only what the edgels
// leave open.
constexpr double kPriorSigmaPx = 3;
// Vertices of the image curve to either side between which the direction of a curve is measured.
constexpr int kTangentReach = 2;

struct MovedCurve {
  SampleArrays samples;
  SupportLists support;
  std::vector<uint8_t> supported;  // per sample: by enough views
};

// Samples of a curve of the sketch per sample that is moved.
int StepOf(const Curve3D& curve, int vertices_per_sample) {
  return std::max(1, vertices_per_sample / curve.anchor.step);
}

// Moves every `step`-th sample of one curve of the sketch.
class CurveRetriangulation {
 public:
  CurveRetriangulation(const Curve3D& curve, int step, const TopologyInput& images,
                       const ViewFinder& finder, const DrawingOptions& options)
      : curve_(curve),
        step_(step),
        vertices_per_sample_(step * curve.anchor.step),
        images_(images),
        finder_(finder),
        options_(options) {}

  MovedCurve Run() {
    Take();
    for (int round = 0; round < kRounds; ++round) {
      for (int s = 0; s < samples_.NumSamples(); ++s) MoveToEdgels(s);
      samples_.position =
          SmoothCurve(samples_, curve_.closed, vertices_per_sample_ * options_.bending_sigma_px);
      UpdateTangents();
      UpdateSupport();
    }
    const std::vector<ViewId> near = finder_.NearAnyOf(samples_.position);
    std::vector<uint8_t> supported;
    for (int s = 0; s < samples_.NumSamples(); ++s) supported.push_back(IsSupported(s, near));
    return {std::move(samples_), std::move(support_), std::move(supported)};
  }

 private:
  void Take() {
    for (size_t s = 0; s < curve_.size(); s += step_) {
      samples_.position.push_back(curve_.points_in_world[s]);
      samples_.tangent.push_back(curve_.tangents_in_world[s]);
      support_.Append(curve_.support.Of(s));
    }
    samples_.information.resize(samples_.position.size());
    samples_.footprint.resize(samples_.position.size());
  }

  void MoveToEdgels(int s) {
    Eigen::Vector3d& position = samples_.position[s];
    std::vector<ViewId> views;
    std::vector<EdgelTarget> targets;
    for (const EdgelRef& ref : support_.Of(s)) {
      views.push_back(ref.view);
      targets.push_back(images_.TargetOf(ref));
    }
    const double footprint = MedianFootprint(position, views, images_.views);
    if (footprint > 0) samples_.footprint[s] = footprint;
    PointFit fit(position, samples_.tangent[s], kPriorSigmaPx * samples_.footprint[s],
                 options_.robust_residual_px);
    for (int step = 0; step < kGaussNewtonSteps; ++step) fit.StepTo(targets);
    position = fit.position();
    samples_.information[s] = fit.Information();
  }

  void UpdateTangents() {
    const int reach = std::max(1, kTangentReach / vertices_per_sample_);
    for (int s = 0; s < samples_.NumSamples(); ++s) {
      const Eigen::Vector3d tangent = DirectionAt(samples_.position, curve_.closed, s, reach);
      if (!tangent.isZero(0)) samples_.tangent[s] = tangent;
    }
  }

  // Chooses the best edgels at the new positions, in all views that support any sample of the
  // curve. The primary view keeps the sample's own edgel while it shows any within the gate.
  void UpdateSupport() {
    std::set<ViewId> views;
    for (const EdgelRef& ref : support_.edgels) views.insert(ref.view);
    support_ = {};
    for (int s = 0; s < samples_.NumSamples(); ++s) {
      std::vector<EdgelRef> of_sample;
      for (const ViewId v : views) {
        const auto ref =
            images_.EdgelAt(v, samples_.position[s], samples_.tangent[s], images_.gate);
        if (ref) of_sample.push_back(v == curve_.anchor.view ? OwnEdgel(s) : *ref);
      }
      support_.Append(of_sample);
    }
  }

  // The anchor's edgel that the sample was made from.
  EdgelRef OwnEdgel(int s) const {
    const auto support = curve_.support.Of(step_ * s);
    return *std::ranges::find(support, curve_.anchor.view, &EdgelRef::view);
  }

  // `near` holds the views that may contain the curve.
  bool IsSupported(int s, const std::vector<ViewId>& near) const {
    const auto num_containing = std::count_if(near.begin(), near.end(), [&](ViewId v) {
      return images_.views[v].Project(samples_.position[s]).has_value();
    });
    return static_cast<int>(support_.Of(s).size()) >=
           NumRequiredViews(static_cast<int>(num_containing), options_.supporting_views_share,
                            options_.min_supporting_views, options_.max_supporting_views);
  }

  const Curve3D& curve_;
  const int step_;
  const int vertices_per_sample_;
  const TopologyInput& images_;
  const ViewFinder& finder_;
  const DrawingOptions& options_;
  SampleArrays samples_;
  SupportLists support_;
};

// Appends the supported pieces of a curve that are long enough. Returns how many samples of the
// sketch are in the others.
int AppendPieces(const MovedCurve& curve, const CurveOrigin& whole, double min_length_px,
                 SampleSet* samples) {
  const int size = curve.samples.NumSamples();
  const auto is_supported = [&](int s) { return s >= 0 && s < size && curve.supported[s]; };
  // A single unsupported sample does not cut a curve.
  const auto is_usable = [&](int s) {
    return is_supported(s) || (is_supported(s - 1) && is_supported(s + 1));
  };
  int in_short_pieces = 0;
  ForEachRun(size, is_usable, [&](int begin, int end) {
    CurveOrigin origin = whole;
    origin.begin = whole.step * begin;
    origin.end = std::min(whole.step * end, whole.end);
    // A curve has two samples, whatever the shortest length is.
    if (end - begin < 2 || LengthPx(curve.samples, begin, end) < min_length_px) {
      in_short_pieces += origin.end - origin.begin;
      return;
    }
    origin.closed = whole.closed && end - begin == size;
    AppendCurve(curve.samples, curve.support, begin, end, origin, samples);
  });
  return in_short_pieces;
}

}  // namespace

SampleSet Retriangulate(const CurveSketch& sketch, int vertices_per_sample,
                        const TopologyInput& images, const DrawingOptions& options,
                        const RunContext& context, RetriangulationStats* stats) {
  SampleSet samples;
  size_t num_samples = 0;
  size_t num_edgels = 0;
  for (const Curve3D& curve : sketch.curves) {
    const int step = StepOf(curve, vertices_per_sample);
    stats->samples_in += static_cast<int64_t>(curve.size());
    num_samples += curve.size() / step + 1;
    num_edgels += curve.support.edgels.size() / step;
  }
  Reserve(num_samples, num_edgels, &samples);
  const ViewFinder finder(images.views);
  MapItemsInBlocks(
      context, "re-triangulation", sketch.curves.size(),
      [&](size_t c) {
        const Curve3D& curve = sketch.curves[c];
        const int step = StepOf(curve, vertices_per_sample);
        return CurveRetriangulation(curve, step, images, finder, options).Run();
      },
      [&](size_t c, const MovedCurve& moved) {
        const Curve3D& curve = sketch.curves[c];
        const CurveOrigin whole = {static_cast<int>(c),
                                   0,
                                   curve.anchor.view,
                                   curve.closed,
                                   StepOf(curve, vertices_per_sample),
                                   static_cast<int>(curve.size())};
        stats->piece_too_short += AppendPieces(moved, whole, options.min_piece_length_px, &samples);
      });
  stats->too_few_views = stats->samples_in - stats->piece_too_short;
  for (const CurveOrigin& origin : samples.origins) {
    stats->too_few_views -= origin.end - origin.begin;
  }
  return samples;
}

}  // namespace limn
