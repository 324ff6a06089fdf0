// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/original_sketch.h"

#include <algorithm>
#include <cmath>

#include "limn/paper/epipolar_stretches.h"
#include "limn/paper/hypotheses.h"
#include "limn/sketch/confirmation.h"
#include "limn/sketch/sketch.h"
#include "limn/sketch/sketch_edgels.h"
#include "limn/sketch/sketch_pieces.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// So many views confirmed a pair where original_min_inliers_total was chosen.
constexpr double kPublishedConfirmationViews = 5;
// As published, for images of 640 x 360: shorter fragments are not matched, curves are cut where
// they are nearer to epipolar lines, and fewer inlier edgels do not make a view count.
constexpr double kMinFragmentLengthPx = 20;
constexpr double kMinEpipolarAngleOfCurvesDeg = 10;
constexpr int kMinInliersView = 15;

// What became of a hypothesis.
struct Counts {
  int64_t made = 0;
  int64_t too_short = 0;
  int64_t too_little_support = 0;
  int64_t ambiguous = 0;
  int64_t outside = 0;
};

struct PrimaryCurves {
  std::vector<Curve3D> curves;
  Counts counts;
};

// A hypothesis with enough support.
struct Match {
  CurveHypothesis hypothesis;
  HypothesisSupport support;
  double total = 0;
};

// A stretch of a fragment that nowhere runs along the epipolar lines of the second view, as a
// fragment of its own.
struct Stretch {
  int fragment = -1;
  int begin = 0;  // vertex of the fragment, modulo its size in a closed one
  FragmentRays rays;
};

// Total support S (CVPR 2010): the sum over confirmation views of the supported samples, where a
// view with fewer than kMinInliersView of them does not vote.
double TotalInliers(const HypothesisSupport& support, size_t num_views) {
  double total = 0;
  for (size_t k = 0; k < num_views; ++k) {
    int inliers = 0;
    for (const uint32_t mask : support.inliers) inliers += mask >> k & 1;
    if (inliers >= kMinInliersView) total += inliers;
  }
  return total;
}

// The total that a pair needs: fewer than the published number of confirmation views, of which the
// second view is none, cannot give all of it.
double RequiredInliers(const ViewPlan& plan, ViewId second, const SketchOptions& options) {
  const std::vector<ViewId>& views = plan.confirmation_views;
  const auto num_views = std::ranges::count_if(views, [&](ViewId v) { return v != second; });
  const double share = static_cast<double>(num_views) / kPublishedConfirmationViews;
  return std::min(1.0, share) * options.original_min_inliers_total;
}

