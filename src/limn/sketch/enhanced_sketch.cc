#include <algorithm>
#include <array>
#include <bit>
#include <set>

#include "limn/sketch/confirmation.h"
#include "limn/sketch/depth_fusion.h"
#include "limn/sketch/sketch.h"
#include "limn/sketch/sketch_pieces.h"
#include "limn/support/required_views.h"

namespace limn {
namespace {

// What became of a vertex of a fragment.
enum class Fate {
  kFragmentTooShort,
  kNoPartner,
  kTooFewViews,
  kInconsistent,
  kPieceTooShort,
  kKept
};
constexpr int kNumFates = 6;

// A support confined to this angle says little where views beyond the other one look on: an
// occluding contour or an accident (algorithm.md 0.1 item 8).
constexpr double kNarrowSupportDeg = 15;
constexpr double kWideViewsDeg = 30;

struct FragmentSketch {
  std::vector<Curve3D> curves;
  std::array<int64_t, kNumFates> fates{};
};

class PrimaryView {
 public:
  PrimaryView(const SketchInput& input, ViewId id, const ViewPlan& plan,
              const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
              const SketchOptions& options)
      : input_(input),
        id_(id),
        plan_(plan),
        evidence_(evidence),
        options_(options),
        confirmation_(id, plan.confirmation_views, input.views, evidence) {
    std::set<ViewId> all(plan.second_views.begin(), plan.second_views.end());
    all.insert(plan.confirmation_views.begin(), plan.confirmation_views.end());
    support_views_.assign(all.begin(), all.end());
    world_from_cam_ = Inverse(input.views[id].cam_from_world);
  }

  FragmentSketch Reconstruct(int fragment_id) const {
    FragmentSketch result;
    const FragmentRays fragment =
        MakeFragmentRays(input_.views[id_], input_.curves[id_], fragment_id);
    std::vector<Fate> fates(fragment.size(), Fate::kFragmentTooShort);
    if (fragment.size() >= 2 && fragment.arc_px.back() >= options_.min_fragment_length_px) {
      const std::vector<int> vertices = SpacedVertices(fragment, options_.sample_spacing_px);
      const FragmentRays spaced = Subset(fragment, vertices);
      std::vector<Fate> spaced_fates(spaced.size());
      const auto candidates = Candidates(spaced, &spaced_fates);
      const std::vector<FusedDepth> spaced_depths = FuseDepths(spaced, candidates, options_);
      for (size_t i = 0; i < spaced.size(); ++i) {
        if (!candidates[i].empty()) {
          spaced_fates[i] = spaced_depths[i].has_depth ? Fate::kPieceTooShort : Fate::kInconsistent;
        }
        const size_t next = i + 1 < vertices.size() ? vertices[i + 1] : fragment.size();
        for (size_t k = vertices[i]; k < next; ++k) fates[k] = spaced_fates[i];
      }
      std::vector<FusedDepth> depths = ExpandDepths(fragment, vertices, spaced_depths);
      InterpolateGaps(fragment, options_, &depths);
      for (const VertexRun& run : FindRuns(fragment, depths, options_)) {
        for (int k = 0; k < run.size; ++k) {
          fates[(run.begin + k) % fragment.size()] = Fate::kKept;
        }
        Curve3D curve = MakeCurve(input_.views[id_], fragment, depths, run);
        curve.anchor.view = id_;
        curve.anchor.fragment = fragment_id;
        CollectSupport(input_.views, input_.curves, evidence_, support_views_, options_.Gate(),
                       &curve);
        result.curves.push_back(std::move(curve));
      }
    }
    for (const Fate fate : fates) ++result.fates[static_cast<int>(fate)];
    return result;
  }

 private:
  // Per vertex, the reconstructions with enough local support.
  std::vector<std::vector<DepthCandidate>> Candidates(const FragmentRays& fragment,
                                                      std::vector<Fate>* fates) const {
    std::fill(fates->begin(), fates->end(), Fate::kNoPartner);
    std::vector<std::vector<DepthCandidate>> candidates(fragment.size());
    for (size_t rank = 0; rank < plan_.second_views.size(); ++rank) {
      const ViewId second = plan_.second_views[rank];
      for (const CurveHypothesis& hypothesis :
           FindHypotheses(fragment, input_.views[id_], input_.views[second], *evidence_[second],
                          plan_.min_depth, plan_.max_depth, options_)) {
        for (const HypothesisSample& sample : hypothesis.samples) {
          (*fates)[sample.vertex] = Fate::kTooFewViews;
        }
        const auto support = confirmation_.Confirm(fragment, hypothesis, second, options_);
        if (!support) continue;
        for (size_t j = 0; j < hypothesis.samples.size(); ++j) {
          AddCandidate(fragment, hypothesis.samples[j], *support, j, static_cast<int>(rank),
                       &candidates);
        }
      }
    }
    return candidates;
  }

