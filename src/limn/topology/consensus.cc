#include "limn/topology/consensus.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "limn/geometry/spatial_index.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// The constants were chosen on day, room, midday and mixed (ALGORITHM.md 22.2).
constexpr int kConsensusRounds = 5;
// A sample that moves by less has settled, px.
constexpr double kSettledPx = 0.02;
// Samples farther than this in space, px, or at a larger angle do not count.
constexpr double kSearchPx = 5;
const double kMinConsensusCosine = std::cos(20 * kDeg);
// Standard deviations of the weights of samples: across the curve as the images see it, and along.
constexpr double kConsensusAcrossPx = 0.5;
constexpr double kAlongPx = 2.5;
// Samples farther than this across the curve neither weigh, being three deviations away, nor agree.
constexpr double kMaxAcrossPx = 3 * kConsensusAcrossPx;
// Samples within this distance along the curve agree, px.
constexpr double kAgreeAlongPx = 1.5;
// By how much samples may move, px, and turn before they meet neighbors that were not listed.
constexpr double kSlackPx = 2;
const double kMinListedCosine = std::cos(35 * kDeg);
// Samples that one thread handles at a time.
constexpr size_t kChunk = 256;
// Successive climbers up to this far from the first, px, and up to this many share a look-up.
constexpr double kGroupPx = 6;
constexpr size_t kGroupSize = 8;

struct Place {
  Eigen::Vector3d position;
  Eigen::Vector3d tangent;
};

// A sample that runs along another.
struct Neighbor {
  int sample = -1;
  double along_px = 0;
  double squared_px = 0;  // across
  Eigen::Vector3d across;
  Eigen::Vector3d tangent;  // in the direction of the other's
};

// The samples that may be neighbors of each climber of a chunk.
struct Lists {
  std::vector<int> samples;
  std::vector<size_t> end;  // per climber
};

class Climb {
 public:
  Climb(const SampleSet& samples, const ReprojectedMetric& metric)
      : samples_(samples),
        metric_(metric),
        consensus_{samples.position, samples.tangent, std::vector<int>(samples.NumSamples())},
        settled_(samples.NumSamples(), 0) {}

  Consensus Run(const RunContext& context) {
    ChooseClimbers();
    ListNeighbors(context);
    std::vector<Place> next(samples_.NumSamples());
    for (int round = 0; round < kConsensusRounds; ++round) {
      const auto is_climbing = [&](int s) { return !settled_[s]; };
      ForEachClimber(is_climbing, kSearchPx, context,
                     [&](int s, const std::vector<Neighbor>& near) { next[s] = Mean(s, near); });
      for (const int s : climbers_) {
        if (!settled_[s]) settled_[s] = !Move(s, next[s]);
      }
      MoveBetweenClimbers();
    }
    const auto all = [](int) { return true; };
    ForEachClimber(all, kAgreeAlongPx, context, [&](int s, const std::vector<Neighbor>& near) {
      consensus_.num_views[s] = CountViews(near);
    });
    ForEachBetween([&](int s) {
      consensus_.num_views[s] = std::min(consensus_.num_views[s - 1], consensus_.num_views[s + 1]);
    });
    return std::move(consensus_);
  }

 private:
  // Every second sample of a curve, and its last.
  void ChooseClimbers() {
    for (int c = 0; c < samples_.NumCurves(); ++c) {
      const int end = samples_.curve_begin[c + 1];
      for (int s = samples_.curve_begin[c]; s < end; s += 2) climbers_.push_back(s);
      if (samples_.Size(c) % 2 == 0) climbers_.push_back(end - 1);
    }
  }

  // Calls visit(sample) for those that do not climb. Both neighbors on the curve do.
  template <typename Visit>
  void ForEachBetween(const Visit& visit) const {
    for (int c = 0; c < samples_.NumCurves(); ++c) {
      const int end = samples_.curve_begin[c + 1];
      for (int s = samples_.curve_begin[c] + 1; s + 1 < end; s += 2) visit(s);
    }
  }

