// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/position_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include <Eigen/SVD>

#include "limn/util/median.h"
#include "limn/util/random_index.h"

namespace limn {
namespace {

// Residuals below this share of the spread of the targets are no contradiction: models bend.
constexpr double kSmallShare = 0.01;
// And so bent ones are as if stretched.
constexpr double kBentShare = 0.03;
// And of so few in other orders: they would leave more.
constexpr double kClearShare = 0.1;
// What fits by so much better, in standard deviations, is no accident; of fewer than
// kManyPairs, whose residuals vary more.
constexpr double kMuchBetter = 3, kMuchBetterOfFew = 5;
constexpr size_t kManyPairs = 7;
// Of pairs in so many random orders, so many may fit as well by accident.
constexpr int kNumOrders = 40, kMaxOrdersAsGood = 1;
constexpr size_t kMaxPairsInOrders = 200;
constexpr double kMaxRejectedShare = 1.0 / 3;
// A linear map has 12 numbers, and is exact for four pairs.
constexpr size_t kMinPairsOfLinear = 6, kMinBelowTypicalOfLinear = 10;
constexpr int kNumLinearSamples = 300;
// Directions of the sources shorter than this share of the longest are flat.
constexpr double kFlat = 1e-3;

struct LinearMap {
  Eigen::Matrix3d target_from_source = Eigen::Matrix3d::Zero();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return target_from_source * point + translation;
  }
};

// Least squares; the least map across directions in which the sources do not extend.
LinearMap FitLinear(const std::vector<PointPair>& pairs) {
  double sum = 0;
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero(), target_mean = Eigen::Vector3d::Zero();
  for (const PointPair& pair : pairs) {
    sum += pair.weight;
    source_mean += pair.weight * pair.source;
    target_mean += pair.weight * pair.target;
  }
  source_mean /= sum;
  target_mean /= sum;
  Eigen::Matrix3d sources = Eigen::Matrix3d::Zero(), both = Eigen::Matrix3d::Zero();
  for (const PointPair& pair : pairs) {
    const Eigen::Vector3d source = pair.source - source_mean;
    sources += pair.weight * source * source.transpose();
    both += pair.weight * (pair.target - target_mean) * source.transpose();
  }
  Eigen::JacobiSVD<Eigen::Matrix3d> svd(sources, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.setThreshold(kFlat * kFlat);
  LinearMap map;
  map.target_from_source = svd.solve(both.transpose()).transpose();
  map.translation = target_mean - map.target_from_source * source_mean;
  return map;
}

template <typename Map>
std::vector<double> ScaledDistances(const std::vector<PointPair>& pairs, const Map& map) {
  std::vector<double> distances;
  for (const PointPair& pair : pairs) {
    distances.push_back((map * pair.source - pair.target).norm() * std::sqrt(pair.weight));
  }
  return distances;
}

// Large enough that a linear map is not exact for all below it.
double TypicalOfLinear(std::vector<double> distances) {
  const size_t last = distances.size() - 1;
  const size_t place = std::max(distances.size() / 2, std::min(last, kMinBelowTypicalOfLinear));
  const auto typical = distances.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(distances.begin(), typical, distances.end());
  return *typical;
}

// The best of those of all pairs and of random sixes.
LinearMap FitLinearRobustly(const std::vector<PointPair>& pairs) {
  LinearMap best = FitLinear(pairs);
  double least = TypicalOfLinear(ScaledDistances(pairs, best));
  std::mt19937 random(1);
  for (int k = 0; k < kNumLinearSamples; ++k) {
    const LinearMap map = FitLinear(RandomSample(pairs, kMinPairsOfLinear, &random));
    const double typical = TypicalOfLinear(ScaledDistances(pairs, map));
    if (!(typical < least)) continue;
    least = typical;
    best = map;
  }
  return best;
}

template <typename Map>
double MedianDistance(const std::vector<PointPair>& pairs, const Map& map) {
  std::vector<double> distances;
  for (const PointPair& pair : pairs) distances.push_back((map * pair.source - pair.target).norm());
  return Median(distances);
}

// Median distance of the targets from their median.
double Spread(const std::vector<PointPair>& pairs) {
  Eigen::Vector3d middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const PointPair& pair : pairs) values.push_back(pair.target[axis]);
    middle[axis] = Median(values);
  }
  std::vector<double> distances;
  for (const PointPair& pair : pairs) distances.push_back((pair.target - middle).norm());
  return Median(distances);
}

std::vector<PointPair> Mirrored(std::vector<PointPair> pairs) {
  for (PointPair& pair : pairs) pair.source.x() *= -1;
  return pairs;
}

