#include "limn/drawing/retriangulation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "limn/drawing/curve_smoothing.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/model/footprint.h"
#include "limn/model/view_finder.h"
#include "limn/support/edgel_residual.h"
#include "limn/support/required_views.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

constexpr int kRounds = 3;
constexpr int kGaussNewtonSteps = 3;
// Standard deviation of the weak pull to the start of a step, px. It decides only what the edgels
// leave open.
constexpr double kPriorSigmaPx = 3;

// A curve of the sketch while its samples move. One entry per sample.
struct WorkingCurve {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> tangent;
  std::vector<Eigen::Matrix3d> information;
  std::vector<double> footprint;
  std::vector<std::vector<EdgelRef>> support;
  std::vector<uint8_t> supported;  // by enough views, in the end
  bool closed = false;

  int size() const { return static_cast<int>(position.size()); }
};

std::vector<ViewId> ViewsOf(const std::vector<EdgelRef>& support) {
  std::vector<ViewId> views;
  for (const EdgelRef& ref : support) views.push_back(ref.view);
  return views;
}

class CurveRetriangulation {
 public:
  CurveRetriangulation(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                       const std::vector<std::unique_ptr<ViewEdgels>>& edgels,
                       const DrawingOptions& options)
      : views_(views), curves_(curves), edgels_(edgels), options_(options), finder_(views) {}

  WorkingCurve Run(const Curve3D& curve) const {
    WorkingCurve working;
    working.closed = curve.closed;
    working.position = curve.points_in_world;
    working.tangent = curve.tangents_in_world;
    working.information.resize(curve.size());
    working.footprint.resize(curve.size());
    for (size_t s = 0; s < curve.size(); ++s) {
      const auto edgels = curve.support.Of(s);
      working.support.emplace_back(edgels.begin(), edgels.end());
    }
    for (int round = 0; round < kRounds; ++round) {
      for (int s = 0; s < working.size(); ++s) MoveToEdgels(s, &working);
      working.position = SmoothCurve({working.position, working.tangent, working.information,
                                      working.footprint, working.closed},
                                     options_.bending_sigma_px, false);
      UpdateTangents(&working);
      UpdateSupport(curve, &working);
    }
    const std::vector<ViewId> near = finder_.NearAnyOf(working.position);
    for (int s = 0; s < working.size(); ++s) {
      working.supported.push_back(IsSupported(s, near, working));
    }
    return working;
  }

 private:
  const Edgel& EdgelOf(const EdgelRef& ref) const {
    return curves_[ref.view].edge_map.edgels[ref.edgel];
  }

  struct WeightedLine {
    const View* view;
    EdgelLine line;
    double variance;
  };

  std::vector<WeightedLine> LinesOf(const std::vector<EdgelRef>& support) const {
    std::vector<WeightedLine> lines;
    lines.reserve(support.size());
    for (const EdgelRef& ref : support) {
      const Edgel& edgel = EdgelOf(ref);
      lines.push_back({&views_[ref.view], edgel, ResidualVariance(edgel)});
    }
    return lines;
  }

  // Robust Gauss-Newton in the plane across the curve.
  void MoveToEdgels(int s, WorkingCurve* working) const {
    const std::vector<EdgelRef>& support = working->support[s];
    Eigen::Vector3d& position = working->position[s];
    const Eigen::Vector3d start = position;
    const double footprint = MedianFootprint(position, ViewsOf(support), views_);
    working->footprint[s] = footprint > 0 ? footprint : working->footprint[s];
    const Eigen::Vector3d& tangent = working->tangent[s];
    const Eigen::Matrix<double, 3, 2> across = TangentFrame(tangent);
    const double prior = 1 / std::pow(kPriorSigmaPx * working->footprint[s], 2);
    const std::vector<WeightedLine> lines = LinesOf(support);
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    for (int step = 0; step < kGaussNewtonSteps; ++step) {
      information.setZero();
      Eigen::Vector2d right = -prior * (across.transpose() * (position - start));
      for (const WeightedLine& line : lines) {
        const auto residual = ResidualToEdgel(*line.view, line.line, position);
        if (!residual) continue;
        const double size = std::abs(residual->residual_px);
        const double robust =
            size > options_.robust_residual_px ? options_.robust_residual_px / size : 1;
        const double weight = robust / line.variance;
        const Eigen::Vector2d gradient = across.transpose() * residual->gradient;
        information += weight * gradient * gradient.transpose();
        right -= weight * gradient * residual->residual_px;
      }
      const Eigen::Matrix2d damped = information + prior * Eigen::Matrix2d::Identity();
      position += across * damped.inverse() * right;
    }
    working->information[s] = across * information * across.transpose();
  }

  static void UpdateTangents(WorkingCurve* working) {
    const int size = working->size();
    for (int s = 0; s < size; ++s) {
      const int before = working->closed ? (s + size - 2) % size : std::max(s - 2, 0);
      const int after = working->closed ? (s + 2) % size : std::min(s + 2, size - 1);
      const Eigen::Vector3d chord = working->position[after] - working->position[before];
      if (chord.norm() > 0) working->tangent[s] = chord.normalized();
    }
  }

