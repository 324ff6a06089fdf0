#include <algorithm>
#include <memory>

#include "limn/sketch/epipolar_crossings.h"
#include "limn/sketch/local_sketch.h"
#include "limn/sketch/sketch_pieces.h"
#include "limn/sketch/sweep_candidates.h"

namespace limn {
namespace {

// Half width of the stretch over which depths are smoothed, px.
constexpr double kSmoothingPx = 5;
// Every this many-th vertex is searched among all crossings. F of the sketch on midday, day with 1,
// that is, all vertices: -1.2, -.5.
constexpr size_t kAnchorSpacing = 4;

class SweptDepths {
 public:
  explicit SweptDepths(const PrimaryView& primary)
      : primary_(primary),
        view_(primary.input.views[primary.id]),
        election_(view_.camera.MeanFocal(), primary.options) {
    for (const ViewId v : primary.plan.confirmation_views) {
      if (static_cast<int>(finders_.size()) == primary.options.max_sweep_views) break;
      finders_.emplace_back(view_, primary.input.views[v], primary.input.curves[v]);
    }
  }

  DepthProfile Find(const FragmentRays& fragment) {
    const auto modes = Modes(fragment);
    const std::vector<int> chosen = ChooseModes(fragment, modes);
    DepthProfile profile;
    profile.depths.resize(fragment.size());
    for (size_t i = 0; i < fragment.size(); ++i) {
      profile.fates.push_back(modes[i].empty() ? EdgelFate::kNoPartner
                              : chosen[i] < 0  ? EdgelFate::kInconsistent
                                               : EdgelFate::kTooFewViews);
      if (chosen[i] >= 0) profile.depths[i] = modes[i][chosen[i]].depth;
    }
    InterpolateGaps(fragment, primary_.options, &profile.depths);
    SmoothDepths(fragment, kSmoothingPx, &profile.depths);
    KeepSupported(fragment, &profile.depths);
    return profile;
  }

 private:
  // Candidates of every vertex: among all crossings at some vertices (anchors), near theirs at
  // those between.
  std::vector<std::vector<DepthMode>> Modes(const FragmentRays& fragment) {
    std::vector<std::vector<DepthMode>> modes(fragment.size());
    if (fragment.size() == 0) return modes;
    const size_t first = std::min(kAnchorSpacing / 2, (fragment.size() - 1) / 2);
    for (size_t anchor = first; anchor < fragment.size(); anchor += kAnchorSpacing) {
      modes[anchor] = election_.Find(Crossings(fragment, anchor));
    }
    for (size_t i = 0; i < fragment.size(); ++i) {
      std::vector<size_t> anchors;
      if (i >= first) anchors.push_back(i - (i - first) % kAnchorSpacing);
      const size_t next = i < first ? first : anchors[0] + kAnchorSpacing;
      if (next < fragment.size()) anchors.push_back(next);
      if (anchors[0] != i) modes[i] = ModesNear(fragment, i, anchors, modes);
    }
    return modes;
  }

  std::vector<DepthMode> ModesNear(const FragmentRays& fragment, size_t vertex,
                                   const std::vector<size_t>& anchors,
                                   const std::vector<std::vector<DepthMode>>& modes) {
    std::vector<DepthPlace> proposals;
    // Lowest score at which a full candidate list would have been truncated, averaged over the
    // anchors.
    double min_score = 0;
    for (const size_t anchor : anchors) {
      const double step_px = fragment.arc_px[vertex] - fragment.arc_px[anchor];
      for (const auto& [score, depth] : modes[anchor]) {
        proposals.push_back(
            PlaceOf(depth.inverse_depth + step_px * depth.slope_per_px, depth.slope_per_px));
      }
      if (modes[anchor].size() == DepthElection::kMaxModes) {
        min_score += modes[anchor].back().score / static_cast<double>(anchors.size());
      }
    }
    return election_.FindNear(Crossings(fragment, vertex), proposals, min_score);
  }

  const std::vector<EpipolarCrossing>& Crossings(const FragmentRays& fragment, size_t vertex) {
    const double near = 1 / primary_.plan.min_depth;
    const double far = 1 / primary_.plan.max_depth;
    crossings_.clear();
    for (size_t k = 0; k < finders_.size(); ++k) {
      finders_[k].Find(fragment, vertex, far, near, static_cast<int>(k), &crossings_);
    }
    return crossings_;
  }

  // Removes depths that too few views support, stretch by stretch.
  void KeepSupported(const FragmentRays& fragment, std::vector<FusedDepth>* depths) const {
    CurveHypothesis stretch;
    for (size_t i = 0; i <= fragment.size(); ++i) {
      if (i < fragment.size() && (*depths)[i].has_depth) {
        stretch.samples.push_back(MakeSample(fragment, static_cast<int>(i), (*depths)[i]));
        continue;
      }
      if (!stretch.samples.empty()) KeepSupported(fragment, stretch, depths);
      stretch.samples.clear();
    }
  }

  HypothesisSample MakeSample(const FragmentRays& fragment, int vertex,
                              const FusedDepth& depth) const {
    HypothesisSample sample;
    sample.vertex = vertex;
    sample.depth = 1 / depth.inverse_depth;
    sample.tangent_in_cam =
        TangentInCam(view_.camera, fragment, vertex, depth.inverse_depth, depth.slope_per_px);
    return sample;
  }

  void KeepSupported(const FragmentRays& fragment, const CurveHypothesis& stretch,
                     std::vector<FusedDepth>* depths) const {
    const auto support =
        primary_.confirmation.Confirm(fragment, stretch, kNoView, primary_.options);
    for (size_t j = 0; j < stretch.samples.size(); ++j) {
      const HypothesisSample& sample = stretch.samples[j];
      FusedDepth& depth = (*depths)[sample.vertex];
      PrimaryView::Verdict verdict;
      if (support) {
        verdict = primary_.Judge(*support, j, sample.depth * fragment.rays[sample.vertex]);
      }
      depth.has_depth = verdict.supported;
      depth.certain = verdict.certain;
    }
  }

  const PrimaryView& primary_;
  const View& view_;
  std::vector<CrossingFinder> finders_;
  std::vector<EpipolarCrossing> crossings_;  // of the vertex looked at
  DepthElection election_;
};

}  // namespace

SketchResult BuildSweptSketch(const SketchInput& input, const SketchOptions& options,
                              const RunContext& context, const ViewSketchStore* store) {
  return SketchFragments(
      "swept sketch", input, options, context, store, [&](const PrimaryView& primary) {
        // std::function copies what it calls.
        const auto depths = std::make_shared<SweptDepths>(primary);
        return DepthFinder{options.sweep_spacing_px, [depths](const FragmentRays& fragment) {
                             return depths->Find(fragment);
                           }};
      });
}

}  // namespace limn
