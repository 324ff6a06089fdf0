#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "limn/sketch/confirmation.h"
#include "limn/sketch/sketch.h"
#include "limn/sketch/sketch_edgels.h"
#include "limn/sketch/sketch_pieces.h"

namespace limn {
namespace {

// What became of a hypothesis.
struct Counts {
  int64_t made = 0;
  int64_t too_short = 0;
  int64_t too_little_support = 0;
  int64_t ambiguous = 0;
};

struct PrimaryCurves {
  std::vector<Curve3D> curves;
  Counts counts;
};

// Total support S (CVPR 2010): the sum over confirmation views of the supported samples, where a
// view with fewer than min_inliers_view of them does not vote.
double TotalSupport(const HypothesisSupport& support, size_t num_views,
                    const SketchOptions& options) {
  double total = 0;
  for (size_t k = 0; k < num_views; ++k) {
    int inliers = 0;
    for (const uint32_t mask : support.inliers) inliers += mask >> k & 1;
    if (inliers >= options.original_min_inliers_view) total += inliers;
  }
  return total >= options.original_min_inliers_total ? total : 0;
}

// Cut away the portions tangent to epipolar lines; keep stretches of the minimum length.
std::vector<CurveHypothesis> CutTangentPortions(const FragmentRays& fragment,
                                                const std::vector<CurveHypothesis>& hypotheses,
                                                const SketchOptions& options, Counts* counts) {
  const double min_sine = std::sin(options.original_min_epipolar_angle_deg * M_PI / 180);
  std::vector<CurveHypothesis> cut;
  for (const CurveHypothesis& hypothesis : hypotheses) {
    CurveHypothesis piece{hypothesis.second_fragment, {}};
    const auto finish = [&] {
      if (piece.samples.empty()) return;
      ++counts->made;
      const double length = fragment.arc_px[piece.samples.back().vertex] -
                            fragment.arc_px[piece.samples.front().vertex];
      if (length >= options.original_min_fragment_length_px) {
        cut.push_back(piece);
      } else {
        ++counts->too_short;
      }
      piece.samples.clear();
    };
    for (const HypothesisSample& sample : hypothesis.samples) {
      if (sample.epipolar_sine >= min_sine) {
        piece.samples.push_back(sample);
      } else {
        finish();
      }
    }
    finish();
  }
  return cut;
}

std::vector<FusedDepth> AsDepths(const FragmentRays& fragment, const CurveHypothesis& hypothesis,
                                 const HypothesisSupport& support) {
  std::vector<FusedDepth> depths(fragment.size());
  for (size_t j = 0; j < hypothesis.samples.size(); ++j) {
    const HypothesisSample& sample = hypothesis.samples[j];
    const double sine = sample.triangulation_sine * sample.epipolar_sine;
    FusedDepth& depth = depths[sample.vertex];
    depth.has_depth = true;
    depth.certain = true;
    depth.inverse_depth = 1 / sample.depth;
    depth.weight = sine * sine;
    depth.px_per_inverse_depth = support.px_per_inverse_depth[j];
  }
  return depths;
}

class PairMatcher {
 public:
  PairMatcher(const SketchInput& input, ViewId primary, const ViewPlan& plan,
              const SketchEdgels& edgels, const SketchOptions& options)
      : input_(input),
        primary_(primary),
        plan_(plan),
        edgels_(edgels),
        options_(options),
        confirmation_(primary, plan.confirmation_views, input.views, edgels.masks) {
    for (const ViewId second : plan.second_views) {
      chords_.emplace_back(input.views[primary], input.views[second], input.curves[second]);
    }
  }