  // Onto the cubic curve through the two beside them that has their tangents, where its chord comes
  // nearest to the sample.
  void MoveBetweenClimbers() {
    ForEachBetween([&](int s) {
      const Eigen::Vector3d& from = consensus_.position[s - 1];
      const Eigen::Vector3d chord = consensus_.position[s + 1] - from;
      const double length = chord.norm();
      if (!(length > 0)) return;
      const auto speed = [&](int at) -> Eigen::Vector3d {
        const Eigen::Vector3d& tangent = consensus_.tangent[at];
        return std::copysign(length, tangent.dot(chord)) * tangent;
      };
      const double share = (samples_.position[s] - from).dot(chord) / (length * length);
      const double t = std::clamp(share, 0.0, 1.0);
      const double u = 1 - t;
      consensus_.position[s] =
          from + t * t * (3 - 2 * t) * chord + t * u * (u * speed(s - 1) - t * speed(s + 1));
      const Eigen::Vector3d tangent = consensus_.tangent[s - 1] + consensus_.tangent[s + 1];
      if (!tangent.isZero(0)) consensus_.tangent[s] = tangent.normalized();
    });
  }

  // Returns whether the sample moved by more than it may when it has settled.
  bool Move(int s, const Place& to) {
    const double moved = (to.position - consensus_.position[s]).norm();
    consensus_.position[s] = to.position;
    consensus_.tangent[s] = to.tangent;
    return moved > kSettledPx * samples_.footprint[s];
  }

  // The climbers of a chunk.
  std::span<const int> Chunk(size_t chunk) const {
    const size_t begin = kChunk * chunk;
    return std::span(climbers_).subspan(begin, std::min(kChunk, climbers_.size() - begin));
  }

  template <typename Visit>
  void ForEachChunk(const RunContext& context, const Visit& visit) const {
    ParallelFor(context, "consensus", lists_.size(), visit);
  }

  // Finds, per climber, the samples that may be its neighbors until it has moved by more than the
  // slack: a wider search than that for neighbors, done once.
  void ListNeighbors(const RunContext& context) {
    lists_.resize((climbers_.size() + kChunk - 1) / kChunk);
    const SpatialIndex index(consensus_.position);
    ForEachChunk(context, [&](size_t chunk) {
      Lists& lists = lists_[chunk];
      std::vector<SpatialIndex::Neighbor> around;
      for (std::span<const int> left = Chunk(chunk); !left.empty();) {
        const std::span<const int> group = left.first(GroupSize(left));
        left = left.subspan(group.size());
        FindAround(group, index, &around);
        for (const int s : group) {
          ListNeighborsOf(s, around, &lists.samples);
          lists.end.push_back(lists.samples.size());
        }
      }
    });
  }

  void ListNeighborsOf(int s, const std::vector<SpatialIndex::Neighbor>& around,
                       std::vector<int>* listed) const {
    const Eigen::Vector3d& position = consensus_.position[s];
    const Eigen::Vector3d& tangent = consensus_.tangent[s];
    const double footprint = samples_.footprint[s];
    const double squared_radius = std::pow((kSearchPx + kSlackPx) * footprint, 2);
    const double max_along = (kSearchPx + 0.5 * kSlackPx) * footprint;
    for (const SpatialIndex::Neighbor& candidate : around) {
      const Eigen::Vector3d apart = consensus_.position[candidate.index] - position;
      if (apart.squaredNorm() > squared_radius) continue;
      if (std::abs(apart.dot(tangent)) > max_along) continue;
      if (std::abs(tangent.dot(consensus_.tangent[candidate.index])) < kMinListedCosine) continue;
      listed->push_back(candidate.index);
    }
  }

  // Calls visit(climber, neighbors up to max_along_px along the curve) for those that are wanted,
  // each sample being its own neighbor.
  template <typename Wanted, typename Visit>
  void ForEachClimber(const Wanted& is_wanted, double max_along_px, const RunContext& context,
                      const Visit& visit) const {
    ForEachChunk(context, [&](size_t chunk) {
      const Lists& lists = lists_[chunk];
      const std::span<const int> climbers = Chunk(chunk);
      std::vector<Neighbor> near;
      size_t begin = 0;
      for (size_t i = 0; i < climbers.size(); ++i) {
        const std::span listed(lists.samples.data() + begin, lists.end[i] - begin);
        begin = lists.end[i];
        if (!is_wanted(climbers[i])) continue;
        FindNeighbors(climbers[i], listed, max_along_px, &near);
        visit(climbers[i], near);
      }
    });
  }

  // How many of the samples, from the first on, are near each other.
  size_t GroupSize(std::span<const int> chosen) const {
    const double reach = kGroupPx * samples_.footprint[chosen[0]];
    const Eigen::Vector3d& first = consensus_.position[chosen[0]];
    size_t size = 1;
    while (size < std::min(kGroupSize, chosen.size()) &&
           (consensus_.position[chosen[size]] - first).norm() < reach) {
      ++size;
    }
    return size;
  }

