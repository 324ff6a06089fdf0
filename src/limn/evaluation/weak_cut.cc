// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/weak_cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace limn {
namespace {

// Pairs that promise less than the first say nothing, those that promise more than the second say
// no more, px.
constexpr double kLeastPromisedPx = 100;
constexpr double kFullWeightPx = 1000;
// Keeps the logarithm of what is shared finite, px.
constexpr double kPriorPx = 20;
constexpr double kBinDeg = 5;
constexpr int kNumBins = 18;
// Weight of the prior of every effect, which is 0.
constexpr double kPriorWeight = 0.5;
// Angles tell of a cut if at least this share of their pairs is on either side of it: those between
// two clusters of views are all across.
constexpr double kLeastShareOfAngle = 0.1;
constexpr int kNumFits = 300;
constexpr int kNumPowers = 300;
constexpr int kMinGroup = 2;
// Any few views have a best cut that explains much.
constexpr int kMinViews = 8;
constexpr size_t kMinPairs = 10;
// A cut is weak if less than this is shared across it and it explains more than this; or, if it
// explains much, with a little less shared.
constexpr double kWeakShared = 0.8;
constexpr double kLeastExplained = 0.1;
constexpr double kSlightlyWeakShared = 0.88;
constexpr double kMuchExplained = 0.3;
// And of the better way between two views, less than this.
constexpr double kWeakBothWays = 0.92;

// A pair of views as the logarithm of the share of what is promised.
struct Observation {
  ViewId from = -1;
  ViewId to = -1;
  int bin = 0;  // of the angle
  double weight = 0;
  double value = 0;
};

std::vector<Observation> Observe(const std::vector<SharedSupport>& pairs) {
  std::vector<Observation> observed;
  for (const SharedSupport& pair : pairs) {
    if (pair.promised_px < kLeastPromisedPx) continue;
    observed.push_back({pair.from, pair.to,
                        std::min(kNumBins - 1, static_cast<int>(pair.angle_deg / kBinDeg)),
                        std::min(1.0, pair.promised_px / kFullWeightPx),
                        std::log((pair.shared_px + kPriorPx) / (pair.promised_px + kPriorPx))});
  }
  return observed;
}

// A weighted mean for each of some classes, drawn to 0.
class ClassMeans {
 public:
  explicit ClassMeans(size_t size) : means_(size, 0), weights_(size, 0) {}
  void Add(int k, double weight, double value) {
    means_[k] += weight * value;
    weights_[k] += weight;
  }
  std::vector<double> Take() {
    for (size_t k = 0; k < means_.size(); ++k) means_[k] /= weights_[k] + kPriorWeight;
    return std::move(means_);
  }

 private:
  std::vector<double> means_, weights_;
};

// Explains observations by the sum of one effect of either view, one of the angle and, with groups,
// one of being in different ones, which are fitted in turn.
class Effects {
 public:
  Effects(int num_views, const std::vector<Observation>& observed,
          const std::vector<uint8_t>* group = nullptr)
      : observed_(observed),
        group_(group),
        from_(num_views, 0),
        to_(num_views, 0),
        angle_(kNumBins, 0) {
    for (int k = 0; k < kNumFits; ++k) FitOnce();
  }

  double Residual(const Observation& pair) const {
    return pair.value - from_[pair.from] - to_[pair.to] - angle_[pair.bin] -
           (IsAcross(pair) ? across_ : 0);
  }

  double SumOfSquares() const {
    double sum = 0;
    for (const Observation& pair : observed_) {
      sum += pair.weight * Residual(pair) * Residual(pair);
    }
    return sum;
  }

  double across() const { return across_; }

 private:
  bool IsAcross(const Observation& pair) const {
    return group_ && (*group_)[pair.from] != (*group_)[pair.to];
  }

  template <typename ClassOf>
  void Fit(const ClassOf& class_of, std::vector<double>* effects) {
    ClassMeans means(effects->size());
    for (const Observation& pair : observed_) {
      const int k = class_of(pair);
      means.Add(k, pair.weight, Residual(pair) + (*effects)[k]);
    }
    *effects = means.Take();
  }

  void FitOnce() {
    Fit([](const Observation& pair) { return pair.bin; }, &angle_);
    Fit([](const Observation& pair) { return pair.from; }, &from_);
    Fit([](const Observation& pair) { return pair.to; }, &to_);
    if (!group_) return;
    ClassMeans mean(1);
    for (const Observation& pair : observed_) {
      if (IsAcross(pair)) mean.Add(0, pair.weight, Residual(pair) + across_);
    }
    across_ = mean.Take().front();
  }

