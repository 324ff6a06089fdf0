// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/align_drawing.h"

#include <algorithm>
#include <cmath>

#include "limn/alignment/straight_lines.h"
#include "limn/geometry/angle_between.h"
#include "limn/model/link_selection.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Cameras that measure gravity agree better.
constexpr double kMaxGravityDeviationRad = 10 * kDeg;
// Standard errors of up from positions: with more, lines are better; with more, cameras are.
constexpr double kGoodUpErrorRad = 2 * kDeg, kMaxUpErrorRad = 10 * kDeg;
constexpr double kMaxHeadingErrorRad = 10 * kDeg;
// With a larger relative error, lengths would not be meters.
constexpr double kMaxScaleError = 0.2;
// Gravity and positions disagree about up by more degrees, and by so many of both their errors.
constexpr double kMaxUpDifferenceRad = 20 * kDeg;
constexpr double kMaxErrors = 5;
// Photographs are held upside down if their upper sides are farther from up; few are.
constexpr double kUpsideDownRad = 120 * kDeg;
constexpr double kMaxUpsideDownShare = 0.7;
// Known lengths and positions disagree about the scale by a larger factor, and by so many errors.
constexpr double kMaxScaleRatio = 1.25;
// Accuracy of satellite positions where it is not given, as phones have it, m.
constexpr double kSatelliteAccuracyM = 10;
// Of the points on either side, which may be wrong, when the drawing is centered.
constexpr double kOutsideShare = 0.02;

std::vector<ViewId> PositionedViews(const std::vector<ViewPrior>& priors) {
  std::vector<ViewId> views;
  for (size_t v = 0; v < priors.size(); ++v) {
    if (priors[v].position) views.push_back(static_cast<ViewId>(v));
  }
  return views;
}

struct CenterPairs {
  std::vector<PointPair> pairs;
  std::vector<PointPair> exchanged;  // none if not all can be exchanged
  double accuracy = 0;               // of scaled residuals; 0 = unknown
};

// Weights are by the given accuracy if it is given for all.
CenterPairs PairCenters(const AlignmentInput& input, const std::vector<ViewId>& views) {
  const auto all = [&](const auto& is) {
    return std::all_of(views.begin(), views.end(), [&](ViewId v) { return is(input.priors[v]); });
  };
  const bool is_weighted = all([](const ViewPrior& prior) { return prior.position_sigma > 0; });
  const bool is_exchangeable =
      all([](const ViewPrior& prior) { return prior.exchanged_position.has_value(); });
  CenterPairs centers;
  for (const ViewId v : views) {
    const ViewPrior& prior = input.priors[v];
    const double weight = is_weighted ? 1 / (prior.position_sigma * prior.position_sigma) : 1;
    const Eigen::Vector3d center = input.views[v].CenterInWorld();
    centers.pairs.push_back({center, *prior.position, weight});
    if (is_exchangeable) centers.exchanged.push_back({center, *prior.exchanged_position, weight});
  }
  if (is_weighted) {
    centers.accuracy = 1;
  } else if (all([](const ViewPrior& prior) { return prior.is_geographic; })) {
    centers.accuracy = kSatelliteAccuracyM;
  }
  return centers;
}

Eigen::Vector3d AxisInModel(const PositionFit& fit, int axis) {
  return fit.target_from_source.rotation.row(axis).transpose();
}

bool GravityAgrees(const AlignmentResult& found) {
  return found.gravity && found.gravity->deviation_rad < kMaxGravityDeviationRad;
}

// The positions, if they contradict nothing and their error of up is at most this.
const PositionFit* PositionsOfUp(const AlignmentResult& found, double max_error_rad) {
  const bool is_good = found.positions && found.position_check.doubt == PositionDoubt::kNone &&
                       found.positions->up_error_rad < max_error_rad;
  return is_good ? &*found.positions : nullptr;
}

bool ContradictsGravity(const AlignmentResult& found, const PositionFit& fit) {
  const double difference = AngleBetween(AxisInModel(fit, 2), found.gravity->direction);
  const double errors = fit.up_error_rad + found.gravity->deviation_rad;
  return difference > std::max(kMaxUpDifferenceRad, kMaxErrors * errors);
}

