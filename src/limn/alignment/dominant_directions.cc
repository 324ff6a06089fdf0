// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/dominant_directions.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limn/util/angles.h"

namespace limn {
namespace {

// How far a vertical may be from the hint: the other directions of a building are 90 degrees away.
constexpr double kMaxFromHintRad = 45 * kDeg;
// Lines that are more nearly parallel have no certain normal.
const double kMinPairingSine = std::sin(10 * kDeg);
// Of the heaviest lines, how many make hypotheses in pairs.
constexpr size_t kNumPairing = 40;
// Standard deviations of lines from the direction they follow: to find it, then to make it exact.
constexpr double kSigmasRad[] = {1.5 * kDeg, 1 * kDeg, 0.5 * kDeg};
// Shares of lines expected to be vertical and horizontal.
constexpr double kShareVertical = 0.2, kShareHorizontal = 0.2;
// What the lines must weigh, in equal lines, times the logarithm of their likelihood ratio.
constexpr double kMinEvidence = 10;

// Likelihood, relative to lines of any direction, of a line at this sine of the angle to the
// vertical that is vertical: Gaussian on the sphere.
double VerticalRatio(double sine, double sigma) {
  return std::exp(-0.5 * std::pow(sine / sigma, 2)) / (sigma * sigma);
}

// The same of a line at this sine of the angle to the horizontal.
double HorizontalRatio(double sine, double sigma) {
  return std::exp(-0.5 * std::pow(sine / sigma, 2)) * std::sqrt(2 / M_PI) / sigma;
}

// What a line is, as far as its direction tells.
struct Posture {
  double vertical = 0, horizontal = 0;  // probabilities
  double log_ratio = 0;                 // of the likelihood to that of lines of any direction
};

Posture PostureOf(const StraightLine& line, const Eigen::Vector3d& up, double sigma) {
  const double cosine = line.direction.dot(up);
  const double vertical = kShareVertical * VerticalRatio(line.direction.cross(up).norm(), sigma);
  const double horizontal = kShareHorizontal * HorizontalRatio(cosine, sigma);
  const double sum = 1 - kShareVertical - kShareHorizontal + vertical + horizontal;
  return {vertical / sum, horizontal / sum, std::log(sum)};
}

double SumOfWeights(const std::vector<StraightLine>& lines) {
  double sum = 0;
  for (const StraightLine& line : lines) sum += line.weight;
  return sum;
}

double LogRatio(const std::vector<StraightLine>& lines, const Eigen::Vector3d& up, double sigma) {
  double sum = 0;
  for (const StraightLine& line : lines) sum += line.weight * PostureOf(line, up, sigma).log_ratio;
  return sum / SumOfWeights(lines);
}

// How many lines of the same weight tell as much.
double EffectiveCount(const std::vector<StraightLine>& lines) {
  double squares = 0;
  for (const StraightLine& line : lines) squares += line.weight * line.weight;
  return std::pow(SumOfWeights(lines), 2) / squares;
}

std::vector<Eigen::Vector3d> Candidates(const std::vector<StraightLine>& lines,
                                        const Eigen::Vector3d& hint) {
  std::vector<Eigen::Vector3d> candidates;
  const auto consider = [&](Eigen::Vector3d direction) {
    if (direction.dot(hint) < 0) direction = -direction;
    if (direction.dot(hint) > std::cos(kMaxFromHintRad)) candidates.push_back(direction);
  };
  for (const StraightLine& line : lines) consider(line.direction);
  const size_t count = std::min(lines.size(), kNumPairing);
  for (size_t i = 0; i < count; ++i) {
    for (size_t k = i + 1; k < count; ++k) {
      const Eigen::Vector3d normal = lines[i].direction.cross(lines[k].direction);
      if (normal.norm() > kMinPairingSine) consider(normal.normalized());
    }
  }
  return candidates;
}

// Nearest to the vertical lines, and to the normals of the horizontal ones.
Eigen::Vector3d Refined(const std::vector<StraightLine>& lines, const Eigen::Vector3d& up,
                        double sigma) {
  Eigen::Matrix3d deviations = Eigen::Matrix3d::Zero();
  for (const StraightLine& line : lines) {
    const Posture posture = PostureOf(line, up, sigma);
    const Eigen::Matrix3d along = line.direction * line.direction.transpose();
    deviations += line.weight * posture.vertical * (Eigen::Matrix3d::Identity() - along);
    deviations += line.weight * posture.horizontal * along;
  }
  const Eigen::Vector3d least =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(deviations).eigenvectors().col(0);
  return least.dot(up) < 0 ? -least : least;
}

struct Weighted {
  double value = 0, weight = 0;
};

// The value below which this share of the weight is.
double Quantile(std::vector<Weighted> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double left = 0;
  for (const Weighted& value : values) left += share * value.weight;
  for (const Weighted& value : values) {
    left -= value.weight;
    if (left <= 0) return value.value;
  }
  return values.back().value;
}

DominantDirection DescribeVertical(const std::vector<StraightLine>& lines,
                                   const Eigen::Vector3d& up) {
  std::vector<Weighted> deviations;
  double share = 0;
  for (const StraightLine& line : lines) {
    const Posture posture = PostureOf(line, up, kSigmasRad[0]);
    const bool is_vertical = posture.vertical > posture.horizontal;
    const double sine = is_vertical ? line.direction.cross(up).norm() : line.direction.dot(up);
    const double weight = line.weight * (posture.vertical + posture.horizontal);
    deviations.push_back({std::asin(std::min(std::abs(sine), 1.0)), weight});
    share += weight;
  }
  return {up, Quantile(deviations, 0.5), share / SumOfWeights(lines)};
}

// Lines that are this far from horizontal do not count for directions and levels.
constexpr double kMaxSlopeRad = 3 * kDeg;
// Standard deviation of horizontal lines from the main direction.
constexpr double kHeadingSigmaRad = 1.5 * kDeg;
constexpr double kHeadingStepRad = 0.5 * kDeg;
constexpr int kHeadingRounds = 10;
// The main direction must have this many times the weight expected if there were none.
constexpr double kMinTimesChance = 3;
// A level is this high, of the height of the drawing, and has this share of the horizontal lines.
constexpr double kLevelHeight = 0.02, kLevelShare = 0.05;

std::vector<StraightLine> HorizontalLines(const std::vector<StraightLine>& lines,
                                          const Eigen::Vector3d& up) {
  std::vector<StraightLine> horizontal;
  for (const StraightLine& line : lines) {
    if (std::abs(line.direction.dot(up)) < std::sin(kMaxSlopeRad)) horizontal.push_back(line);
  }
  return horizontal;
}

// To the nearest of the four directions at right angles, from -45 to 45 degrees.
double QuarterTurn(double angle_rad) { return std::remainder(angle_rad, M_PI / 2); }

double WeightNear(const std::vector<Weighted>& angles, double heading) {
  double sum = 0;
  for (const Weighted& angle : angles) {
    const double ratio = QuarterTurn(angle.value - heading) / kHeadingSigmaRad;
    sum += angle.weight * std::exp(-0.5 * ratio * ratio);
  }
  return sum;
}

double RefinedHeading(const std::vector<Weighted>& angles, double heading) {
  double sum = 0, turned = 0;
  for (const Weighted& angle : angles) {
    const double difference = QuarterTurn(angle.value - heading);
    const double ratio = difference / kHeadingSigmaRad;
    const double weight = angle.weight * std::exp(-0.5 * ratio * ratio);
    sum += weight;
    turned += weight * difference;
  }
  return sum > 0 ? heading + turned / sum : heading;
}

}  // namespace

std::optional<DominantDirection> FindVertical(const std::vector<StraightLine>& lines,
                                              const Eigen::Vector3d& hint) {
  if (!(SumOfWeights(lines) > 0)) return std::nullopt;
  Eigen::Vector3d best = hint;
  double most = LogRatio(lines, hint, kSigmasRad[0]);
  for (const Eigen::Vector3d& candidate : Candidates(lines, hint)) {
    const double ratio = LogRatio(lines, candidate, kSigmasRad[0]);
    if (ratio <= most) continue;
    most = ratio;
    best = candidate;
  }
  if (most * EffectiveCount(lines) < kMinEvidence) return std::nullopt;
  for (const double sigma : kSigmasRad) {
    for (int k = 0; k < 5; ++k) best = Refined(lines, best, sigma);
  }
  return DescribeVertical(lines, best);
}

std::optional<DominantDirection> FindHorizontal(const std::vector<StraightLine>& lines,
                                                const Eigen::Vector3d& up,
                                                const Eigen::Vector3d& reference) {
  const Eigen::Vector3d x = (reference - up * up.dot(reference)).normalized();
  const Eigen::Vector3d y = up.cross(x);
  std::vector<Weighted> angles;
  for (const StraightLine& line : HorizontalLines(lines, up)) {
    angles.push_back({std::atan2(line.direction.dot(y), line.direction.dot(x)), line.weight});
  }
  double most = 0, heading = 0, sum = 0;
  for (const Weighted& angle : angles) sum += angle.weight;
  for (double candidate = -M_PI / 4; candidate < M_PI / 4; candidate += kHeadingStepRad) {
    const double weight = WeightNear(angles, candidate);
    if (weight <= most) continue;
    most = weight;
    heading = candidate;
  }
  const double chance = kHeadingSigmaRad * std::sqrt(2 * M_PI) / (M_PI / 2);
  if (!(most > kMinTimesChance * chance * sum)) return std::nullopt;
  for (int k = 0; k < kHeadingRounds; ++k) heading = RefinedHeading(angles, heading);
  heading = QuarterTurn(heading);
  std::vector<Weighted> deviations;
  for (const Weighted& angle : angles) {
    const double deviation = std::abs(QuarterTurn(angle.value - heading));
    if (deviation < 3 * kHeadingSigmaRad) deviations.push_back({deviation, angle.weight});
  }
  return DominantDirection{x * std::cos(heading) + y * std::sin(heading), Quantile(deviations, 0.5),
                           most / sum};
}

std::optional<double> FloorHeight(const std::vector<StraightLine>& lines,
                                  const Eigen::Vector3d& up) {
  std::vector<Weighted> heights, levels;
  for (const StraightLine& line : lines) heights.push_back({line.middle.dot(up), line.weight});
  for (const StraightLine& line : HorizontalLines(lines, up)) {
    levels.push_back({line.middle.dot(up), line.weight});
  }
  const double height = kLevelHeight * (Quantile(heights, 0.99) - Quantile(heights, 0.01));
  std::sort(levels.begin(), levels.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double all = 0;
  for (const Weighted& level : levels) all += level.weight;
  double inside = 0;
  for (auto end = levels.begin(), begin = end; end != levels.end(); ++end) {
    inside += end->weight;
    for (; end->value - begin->value > height; ++begin) inside -= begin->weight;
    if (inside <= kLevelShare * all) continue;
    // The lowest lines alone, which crossed the limit, are below the middle of their level.
    const auto top = std::find_if(end, levels.end(), [&](const Weighted& line) {
      return line.value - begin->value > height;
    });
    return Quantile({begin, top}, 0.5);
  }
  return std::nullopt;
}

}  // namespace limn