  // Finds all samples within the search radius and the slack of any of a group, and a few more.
  void FindAround(std::span<const int> group, const SpatialIndex& index,
                  std::vector<SpatialIndex::Neighbor>* around) const {
    const Eigen::Vector3d center =
        0.5 * (consensus_.position[group.front()] + consensus_.position[group.back()]);
    double radius = 0;
    for (const int s : group) {
      radius = std::max(radius, (consensus_.position[s] - center).norm() +
                                    (kSearchPx + kSlackPx) * samples_.footprint[s]);
    }
    index.FindWithin(center, radius, around);
  }

  void FindNeighbors(int s, std::span<const int> listed, double max_along_px,
                     std::vector<Neighbor>* near) const {
    const Eigen::Vector3d& position = consensus_.position[s];
    const Eigen::Vector3d& tangent = consensus_.tangent[s];
    const double footprint = samples_.footprint[s];
    const double squared_radius = std::pow(kSearchPx * footprint, 2);
    near->clear();
    for (const int other : listed) {
      const Eigen::Vector3d apart = consensus_.position[other] - position;
      if (!(apart.squaredNorm() < squared_radius)) continue;
      const double along_px = apart.dot(tangent) / footprint;
      if (std::abs(along_px) > max_along_px) continue;
      const double cosine = tangent.dot(consensus_.tangent[other]);
      if (std::abs(cosine) < kMinConsensusCosine) continue;
      const Eigen::Vector3d other_tangent = std::copysign(1, cosine) * consensus_.tangent[other];
      const Eigen::Vector3d across = OffsetBetween(apart, tangent, other_tangent).across;
      const double own_part = 0.5 * metric_.Squared(s, across);
      if (own_part > kMaxAcrossPx * kMaxAcrossPx) continue;
      const double squared_px = own_part + 0.5 * metric_.Squared(other, across);
      if (squared_px > kMaxAcrossPx * kMaxAcrossPx) continue;
      near->push_back({other, along_px, squared_px, across, other_tangent});
    }
  }

  // The mean of the neighbors' places, weighted by distance and information.
  Place Mean(int s, const std::vector<Neighbor>& near) const {
    const Eigen::Matrix<double, 3, 2> across = TangentFrame(consensus_.tangent[s]);
    Eigen::Matrix2d sum = WeakInformation(samples_.footprint[s]) * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
    for (const Neighbor& neighbor : near) {
      const double squared_sigmas =
          neighbor.squared_px / (kConsensusAcrossPx * kConsensusAcrossPx) +
          neighbor.along_px * neighbor.along_px / (kAlongPx * kAlongPx);
      if (squared_sigmas > 9) continue;
      const double weight = std::exp(-0.5 * squared_sigmas);
      const Eigen::Matrix2d information =
          weight * across.transpose() * samples_.information[neighbor.sample] * across;
      sum += information;
      right += information * (across.transpose() * neighbor.across);
      tangent += weight * neighbor.tangent;
    }
    return {consensus_.position[s] + across * sum.inverse() * right, tangent.normalized()};
  }

  int CountViews(const std::vector<Neighbor>& near) const {
    std::vector<ViewId> views;
    for (const Neighbor& neighbor : near) {
      const ViewId view = samples_.origins[samples_.curve_of[neighbor.sample]].primary_view;
      if (std::ranges::find(views, view) == views.end()) views.push_back(view);
    }
    return static_cast<int>(views.size());
  }

  const SampleSet& samples_;
  const ReprojectedMetric& metric_;
  Consensus consensus_;
  std::vector<int> climbers_;
  std::vector<uint8_t> settled_;  // per sample
  std::vector<Lists> lists_;      // per chunk of climbers
};

}  // namespace

ReprojectedMetric::ReprojectedMetric(const SampleArrays& samples) {
  metric_.reserve(samples.position.size());
  for (int s = 0; s < samples.NumSamples(); ++s) {
    const Eigen::Vector3d& tangent = samples.tangent[s];
    Eigen::Matrix3d metric = samples.information[s];
    double largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(metric, Eigen::EigenvaluesOnly)
                         .eigenvalues()[2];
    if (!(largest > 0)) {
      metric = Eigen::Matrix3d::Identity() - tangent * tangent.transpose();
      largest = 1;
    }
    metric_.push_back(metric / (largest * samples.footprint[s] * samples.footprint[s]));
  }
}

Consensus FindConsensus(const SampleSet& samples, const ReprojectedMetric& metric,
                        const RunContext& context) {
  return Climb(samples, metric).Run(context);
}

}  // namespace limn