std::vector<ViewId> UpsideDown(const AlignmentInput& input, const std::vector<ViewId>& views,
                               const Eigen::Vector3d& up) {
  std::vector<ViewId> upside_down;
  for (const ViewId v : views) {
    const double angle = AngleBetween(UpAsHeld(input.views[v], input.priors[v]), up);
    if (angle > kUpsideDownRad) upside_down.push_back(v);
  }
  return upside_down;
}

// Whether positions that fit the cameras tell an up that something else denies.
void CheckUpOfPositions(const AlignmentInput& input, AlignmentResult* result) {
  const PositionFit* fit = PositionsOfUp(*result, kMaxUpErrorRad);
  if (!fit) return;
  if (GravityAgrees(*result)) {
    if (ContradictsGravity(*result, *fit)) result->position_check.doubt = PositionDoubt::kGravity;
    return;
  }
  const Eigen::Vector3d up = AxisInModel(*fit, 2);
  result->upside_down = UpsideDown(input, result->positioned, up);
  if (static_cast<double>(result->upside_down.size()) >
      kMaxUpsideDownShare * static_cast<double>(result->positioned.size())) {
    result->position_check.doubt = PositionDoubt::kUpsideDown;
  }
}

void CheckScaleOfPositions(AlignmentResult* result) {
  const bool both =
      result->lengths && result->positions && result->position_check.doubt == PositionDoubt::kNone;
  if (!both || !(result->positions->scale_error < kMaxScaleError)) return;
  const double by_lengths = result->lengths->scale;
  const double by_positions = result->positions->target_from_source.scale;
  const double ratio = std::max(by_lengths / by_positions, by_positions / by_lengths);
  if (ratio > std::max(kMaxScaleRatio, 1 + kMaxErrors * result->positions->scale_error)) {
    result->position_check.doubt = PositionDoubt::kLengths;
  }
}

void FitCenters(const AlignmentInput& input, AlignmentResult* result) {
  result->positioned = PositionedViews(input.priors);
  const CenterPairs centers = PairCenters(input, result->positioned);
  result->positions = FitPositions(centers.pairs);
  if (!result->positions) return;
  result->position_check =
      CheckPositions(centers.pairs, *result->positions, centers.exchanged, centers.accuracy);
  CheckUpOfPositions(input, result);
  CheckScaleOfPositions(result);
}

struct Up {
  Eigen::Vector3d direction;
  UpSource source;
};

// What is known of it without the drawing: to tell up from down, and from other main directions.
Up UpHint(const AlignmentInput& input, const AlignmentResult& found) {
  if (GravityAgrees(found)) return {found.gravity->direction, UpSource::kGravity};
  if (const PositionFit* positions = PositionsOfUp(found, kMaxUpErrorRad)) {
    return {AxisInModel(*positions, 2), UpSource::kPositions};
  }
  return {UpOfCameras(input.views, input.priors), UpSource::kCameras};
}

Up ChooseUp(const Up& hint, const AlignmentResult& found) {
  const bool is_good =
      hint.source == UpSource::kGravity ||
      (hint.source == UpSource::kPositions && found.positions->up_error_rad < kGoodUpErrorRad);
  if (is_good || !found.vertical) return hint;
  return {found.vertical->direction, UpSource::kLines};
}

// The horizontal direction that x shall be near.
struct Heading {
  Eigen::Vector3d direction;
  AxesSource source;
};

Heading HeadingHint(const Eigen::Vector3d& up, const AlignmentResult& found) {
  if (found.positions && found.position_check.doubt == PositionDoubt::kNone &&
      found.positions->heading_error_rad < kMaxHeadingErrorRad) {
    const Eigen::Vector3d east = AxisInModel(*found.positions, 0);
    if (std::abs(east.dot(up)) < 0.5) return {east, AxesSource::kPositions};
  }
  const bool x_is_vertical = std::abs(up.x()) > 0.9;
  return {x_is_vertical ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX(), AxesSource::kModel};
}

Heading ChooseHeading(const AlignmentInput& input, const Eigen::Vector3d& up,
                      const AlignmentResult& found) {
  const Heading hint = HeadingHint(up, found);
  if (input.plan_lines.empty()) return hint;
  return {FitPlanLines(input.graph, input.plan_lines, up, hint.direction), AxesSource::kPlan};
}

// Rows: the axes of the world.
Eigen::Matrix3d RotationOf(const Eigen::Vector3d& up, const Eigen::Vector3d& heading) {
  const Eigen::Vector3d x = (heading - up * up.dot(heading)).normalized();
  Eigen::Matrix3d rotation;
  rotation << x.transpose(), up.cross(x).transpose(), up.transpose();
  return rotation;
}

