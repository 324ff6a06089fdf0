// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/position_doubts.h"

#include <algorithm>
#include <string>

#include "limn/geometry/angle_between.h"
#include "limn/util/angles.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

// Positions are far if their residuals, scaled by their accuracies, exceed this many typical ones.
constexpr double kFarTimesTypical = 5;

std::string Meters(double meters) { return ShortNumber(meters) + " m"; }

std::vector<NamedNumber> PositionsBeyond(const AlignmentResult& result, double scaled_residual,
                                         const ViewSet& set) {
  const PositionFit& fit = *result.positions;
  std::vector<NamedNumber> far;
  for (size_t i = 0; i < fit.residuals.size(); ++i) {
    if (fit.scaled_residuals[i] > scaled_residual) {
      far.push_back({set.ImageName(result.positioned[i]), fit.residuals[i]});
    }
  }
  std::stable_sort(far.begin(), far.end(),
                   [](const NamedNumber& a, const NamedNumber& b) { return a.number > b.number; });
  return far;
}

// "they fit the cameras within 3.1 m (median), <how> within 0.02 m".
std::string Residuals(const AlignmentResult& result, const std::string& how) {
  return "as they are they fit the cameras within " + Meters(result.positions->median_residual) +
         " (median), " + how + " within " + Meters(result.position_check.other_residual);
}

std::string StretchText(const Eigen::Vector3d& stretch) {
  return ShortNumber(stretch[0]) + " : " + ShortNumber(stretch[1]) + " : " +
         ShortNumber(stretch[2]);
}

std::string UpsideDownText(const AlignmentResult& result, const ViewSet& set) {
  std::vector<std::string> names;
  for (const ViewId view : result.upside_down) names.push_back(set.ImageName(view));
  return "positions of cameras contradict the photographs: by them " +
         std::to_string(names.size()) + " of " + std::to_string(result.positioned.size()) +
         " were taken upside down (" + ListNames(names) +
         "): they are mirrored, as with east and north exchanged, or their third axis points down";
}

std::string GravityText(const AlignmentResult& result) {
  const Eigen::Vector3d up = result.positions->target_from_source.rotation.row(2).transpose();
  const double angle = AngleBetween(up, result.gravity->direction);
  return "positions of " + std::to_string(result.positioned.size()) +
         " cameras contradict the gravity that " + std::to_string(result.gravity->num_views) +
         " measured: their ups are " + ShortNumber(Degrees(angle)) +
         " degrees apart; the third axis of positions must point up";
}

std::string LengthsText(const AlignmentResult& result, const std::vector<KnownLength>& lengths) {
  std::vector<std::string> texts;
  for (const KnownLength& length : lengths) texts.push_back("\"" + length.text + "\"");
  const PositionFit& fit = *result.positions;
  return "positions of " + std::to_string(result.positioned.size()) +
         " cameras contradict the known length " + ListNames(texts) + ": a unit of the model is " +
         Meters(fit.target_from_source.scale) + " by them (standard error " +
         ShortNumber(100 * fit.scale_error) + " %) and " + Meters(result.lengths->scale) +
         " by it; positions must be in meters";
}

}  // namespace

std::vector<NamedNumber> FarPositions(const AlignmentResult& result, const ViewSet& set) {
  return PositionsBeyond(result, kFarTimesTypical * result.positions->typical_scaled_residual, set);
}

std::string PositionDoubtText(const AlignmentResult& result,
                              const std::vector<KnownLength>& lengths, const ViewSet& set) {
  const std::string begin = "positions of cameras contradict the cameras of the model: ";
  switch (result.position_check.doubt) {
    case PositionDoubt::kNone:
      return "";
    case PositionDoubt::kExchanged:
      return begin + "latitude and longitude are exchanged: " + Residuals(result, "exchanged");
    case PositionDoubt::kMirrored:
      return begin + "they are mirrored, as with two axes exchanged or one of another sign: " +
             Residuals(result, "mirrored");
    case PositionDoubt::kStretched:
      return begin + "they are distorted, as with axes of different units or degrees for meters: " +
             Residuals(result, "stretched by " + StretchText(result.position_check.stretch));
    case PositionDoubt::kAnyOrder:
      return begin + "they fit within " + Meters(result.positions->median_residual) +
             " (median), no better than in another order: they are of other images, many are "
             "wrong, "
             "or their errors are as large as the distances of the cameras; farthest are " +
             ListNumbers(PositionsBeyond(result, -1, set), "m");
    case PositionDoubt::kManyWrong:
      return begin + std::to_string(result.positions->num_rejected) + " of " +
             std::to_string(result.positioned.size()) +
             " contradict the others: " + ListNumbers(FarPositions(result, set), "m");
    case PositionDoubt::kGravity:
      return GravityText(result);
    case PositionDoubt::kUpsideDown:
      return UpsideDownText(result, set);
    case PositionDoubt::kLengths:
      return LengthsText(result, lengths);
  }
  return "";
}

}  // namespace limn::colmap_ext
