// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/evaluate_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/evaluation/circle_scores.h"
#include "limn/evaluation/curve_bootstrap.h"
#include "limn/evaluation/curve_samples.h"
#include "limn/evaluation/curve_topology.h"
#include "limn/evaluation/duplicates.h"
#include "limn/evaluation/evaluation_scene.h"
#include "limn/evaluation/junction_kind_scores.h"
#include "limn/evaluation/node_scores.h"
#include "limn/evaluation/pair_scores.h"
#include "limn/evaluation/quantiles.h"
#include "limn/model/footprint.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kStepPerTau = 0.25;
constexpr int kMinJunctionDegree = 3;
// True ends nearer than this are at one place.
constexpr double kWeldTaus = 0.25;
// The footprint along a curve is looked up at this many places to choose its step.
constexpr int kFootprintProbes = 16;

// Local unit of length at a point: 1 for world units.
using UnitAt = std::function<double(const Eigen::Vector3d&)>;

using Scene = EvaluationScene;

// What is known of a sample once it has been looked at.
struct Judged {
  bool counts = false;
  bool duplicated = false;
  double distance = 0;  // in local units
  double weight = 0;
};

void CheckSet(const CurveSet& set, const char* name, bool may_be_empty) {
  const auto check_finite = [&](const Eigen::Vector3d& point) {
    if (!point.allFinite()) throw InputError(std::string(name) + ": a point is not finite");
  };
  const auto is_per_polyline = [&](size_t count) {
    return count == 0 || count == set.polylines.size();
  };
  if (!is_per_polyline(set.curves.size()) || !is_per_polyline(set.is_circle.size())) {
    throw InputError(std::string(name) + ": curves or types of some polylines only");
  }
  bool empty = set.points.empty();
  for (const Polyline3d& polyline : set.polylines) {
    std::for_each(polyline.begin(), polyline.end(), check_finite);
    empty = empty && polyline.empty();
  }
  std::for_each(set.points.begin(), set.points.end(), check_finite);
  if (empty && !may_be_empty) throw InputError(std::string(name) + ": no curves and no points");
}

// `num_before`: cells of other sets, which share the memory.
CurveSamples Sample(const CurveSet& set, double tau, const UnitAt& unit_at, int num_before) {
  const auto step_of = [&](const Polyline3d& polyline) {
    double unit = std::numeric_limits<double>::infinity();
    const double length = Length(polyline);
    if (!(length > 0)) return tau;
    for (const Eigen::Vector3d& probe : ResampleUniform(polyline, length / kFootprintProbes)) {
      unit = std::min(unit, unit_at(probe));
    }
    return kStepPerTau * tau * unit;
  };
  return CurveSamples(set, step_of, CurveSamples::kMaxCells - num_before);
}

std::vector<Judged> JudgeReconstruction(const Scene& scene, const CurveSamples& samples,
                                        const CurveSamples& truth, const CurveSamples& dont_care,
                                        double tau) {
  std::vector<Judged> judged(samples.size());
  const std::vector<int> groups =
      GroupNodes(scene.reconstruction.polylines, scene.topology,
                 [&](const Polyline3d& link) { return tau * scene.unit_at(link.front()); });
  const AlongsideSearch search{samples, scene.topology, groups};
  ForEachSample(scene.context, samples.size(), [&](int i) {
    thread_local std::vector<SpatialIndex::Neighbor> scratch;
    const Eigen::Vector3d& position = samples.Position(i);
    if (!scene.InRegion(position)) return;
    const double unit = scene.unit_at(position);
    if (dont_care.Distance(position) < scene.options.dont_care_taus * tau * unit) return;
    judged[i].counts = true;
    judged[i].weight = samples.Weight(i);
    judged[i].distance = truth.Distance(position) / unit;
    judged[i].duplicated =
        scene.options.find_duplicates && RunsAlongsideAnother(search, i, tau * unit, &scratch);
  });
  return judged;
}

std::vector<Judged> JudgeTruth(const Scene& scene, const CurveSamples& truth,
                               const CurveSamples& reconstruction) {
  std::vector<Judged> judged(truth.size());
  ForEachSample(scene.context, truth.size(), [&](int i) {
    const Eigen::Vector3d& position = truth.Position(i);
    if (!scene.InRegion(position)) return;
    judged[i].counts = true;
    judged[i].weight = truth.Weight(i);
    judged[i].distance = reconstruction.Distance(position) / scene.unit_at(position);
  });
  return judged;
}

struct Shares {
  double total = 0;
  int64_t samples_within = 0;
  int64_t samples_beyond = 0;
  std::optional<double> within, mean, median, duplicated;
};