  void AddCandidate(const FragmentRays& fragment, const HypothesisSample& sample,
                    const HypothesisSupport& support, size_t j, int rank,
                    std::vector<std::vector<DepthCandidate>>* candidates) const {
    const int num_supporting = std::popcount(support.supporting[j]);
    const int required =
        NumRequiredViews(std::popcount(support.contained[j]), options_.supporting_views_share,
                         options_.min_supporting_views, options_.max_supporting_views);
    if (num_supporting < required) return;
    const Eigen::Vector3d point = sample.depth * fragment.rays[sample.vertex];
    if (input_.box && !input_.box->contains(world_from_cam_ * point)) return;
    if (confirmation_.MaxAngleDeg(point, support.supporting[j]) < kNarrowSupportDeg &&
        confirmation_.MaxAngleDeg(point, support.contained[j]) > kWideViewsDeg) {
      return;
    }
    const double sine = sample.triangulation_sine * sample.epipolar_sine;
    DepthCandidate candidate;
    candidate.inverse_depth = 1 / sample.depth;
    candidate.px_per_inverse_depth = support.px_per_inverse_depth[j];
    candidate.slope_per_px = Slope(fragment, sample);
    candidate.information = sine * sine;
    candidate.weighted_support = support.weighted[j];
    candidate.second_rank = rank;
    candidate.certain = support.weighted[j] >= required;
    (*candidates)[sample.vertex].push_back(candidate);
  }

  // d (1/depth) per px along the fragment when the point moves along its 3D tangent.
  double Slope(const FragmentRays& fragment, const HypothesisSample& sample) const {
    const PinholeCamera& camera = input_.views[id_].camera;
    const Eigen::Vector3d& ray = fragment.rays[sample.vertex];
    const Eigen::Vector3d& tangent = sample.tangent_in_cam;
    const Eigen::Vector2d motion(camera.fx * (tangent.x() - ray.x() * tangent.z()),
                                 camera.fy * (tangent.y() - ray.y() * tangent.z()));
    const double px_per_length = motion.norm() / sample.depth;
    if (!(px_per_length > 1e-12)) return 0;
    return -tangent.z() / (sample.depth * sample.depth * px_per_length);
  }

  const SketchInput& input_;
  ViewId id_;
  const ViewPlan& plan_;
  const std::vector<std::unique_ptr<ViewEvidence>>& evidence_;
  const SketchOptions& options_;
  ConfirmationViews confirmation_;
  std::vector<ViewId> support_views_;
  Rigid3d world_from_cam_;
};

StageSummary Summarize(const std::array<int64_t, kNumFates>& fates, const CurveSketch& sketch,
                       int64_t num_fragments) {
  const auto count = [&](Fate fate) { return fates[static_cast<int>(fate)]; };
  int64_t total = 0;
  for (const int64_t n : fates) total += n;
  StageSummary summary;
  summary.stage = "enhanced sketch";
  summary.in = {{"fragments", num_fragments}, {"edgels", total}};
  summary.kept = {{"edgels", count(Fate::kKept)},
                  {"curves", static_cast<int64_t>(sketch.curves.size())}};
  summary.dropped = {{"edgels: fragment too short", count(Fate::kFragmentTooShort)},
                     {"edgels: no partner in a second view", count(Fate::kNoPartner)},
                     {"edgels: too few supporting views", count(Fate::kTooFewViews)},
                     {"edgels: depth inconsistent along the curve", count(Fate::kInconsistent)},
                     {"edgels: piece too short", count(Fate::kPieceTooShort)}};
  return summary;
}

}  // namespace

SketchResult BuildEnhancedSketch(const SketchInput& input, const SketchOptions& options,
                                 const RunContext& context) {
  options.Check();
  const auto plans = SelectViews(input.views, input.hints, options.view_selection, context);
  const auto evidence = BuildEvidence(input.views, input.curves, options.Gate(), context);
  std::vector<std::vector<FragmentSketch>> by_view(input.views.size());
  ParallelFor(context, "enhanced sketch", input.views.size(), [&](size_t v) {
    const PrimaryView primary(input, static_cast<ViewId>(v), plans[v], evidence, options);
    for (size_t f = 0; f < input.curves[v].fragments.size(); ++f) {
      by_view[v].push_back(primary.Reconstruct(static_cast<int>(f)));
    }
  });
  SketchResult result;
  std::array<int64_t, kNumFates> fates{};
  int64_t num_fragments = 0;
  for (auto& fragments : by_view) {
    for (FragmentSketch& fragment : fragments) {
      ++num_fragments;
      for (int i = 0; i < kNumFates; ++i) fates[i] += fragment.fates[i];
      for (Curve3D& curve : fragment.curves) result.sketch.curves.push_back(std::move(curve));
    }
  }
  result.summary = Summarize(fates, result.sketch, num_fragments);
  return result;
}

}  // namespace limn
