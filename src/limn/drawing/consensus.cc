// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/consensus.h"

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

// How the constants were chosen: algorithm/drawing.md#what-was-measured.
constexpr int kConsensusRounds = 3;
// A sample that moves by less has settled, px.
constexpr double kSettledPx = 0.02;
// Samples farther than this in space, px, or at a larger angle do not count.
constexpr double kSearchPx = 5;
const double kMinConsensusCosine = std::cos(20 * kDeg);
// Standard deviations of the weights of samples: across the curve as the images see it, and along.
constexpr double kConsensusAcrossPx = 0.5;
constexpr double kAlongPx = 2.5;
// Samples farther away than this many of them do not weigh.
constexpr double kMaxSigmas = 3;
// Nor do samples farther than this across the curve, which do not agree either.
constexpr double kMaxAcrossPx = kMaxSigmas * kConsensusAcrossPx;
// Samples within this distance along the curve agree, px.
constexpr double kAgreeAlongPx = 1.5;
// By how much samples may move, px, and turn before they meet neighbors that were not listed.
constexpr double kSlackPx = 2;
const double kMinListedCosine = std::cos(35 * kDeg);
// Samples that one thread handles at a time.
constexpr int kChunk = 256;
// Successive samples up to this far from the first, px, and up to this many share a look-up.
constexpr double kGroupPx = 6;
constexpr int kGroupSize = 8;

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

// The samples that may be neighbors of each sample of a chunk.
struct Lists {
  std::vector<int> samples;
  std::vector<size_t> end;  // per sample of the chunk
};

// Sample ids [begin, end).
struct IdRange {
  int begin = 0;
  int end = 0;
};

class Climb {
 public:
  Climb(const SampleSet& samples, const ReprojectedMetric& metric)
      : samples_(samples),
        metric_(metric),
        consensus_{samples.position, samples.tangent, std::vector<int>(samples.NumSamples())},
        settled_(samples.NumSamples(), 0) {}

  Consensus Run(const RunContext& context) {
    ListNeighbors(context);
    std::vector<Place> next(samples_.NumSamples());
    for (int round = 0; round < kConsensusRounds; ++round) {
      const auto is_climbing = [&](int s) { return !settled_[s]; };
      ForEachSample(is_climbing, kSearchPx, context,
                    [&](int s, const std::vector<Neighbor>& near) { next[s] = Mean(s, near); });
      for (int s = 0; s < samples_.NumSamples(); ++s) {
        if (!settled_[s]) settled_[s] = !Move(s, next[s]);
      }
    }
    const auto all = [](int) { return true; };
    ForEachSample(all, kAgreeAlongPx, context, [&](int s, const std::vector<Neighbor>& near) {
      consensus_.num_views[s] = CountViews(near);
    });
    return std::move(consensus_);
  }

 private:
  // Returns whether the sample moved by more than it may when it has settled.
  bool Move(int s, const Place& to) {
    const double moved = (to.position - consensus_.position[s]).norm();
    consensus_.position[s] = to.position;
    consensus_.tangent[s] = to.tangent;
    return moved > kSettledPx * samples_.footprint[s];
  }

  // The samples of a chunk.
  IdRange Chunk(size_t chunk) const {
    const int begin = kChunk * static_cast<int>(chunk);
    return {begin, std::min(begin + kChunk, samples_.NumSamples())};
  }

  template <typename Visit>
  void ForEachChunk(const RunContext& context, const Visit& visit) const {
    ParallelFor(context, "consensus", lists_.size(), visit);
  }

  // Finds, per sample, those that may be its neighbors until it has moved by more than the
  // slack: a wider search than that for neighbors, done once.
  void ListNeighbors(const RunContext& context) {
    lists_.resize((samples_.NumSamples() + kChunk - 1) / kChunk);
    const SpatialIndex index(consensus_.position);
    ForEachChunk(context, [&](size_t chunk) {
      Lists& lists = lists_[chunk];
      std::vector<SpatialIndex::Neighbor> around;
      for (IdRange left = Chunk(chunk); left.begin < left.end;) {
        const IdRange group = {left.begin, EndOfGroup(left)};
        FindAround(group, index, &around);
        for (int s = group.begin; s < group.end; ++s) {
          ListNeighborsOf(s, around, &lists.samples);
          lists.end.push_back(lists.samples.size());
        }
        left.begin = group.end;
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

  // Calls visit(sample, neighbors up to max_along_px along the curve) for those that are wanted,
  // each sample being its own neighbor.
  template <typename Wanted, typename Visit>
  void ForEachSample(const Wanted& is_wanted, double max_along_px, const RunContext& context,
                     const Visit& visit) const {
    ForEachChunk(context, [&](size_t chunk) {
      const Lists& lists = lists_[chunk];
      const IdRange chosen = Chunk(chunk);
      std::vector<Neighbor> near;
      size_t begin = 0;
      for (int s = chosen.begin; s < chosen.end; ++s) {
        const size_t end = lists.end[s - chosen.begin];
        const std::span listed(lists.samples.data() + begin, end - begin);
        begin = end;
        if (!is_wanted(s)) continue;
        FindNeighbors(s, listed, max_along_px, &near);
        visit(s, near);
      }
    });
  }

  // One past the last of the samples that are, from the first on, near each other.
  int EndOfGroup(const IdRange& chosen) const {
    const double reach = kGroupPx * samples_.footprint[chosen.begin];
    const Eigen::Vector3d& first = consensus_.position[chosen.begin];
    const int last = std::min(chosen.begin + kGroupSize, chosen.end);
    int end = chosen.begin + 1;
    while (end < last && (consensus_.position[end] - first).norm() < reach) ++end;
    return end;
  }

  // Finds all samples within the search radius and the slack of any of a group, and a few more.
  void FindAround(const IdRange& group, const SpatialIndex& index,
                  std::vector<SpatialIndex::Neighbor>* around) const {
    const Eigen::Vector3d center =
        0.5 * (consensus_.position[group.begin] + consensus_.position[group.end - 1]);
    double radius = 0;
    for (int s = group.begin; s < group.end; ++s) {
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
      if (squared_sigmas > kMaxSigmas * kMaxSigmas) continue;
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
  std::vector<uint8_t> settled_;  // per sample
  std::vector<Lists> lists_;      // per chunk
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
