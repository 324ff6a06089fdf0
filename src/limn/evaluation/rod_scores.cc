// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/rod_scores.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/evaluation/curve_samples.h"
#include "limn/evaluation/evaluation_scene.h"
#include "limn/evaluation/parallel_samples.h"
#include "limn/evaluation/quantiles.h"
#include "limn/model/footprint.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kCellOfRodsPerTau = 0.25;

struct SampledRods {
  const RodComparison& compared;
  const std::vector<View>& views;
  const EvaluationOptions& options;
  const RunContext& context;
  double tau = 0;
  CurveSamples rods, others, truth;

  double UnitAt(const Eigen::Vector3d& place) const {
    return views.empty() ? 1 : PixelFootprint(views, place);
  }
  bool InRegion(const Eigen::Vector3d& place) const {
    return !options.region || options.region->contains(place);
  }
};

// A sample of the truth.
struct TrueRodPlace {
  bool is_matched = false;
  double radius = 0;  // that counts there, world units; 0 if unknown
};

// A sample of a drawn link.
struct DrawnRodPlace {
  bool counts = false;
  bool runs_along = false;  // a true rod, within radius + tau
  // If it matches a true rod.
  std::optional<double> error;         // in units
  std::optional<double> radius_ratio;  // if the true radius is known
};

double RadiusOf(const CurveSet& set, const CurveSamples& samples, int sample) {
  return set.rod_radii.empty() ? 0 : set.rod_radii[samples.CurveOf(sample)];
}

CurveSamples SampleRods(const CurveSet& set, const std::vector<View>& views, double tau,
                        int num_before) {
  const auto step_of = [&](const Polyline3d& polyline) {
    return kCellOfRodsPerTau * tau * (views.empty() ? 1 : FootprintOfCurve(views, polyline));
  };
  return CurveSamples(set, step_of, CurveSamples::kMaxCells - num_before);
}

// All samples, whether they are inside the region or not.
std::vector<TrueRodPlace> JudgeTrueRods(const SampledRods& sampled) {
  const CurveSamples& truth = sampled.truth;
  std::vector<TrueRodPlace> judged(truth.size());
  ForEachSample(sampled.context, truth.size(), [&](int i) {
    thread_local std::vector<SpatialIndex::Neighbor> found;
    const Eigen::Vector3d& position = truth.Position(i);
    FindParallel(sampled.rods, position, truth.Direction(i), sampled.tau * sampled.UnitAt(position),
                 &found);
    judged[i].is_matched = !found.empty();
    judged[i].radius = RadiusOf(sampled.compared.truth, truth, i);
    if (judged[i].radius > 0) return;
    for (const SpatialIndex::Neighbor& rod : found) {
      const double radius = RadiusOf(sampled.compared.rods, sampled.rods, rod.index);
      judged[i].radius = std::max(judged[i].radius, radius);
    }
  });
  return judged;
}

// `drawn` are the samples of `set`: of the rods, or of all else.
std::vector<DrawnRodPlace> JudgeDrawn(const SampledRods& sampled, const CurveSet& set,
                                      const CurveSamples& drawn,
                                      const std::vector<TrueRodPlace>& truth) {
  double max_radius = 0;
  for (const TrueRodPlace& place : truth) max_radius = std::max(max_radius, place.radius);
  std::vector<DrawnRodPlace> judged(drawn.size());
  ForEachSample(sampled.context, drawn.size(), [&](int i) {
    thread_local std::vector<SpatialIndex::Neighbor> found;
    const Eigen::Vector3d& position = drawn.Position(i);
    if (!sampled.InRegion(position)) return;
    judged[i].counts = true;
    const double unit = sampled.UnitAt(position);
    const double reach = sampled.tau * unit;
    FindParallel(sampled.truth, position, drawn.Direction(i), max_radius + reach, &found);
    if (found.empty()) return;
    judged[i].runs_along = std::ranges::any_of(found, [&](const SpatialIndex::Neighbor& rod) {
      const double radius = truth[rod.index].radius;
      return radius > 0 && std::sqrt(rod.squared_distance) <= radius + reach;
    });
    const SpatialIndex::Neighbor& nearest =
        *std::ranges::min_element(found, {}, &SpatialIndex::Neighbor::squared_distance);
    const double distance = std::sqrt(nearest.squared_distance);
    if (distance > reach) return;
    judged[i].error = distance / unit;
    const double true_radius = RadiusOf(sampled.compared.truth, sampled.truth, nearest.index);
    if (true_radius > 0) judged[i].radius_ratio = RadiusOf(set, drawn, i) / true_radius;
  });
  return judged;
}