Shares Summarize(const std::vector<Judged>& judged, double tau) {
  Shares shares;
  double within = 0;
  double duplicated = 0;
  double moment = 0;
  std::vector<WeightedValue> distances;
  for (const Judged& sample : judged) {
    if (!sample.counts || !(sample.weight > 0)) continue;
    shares.total += sample.weight;
    if (sample.distance <= tau) within += sample.weight;
    ++(sample.distance <= tau ? shares.samples_within : shares.samples_beyond);
    if (sample.duplicated) duplicated += sample.weight;
    moment += sample.weight * sample.distance;
    distances.emplace_back(sample.distance, sample.weight);
  }
  if (!(shares.total > 0)) return shares;
  shares.within = within / shares.total;
  shares.duplicated = duplicated / shares.total;
  if (!std::isfinite(moment)) return shares;  // nothing to be distant from
  shares.mean = moment / shares.total;
  shares.median = WeightedQuantile(std::move(distances), 0.5);
  return shares;
}

// Share of `junctions` with one of `others` within junction_taus; `count` gets their number.
std::optional<double> ShareOfJunctions(const Scene& scene,
                                       const std::vector<Eigen::Vector3d>& junctions,
                                       const std::vector<Eigen::Vector3d>& others,
                                       const CurveSamples* dont_care, double tau, int* count) {
  const SpatialIndex index(others);
  int found = 0;
  *count = 0;
  for (const Eigen::Vector3d& junction : junctions) {
    if (!scene.InRegion(junction)) continue;
    const double unit = scene.unit_at(junction);
    if (dont_care && dont_care->Distance(junction) < scene.options.dont_care_taus * tau * unit) {
      continue;
    }
    ++*count;
    if (index.size() == 0) continue;
    const double distance = std::sqrt(index.Nearest(junction).squared_distance);
    if (distance <= scene.options.junction_taus * tau * unit) ++found;
  }
  if (*count == 0) return std::nullopt;
  return static_cast<double>(found) / *count;
}

void EvaluateJunctions(const Scene& scene, const CurveSamples& dont_care, TauResult* row) {
  const auto junctions = NodesOfDegree(scene.reconstruction, kMinJunctionDegree);
  const auto true_junctions = NodesOfDegree(scene.truth, kMinJunctionDegree);
  const auto precision =
      ShareOfJunctions(scene, junctions, true_junctions, &dont_care, row->tau, &row->num_junctions);
  if (true_junctions.empty()) return;
  row->junction_precision = precision;
  row->junction_recall = ShareOfJunctions(scene, true_junctions, junctions, nullptr, row->tau,
                                          &row->num_true_junctions);
}

void AddToShare(const Judged& sample, double tau, CurveShare* share) {
  if (!sample.counts) return;
  share->total += sample.weight;
  if (sample.distance <= tau) share->right += sample.weight;
}

void AddIntervals(const CurveSamples& samples, const std::vector<Judged>& judged,
                  const std::vector<ChainPlace>& places, const std::vector<Judged>& judged_truth,
                  TauResult* row) {
  std::vector<CurveShare> links, chains;
  for (int i = 0; i < samples.size(); ++i) {
    // Points are not curves.
    if (samples.Direction(i).isZero(0)) continue;
    const size_t link = samples.CurveOf(i);
    if (link >= links.size()) links.resize(link + 1);
    AddToShare(judged[i], row->tau, &links[link]);
  }
  for (size_t i = 0; i < places.size(); ++i) {
    if (places[i].chain < 0) continue;
    const size_t chain = places[i].chain;
    if (chain >= chains.size()) chains.resize(chain + 1);
    AddToShare(judged_truth[i], row->tau, &chains[chain]);
  }
  const ShareIntervals intervals = BootstrapShares(links, chains);
  row->precision_interval = intervals.precision;
  row->recall_interval = intervals.recall;
  row->f_interval = intervals.f;
}

void AddStructure(const SampledScene& sampled, const TrueChains& chains,
                  const std::vector<ChainPlace>& places, TauResult* row) {
  const CurveSet& reconstruction = sampled.scene.reconstruction;
  const bool has_only_points = reconstruction.polylines.empty() && !reconstruction.points.empty();
  if (has_only_points) return;
  ScoreFreeEnds(sampled, chains, row->true_length, &row->structure);
  if (chains.chains.empty()) return;
  const ChainCoverage coverage = CoverChains(sampled, chains, places, kArmTaus);
  ScorePiecesPerChain(sampled, coverage, &row->structure);
  ScoreJunctions(sampled, chains, row->true_length, &row->structure);
  FeatureScores& features = row->features;
  ScoreConnectivity(sampled, chains, coverage, &row->structure, &features.drawn_corners);
  features.circles = ScoreCircles(sampled);
  features.corners = ScoreJunctionsOfKind(sampled.scene, JunctionKind::kCorner, sampled.tau);
  features.tees = ScoreJunctionsOfKind(sampled.scene, JunctionKind::kTee, sampled.tau);
  features.crossings = ScoreJunctionsOfKind(sampled.scene, JunctionKind::kCrossing, sampled.tau);
  features.pairs = ScorePairs(sampled, places);
}