  const std::vector<Observation>& observed_;
  const std::vector<uint8_t>* group_;
  std::vector<double> from_, to_, angle_;
  double across_ = 0;
};

// What is left of a pair of views, both ways together.
struct Tie {
  ViewId a = -1;
  ViewId b = -1;
  double weight = 0;
};

std::vector<Tie> TiesOf(const std::vector<Observation>& observed, const Effects& effects) {
  std::vector<Tie> ties;
  for (const Observation& pair : observed) {
    ties.push_back({pair.from, pair.to, 0.5 * pair.weight * effects.Residual(pair)});
  }
  return ties;
}

// The direction in which the ties differ most: the leading eigenvector of their matrix, by the
// power method. Views of one group have values of one sign.
std::vector<double> LeadingVector(int num_views, const std::vector<Tie>& ties) {
  std::vector<double> sums(num_views, 0);
  for (const Tie& tie : ties) {
    sums[tie.a] += std::abs(tie.weight);
    sums[tie.b] += std::abs(tie.weight);
  }
  const double shift = *std::ranges::max_element(sums);  // makes all eigenvalues positive
  std::vector<double> vector;
  for (int v = 0; v < num_views; ++v) vector.push_back(std::sin(v + 1.0));
  for (int k = 0; k < kNumPowers; ++k) {
    std::vector<double> next;
    for (const double value : vector) next.push_back(shift * value);
    for (const Tie& tie : ties) {
      next[tie.a] += tie.weight * vector[tie.b];
      next[tie.b] += tie.weight * vector[tie.a];
    }
    const double norm = std::sqrt(std::inner_product(next.begin(), next.end(), next.begin(), 0.0));
    if (!(norm > 0)) break;
    for (double& value : next) value /= norm;
    vector = std::move(next);
  }
  return vector;
}

// Of the cuts between views in the order of the vector, that with the strongest ties inside the
// groups and the weakest across. Per view, its group.
std::vector<uint8_t> BestCut(const std::vector<double>& vector, const std::vector<Tie>& ties) {
  const int size = static_cast<int>(vector.size());
  std::vector<ViewId> order(size);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](ViewId v) { return vector[v]; });
  std::vector<std::vector<Tie>> of_view(size);
  double outside = 0;
  for (const Tie& tie : ties) {
    of_view[tie.a].push_back(tie);
    of_view[tie.b].push_back(tie);
    outside += tie.weight;
  }
  std::vector<uint8_t> group(size, 0);
  std::vector<uint8_t> best_group;
  double best = 0, inside = 0, across = 0;
  for (int n = 1; n <= size - kMinGroup; ++n) {
    const ViewId moved = order[n - 1];
    group[moved] = 1;
    for (const Tie& tie : of_view[moved]) {
      const bool to_inside = group[tie.a] && group[tie.b];
      (to_inside ? across : outside) -= tie.weight;
      (to_inside ? inside : across) += tie.weight;
    }
    if (n < kMinGroup) continue;
    const double n0 = size - n, n1 = n;
    const double contrast =
        inside / (n1 * (n1 - 1)) + outside / (n0 * (n0 - 1)) - across / (n0 * n1);
    const double score = contrast * std::sqrt(n0 * n1);
    if (score > best) {
      best = score;
      best_group = group;
    }
  }
  return best_group;
}

// The pairs under angles that occur inside the groups and across.
std::vector<Observation> UnderCommonAngles(const std::vector<Observation>& observed,
                                           const std::vector<uint8_t>& group) {
  std::vector<double> inside(kNumBins, 0), across(kNumBins, 0);
  for (const Observation& pair : observed) {
    (group[pair.from] == group[pair.to] ? inside : across)[pair.bin] += pair.weight;
  }
  std::vector<Observation> common;
  for (const Observation& pair : observed) {
    const double a = inside[pair.bin], b = across[pair.bin];
    if (std::min(a, b) >= kLeastShareOfAngle * (a + b)) common.push_back(pair);
  }
  return common;
}

// Of both ways between two views, that which shares more: a group that lacks what others see is no
// group of its own, it lacks it one way only.
std::vector<Observation> BetterWays(const std::vector<Observation>& observed) {
  std::map<std::pair<ViewId, ViewId>, Observation> better;
  for (const Observation& pair : observed) {
    const auto [known, is_new] = better.emplace(std::minmax(pair.from, pair.to), pair);
    if (!is_new && pair.value > known->second.value) known->second = pair;
  }
  std::vector<Observation> ways;
  for (const auto& [views, pair] : better) ways.push_back(pair);
  return ways;
}

bool IsWeak(const WeakCut& cut) {
  return (cut.shared < kWeakShared && cut.explained > kLeastExplained) ||
         (cut.shared < kSlightlyWeakShared && cut.explained > kMuchExplained);
}

}  // namespace

std::optional<WeakCut> FindWeakCut(int num_views, const std::vector<SharedSupport>& pairs) {
  const std::vector<Observation> observed = Observe(pairs);
  if (num_views < kMinViews || observed.size() < kMinPairs) return std::nullopt;
  const std::vector<Tie> ties = TiesOf(observed, Effects(num_views, observed));
  const std::vector<uint8_t> group = BestCut(LeadingVector(num_views, ties), ties);
  if (group.empty()) return std::nullopt;
  const std::vector<Observation> common = UnderCommonAngles(observed, group);
  if (common.size() < kMinPairs) return std::nullopt;
  const Effects without(num_views, common);
  const Effects with(num_views, common, &group);
  WeakCut cut;
  cut.shared = std::exp(with.across());
  cut.explained = 1 - with.SumOfSquares() / without.SumOfSquares();
  const std::vector<Observation> better_ways = UnderCommonAngles(BetterWays(observed), group);
  const Effects of_better_ways(num_views, better_ways, &group);
  if (!IsWeak(cut) || std::exp(of_better_ways.across()) > kWeakBothWays) return std::nullopt;
  const bool is_smaller = 2 * std::ranges::count(group, 1) <= num_views;
  for (ViewId v = 0; v < num_views; ++v) {
    if (group[v] == (is_smaller ? 1 : 0)) cut.smaller.push_back(v);
  }
  return cut;
}

}  // namespace limn
