// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/parallel_lines.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "limn/geometry/tangent_frame.h"

namespace limn {
namespace {

using Matrix32 = Eigen::Matrix<double, 3, 2>;

constexpr size_t kMaxHypotheses = 1000;
constexpr int kDirectionRefinements = 3;
constexpr double kMinCosine = 0.95;
// Errors that all lines share, such as those of the cameras, px: no class is more accurate than
// this makes its longest line.
constexpr double kCommonErrorPx = 0.1;
// Perpendicular classes are so within this many standard deviations.
constexpr double kMaxDeviations = 4;

// The direction as the chord of a line that best suits it.
Eigen::Vector3d ChordAlong(const LineEvidence& line, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d weighted = line.chord_information * direction;
  return weighted.dot(line.Chord()) / weighted.dot(direction) * direction;
}

// Information of rotations of the direction of a line, 1/rad^2, with the best length.
Eigen::Matrix2d AngleInformation(const LineEvidence& line, const Eigen::Vector3d& direction,
                                 const Matrix32& frame) {
  const Eigen::Matrix3d& s = line.chord_information;
  const Eigen::Vector3d weighted = s * direction;
  const Eigen::Matrix3d profile = s - weighted * weighted.transpose() / weighted.dot(direction);
  return ChordAlong(line, direction).squaredNorm() * frame.transpose() * profile * frame;
}

// What a line's own direction takes to tell, in nats: a hemisphere in cells of its uncertainty.
double OwnDirectionCost(const LineEvidence& line) {
  const Eigen::Vector3d direction = line.Chord().normalized();
  const double determinant =
      AngleInformation(line, direction, TangentFrame(direction)).determinant();
  return std::max(0.0, 0.5 * std::log(std::max(determinant, 1.0)));
}

struct Member {
  int line;
  double gain;
};

class ClassFinder {
 public:
  ClassFinder(const std::vector<LineEvidence>& lines, const RegularityOptions& options)
      : lines_(lines), options_(options), is_free_(lines.size(), true) {
    for (const LineEvidence& line : lines) own_cost_.push_back(OwnDirectionCost(line));
    for (size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].length_px >= kMinRegularLengthPx) hypotheses_.push_back(static_cast<int>(i));
    }
    std::stable_sort(hypotheses_.begin(), hypotheses_.end(),
                     [&](int a, int b) { return lines_[a].length_px > lines_[b].length_px; });
    num_lines_ = std::max<double>(2, static_cast<double>(hypotheses_.size()));
    if (hypotheses_.size() > kMaxHypotheses) hypotheses_.resize(kMaxHypotheses);
  }

  // The class that saves most; without lines if none saves anything.
  DirectionClass Next() {
    DirectionClass best;
    double best_gain = 0;
    for (const int hypothesis : hypotheses_) {
      if (!is_free_[hypothesis]) continue;
      const Eigen::Vector3d direction = lines_[hypothesis].Chord().normalized();
      const double gain = Gain(MembersOf(direction, 1));
      if (gain <= best_gain) continue;
      best_gain = gain;
      best.direction = direction;
    }
    if (best_gain <= 0) return best;
    std::vector<Member> members = MembersOf(best.direction, 1);
    for (int k = 0; k < kDirectionRefinements; ++k) {
      const Eigen::Vector3d refined = Refined(best.direction, members);
      std::vector<Member> more = MembersOf(refined, members.size());
      if (Gain(more) < Gain(members)) break;
      best.direction = refined;
      members = std::move(more);
    }
    return Take(best.direction, members);
  }

 private:
  // To name a direction that `count` lines have takes the less, the more there are.
  std::vector<Member> MembersOf(const Eigen::Vector3d& direction, size_t count) const {
    const double name_cost = std::log(num_lines_ / static_cast<double>(count));
    std::vector<Member> members;
    for (size_t i = 0; i < lines_.size(); ++i) {
      if (!is_free_[i] || lines_[i].length_px < kMinRegularLengthPx) continue;
      // Most lines are far from it.
      if (std::abs(lines_[i].Chord().dot(direction)) < kMinCosine * lines_[i].Chord().norm()) {
        continue;
      }
      const DirectionCost cost = CostOfDirection(lines_[i], direction);
      const double gain = own_cost_[i] - name_cost - 0.5 * cost.chi_square;
      if (gain > 0 && cost.shift_px <= options_.max_shift_px) {
        members.push_back({static_cast<int>(i), gain});
      }
    }
    return members;
  }