  // Chooses the best edgels at the new positions, in all views that support any sample of the
  // curve.
  void UpdateSupport(const Curve3D& curve, WorkingCurve* working) const {
    std::vector<ViewId> views;
    for (const auto& support : working->support) {
      for (const EdgelRef& ref : support) views.push_back(ref.view);
    }
    std::sort(views.begin(), views.end());
    views.erase(std::unique(views.begin(), views.end()), views.end());
    const SupportGate gate = options_.Gate();
    for (int s = 0; s < working->size(); ++s) {
      std::vector<EdgelRef> support;
      for (const ViewId v : views) {
        const auto sight = See(views_[v], working->position[s], working->tangent[s]);
        if (!sight) continue;
        const auto match = edgels_[v]->edgels.Best(sight->position_px, sight->direction_rad, gate);
        if (match) support.push_back({v, match->edgel});
      }
      // The anchor keeps its own edgel while that supports the sample at all.
      for (EdgelRef& ref : support) {
        if (ref.view == curve.anchor.view) ref = OwnEdgel(curve, s);
      }
      working->support[s] = std::move(support);
    }
  }

  // `near` holds the views that may contain the curve.
  bool IsSupported(int s, const std::vector<ViewId>& near, const WorkingCurve& working) const {
    const auto num_containing = std::count_if(near.begin(), near.end(), [&](ViewId v) {
      return views_[v].Project(working.position[s]).has_value();
    });
    return static_cast<int>(working.support[s].size()) >=
           NumRequiredViews(static_cast<int>(num_containing), options_.supporting_views_share,
                            options_.min_supporting_views, options_.max_supporting_views);
  }

  EdgelRef OwnEdgel(const Curve3D& curve, int s) const {
    for (const EdgelRef& ref : curve.support.Of(s)) {
      if (ref.view == curve.anchor.view) return ref;
    }
    return {};
  }

  const std::vector<View>& views_;
  const std::vector<ImageCurves>& curves_;
  const std::vector<std::unique_ptr<ViewEdgels>>& edgels_;
  const DrawingOptions& options_;
  ViewFinder finder_;
};

class SampleCollector {
 public:
  SampleCollector(const CurveSketch& sketch, const DrawingOptions& options,
                  RetriangulationStats* stats)
      : options_(options), stats_(stats) {
    size_t num_samples = 0;
    size_t num_edgels = 0;
    for (const Curve3D& curve : sketch.curves) {
      num_samples += curve.size();
      num_edgels += curve.support.edgels.size();
    }
    Reserve(num_samples, num_edgels, &samples_);
  }

  void Add(const WorkingCurve& working, int sketch_curve, ViewId anchor_view) {
    const int size = working.size();
    stats_->samples_in += size;
    const auto supported = [&](int s) { return working.supported[s] != 0; };
    // A single unsupported sample does not cut a curve.
    const auto usable = [&](int s) {
      return supported(s) || (s > 0 && s + 1 < size && supported(s - 1) && supported(s + 1));
    };
    int begin = 0;
    for (int s = 0; s <= size; ++s) {
      if (s < size && usable(s)) continue;
      AddRun(working, begin, s, sketch_curve, anchor_view);
      if (s < size) ++stats_->too_few_views;
      begin = s + 1;
    }
  }

  SampleSet Take() { return std::move(samples_); }

 private:
  void AddRun(const WorkingCurve& working, int begin, int end, int sketch_curve,
              ViewId anchor_view) {
    if (begin == end) return;
    double length_px = 0;
    for (int s = begin + 1; s < end; ++s) {
      length_px += (working.position[s] - working.position[s - 1]).norm() / working.footprint[s];
    }
    if (length_px < options_.min_linked_length_px) {
      stats_->piece_too_short += end - begin;
      return;
    }
    const int curve = samples_.NumCurves();
    const bool whole = end - begin == working.size();
    samples_.origins.push_back({sketch_curve, begin, anchor_view, working.closed && whole});
    for (int s = begin; s < end; ++s) {
      samples_.curve_of.push_back(curve);
      samples_.position.push_back(working.position[s]);
      samples_.tangent.push_back(working.tangent[s]);
      samples_.information.push_back(working.information[s]);
      samples_.footprint.push_back(working.footprint[s]);
      samples_.support.Append(working.support[s]);
    }
    samples_.curve_begin.push_back(samples_.NumSamples());
  }

  const DrawingOptions& options_;
  RetriangulationStats* stats_;
  SampleSet samples_;
};

}  // namespace

SampleSet Retriangulate(const CurveSketch& sketch, const std::vector<View>& views,
                        const std::vector<ImageCurves>& curves,
                        const std::vector<std::unique_ptr<ViewEdgels>>& edgels,
                        const DrawingOptions& options, const RunContext& context,
                        RetriangulationStats* stats) {
  const CurveRetriangulation retriangulation(views, curves, edgels, options);
  SampleCollector collector(sketch, options, stats);
  MapItemsInBlocks(
      context, "re-triangulation", sketch.curves.size(),
      [&](size_t c) { return retriangulation.Run(sketch.curves[c]); },
      [&](size_t c, const WorkingCurve& working) {
        collector.Add(working, static_cast<int>(c), sketch.curves[c].anchor.view);
      });
  return collector.Take();
}

}  // namespace limn