TauResult EvaluateAt(const Scene& scene, double tau) {
  const CurveSamples samples = Sample(scene.reconstruction, tau, scene.unit_at, 0);
  const CurveSamples truth = Sample(scene.truth, tau, scene.unit_at, samples.size());
  const CurveSamples dont_care =
      Sample(scene.dont_care, tau, scene.unit_at, samples.size() + truth.size());
  const std::vector<Judged> judged = JudgeReconstruction(scene, samples, truth, dont_care, tau);
  const std::vector<Judged> judged_truth = JudgeTruth(scene, truth, samples);
  const Shares precision = Summarize(judged, tau);
  const Shares recall = Summarize(judged_truth, tau);
  TauResult row;
  row.tau = tau;
  row.precision = precision.within;
  row.recall = recall.within;
  const int64_t num_samples = recall.samples_within + precision.samples_beyond;
  if (num_samples > 0) {
    row.sample_precision = static_cast<double>(recall.samples_within) / num_samples;
  }
  if (row.precision && row.recall) {
    const double sum = *row.precision + *row.recall;
    row.f = sum > 0 ? 2 * *row.precision * *row.recall / sum : 0.0;
  }
  row.accuracy = precision.mean;
  row.median_accuracy = precision.median;
  row.completeness = recall.mean;
  row.median_completeness = recall.median;
  if (scene.options.find_duplicates && !scene.reconstruction.polylines.empty()) {
    row.duplicated = precision.duplicated;
  }
  row.reconstructed_length = precision.total;
  row.true_length = recall.total;
  EvaluateJunctions(scene, dont_care, &row);
  const auto tolerance_at = [&](const Eigen::Vector3d& point) {
    return kWeldTaus * tau * scene.unit_at(point);
  };
  const TrueChains chains = FindTrueChains(scene.truth, tolerance_at);
  const std::vector<ChainPlace> places = PlacesOnChains(chains, truth);
  AddIntervals(samples, judged, places, judged_truth, &row);
  AddStructure({scene, tau, samples, truth, dont_care}, chains, places, &row);
  return row;
}

EvaluationReport Evaluate(const CurveSet& reconstruction, const CurveSet& truth,
                          const CurveSet& dont_care, const UnitAt& unit_at, bool in_footprints,
                          const EvaluationOptions& options, const RunContext& context) {
  options.Check();
  CheckSet(reconstruction, "reconstruction", true);
  CheckSet(truth, "ground truth", false);
  CheckSet(dont_care, "don't-care curves", true);
  const Scene scene{reconstruction,
                    truth,
                    dont_care,
                    options,
                    unit_at,
                    context,
                    FindTopology(reconstruction.polylines),
                    in_footprints};
  EvaluationReport report = CountCurves(reconstruction);
  report.in_footprints = in_footprints;
  for (const double tau : options.taus) report.rows.push_back(EvaluateAt(scene, tau));
  return report;
}

}  // namespace

EvaluationReport EvaluateCurves(const CurveSet& reconstruction, const CurveSet& truth,
                                const EvaluationOptions& options, const CurveSet& dont_care,
                                const RunContext& context) {
  const UnitAt world_units = [](const Eigen::Vector3d&) { return 1.0; };
  return Evaluate(reconstruction, truth, dont_care, world_units, false, options, context);
}

EvaluationReport EvaluateCurvesInFootprints(const CurveSet& reconstruction, const CurveSet& truth,
                                            const std::vector<View>& views,
                                            const EvaluationOptions& options,
                                            const CurveSet& dont_care, const RunContext& context) {
  if (views.empty()) throw InputError("pixel footprints need at least one view");
  const UnitAt footprint = [&](const Eigen::Vector3d& point) {
    return PixelFootprint(views, point);
  };
  return Evaluate(reconstruction, truth, dont_care, footprint, true, options, context);
}

EvaluationReport CountCurves(const CurveSet& reconstruction) {
  EvaluationReport report;
  report.num_links = static_cast<int>(reconstruction.polylines.size());
  report.num_points = static_cast<int>(reconstruction.points.size());
  for (const Polyline3d& link : reconstruction.polylines) report.total_length += Length(link);
  if (report.num_links > 0) report.mean_link_length = report.total_length / report.num_links;
  report.num_components = CountComponents(FindTopology(reconstruction.polylines));
  report.nodes_by_degree = CountNodesByDegree(reconstruction);
  if (report.num_links > 0) report.num_ignored_points = report.num_points;
  return report;
}

}  // namespace limn
