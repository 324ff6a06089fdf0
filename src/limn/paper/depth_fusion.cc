// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/depth_fusion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr int kMaxModes = 8;
// Reconstructions of one edgel that reproject within this of each other belong together: as near as
// edgels support.
constexpr double kDepthGatePx = 1.5;
// Each agreeing second view counts as this many supporting views, up to this many second views.
constexpr double kAgreementBonus = 0.5;
constexpr int kMaxAgreement = 4;
// The paper drops candidates farther than this many standard deviations from the mean.
constexpr double kPaperSigmas = 2;
// Ours drops those farther from the median than this many, by the median absolute deviation, but
// never below this distance.
constexpr double kGateSigmas = 2;
constexpr double kSigmaPerDeviation = 1.4826;
constexpr double kMinGatePx = 0.25;

// The modes of one vertex, and the candidates that each was made from.
struct VertexModes {
  std::vector<DepthMode> modes;
  std::vector<std::vector<int>> members;
};

double Distance(const DepthCandidate& a, double inverse_depth) {
  return std::abs(a.inverse_depth - inverse_depth) * a.px_per_inverse_depth;
}

// Greedy modes: the best supported candidate gathers those within the gate, and so on.
VertexModes FindModes(const std::vector<DepthCandidate>& candidates, double gate_px) {
  std::vector<int> order(candidates.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return candidates[a].weighted_support > candidates[b].weighted_support;
  });
  std::vector<bool> taken(candidates.size(), false);
  VertexModes found;
  for (const int seed : order) {
    if (taken[seed]) continue;
    if (found.modes.size() == kMaxModes) break;
    const DepthCandidate& best = candidates[seed];
    DepthMode mode;
    std::vector<int> members;
    uint32_t seconds = 0;
    double weight = 0;
    for (size_t i = 0; i < candidates.size(); ++i) {
      if (taken[i] || Distance(best, candidates[i].inverse_depth) > gate_px) continue;
      taken[i] = true;
      members.push_back(static_cast<int>(i));
      seconds |= 1u << std::min(candidates[i].second_rank, 31);
      const double w = candidates[i].weight + 1e-12;
      mode.depth.inverse_depth += w * candidates[i].inverse_depth;
      mode.depth.slope_per_px += w * candidates[i].slope_per_px;
      weight += w;
    }
    mode.depth.inverse_depth /= weight;
    mode.depth.slope_per_px /= weight;
    mode.depth.px_per_inverse_depth = best.px_per_inverse_depth;
    mode.score =
        best.weighted_support + kAgreementBonus * std::min(std::popcount(seconds), kMaxAgreement);
    found.modes.push_back(mode);
    found.members.push_back(std::move(members));
  }
  return found;
}

double WeightedMedian(std::vector<std::pair<double, double>> values_and_weights) {
  std::sort(values_and_weights.begin(), values_and_weights.end());
  double total = 0;
  for (const auto& [value, weight] : values_and_weights) total += weight;
  double below = 0;
  for (const auto& [value, weight] : values_and_weights) {
    below += weight;
    if (below >= 0.5 * total) return value;
  }
  return values_and_weights.back().first;
}

FusedDepth Average(const std::vector<DepthCandidate>& candidates, const std::vector<int>& members,
                   double px_per_inverse_depth) {
  std::vector<std::pair<double, double>> values;
  for (const int i : members) {
    values.push_back({candidates[i].inverse_depth, candidates[i].weight + 1e-12});
  }
  const double median = WeightedMedian(values);
  for (auto& [value, weight] : values) value = std::abs(value - median);
  const double gate = std::max(kGateSigmas * kSigmaPerDeviation * WeightedMedian(values),
                               kMinGatePx / std::max(px_per_inverse_depth, 1e-300));
  FusedDepth fused;
  fused.px_per_inverse_depth = px_per_inverse_depth;
  double weight = 0;
  for (const int i : members) {
    const DepthCandidate& candidate = candidates[i];
    if (std::abs(candidate.inverse_depth - median) > gate) continue;
    const double w = candidate.weight + 1e-12;
    fused.inverse_depth += w * candidate.inverse_depth;
    weight += w;
    fused.weight += candidate.weight;
    fused.certain |= candidate.certain;
  }
  fused.inverse_depth /= weight;
  fused.has_depth = true;
  return fused;
}

// Standard deviation of the pairwise distances between the candidates of each vertex, along the ray
// in units of depth: the Gaussian about zero that fits them all.
double PairwiseSigma(const std::vector<std::vector<DepthCandidate>>& candidates) {
  double sum = 0;
  int64_t count = 0;
  for (const std::vector<DepthCandidate>& of_vertex : candidates) {
    for (size_t i = 0; i < of_vertex.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        const double distance = 1 / of_vertex[i].inverse_depth - 1 / of_vertex[j].inverse_depth;
        sum += distance * distance;
        ++count;
      }
    }
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

// The mean depth of the candidates without those farther from their mean than `gate`; none if
// nothing is left.
FusedDepth MeanWithin(const std::vector<DepthCandidate>& candidates, double gate) {
  const double count = static_cast<double>(candidates.size());
  double mean = 0;
  for (const DepthCandidate& candidate : candidates) mean += 1 / candidate.inverse_depth / count;
  FusedDepth fused;
  double sum = 0;
  int kept = 0;
  for (const DepthCandidate& candidate : candidates) {
    const double depth = 1 / candidate.inverse_depth;
    if (std::abs(depth - mean) > gate) continue;
    ++kept;
    sum += depth;
    fused.weight += candidate.weight;
    fused.px_per_inverse_depth = candidate.px_per_inverse_depth;
    fused.certain |= candidate.certain;
  }
  fused.has_depth = kept > 0;
  if (fused.has_depth) fused.inverse_depth = kept / sum;
  return fused;
}

std::vector<FusedDepth> AverageDepths(const std::vector<std::vector<DepthCandidate>>& candidates) {
  const double sigma = PairwiseSigma(candidates);
  std::vector<FusedDepth> fused;
  for (const auto& of_vertex : candidates) {
    // A single one is its own mean, up to rounding.
    const double gate =
        of_vertex.size() == 1 ? std::numeric_limits<double>::infinity() : kPaperSigmas * sigma;
    fused.push_back(MeanWithin(of_vertex, gate));
  }
  return fused;
}

}  // namespace

std::vector<FusedDepth> FuseDepths(const FragmentRays& fragment,
                                   const std::vector<std::vector<DepthCandidate>>& candidates,
                                   const SketchOptions& options) {
  if (options.averaging == DepthAveraging::kPaper) return AverageDepths(candidates);
  std::vector<std::vector<DepthMode>> modes(candidates.size());
  std::vector<std::vector<std::vector<int>>> members(candidates.size());
  for (size_t i = 0; i < candidates.size(); ++i) {
    VertexModes found = FindModes(candidates[i], kDepthGatePx);
    modes[i] = std::move(found.modes);
    members[i] = std::move(found.members);
  }
  const std::vector<int> chosen = ChooseModes(fragment, modes);
  std::vector<FusedDepth> fused(candidates.size());
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (chosen[i] < 0) continue;
    fused[i] = Average(candidates[i], members[i][chosen[i]],
                       modes[i][chosen[i]].depth.px_per_inverse_depth);
  }
  return fused;
}

}  // namespace limn
