// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/trace_curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "limn/drawing/consensus.h"
#include "limn/drawing/traced_graph.h"
#include "limn/geometry/spatial_index.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// A step looks for samples this far ahead, this far from the line, px, and within this angle.
constexpr double kTraceStepPx = 1;
constexpr double kMinAheadPx = 0.5;
constexpr double kTraceAcrossPx = 1;
const double kMinTraceCosine = std::cos(25 * kDeg);
// Samples up to this far behind the nearest one ahead decide where the step goes, px.
constexpr double kDepthPx = 1;
// Standard deviation of their weights across the curve, px.
constexpr double kWeightPx = 0.5;
// A vertex stands for samples within these distances, px.
constexpr double kClaimAcrossPx = 1.5;
constexpr double kClaimAlongPx = 0.6;
// Samples of this many vertices behind are not ahead, however a curve turns.
constexpr int kRecentVertices = 8;
// A curve whose end reaches one of its first vertices is closed.
constexpr int kNearStart = 4;
// Curves of fewer vertices are dropped.
constexpr int kMinVertices = 6;

// Instead of a vertex, the owner of a sample may be:
constexpr int kNobody = -1;
constexpr int kDropped = -2;  // a curve that was too short

// A sample beside or ahead of a vertex.
struct Candidate {
  int sample = -1;
  double along_px = 0;
  double squared_px = 0;    // across, as the images see it
  Eigen::Vector3d tangent;  // in the direction of the curve
};

class CurveTracer {
 public:
  CurveTracer(const SampleSet& samples, const ReprojectedMetric& metric, const Consensus& consensus,
              const TracingOptions& options)
      : samples_(samples),
        metric_(metric),
        consensus_(consensus),
        options_(options),
        index_(consensus.position),
        owner_(samples.NumSamples(), kNobody) {}

  TracedCurves Run(const RunContext& context) {
    for (const int seed : Seeds()) {
      if (owner_[seed] != kNobody) continue;
      ThrowIfCancelled(context);
      TraceFrom(seed);
    }
    return std::move(traced_);
  }

  int64_t NumUnclaimed() const {
    int64_t count = 0;
    for (int s = 0; s < samples_.NumSamples(); ++s) {
      if (owner_[s] < 0) count += samples_.InSketch(s).size();
    }
    return count;
  }

 private:
  // Those with most views first.
  std::vector<int> Seeds() const {
    std::vector<int> seeds;
    for (int s = 0; s < samples_.NumSamples(); ++s) {
      if (consensus_.num_views[s] >= options_.min_seed_views) seeds.push_back(s);
    }
    std::ranges::stable_sort(seeds, std::greater(), [&](int s) { return consensus_.num_views[s]; });
    return seeds;
  }

  void TraceFrom(int seed) {
    const size_t first = traced_.vertices.size();
    TracedCurve curve;
    curve.vertices = {
        AddVertex(consensus_.position[seed], consensus_.tangent[seed], samples_.footprint[seed])};
    Claim(curve.vertices[0], kClaimAlongPx);
    curve.meets[1] = Follow(&curve);
    const auto start = curve.vertices.begin() + std::min<size_t>(kNearStart, curve.vertices.size());
    if (std::find(curve.vertices.begin(), start, curve.meets[1]) != start) {
      curve.closed = true;
      curve.meets[1] = -1;
    } else {
      Turn(&curve);
      curve.meets[1] = Follow(&curve);
    }
    if (std::ssize(curve.vertices) >= kMinVertices) {
      traced_.curves.push_back(std::move(curve));
    } else {
      Drop(first);
    }
  }

  void Turn(TracedCurve* curve) {
    std::ranges::reverse(curve->vertices);
    std::swap(curve->meets[0], curve->meets[1]);
    for (const int v : curve->vertices) traced_.vertices[v].direction *= -1;
  }

  // Drops the vertices of the latest curve.
  void Drop(size_t first) {
    for (size_t v = first; v < traced_.vertices.size(); ++v) {
      for (const int s : traced_.vertices[v].samples) owner_[s] = kDropped;
    }
    traced_.vertices.resize(first);
  }

  int AddVertex(const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                double footprint) {
    traced_.vertices.push_back(
        {position, direction, footprint, static_cast<int>(traced_.curves.size()), {}});
    return static_cast<int>(traced_.vertices.size()) - 1;
  }

  // Finds samples that run along the line through a vertex, between two places on it.
  void Look(const TracedVertex& from, double begin_px, double end_px, double across_px) {
    // Weakly determined samples of the line may be farther from it in space than in the images.
    constexpr double kInSpacePx = 3;
    const Eigen::Vector3d center =
        from.position + 0.5 * (begin_px + end_px) * from.footprint * from.direction;
    index_.FindWithin(center, std::hypot(0.5 * (end_px - begin_px), kInSpacePx) * from.footprint,
                      &within_);
    found_.clear();
    for (const SpatialIndex::Neighbor& neighbor : within_) {
      const int s = neighbor.index;
      if (owner_[s] == kDropped || consensus_.num_views[s] < options_.min_traced_views) continue;
      const double cosine = from.direction.dot(consensus_.tangent[s]);
      if (std::abs(cosine) < kMinTraceCosine) continue;
      const Eigen::Vector3d tangent = std::copysign(1, cosine) * consensus_.tangent[s];
      const OffsetAlong offset =
          OffsetBetween(consensus_.position[s] - from.position, from.direction, tangent);
      const double along_px = offset.along / from.footprint;
      const double squared_px = metric_.Squared(s, offset.across);
      if (along_px < begin_px || along_px > end_px || squared_px > across_px * across_px) continue;
      found_.push_back({s, along_px, squared_px, tangent});
    }
  }

