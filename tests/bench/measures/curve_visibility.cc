// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/curve_visibility.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "limn/model/footprint.h"
#include "limn/support/edgel_residual.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr size_t kChunk = 1024;

CurveSamples SampleByPixels(const std::vector<SupportedCurve>& curves,
                            const std::vector<View>& views) {
  CurveSet set;
  for (const SupportedCurve& curve : curves) set.polylines.push_back(curve.points_in_world);
  return CurveSamples(set, [&](const Polyline3d& polyline) {
    return CurveVisibility::kSpacingPx * FootprintOfCurve(views, polyline);
  });
}

// The sample as an edgel of the view; nothing where the view does not contain it or sees it end on.
std::optional<Edgel> ProjectSample(const View& view, const CurveSamples& samples, int sample) {
  const auto pixel = view.Project(samples.Position(sample));
  if (!pixel) return std::nullopt;
  const auto direction =
      ProjectedDirection(view, samples.Position(sample), samples.Direction(sample));
  if (!direction) return std::nullopt;
  Edgel edgel;
  edgel.position_px = *pixel;
  edgel.tangent_rad = std::atan2(direction->y(), direction->x());
  return edgel;
}

Eigen::Vector3d Ray(const View& view, const Eigen::Vector3d& point_in_world) {
  return (point_in_world - view.CenterInWorld()).normalized();
}

}  // namespace

void VisibilityOptions::Check() const {
  LIMN_CHECK_OPTION(max_viewing_angle_deg, > 0);
  LIMN_CHECK_OPTION(max_viewing_angle_deg, <= 180);
  LIMN_CHECK_OPTION(shown_distance_px, > 0);
  LIMN_CHECK_OPTION(shown_angle_deg, > 0);
}

CurveVisibility::CurveVisibility(const std::vector<SupportedCurve>& curves,
                                 const std::vector<View>& views,
                                 const std::vector<ImageCurves>& image_curves,
                                 const VisibilityOptions& options, const RunContext& context)
    : curves_(curves),
      views_(views),
      gate_{options.shown_distance_px, kSpacingPx, options.shown_angle_deg * kDeg},
      min_cosine_(std::cos(options.max_viewing_angle_deg * kDeg)),
      samples_(SampleByPixels(curves, views)),
      edgels_(BuildViewEdgels(image_curves, context)) {}

bool CurveVisibility::Shows(ViewId view, int sample) const {
  const auto& supporting = curves_[samples_.CurveOf(sample)].supporting_views;
  if (!std::binary_search(supporting.begin(), supporting.end(), view)) return false;
  const auto seen = ProjectSample(views_[view], samples_, sample);
  return seen && edgels_[view]->edgels.Best(seen->position_px, seen->Tangent(), gate_);
}

// The views that contain the sample, within the viewing angle, nearest first.
std::vector<ViewId> CurveVisibility::Beside(const View& view, int sample) const {
  const Eigen::Vector3d& position = samples_.Position(sample);
  const Eigen::Vector3d ray = Ray(view, position);
  std::vector<std::pair<double, ViewId>> found;
  for (size_t v = 0; v < views_.size(); ++v) {
    const double cosine = ray.dot(Ray(views_[v], position));
    if (cosine < min_cosine_ || !views_[v].Project(position)) continue;
    found.emplace_back(-cosine, static_cast<ViewId>(v));
  }
  std::sort(found.begin(), found.end());
  std::vector<ViewId> beside;
  for (const auto& [order, v] : found) beside.push_back(v);
  return beside;
}

CurveVisibility::Visibility CurveVisibility::VisibilityIn(const View& view, int sample) const {
  constexpr int kSure = 2;
  int shown = 0;
  int asked = 0;
  for (const ViewId v : Beside(view, sample)) {
    shown += Shows(v, sample);
    ++asked;
    if (shown == kSure && asked == kSure) return Visibility::kSure;
    if (shown > 0 && asked >= kSure) break;
  }
  return shown > 0 ? Visibility::kPossible : Visibility::kNot;
}

ForetoldView CurveVisibility::Foretell(const View& view, const RunContext& context) const {
  const auto count = static_cast<size_t>(samples_.size());
  std::vector<std::optional<Edgel>> projected(count);
  std::vector<Visibility> visibility(count, Visibility::kNot);
  ParallelFor(context, "visible curves", (count + kChunk - 1) / kChunk, [&](size_t chunk) {
    for (size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) {
      const int sample = static_cast<int>(i);
      projected[i] = ProjectSample(view, samples_, sample);
      if (projected[i]) visibility[i] = VisibilityIn(view, sample);
    }
  });
  ForetoldView foretold;
  for (size_t i = 0; i < count; ++i) {
    if (visibility[i] == Visibility::kNot) continue;
    foretold.possible.edgels.push_back(*projected[i]);
    if (visibility[i] == Visibility::kSure) foretold.sure.push_back(*projected[i]);
  }
  return foretold;
}

}  // namespace limn