void SetScale(AlignmentResult* result) {
  Alignment& alignment = result->alignment;
  if (result->lengths) {
    alignment.world_from_model.scale = result->lengths->scale;
    alignment.scale_sigma = result->lengths->sigma;
    alignment.scale = ScaleSource::kLengths;
  } else if (result->positions && result->position_check.doubt == PositionDoubt::kNone &&
             result->positions->scale_error < kMaxScaleError) {
    alignment.world_from_model.scale = result->positions->target_from_source.scale;
    alignment.scale_sigma = result->positions->scale_error;
    alignment.scale = ScaleSource::kPositions;
  }
}

double QuantileOf(std::vector<double>* values, double share) {
  const auto place = values->begin() +
                     static_cast<std::ptrdiff_t>(share * static_cast<double>(values->size() - 1));
  std::nth_element(values->begin(), place, values->end());
  return *place;
}

// The model's point at the world's origin: in the middle of the drawing, on its floor.
Eigen::Vector3d OriginInModel(const DrawingGraph& graph, const std::vector<StraightLine>& lines,
                              const Eigen::Matrix3d& rotation) {
  const LinkSelection selection;
  std::vector<double> values[3];
  for (const DrawingLink& link : graph.links) {
    if (!selection.Has(link)) continue;
    for (const Eigen::Vector3d& point : link.points_in_world) {
      const Eigen::Vector3d turned = rotation * point;
      for (int axis = 0; axis < 3; ++axis) values[axis].push_back(turned[axis]);
    }
  }
  if (values[0].empty()) return Eigen::Vector3d::Zero();
  Eigen::Vector3d origin;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = QuantileOf(&values[axis], kOutsideShare);
    const double high = QuantileOf(&values[axis], 1 - kOutsideShare);
    origin[axis] = axis < 2 ? (low + high) / 2 : low;
  }
  const Eigen::Vector3d up = rotation.row(2).transpose();
  origin.z() = FloorHeight(lines, up).value_or(origin.z());
  return rotation.transpose() * origin;
}

// Where the world is that of the positions: in the middle of the cameras, wherever up and scale are
// from.
Eigen::Vector3d TranslationToPositions(const AlignmentInput& input, const AlignmentResult& result) {
  const auto& [scale, rotation, translation] = result.alignment.world_from_model;
  const PositionFit& fit = *result.positions;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < result.positioned.size(); ++i) {
    if (fit.is_rejected[i]) continue;
    middle += input.views[result.positioned[i]].CenterInWorld();
  }
  middle /= static_cast<double>(result.positioned.size() - fit.num_rejected);
  return fit.target_from_source * middle - scale * (rotation * middle);
}

}  // namespace

AlignmentResult AlignDrawing(const AlignmentInput& input) {
  AlignmentResult result;
  const std::vector<StraightLine> lines = StraightLines(input.graph);
  result.gravity = MeasuredUp(input.views, input.priors);
  if (!input.lengths.empty()) result.lengths = FitLengths(input.graph, input.lengths);
  FitCenters(input, &result);
  const Up hint = UpHint(input, result);
  result.vertical = FindVertical(lines, hint.direction);
  const Up up = ChooseUp(hint, result);
  const Heading heading = ChooseHeading(input, up.direction, result);
  SetScale(&result);
  const bool is_at_positions = input.world == WorldFrame::kPositions &&
                               heading.source == AxesSource::kPositions &&
                               result.alignment.IsMetric();
  if (!is_at_positions && heading.source != AxesSource::kPlan) {
    result.horizontal = FindHorizontal(lines, up.direction, heading.direction);
  }

  Alignment& alignment = result.alignment;
  alignment.up = up.source;
  alignment.axes = result.horizontal ? AxesSource::kLines : heading.source;
  Similarity3d& world_from_model = alignment.world_from_model;
  world_from_model.rotation = RotationOf(
      up.direction, result.horizontal ? result.horizontal->direction : heading.direction);
  if (is_at_positions) {
    result.world = WorldFrame::kPositions;
    world_from_model.translation = TranslationToPositions(input, result);
    return result;
  }
  const Eigen::Vector3d origin = OriginInModel(input.graph, lines, world_from_model.rotation);
  world_from_model.translation = -world_from_model.scale * (world_from_model.rotation * origin);
  return result;
}

}  // namespace limn
