// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/enhanced_sketch.h"

#include <utility>

#include "limn/paper/depth_fusion.h"
#include "limn/paper/hypotheses.h"
#include "limn/paper/vertex_winners.h"
#include "limn/sketch/local_sketch.h"

namespace limn {
namespace {

// Spacing of the samples for which depths are sought; edgels between them are interpolated.
constexpr double kSampleSpacingPx = 2;

class PairedDepths {
 public:
  explicit PairedDepths(const PrimaryView& primary) : primary_(primary) {
    const SketchInput& input = primary.input;
    for (const ViewId second : primary.plan.second_views) {
      chords_.emplace_back(input.scene.views[primary.id], input.scene.views[second],
                           *primary.edgels.chords[second]);
    }
  }

  DepthProfile Find(const FragmentRays& fragment) const {
    DepthProfile profile;
    profile.fates.assign(fragment.size(), EdgelFate::kNoPartner);
    const auto candidates = Candidates(fragment, &profile.fates);
    profile.depths = FuseDepths(fragment, candidates, primary_.options);
    for (size_t i = 0; i < fragment.size(); ++i) {
      if (!candidates[i].empty()) profile.fates[i] = EdgelFate::kInconsistent;
    }
    return profile;
  }

 private:
  std::vector<SupportedHypothesis> Supported(const FragmentRays& fragment, size_t rank,
                                             std::vector<EdgelFate>* fates) const {
    const ViewPlan& plan = primary_.plan;
    const ViewId second = plan.second_views[rank];
    std::vector<SupportedHypothesis> supported;
    for (CurveHypothesis& hypothesis : FindHypotheses(
             fragment, primary_.input.scene.views[primary_.id], primary_.input.scene.views[second],
             chords_[rank], plan.min_depth, plan.max_depth)) {
      for (const HypothesisSample& sample : hypothesis.samples) {
        (*fates)[sample.vertex] = EdgelFate::kTooFewViews;
      }
      auto support = primary_.confirmation.Confirm(fragment, hypothesis, second);
      if (support) supported.push_back({std::move(hypothesis), std::move(*support)});
    }
    return supported;
  }

  // Per vertex, the reconstructions with enough local support. With the averaging of the paper, of
  // each second view only the hypothesis with the most support in all counts, if it clearly has.
  std::vector<std::vector<DepthCandidate>> Candidates(const FragmentRays& fragment,
                                                      std::vector<EdgelFate>* fates) const {
    const SketchOptions& options = primary_.options;
    std::vector<std::vector<DepthCandidate>> candidates(fragment.size());
    for (size_t rank = 0; rank < chords_.size(); ++rank) {
      const std::vector<SupportedHypothesis> rivals = Supported(fragment, rank, fates);
      std::vector<int> winners;  // with the averaging of the paper
      if (options.averaging == DepthAveraging::kPaper) {
        winners = FindVertexWinners(rivals, fragment.size(), options.first_to_second_ratio);
      }
      for (size_t r = 0; r < rivals.size(); ++r) {
        const auto& [hypothesis, support] = rivals[r];
        for (size_t j = 0; j < hypothesis.samples.size(); ++j) {
          const bool wins =
              winners.empty() || winners[hypothesis.samples[j].vertex] == static_cast<int>(r);
          if (!wins) continue;
          AddCandidate(fragment, hypothesis.samples[j], support, j, static_cast<int>(rank),
                       &candidates);
        }
      }
    }
    return candidates;
  }

  void AddCandidate(const FragmentRays& fragment, const HypothesisSample& sample,
                    const HypothesisSupport& support, size_t j, int rank,
                    std::vector<std::vector<DepthCandidate>>* candidates) const {
    const auto verdict = primary_.Judge(support, j, sample.depth * fragment.rays[sample.vertex]);
    if (!verdict.supported) return;
    const double sine = sample.triangulation_sine * sample.epipolar_sine;
    DepthCandidate candidate;
    candidate.inverse_depth = 1 / sample.depth;
    candidate.px_per_inverse_depth = support.px_per_inverse_depth[j];
    candidate.slope_per_px = Slope(fragment, sample);
    candidate.weight = sine * sine;
    candidate.weighted_support = support.weighted[j];
    candidate.second_rank = rank;
    candidate.certain = verdict.certain;
    (*candidates)[sample.vertex].push_back(candidate);
  }

  // d (1/depth) per px along the fragment when the point moves along its 3D tangent.
  double Slope(const FragmentRays& fragment, const HypothesisSample& sample) const {
    const PinholeCamera& camera = primary_.input.scene.views[primary_.id].camera;
    const Eigen::Vector3d& ray = fragment.rays[sample.vertex];
    const Eigen::Vector3d& tangent = sample.tangent_in_cam;
    const Eigen::Vector2d motion(camera.fx * (tangent.x() - ray.x() * tangent.z()),
                                 camera.fy * (tangent.y() - ray.y() * tangent.z()));
    if (!(motion.norm() > 1e-12)) return 0;
    const double px_per_length = motion.norm() / sample.depth;
    return -tangent.z() / (sample.depth * sample.depth * px_per_length);
  }

  const PrimaryView& primary_;
  std::vector<EpipolarChords> chords_;  // per second view
};

}  // namespace

SketchOptions WithSupportRule(SketchOptions options) {
  options.by_weight_alone = options.averaging == DepthAveraging::kPaper;
  return options;
}

SketchResult BuildEnhancedSketch(const SketchInput& input, const SketchOptions& given,
                                 const RunContext& context, const ViewSketchStore* store) {
  const SketchOptions options = WithSupportRule(given);
  return SketchFragments(
      "enhanced sketch", input, options, context, store, [&](const PrimaryView& primary) {
        // std::function copies what it calls.
        const auto depths = std::make_shared<PairedDepths>(primary);
        return DepthFinder{kSampleSpacingPx, 1, [depths](const FragmentRays& fragment) {
                             return depths->Find(fragment);
                           }};
      });
}

}  // namespace limn
