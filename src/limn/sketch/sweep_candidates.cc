// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/sweep_candidates.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "limn/sketch/tangency.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Candidates before they are elected anew about the means of their voters.
constexpr size_t kMaxPreliminaryModes = 16;
// Depths are proposed by the crossings of this many views, the first in the plan. More take more
// time and gain little.
constexpr int kSeedViews = 8;
// Smallest number of voters.
constexpr int kMinVoters = 2;
// Modes this near to a better one, in px of the other views, are the same.
constexpr double kSamePx = 1.0;

double Square(double value) { return value * value; }

// The votes for a mode.
class Ballot {
 public:
  void Add(const EpipolarCrossing& voter) {
    ++num_voters_;
    const double w = Square(voter.across_px_per_inverse_depth);
    const double s = Square(voter.rad_per_slope);
    mode_.depth.inverse_depth += w * voter.inverse_depth;
    mode_.depth.slope_per_px += s * voter.slope_per_px;
    mode_.depth.px_per_inverse_depth += voter.px_per_inverse_depth;
    depth_weight_ += w;
    slope_weight_ += s;
  }

  // The mean of the voters.
  DepthMode Result(double score, double focal_px) const {
    DepthMode mode = mode_;
    mode.score = score;
    mode.depth.has_depth = true;
    mode.depth.inverse_depth /= depth_weight_;
    mode.depth.slope_per_px /= slope_weight_;
    mode.depth.px_per_inverse_depth /= num_voters_;
    mode.depth.weight = depth_weight_ * Square(mode.depth.inverse_depth / focal_px);
    return mode;
  }

 private:
  DepthMode mode_;
  int num_voters_ = 0;
  double depth_weight_ = 0;
  double slope_weight_ = 0;
};

// The best modes so far, by descending score, no two the same.
class Ranking {
 public:
  explicit Ranking(size_t max_modes) : max_modes_(max_modes) {}

  void Offer(const DepthMode& mode) {
    const auto is_same = [&](const DepthMode& other) {
      return std::abs(other.depth.inverse_depth - mode.depth.inverse_depth) *
                 other.depth.px_per_inverse_depth <
             kSamePx;
    };
    const auto worse = std::find_if(modes_.begin(), modes_.end(), [&](const DepthMode& other) {
      return other.score < mode.score;
    });
    if (std::any_of(modes_.begin(), worse, is_same)) return;
    const auto at = worse - modes_.begin();
    modes_.erase(std::remove_if(worse, modes_.end(), is_same), modes_.end());
    modes_.insert(modes_.begin() + at, mode);
    if (modes_.size() > max_modes_) modes_.pop_back();
  }

  // Modes whose score is no greater than this are not taken.
  double LeastScore() const { return modes_.size() < max_modes_ ? 0 : modes_.back().score; }

  const std::vector<DepthMode>& Modes() const { return modes_; }

 private:
  size_t max_modes_;
  std::vector<DepthMode> modes_;
};

}  // namespace

DepthElection::DepthElection(double focal_px, const SketchOptions& options)
    : focal_px_(focal_px),
      sin_low_(static_cast<float>(std::sin(kMinEpipolarAngleDeg * kDeg))),
      sin_high_(static_cast<float>(std::sin(kMaxEpipolarAngleDeg * kDeg))),
      min_weight_(static_cast<float>(kMinTangencyWeight)),
      table_(options.max_support_distance_px, options.max_support_angle_deg * kDeg) {}

std::vector<DepthMode> DepthElection::Find(const std::vector<EpipolarCrossing>& crossings) {
  seeds_.clear();
  for (const EpipolarCrossing& crossing : crossings) {
    if (crossing.view >= kSeedViews) break;
    seeds_.push_back({crossing.inverse_depth, crossing.slope_per_px});
  }
  return FindNear(crossings, seeds_);
}

std::vector<DepthMode> DepthElection::FindNear(const std::vector<EpipolarCrossing>& crossings,
                                               const std::vector<DepthPlace>& proposals) {
  if (crossings.empty()) return {};
  table_.Fill(crossings);
  weights_.clear();
  for (const EpipolarCrossing& crossing : crossings) weights_.push_back(TangencyWeight(crossing));
  Ranking preliminary(kMaxPreliminaryModes);
  for (const DepthPlace& proposal : proposals) {
    const auto mode = Vote(crossings, proposal, preliminary.LeastScore());
    if (mode) preliminary.Offer(*mode);
  }
  Ranking final(kMaxModes);
  for (const auto& [score, depth] : preliminary.Modes()) {
    const auto mode =
        Vote(crossings, PlaceOf(depth.inverse_depth, depth.slope_per_px), final.LeastScore());
    if (mode) final.Offer(*mode);
  }
  return final.Modes();
}

// The mode that the crossings near a place elect; nothing if too few views vote, or if its score is
// no greater than `least_score`.
std::optional<DepthMode> DepthElection::Vote(const std::vector<EpipolarCrossing>& crossings,
                                             const DepthPlace& place, double least_score) {
  uint64_t voting = 0;  // a bit per view
  table_.ForEachNear(place, [&](int crossing, float distance) {
    const int view = crossings[crossing].view;
    const uint64_t bit = uint64_t{1} << view;
    if ((voting & bit) != 0 && distance >= voters_[view].distance) return;
    voting |= bit;
    voters_[view] = {crossing, distance};
  });
  if (std::popcount(voting) < kMinVoters) return std::nullopt;
  const auto for_each_voter = [&](auto&& visit) {
    for (uint64_t left = voting; left != 0; left &= left - 1) {
      visit(voters_[std::countr_zero(left)]);
    }
  };
  double score = 0;
  for_each_voter(
      [&](const Voter& voter) { score += weights_[voter.crossing] * (1 - 0.5f * voter.distance); });
  if (score <= least_score) return std::nullopt;
  Ballot ballot;
  for_each_voter([&](const Voter& voter) { ballot.Add(crossings[voter.crossing]); });
  return ballot.Result(score, focal_px_);
}

float DepthElection::TangencyWeight(const EpipolarCrossing& crossing) const {
  return std::clamp((crossing.EpipolarSine() - sin_low_) / (sin_high_ - sin_low_), min_weight_,
                    1.f);
}

}  // namespace limn