  double Gain(const std::vector<Member>& members) const {
    if (members.size() < 2) return 0;
    double sum = 0, dearest = 0;
    for (const Member& member : members) {
      sum += member.gain;
      dearest = std::max(dearest, own_cost_[member.line]);
    }
    return sum - dearest;
  }

  // The least squares of the members, of small rotations.
  Eigen::Vector3d Refined(const Eigen::Vector3d& direction,
                          const std::vector<Member>& members) const {
    const Matrix32 frame = TangentFrame(direction);
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const Member& member : members) {
      const LineEvidence& line = lines_[member.line];
      const Eigen::Vector3d chord = ChordAlong(line, direction);
      const double length = chord.dot(direction);  // with the sense of the line
      normal += AngleInformation(line, direction, frame);
      right += length * frame.transpose() * line.chord_information * (line.Chord() - chord);
    }
    return (direction + frame * normal.ldlt().solve(right)).normalized();
  }

  DirectionClass Take(const Eigen::Vector3d& direction, const std::vector<Member>& members) {
    DirectionClass result;
    result.direction = direction;
    const Matrix32 frame = TangentFrame(direction);
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    for (const Member& member : members) {
      is_free_[member.line] = false;
      result.lines.push_back(member.line);
      result.longest_px = std::max(result.longest_px, lines_[member.line].length_px);
      information += AngleInformation(lines_[member.line], direction, frame);
    }
    const double common = 2 * kCommonErrorPx / result.longest_px;
    const Eigen::Matrix2d covariance =
        information.inverse() + common * common * Eigen::Matrix2d::Identity();
    result.covariance = frame * covariance * frame.transpose();
    return result;
  }

  const std::vector<LineEvidence>& lines_;
  const RegularityOptions& options_;
  std::vector<bool> is_free_;
  std::vector<double> own_cost_;
  double num_lines_ = 2;  // that are long enough
  std::vector<int> hypotheses_;
};

}  // namespace

DirectionCost CostOfDirection(const LineEvidence& line, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d offset = ChordAlong(line, direction) - line.Chord();
  return {offset.dot(line.chord_information * offset),
          0.5 * std::sqrt(offset.dot(line.metric * offset))};
}

std::vector<DirectionClass> FindParallelLines(const std::vector<LineEvidence>& lines,
                                              const RegularityOptions& options) {
  ClassFinder finder(lines, options);
  std::vector<DirectionClass> classes;
  for (DirectionClass next = finder.Next(); !next.lines.empty(); next = finder.Next()) {
    classes.push_back(std::move(next));
  }
  return classes;
}

void FindOrthogonalClasses(const RegularityOptions& options, std::vector<DirectionClass>* classes) {
  const int count = static_cast<int>(classes->size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      DirectionClass& first = (*classes)[a];
      DirectionClass& second = (*classes)[b];
      const double sine =
          first.direction.dot(second.direction);  // of what is missing to 90 degrees
      const double variance_a = second.direction.dot(first.covariance * second.direction);
      const double variance_b = first.direction.dot(second.covariance * first.direction);
      const double sigma = std::sqrt(variance_a + variance_b);
      if (!(std::abs(sine) <= kMaxDeviations * sigma)) continue;
      // Any other angle takes log(1 / sigma) to tell, this one the name of the pair.
      const double saved = std::log(1 / sigma) - std::log(std::max(2.0, 0.5 * count * (count - 1)));
      if (saved <= 0.5 * sine * sine / (sigma * sigma)) continue;
      // Each turns as it is uncertain.
      const double turn_a = std::abs(sine) * variance_a / (sigma * sigma);
      const double turn_b = std::abs(sine) * variance_b / (sigma * sigma);
      if (std::max(turn_a * first.longest_px, turn_b * second.longest_px) >
          2 * options.max_shift_px) {
        continue;
      }
      first.orthogonal_to.push_back(b);
      second.orthogonal_to.push_back(a);
    }
  }
}

}  // namespace limn