  // Gives a vertex the samples near it that have no owner, up to `behind_px` behind.
  void Claim(int vertex, double behind_px) {
    TracedVertex& claiming = traced_.vertices[vertex];
    Look(claiming, -behind_px, kClaimAlongPx, kClaimAcrossPx);
    for (const Candidate& candidate : found_) {
      if (owner_[candidate.sample] != kNobody) continue;
      owner_[candidate.sample] = vertex;
      claiming.samples.push_back(candidate.sample);
    }
  }

  // Appends vertices while the ridge continues. Returns the vertex that it reaches, or -1.
  int Follow(TracedCurve* curve) {
    while (true) {
      const int last = curve->vertices.back();
      LookAhead(*curve);
      if (found_.empty()) return -1;
      const auto num_owned =
          std::ranges::count_if(found_, [&](const Candidate& c) { return owner_[c.sample] >= 0; });
      const int met = NearestOwner();
      if (2 * num_owned > std::ssize(found_)) return met;
      const double old_footprint = traced_.vertices[last].footprint;
      const double step_px = StepPx();
      const int next = AddStep(traced_.vertices[last], step_px);
      Claim(next, step_px * old_footprint / traced_.vertices[next].footprint - kClaimAlongPx);
      if (traced_.vertices[next].samples.empty() && met >= 0) {
        traced_.vertices.pop_back();
        return met;
      }
      curve->vertices.push_back(next);
    }
  }

  // Finds the nearest samples ahead of the last vertex.
  void LookAhead(const TracedCurve& curve) {
    Look(traced_.vertices[curve.vertices.back()], kMinAheadPx, options_.max_gap_px, kTraceAcrossPx);
    const auto num_recent = std::min<std::ptrdiff_t>(kRecentVertices, std::ssize(curve.vertices));
    const auto recent = curve.vertices.end() - num_recent;
    std::erase_if(found_, [&](const Candidate& c) {
      return std::find(recent, curve.vertices.end(), owner_[c.sample]) != curve.vertices.end();
    });
    if (found_.empty()) return;
    const double end_px = StepPx() + kDepthPx;
    std::erase_if(found_, [&](const Candidate& c) { return c.along_px > end_px; });
  }

  // Length of the step to the samples that were found.
  double StepPx() const {
    return std::max(kTraceStepPx,
                    std::ranges::min_element(found_, {}, &Candidate::along_px)->along_px);
  }

  // The vertex that owns the nearest of the samples that were found; -1 if they have no owners.
  int NearestOwner() const {
    double nearest_px = std::numeric_limits<double>::infinity();
    int owner = -1;
    for (const Candidate& candidate : found_) {
      if (owner_[candidate.sample] < 0 || candidate.along_px >= nearest_px) continue;
      nearest_px = candidate.along_px;
      owner = owner_[candidate.sample];
    }
    return owner;
  }

  // Adds a vertex in the middle of the samples that were found, slid along their tangents to where
  // the step leads.
  int AddStep(const TracedVertex& from, double step_px) {
    const Eigen::Vector3d goal = from.position + step_px * from.footprint * from.direction;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = from.direction;
    double footprint = 0;
    double sum = 0;
    for (const Candidate& c : found_) {
      const double weight =
          consensus_.num_views[c.sample] * std::exp(-0.5 * c.squared_px / (kWeightPx * kWeightPx));
      const Eigen::Vector3d& place = consensus_.position[c.sample];
      const double slide = (goal - place).dot(from.direction) / c.tangent.dot(from.direction);
      position += weight * (place + slide * c.tangent);
      direction += weight * c.tangent;
      footprint += weight * samples_.footprint[c.sample];
      sum += weight;
    }
    return AddVertex(position / sum, direction.normalized(), footprint / sum);
  }

  const SampleSet& samples_;
  const ReprojectedMetric& metric_;
  const Consensus& consensus_;
  const TracingOptions& options_;
  SpatialIndex index_;
  std::vector<int> owner_;  // per sample
  TracedCurves traced_;
  // Of the last look.
  std::vector<SpatialIndex::Neighbor> within_;
  std::vector<Candidate> found_;
};

}  // namespace

DrawingGraph TraceCurves(const SampleSet& samples, const TracingOptions& options,
                         const RunContext& context, TracingCounts* counts) {
  const ReprojectedMetric metric(samples);
  const Consensus consensus = FindConsensus(samples, metric, context);
  CurveTracer tracer(samples, metric, consensus, options);
  const TracedCurves traced = tracer.Run(context);
  *counts = {};
  counts->unclaimed = tracer.NumUnclaimed();
  counts->curves = std::ssize(traced.curves);
  for (const TracedCurve& curve : traced.curves) {
    counts->closed += curve.closed;
    for (const int met : curve.meets) counts->meetings += met >= 0;
  }
  return MakeTracedGraph(samples, consensus, traced);
}

}  // namespace limn