double LengthAlong(const CurveSamples& drawn, const std::vector<DrawnRodPlace>& judged) {
  double length = 0;
  for (int i = 0; i < drawn.size(); ++i) {
    if (judged[i].runs_along) length += drawn.Weight(i);
  }
  return length;
}

// Returns the length that matches.
double AddDrawnRods(const CurveSamples& rods, const std::vector<DrawnRodPlace>& judged,
                    RodScores* scores) {
  double matched = 0;
  std::vector<WeightedValue> errors, ratios;
  for (int i = 0; i < rods.size(); ++i) {
    const double length = rods.Weight(i);
    if (judged[i].counts) scores->drawn_length += length;
    if (judged[i].error) {
      matched += length;
      errors.emplace_back(*judged[i].error, length);
    }
    if (judged[i].radius_ratio) ratios.emplace_back(*judged[i].radius_ratio, length);
  }
  scores->median_error = WeightedQuantile(std::move(errors), 0.5);
  scores->median_radius_ratio = WeightedQuantile(std::move(ratios), 0.5);
  return matched;
}

RodScores SummarizeRods(const SampledRods& sampled, const std::vector<TrueRodPlace>& truth,
                        const std::vector<DrawnRodPlace>& rods,
                        const std::vector<DrawnRodPlace>& others) {
  RodScores scores;
  double matched = 0;
  double of_known_radius = 0;
  for (int i = 0; i < sampled.truth.size(); ++i) {
    if (!sampled.InRegion(sampled.truth.Position(i))) continue;
    const double length = sampled.truth.Weight(i);
    scores.true_length += length;
    if (truth[i].is_matched) matched += length;
    if (truth[i].radius > 0) of_known_radius += length;
  }
  const double right = AddDrawnRods(sampled.rods, rods, &scores);
  if (!(scores.true_length > 0)) return scores;
  scores.recall = matched / scores.true_length;
  scores.false_per_length = (scores.drawn_length - right) / scores.true_length;
  if (!(of_known_radius > 0)) return scores;
  scores.links_per_length =
      (LengthAlong(sampled.rods, rods) + LengthAlong(sampled.others, others)) / of_known_radius;
  return scores;
}

RodScores ScoreRodsAt(const RodComparison& compared, const std::vector<View>& views, double tau,
                      const EvaluationOptions& options, const RunContext& context) {
  CurveSamples rods = SampleRods(compared.rods, views, tau, 0);
  CurveSamples others = SampleRods(compared.others, views, tau, rods.size());
  CurveSamples truth = SampleRods(compared.truth, views, tau, rods.size() + others.size());
  const SampledRods sampled{compared, views,           options,           context,
                            tau,      std::move(rods), std::move(others), std::move(truth)};
  const std::vector<TrueRodPlace> true_places = JudgeTrueRods(sampled);
  return SummarizeRods(sampled, true_places,
                       JudgeDrawn(sampled, compared.rods, sampled.rods, true_places),
                       JudgeDrawn(sampled, compared.others, sampled.others, true_places));
}

}  // namespace

RodsApart TakeRodsApart(const DrawingGraph& drawing) {
  RodsApart apart = {drawing, drawing};
  std::vector<uint8_t> are_rods, are_others;
  for (const DrawingLink& link : drawing.links) {
    are_rods.push_back(link.kind == LinkKind::kRod);
    are_others.push_back(link.kind != LinkKind::kRod);
  }
  RemoveLinks(are_rods, &apart.rods);
  RemoveLinks(are_others, &apart.others);
  return apart;
}

std::vector<RodScores> ScoreRods(const RodComparison& compared, const std::vector<View>& views,
                                 const EvaluationOptions& options, const RunContext& context) {
  if (compared.truth.polylines.empty()) throw InputError("true rods: no curves");
  std::vector<RodScores> scores;
  for (const double tau : options.taus) {
    scores.push_back(ScoreRodsAt(compared, views, tau, options, context));
  }
  return scores;
}

}  // namespace limn