  // At most one curve per stretch of fragment and second view: the best supported one, if it beats
  // the second best by the ratio.
  void Match(int fragment_id, PrimaryCurves* sketch) const {
    const FragmentRays fragment =
        MakeFragmentRays(input_.views[primary_], input_.curves[primary_], fragment_id);
    if (fragment.size() < 2 || fragment.arc_px.back() < options_.original_min_fragment_length_px) {
      return;
    }
    for (size_t rank = 0; rank < plan_.second_views.size(); ++rank) {
      const ViewId second = plan_.second_views[rank];
      const auto hypotheses = CutTangentPortions(
          fragment,
          FindHypotheses(fragment, input_.views[primary_], input_.views[second], chords_[rank],
                         plan_.min_depth, plan_.max_depth, options_),
          options_, &sketch->counts);
      double best = 0;
      double second_best = 0;
      const CurveHypothesis* winner = nullptr;
      HypothesisSupport winner_support;
      for (const CurveHypothesis& hypothesis : hypotheses) {
        auto support = confirmation_.Confirm(fragment, hypothesis, second, options_);
        const double total = support ? TotalSupport(*support, confirmation_.size(), options_) : 0;
        if (total == 0) ++sketch->counts.too_little_support;
        if (total > best) {
          if (winner) ++sketch->counts.ambiguous;
          second_best = best;
          best = total;
          winner = &hypothesis;
          winner_support = std::move(*support);
        } else if (total > 0) {
          ++sketch->counts.ambiguous;
          second_best = std::max(second_best, total);
        }
      }
      if (!winner) continue;
      if (!(options_.original_first_to_second_ratio * second_best < best)) {
        ++sketch->counts.ambiguous;
        continue;
      }
      Emit(fragment_id, fragment, *winner, winner_support, sketch);
    }
  }

 private:
  void Emit(int fragment_id, const FragmentRays& fragment, const CurveHypothesis& hypothesis,
            const HypothesisSupport& support, PrimaryCurves* sketch) const {
    const auto depths = AsDepths(fragment, hypothesis, support);
    const int begin = hypothesis.samples.front().vertex;
    // One curve over the whole overlap, as published: inner vertices without a match are passed
    // over.
    std::vector<int> vertices;
    std::vector<FusedDepth> matched_depths;
    for (const HypothesisSample& sample : hypothesis.samples) {
      vertices.push_back(sample.vertex);
      matched_depths.push_back(depths[sample.vertex]);
    }
    const FragmentRays matched = Subset(fragment, vertices);
    const int count = static_cast<int>(matched.size());
    Curve3D curve = MakeCurve(input_.views[primary_], matched, matched_depths, {0, count, false});
    if (input_.box) {
      for (const Eigen::Vector3d& point : curve.points_in_world) {
        if (!input_.box->contains(point)) return;
      }
    }
    curve.anchor = {primary_, fragment_id, begin};
    std::vector<ViewId> support_views = plan_.confirmation_views;
    std::sort(support_views.begin(), support_views.end());
    CollectSupport(input_.views, input_.curves, edgels_.views, support_views, options_.Gate(),
                   &curve);
    sketch->curves.push_back(std::move(curve));
  }

  const SketchInput& input_;
  ViewId primary_;
  const ViewPlan& plan_;
  const SketchEdgels& edgels_;
  const SketchOptions& options_;
  ConfirmationViews confirmation_;
  std::vector<EpipolarChords> chords_;  // per second view
};

}  // namespace

SketchResult BuildOriginalSketch(const SketchInput& input, const SketchOptions& options,
                                 const RunContext& context) {
  options.Check();
  const auto plans = SelectViews(input.views, input.hints, options.view_selection, context);
  SketchEdgels edgels(input.views.size());
  HoldViews(IdsOf({}, input.views.size()), input, options.Gate(), context, &edgels);
  std::vector<PrimaryCurves> by_view(input.views.size());
  ParallelFor(context, "original sketch", input.views.size(), [&](size_t v) {
    const PairMatcher matcher(input, static_cast<ViewId>(v), plans[v], edgels, options);
    for (size_t f = 0; f < input.curves[v].fragments.size(); ++f) {
      matcher.Match(static_cast<int>(f), &by_view[v]);
    }
  });
  SketchResult result;
  Counts counts;
  for (PrimaryCurves& sketch : by_view) {
    counts.made += sketch.counts.made;
    counts.too_short += sketch.counts.too_short;
    counts.too_little_support += sketch.counts.too_little_support;
    counts.ambiguous += sketch.counts.ambiguous;
    for (Curve3D& curve : sketch.curves) result.sketch.curves.push_back(std::move(curve));
  }
  result.summary.stage = "original sketch";
  result.summary.in = {{"hypotheses", counts.made}};
  result.summary.kept = {{"curves", static_cast<int64_t>(result.sketch.curves.size())}};
  result.summary.dropped = {{"hypotheses: too short", counts.too_short},
                            {"hypotheses: too little support", counts.too_little_support},
                            {"hypotheses: not better than another by the ratio", counts.ambiguous}};
  return result;
}

}  // namespace limn