// Cut away the portions tangent to epipolar lines of either view; keep those of the minimum length.
std::vector<CurveHypothesis> CutTangentPortions(const FragmentRays& stretch,
                                                const std::vector<CurveHypothesis>& hypotheses,
                                                double min_sine, double min_length_px,
                                                Counts* counts) {
  std::vector<CurveHypothesis> cut;
  for (const CurveHypothesis& hypothesis : hypotheses) {
    CurveHypothesis piece{hypothesis.second_fragment, {}};
    const auto finish = [&] {
      if (piece.samples.empty()) return;
      ++counts->made;
      const double length = stretch.arc_px[piece.samples.back().vertex] -
                            stretch.arc_px[piece.samples.front().vertex];
      if (length >= min_length_px) {
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

// Whether both explain the same part of the curve; pieces that continue each other do not.
bool AreRivals(const FragmentRays& stretch, const Match& a, const Match& b) {
  const int begin =
      std::max(a.hypothesis.samples.front().vertex, b.hypothesis.samples.front().vertex);
  const int end = std::min(a.hypothesis.samples.back().vertex, b.hypothesis.samples.back().vertex);
  return begin < end && stretch.arc_px[end] - stretch.arc_px[begin] >= kMinOverlapPx;
}

// The depths of all vertices that the match covers: inner ones that its curve does not cross lie on
// the line between their neighbors.
std::vector<FusedDepth> AsDepths(const FragmentRays& stretch, const Match& match) {
  std::vector<int> vertices;
  std::vector<FusedDepth> depths;
  for (size_t j = 0; j < match.hypothesis.samples.size(); ++j) {
    const HypothesisSample& sample = match.hypothesis.samples[j];
    const double sine = sample.triangulation_sine * sample.epipolar_sine;
    FusedDepth depth;
    depth.has_depth = true;
    depth.certain = true;
    depth.inverse_depth = 1 / sample.depth;
    depth.weight = sine * sine;
    depth.px_per_inverse_depth = match.support.px_per_inverse_depth[j];
    vertices.push_back(sample.vertex);
    depths.push_back(depth);
  }
  return ExpandDepths(stretch, vertices, depths);
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
        min_sine_(std::sin(kMinEpipolarAngleOfCurvesDeg * kDeg)),
        confirmation_(primary, plan.confirmation_views, input.scene.views, edgels.masks) {
    for (const ViewId second : plan.second_views) {
      chords_.emplace_back(input.scene.views[primary], input.scene.views[second],
                           *edgels.chords[second]);
    }
  }

  void MatchFragment(int fragment_id, PrimaryCurves* sketch) const {
    const FragmentRays fragment =
        MakeFragmentRays(input_.scene.views[primary_], input_.scene.curves[primary_], fragment_id);
    if (fragment.size() < 2 || fragment.arc_px.back() < kMinFragmentLengthPx) {
      return;
    }
    for (size_t rank = 0; rank < plan_.second_views.size(); ++rank) {
      for (const VertexStretch& part : EpipolarStretches(
               fragment, input_.scene.views[primary_], input_.scene.views[plan_.second_views[rank]],
               min_sine_, kMinFragmentLengthPx)) {
        MatchStretch({fragment_id, part.begin, OpenStretch(fragment, part.begin, part.end)}, rank,
                     sketch);
      }
    }
  }

 private:
  // Matches of one part of a stretch compete: one becomes a curve if it beats every other by the
  // ratio.
  void MatchStretch(const Stretch& stretch, size_t rank, PrimaryCurves* sketch) const {
    const std::vector<Match> matches = FindMatches(stretch.rays, rank, &sketch->counts);
    for (const Match& match : matches) {
      const bool wins = std::ranges::all_of(matches, [&](const Match& other) {
        return &other == &match || !AreRivals(stretch.rays, match, other) ||
               options_.first_to_second_ratio * other.total < match.total;
      });
      if (wins) {
        Emit(stretch, match, sketch);
      } else {
        ++sketch->counts.ambiguous;
      }
    }
  }

  std::vector<Match> FindMatches(const FragmentRays& stretch, size_t rank, Counts* counts) const {
    const ViewId second = plan_.second_views[rank];
    const auto hypotheses = CutTangentPortions(
        stretch,
        FindHypotheses(stretch, input_.scene.views[primary_], input_.scene.views[second],
                       chords_[rank], plan_.min_depth, plan_.max_depth,
                       &input_.scene.curves[second].fragments),
        min_sine_, kMinFragmentLengthPx, counts);
    const double required = RequiredInliers(plan_, second, options_);
    std::vector<Match> matches;
    for (const CurveHypothesis& hypothesis : hypotheses) {
      auto support = confirmation_.Confirm(stretch, hypothesis, second);
      const double total = support ? TotalInliers(*support, confirmation_.size()) : 0;
      if (total > 0 && total >= required) {
        matches.push_back({hypothesis, std::move(*support), total});
      } else {
        ++counts->too_little_support;
      }
    }
    return matches;
  }

  void Emit(const Stretch& stretch, const Match& match, PrimaryCurves* sketch) const {
    const int begin = match.hypothesis.samples.front().vertex;
    const int size = match.hypothesis.samples.back().vertex + 1 - begin;
    Curve3D curve = MakeCurve(input_.scene.views[primary_], stretch.rays,
                              AsDepths(stretch.rays, match), {begin, size, false});
    const auto inside = [&](const Eigen::Vector3d& point) {
      return input_.scene.box->contains(point);
    };
    if (input_.scene.box && !std::ranges::all_of(curve.points_in_world, inside)) {
      ++sketch->counts.outside;
      return;
    }
    const auto& vertices = input_.scene.curves[primary_].fragments[stretch.fragment].edgel_ids;
    curve.anchor = {primary_, stretch.fragment,
                    (stretch.begin + begin) % static_cast<int>(vertices.size())};
    curve.total_support = match.total;
    std::vector<ViewId> support_views = plan_.confirmation_views;
    std::sort(support_views.begin(), support_views.end());
    CollectSupport(input_.scene.views, input_.scene.curves, edgels_.indices, support_views,
                   options_.Gate(), &curve);
    sketch->curves.push_back(std::move(curve));
  }

  const SketchInput& input_;
  ViewId primary_;
  const ViewPlan& plan_;
  const SketchEdgels& edgels_;
  const SketchOptions& options_;
  double min_sine_;
  ConfirmationViews confirmation_;
  std::vector<EpipolarChords> chords_;  // per second view
};

// The plans of all views; with original_exhaustive_pairs every other view is a second view.
std::vector<ViewPlan> PairViews(const SketchInput& input, const SketchOptions& options,
                                const RunContext& context) {
  std::vector<ViewPlan> plans =
      SelectViews(input.scene.views, input.scene.hints, options.view_selection, context);
  if (!options.original_exhaustive_pairs) return plans;
  for (size_t v = 0; v < plans.size(); ++v) {
    plans[v].second_views = IdsOf({}, plans.size());
    std::erase(plans[v].second_views, static_cast<ViewId>(v));
  }
  return plans;
}

}  // namespace

SketchResult BuildOriginalSketch(const SketchInput& input, const SketchOptions& options,
                                 const RunContext& context) {
  options.Check();
  const auto plans = PairViews(input, options, context);
  SketchEdgels edgels(input.scene.views.size());
  HoldViews(IdsOf({}, input.scene.views.size()), input, options.Gate(), context, &edgels);
  std::vector<PrimaryCurves> by_view(input.scene.views.size());
  ParallelFor(context, "original sketch", input.scene.views.size(), [&](size_t v) {
    const PairMatcher matcher(input, static_cast<ViewId>(v), plans[v], edgels, options);
    for (size_t f = 0; f < input.scene.curves[v].fragments.size(); ++f) {
      matcher.MatchFragment(static_cast<int>(f), &by_view[v]);
    }
  });
  SketchResult result;
  Counts counts;
  int64_t num_pairs = 0;
  for (const ViewPlan& plan : plans) num_pairs += static_cast<int64_t>(plan.second_views.size());
  for (PrimaryCurves& sketch : by_view) {
    counts.made += sketch.counts.made;
    counts.too_short += sketch.counts.too_short;
    counts.too_little_support += sketch.counts.too_little_support;
    counts.ambiguous += sketch.counts.ambiguous;
    counts.outside += sketch.counts.outside;
    for (Curve3D& curve : sketch.curves) result.sketch.curves.push_back(std::move(curve));
  }
  result.summary.stage = "original sketch";
  result.summary.in = {{"pairs of views", num_pairs}, {"hypotheses", counts.made}};
  result.summary.kept = {{"curves", static_cast<int64_t>(result.sketch.curves.size())}};
  result.summary.dropped = {{"hypotheses: too short", counts.too_short},
                            {"hypotheses: too little support", counts.too_little_support},
                            {"hypotheses: not better than another by the ratio", counts.ambiguous},
                            {"hypotheses: outside the box", counts.outside}};
  return result;
}

}  // namespace limn
