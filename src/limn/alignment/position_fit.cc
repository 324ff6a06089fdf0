// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/position_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "limn/util/median.h"
#include "limn/util/random_index.h"

namespace limn {
namespace {

constexpr int kNumSamples = 300;
constexpr int kNumIterations = 30;
// Of the distance of points with a standard deviation of 1 along each axis.
constexpr double kMedianDistance = 1.5382;
// Residuals of more standard deviations are wrong rather than noise. Weights that fall gradually
// would shrink the scale where the noise is not small beside the extent.
constexpr double kOutlierSigmas = 4;
// So many residuals below the typical one, if there are as many. Any fit has 7 degrees of freedom:
// to a pair or two more it can be exact by chance, which would make all others look wrong.
constexpr size_t kMinBelowTypical = 6;
// Of few pairs all are below it: one is wrong if the largest residual of the others falls by this
// factor without it.
constexpr double kFallWithoutWrong = 5;

// Least squares with these weights (Umeyama 1991); nothing if the sources are at one place.
std::optional<Similarity3d> FitWeighted(const std::vector<PointPair>& pairs,
                                        const std::vector<double>& weights) {
  double sum = 0;
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero(), target_mean = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < pairs.size(); ++i) {
    sum += weights[i];
    source_mean += weights[i] * pairs[i].source;
    target_mean += weights[i] * pairs[i].target;
  }
  source_mean /= sum;
  target_mean /= sum;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double variance = 0;
  for (size_t i = 0; i < pairs.size(); ++i) {
    const Eigen::Vector3d source = pairs[i].source - source_mean;
    covariance += weights[i] * (pairs[i].target - target_mean) * source.transpose();
    variance += weights[i] * source.squaredNorm();
  }
  if (!(variance > 0)) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d sign(1, 1, 1);
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) sign.z() = -1;
  Similarity3d fit;
  fit.rotation = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  fit.scale = svd.singularValues().dot(sign) / variance;
  if (!(fit.scale > 0)) return std::nullopt;
  fit.translation = target_mean - fit.scale * (fit.rotation * source_mean);
  return fit;
}

std::vector<double> Residuals(const std::vector<PointPair>& pairs, const Similarity3d& fit) {
  std::vector<double> residuals;
  for (const PointPair& pair : pairs) residuals.push_back((fit * pair.source - pair.target).norm());
  return residuals;
}

// By the accuracy of each pair, up to one factor.
std::vector<double> ScaledResiduals(const std::vector<PointPair>& pairs, const Similarity3d& fit) {
  std::vector<double> scaled = Residuals(pairs, fit);
  for (size_t i = 0; i < pairs.size(); ++i) scaled[i] *= std::sqrt(pairs[i].weight);
  return scaled;
}

std::vector<double> GivenWeights(const std::vector<PointPair>& pairs) {
  std::vector<double> weights;
  for (const PointPair& pair : pairs) weights.push_back(pair.weight);
  return weights;
}

// The median, or a greater one of few: the residual that tells noise from wrong pairs. Of few, so
// many are known to be wrong.
double TypicalResidual(std::vector<double> residuals, size_t num_wrong = 0) {
  const size_t last = residuals.size() - 1 - num_wrong;
  const size_t place = std::max(residuals.size() / 2, std::min(last, kMinBelowTypical));
  const auto typical = residuals.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(residuals.begin(), typical, residuals.end());
  return *typical;
}

// The best of those of three pairs each and of the one of all pairs.
std::optional<Similarity3d> BestStart(const std::vector<PointPair>& pairs) {
  std::optional<Similarity3d> best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const std::optional<Similarity3d>& fit) {
    if (!fit) return;
    const double typical = TypicalResidual(ScaledResiduals(pairs, *fit));
    if (!(typical < least)) return;
    least = typical;
    best = fit;
  };
  consider(FitWeighted(pairs, GivenWeights(pairs)));
  std::mt19937 random(1);
  for (int k = 0; k < kNumSamples; ++k) {
    const std::vector<PointPair> sample = RandomSample(pairs, 3, &random);
    consider(FitWeighted(sample, GivenWeights(sample)));
  }
  return best;
}

std::vector<PointPair> Without(size_t wrong, std::vector<PointPair> pairs) {
  pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(wrong));
  return pairs;
}

