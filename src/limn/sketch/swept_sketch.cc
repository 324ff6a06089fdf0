// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>
#include <span>

#include "limn/model/sample_step.h"
#include "limn/sketch/epipolar_crossings.h"
#include "limn/sketch/local_sketch.h"
#include "limn/sketch/sketch_pieces.h"
#include "limn/sketch/sweep_candidates.h"

namespace limn {
namespace {

// Half width of the stretch over which depths are smoothed, px.
constexpr double kSmoothingPx = 5;
// Every this many-th vertex is searched among all crossings. Searching at all of them is slower and
// no better: what its neighbors foretell protects a vertex from accidents.
constexpr size_t kAnchorSpacing = 4;
// Depths are sought in this many confirmation views, the most useful first: more cost time and find
// little more.
constexpr int kMaxSweepViews = 16;
// Spacing of the vertices whose depth is sought; those between are interpolated.
constexpr double kSweepSpacingPx = 3;

class SweptDepths {
 public:
  explicit SweptDepths(const PrimaryView& primary)
      : primary_(primary),
        view_(primary.input.scene.views[primary.id]),
        range_{1 / primary.plan.max_depth, 1 / primary.plan.min_depth},
        election_(view_.camera.MeanFocal(), primary.options) {
    for (const ViewId v : primary.plan.confirmation_views) {
      if (static_cast<int>(finders_.size()) == kMaxSweepViews) break;
      finders_.emplace_back(view_, primary.input.scene.views[v], *primary.edgels.chords[v]);
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
    InterpolateGaps(fragment, &profile.depths);
    SmoothDepths(fragment, kSmoothingPx, &profile.depths);
    KeepSupported(fragment, &profile.depths);
    return profile;
  }

 private:
  // A vertex that is searched among all crossings, and what it proposes to those beside it.
  struct Anchor {
    double arc_px = 0;
    std::vector<FusedDepth> proposals;
    // Below this a full list of candidates would have been cut off.
    double min_score = 0;
  };

  // Candidates of every vertex: among all crossings at anchors, near theirs at those between.
  std::vector<std::vector<DepthMode>> Modes(const FragmentRays& fragment) {
    std::vector<std::vector<DepthMode>> modes(fragment.size());
    if (fragment.size() == 0) return modes;
    std::vector<int> at;  // vertices of anchors
    const size_t first = std::min(kAnchorSpacing / 2, (fragment.size() - 1) / 2);
    for (size_t i = first; i < fragment.size(); i += kAnchorSpacing) {
      at.push_back(static_cast<int>(i));
      modes[i] = election_.Find(Crossings(fragment, i));
    }
    const std::vector<Anchor> anchors = Anchors(fragment, at, modes);
    for (size_t i = 0; i < fragment.size(); ++i) {
      const auto next = std::ranges::lower_bound(at, static_cast<int>(i)) - at.begin();
      const bool is_anchor = next < std::ssize(at) && at[next] == static_cast<int>(i);
      if (is_anchor) continue;
      const auto begin = anchors.begin() + std::max<std::ptrdiff_t>(0, next - 1);
      const auto end = anchors.begin() + std::min(next + 1, std::ssize(at));
      modes[i] = ModesNear(fragment, i, {begin, end});
    }
    return modes;
  }

  // Anchors propose the candidate that is chosen along the fragment, or all if none is.
  static std::vector<Anchor> Anchors(const FragmentRays& fragment, const std::vector<int>& at,
                                     const std::vector<std::vector<DepthMode>>& modes) {
    std::vector<std::vector<DepthMode>> candidates;
    for (const int i : at) candidates.push_back(modes[i]);
    const std::vector<int> chosen = ChooseModes(Subset(fragment, at), candidates);
    std::vector<Anchor> anchors;
    for (size_t k = 0; k < at.size(); ++k) {
      Anchor& anchor = anchors.emplace_back();
      anchor.arc_px = fragment.arc_px[at[k]];
      const bool is_full = candidates[k].size() == DepthElection::kMaxModes;
      if (is_full) anchor.min_score = candidates[k].back().score;
      for (int m = 0; m < std::ssize(candidates[k]); ++m) {
        if (chosen[k] < 0 || chosen[k] == m) anchor.proposals.push_back(candidates[k][m].depth);
      }
    }
    return anchors;
  }

  std::vector<DepthMode> ModesNear(const FragmentRays& fragment, size_t vertex,
                                   std::span<const Anchor> anchors) {
    std::vector<DepthPlace> proposals;
    double min_score = 0;
    for (const Anchor& anchor : anchors) {
      const double step_px = fragment.arc_px[vertex] - anchor.arc_px;
      for (const FusedDepth& depth : anchor.proposals) {
        proposals.push_back(
            PlaceOf(depth.inverse_depth + step_px * depth.slope_per_px, depth.slope_per_px));
      }
      min_score += anchor.min_score / static_cast<double>(anchors.size());
    }
    std::vector<DepthMode> modes =
        election_.FindNear(CrossingsNear(fragment, vertex, proposals), proposals);
    std::erase_if(modes, [&](const DepthMode& mode) { return mode.score < min_score; });
    return modes;
  }

  const std::vector<EpipolarCrossing>& Crossings(const FragmentRays& fragment, size_t vertex) {
    crossings_.clear();
    for (size_t k = 0; k < finders_.size(); ++k) {
      finders_[k].Find(fragment, vertex, range_, static_cast<int>(k), &crossings_);
    }
    return crossings_;
  }

  const std::vector<EpipolarCrossing>& CrossingsNear(const FragmentRays& fragment, size_t vertex,
                                                     const std::vector<DepthPlace>& places) {
    crossings_.clear();
    for (size_t k = 0; k < finders_.size(); ++k) {
      finders_[k].FindNear(fragment, vertex, range_, places, static_cast<int>(k), &crossings_);
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
    const auto support = primary_.confirmation.Confirm(fragment, stretch, kNoView);
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
  InverseDepthRange range_;
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
        return DepthFinder{
            kSweepSpacingPx, kVerticesPerSample,
            [depths](const FragmentRays& fragment) { return depths->Find(fragment); }};
      });
}

}  // namespace limn
