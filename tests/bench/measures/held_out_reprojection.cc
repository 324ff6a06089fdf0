// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/held_out_reprojection.h"

#include <algorithm>
#include <cmath>

#include "limn/evaluation/quantiles.h"
#include "limn/geometry/epipolar.h"
#include "limn/support/view_edgels.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr size_t kEdgelChunk = 1024;

double DistanceToNearest(const Edgel& from, const EdgeMap& to, const EdgelIndex& index,
                         const HeldOutOptions& options) {
  const double max_angle = options.max_angle_deg * kDeg;
  double nearest = options.cap_px;
  index.ForEachWithin(from.position_px, options.cap_px, [&](EdgelId id) {
    const Edgel& edgel = to.edgels[id];
    if (UndirectedAngle(from.tangent_rad, edgel.tangent_rad) > max_angle) return;
    const Eigen::Vector2d offset = from.position_px - edgel.position_px;
    const double across = offset.dot(edgel.Normal());
    const double along =
        std::max(0.0, std::abs(offset.dot(edgel.Tangent())) - 0.5 * CurveVisibility::kSpacingPx);
    nearest = std::min(nearest, std::hypot(across, along));
  });
  return nearest;
}

void AppendDistances(const std::vector<Edgel>& from, const EdgeMap& to, const EdgelIndex& index,
                     const HeldOutOptions& options, const RunContext& context,
                     std::vector<double>* distances) {
  const size_t begin = distances->size();
  distances->resize(begin + from.size());
  ParallelFor(
      context, "held-out distances", (from.size() + kEdgelChunk - 1) / kEdgelChunk, [&](size_t c) {
        for (size_t i = c * kEdgelChunk; i < std::min(from.size(), (c + 1) * kEdgelChunk); ++i) {
          (*distances)[begin + i] = DistanceToNearest(from[i], to, index, options);
        }
      });
}

double FragmentLength(const ImageCurves& curves, const CurveFragment& fragment) {
  double length = 0;
  for (size_t i = 1; i < fragment.edgel_ids.size(); ++i) {
    length += (curves.edge_map.edgels[fragment.edgel_ids[i]].position_px -
               curves.edge_map.edgels[fragment.edgel_ids[i - 1]].position_px)
                  .norm();
  }
  return length;
}

std::vector<Edgel> EdgelsOfLongFragments(const ImageCurves& curves, double min_length_px) {
  std::vector<Edgel> edgels;
  for (const CurveFragment& fragment : curves.fragments) {
    if (FragmentLength(curves, fragment) < min_length_px) continue;
    for (const EdgelId id : fragment.edgel_ids) edgels.push_back(curves.edge_map.edgels[id]);
  }
  return edgels;
}

ReprojectionDistances Summarize(const std::vector<double>& distances, double cap_px) {
  ReprojectionDistances summary;
  summary.count = static_cast<int>(distances.size());
  if (distances.empty()) return summary;
  summary.median_px = Quantile(distances, 0.5);
  summary.p90_px = Quantile(distances, 0.9);
  const auto lonely = std::count(distances.begin(), distances.end(), cap_px);
  summary.lonely = static_cast<double>(lonely) / static_cast<double>(distances.size());
  return summary;
}

}  // namespace

void HeldOutOptions::Check() const {
  visibility.Check();
  LIMN_CHECK_OPTION(max_angle_deg, > 0);
  LIMN_CHECK_OPTION(cap_px, > 0);
  LIMN_CHECK_OPTION(min_fragment_length_px, >= 0);
}

HeldOutReport MeasureHeldOut(const std::vector<SupportedCurve>& curves, const HeldOutInput& input,
                             const HeldOutOptions& options, const RunContext& context) {
  options.Check();
  const CurveVisibility visibility(curves, input.training_views, input.training_curves,
                                   options.visibility, context);
  std::vector<double> there, back;
  for (size_t v = 0; v < input.held_out_views.size(); ++v) {
    const View& view = input.held_out_views[v];
    const ImageCurves& image = input.held_out_curves[v];
    const EdgelIndex index(image.edge_map, LinkedEdgels(image));
    const auto [sure, possible] = visibility.Foretell(view, context);
    const EdgelIndex possible_index(possible, std::vector<bool>(possible.edgels.size(), true));
    AppendDistances(sure, image.edge_map, index, options, context, &there);
    AppendDistances(EdgelsOfLongFragments(image, options.min_fragment_length_px), possible,
                    possible_index, options, context, &back);
  }
  return {Summarize(there, options.cap_px), Summarize(back, options.cap_px)};
}

}  // namespace limn