std::vector<PointPair> Thinned(const std::vector<PointPair>& pairs) {
  const size_t every = (pairs.size() + kMaxPairsInOrders - 1) / kMaxPairsInOrders;
  std::vector<PointPair> kept;
  for (size_t i = 0; i < pairs.size(); i += every) kept.push_back(pairs[i]);
  return kept;
}

// In a random order that leaves none in its place (Sattolo's).
std::vector<PointPair> InAnotherOrder(const std::vector<PointPair>& pairs, std::mt19937* random) {
  std::vector<PointPair> shuffled = pairs;
  for (size_t i = pairs.size() - 1; i > 0; --i) {
    std::swap(shuffled[i], shuffled[RandomIndex(static_cast<uint32_t>((*random)()), i)]);
  }
  for (size_t i = 0; i < pairs.size(); ++i) shuffled[i].source = pairs[i].source;
  return shuffled;
}

// Whether the pairs fit no better than in random orders.
bool FitsInAnyOrder(const std::vector<PointPair>& all, const PositionFit& fit) {
  std::vector<PointPair> pairs = Thinned(all);
  double typical = fit.typical_scaled_residual;
  if (pairs.size() < all.size()) {
    const auto of_some = FitPositions(pairs);
    if (of_some) typical = of_some->typical_scaled_residual;
  }
  std::mt19937 random(2);
  int num_as_good = 0;
  for (int k = 0; k < kNumOrders && num_as_good <= kMaxOrdersAsGood; ++k) {
    const auto other = FitPositions(InAnotherOrder(pairs, &random));
    num_as_good += other && other->typical_scaled_residual <= typical ? 1 : 0;
  }
  return num_as_good > kMaxOrdersAsGood;
}

// What explains the pairs better by so much.
std::optional<PositionCheck> BetterSimilarity(PositionDoubt doubt, const PositionFit& fit,
                                              const std::vector<PointPair>& other,
                                              double much_better) {
  const auto other_fit = FitPositions(other);
  if (!other_fit) return std::nullopt;
  if (!(much_better * other_fit->typical_scaled_residual < fit.typical_scaled_residual)) {
    return std::nullopt;
  }
  return PositionCheck{doubt, other_fit->median_residual, Eigen::Vector3d::Ones()};
}

std::optional<PositionCheck> BetterStretch(const std::vector<PointPair>& all,
                                           const PositionFit& fit, double much_better) {
  std::vector<PointPair> pairs;
  for (size_t i = 0; i < all.size(); ++i) {
    if (fit.is_rejected[i] == 0) pairs.push_back(all[i]);
  }
  if (pairs.size() < kMinPairsOfLinear) return std::nullopt;
  const LinearMap map = FitLinearRobustly(pairs);
  const double typical = TypicalOfLinear(ScaledDistances(pairs, fit.target_from_source));
  const double of_map = TypicalOfLinear(ScaledDistances(pairs, map));
  if (!(much_better * of_map < typical)) return std::nullopt;
  const Eigen::Vector3d stretch =
      Eigen::JacobiSVD<Eigen::Matrix3d>(map.target_from_source).singularValues();
  return PositionCheck{PositionDoubt::kStretched, MedianDistance(pairs, map),
                       stretch / std::max(stretch.mean(), 1e-300)};
}

}  // namespace

PositionCheck CheckPositions(const std::vector<PointPair>& pairs, const PositionFit& fit,
                             const std::vector<PointPair>& exchanged, double accuracy) {
  const double spread = Spread(pairs);
  if (fit.median_residual > kSmallShare * spread) {
    const double much_better = pairs.size() < kManyPairs ? kMuchBetterOfFew : kMuchBetter;
    auto better = BetterSimilarity(PositionDoubt::kExchanged, fit, exchanged, much_better);
    if (!better) {
      better = BetterSimilarity(PositionDoubt::kMirrored, fit, Mirrored(pairs), much_better);
    }
    if (!better && fit.median_residual > kBentShare * spread) {
      better = BetterStretch(pairs, fit, much_better);
    }
    if (better) return *better;
    const bool is_clear = fit.median_residual < kClearShare * spread;
    const bool is_noise = fit.typical_scaled_residual <= kMuchBetter * accuracy;
    if (!is_clear && !is_noise && FitsInAnyOrder(pairs, fit)) {
      return {.doubt = PositionDoubt::kAnyOrder};
    }
  }
  if (static_cast<double>(fit.num_rejected) >
      kMaxRejectedShare * static_cast<double>(pairs.size())) {
    return {.doubt = PositionDoubt::kManyWrong};
  }
  return {};
}

}  // namespace limn