// The fit to all of a few pairs but one, if that is wrong.
std::optional<Similarity3d> FitWithoutWrong(const std::vector<PointPair>& pairs,
                                            const Similarity3d& fit_to_all) {
  if (pairs.size() <= kMinPositions || pairs.size() > kMinBelowTypical + 1) return std::nullopt;
  double least = TypicalResidual(ScaledResiduals(pairs, fit_to_all)) / kFallWithoutWrong;
  std::optional<Similarity3d> best;
  for (size_t wrong = 0; wrong < pairs.size(); ++wrong) {
    const std::vector<PointPair> others = Without(wrong, pairs);
    const auto fit = FitWeighted(others, GivenWeights(others));
    if (!fit) continue;
    const double typical = TypicalResidual(ScaledResiduals(others, *fit));
    if (!(typical < least)) continue;
    least = typical;
    best = fit;
  }
  return best;
}

// What rounding may leave of a scaled residual, however well the pairs fit.
double RoundingOf(const std::vector<PointPair>& pairs, const Similarity3d& fit) {
  constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
  double rounding = 0;
  for (const PointPair& pair : pairs) {
    const double size = std::max(pair.target.norm(), fit.translation.norm());
    rounding = std::max(rounding, kRounding * size * std::sqrt(pair.weight));
  }
  return rounding;
}

std::vector<double> RobustWeights(const std::vector<PointPair>& pairs,
                                  const std::vector<double>& residuals, double rounding,
                                  size_t num_wrong) {
  // Along each axis.
  const double sigma = TypicalResidual(residuals, num_wrong) / kMedianDistance;
  const double limit = std::max(kOutlierSigmas * sigma, rounding);
  std::vector<double> weights;
  for (size_t i = 0; i < pairs.size(); ++i) {
    weights.push_back(residuals[i] <= limit ? pairs[i].weight : 0);
  }
  return weights;
}

// From the spread of the targets around their middle, and what the fit leaves, of the pairs that
// were not rejected.
void SetErrors(const std::vector<PointPair>& pairs, const std::vector<double>& weights,
               PositionFit* fit) {
  double sum = 0, squares = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < pairs.size(); ++i) {
    sum += weights[i];
    squares += weights[i] * fit->residuals[i] * fit->residuals[i];
    mean += weights[i] * (fit->target_from_source * pairs[i].source);
  }
  mean /= sum;
  const auto count = static_cast<double>(weights.size() - fit->num_rejected);
  // Seven numbers were fitted.
  const double variance = squares / sum * count / std::max(3 * count - 7, 1.0);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double spread = 0;
  for (size_t i = 0; i < pairs.size(); ++i) {
    const Eigen::Vector3d at = fit->target_from_source * pairs[i].source - mean;
    const double weight = weights[i] / sum * count;
    information += weight * (at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose());
    spread += weight * at.squaredNorm();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(information);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = eigen.eigenvalues()[k];
    const bool is_open = !(value > 1e-9 * eigen.eigenvalues()[2]);
    const double angle2 = is_open ? M_PI * M_PI : std::min(variance / value, M_PI * M_PI);
    covariance += angle2 * eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).transpose();
  }
  fit->up_error_rad = std::sqrt(covariance(0, 0) + covariance(1, 1));
  fit->heading_error_rad = std::sqrt(covariance(2, 2));
  fit->scale_error = std::sqrt(variance / spread);
}

}  // namespace

std::optional<PositionFit> FitPositions(const std::vector<PointPair>& pairs) {
  if (pairs.size() < kMinPositions) return std::nullopt;
  std::optional<Similarity3d> best = BestStart(pairs);
  if (!best) return std::nullopt;
  const std::optional<Similarity3d> without_wrong = FitWithoutWrong(pairs, *best);
  const size_t num_wrong = without_wrong ? 1 : 0;
  PositionFit fit;
  fit.target_from_source = without_wrong.value_or(*best);
  const double rounding = RoundingOf(pairs, fit.target_from_source);
  std::vector<double> weights;
  for (int k = 0; k < kNumIterations; ++k) {
    weights =
        RobustWeights(pairs, ScaledResiduals(pairs, fit.target_from_source), rounding, num_wrong);
    const std::optional<Similarity3d> next = FitWeighted(pairs, weights);
    if (!next) break;
    fit.target_from_source = *next;
  }
  fit.residuals = Residuals(pairs, fit.target_from_source);
  fit.scaled_residuals = ScaledResiduals(pairs, fit.target_from_source);
  fit.median_residual = Median(fit.residuals);
  fit.typical_scaled_residual = TypicalResidual(fit.scaled_residuals, num_wrong);
  for (const double weight : weights) fit.is_rejected.push_back(weight == 0 ? 1 : 0);
  fit.num_rejected = static_cast<size_t>(std::count(weights.begin(), weights.end(), 0.0));
  SetErrors(pairs, weights, &fit);
  return fit;
}

}  // namespace limn
