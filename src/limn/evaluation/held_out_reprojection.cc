#include "limn/evaluation/held_out_reprojection.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "limn/evaluation/curve_samples.h"
#include "limn/evaluation/footprint.h"
#include "limn/evaluation/quantiles.h"
#include "limn/geometry/epipolar.h"
#include "limn/support/edgel_residual.h"
#include "limn/support/view_evidence.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using Evidence = std::vector<std::unique_ptr<ViewEvidence>>;

constexpr double kRadiansPerDegree = M_PI / 180;
// Spacing of samples along a curve, px; half of it is the reach of an edgel along its edge.
constexpr double kSpacingPx = 1;
constexpr size_t kChunk = 1024;

SupportGate ShownGate(const HeldOutOptions& options) {
  return {options.shown_distance_px, kSpacingPx, options.shown_angle_deg * kRadiansPerDegree};
}

CurveSamples SampleByPixels(const std::vector<SupportedCurve>& curves,
                            const std::vector<View>& views) {
  CurveSet set;
  for (const SupportedCurve& curve : curves) set.polylines.push_back(curve.points_in_world);
  return CurveSamples(set, [&](const Polyline3d& polyline) {
    return kSpacingPx * FootprintOfCurve(views, polyline);
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
  edgel.tangent_rad = *direction;
  return edgel;
}

enum class Visibility { kNot, kMaybe, kSurely };

// What the training views tell of the visibility of samples.
struct Witnesses {
  const std::vector<SupportedCurve>& curves;
  const CurveSamples& samples;
  const HeldOutInput& input;
  const Evidence& evidence;
  const HeldOutOptions& options;

  bool Shows(ViewId view, int sample) const {
    const auto& supporting = curves[samples.CurveOf(sample)].supporting_views;
    if (!std::binary_search(supporting.begin(), supporting.end(), view)) return false;
    const auto seen = ProjectSample(input.training_views[view], samples, sample);
    return seen &&
           evidence[view]->edgels.Best(seen->position_px, seen->tangent_rad, ShownGate(options));
  }

  // The views that contain the sample within the viewing angle, nearest first.
  std::vector<ViewId> Beside(const View& view, int sample) const {
    const Eigen::Vector3d& position = samples.Position(sample);
    const Eigen::Vector3d ray = (position - view.CenterInWorld()).normalized();
    const double min_cosine = std::cos(options.max_viewing_angle_deg * kRadiansPerDegree);
    std::vector<std::pair<double, ViewId>> found;
    for (size_t v = 0; v < input.training_views.size(); ++v) {
      const View& training = input.training_views[v];
      const double cosine = ray.dot((position - training.CenterInWorld()).normalized());
      if (cosine < min_cosine || !training.Project(position)) continue;
      found.emplace_back(-cosine, static_cast<ViewId>(v));
    }
    std::sort(found.begin(), found.end());
    std::vector<ViewId> beside;
    for (const auto& [order, v] : found) beside.push_back(v);
    return beside;
  }

  Visibility VisibilityIn(const View& view, int sample) const {
    constexpr int kSure = 2;
    int shown = 0;
    int asked = 0;
    for (const ViewId v : Beside(view, sample)) {
      shown += Shows(v, sample);
      ++asked;
      if (shown == kSure && asked == kSure) return Visibility::kSurely;
      if (shown > 0 && asked >= kSure) return Visibility::kMaybe;
    }
    return shown > 0 ? Visibility::kMaybe : Visibility::kNot;
  }
};

// The samples as the edgels that a view should have.
struct DrawnView {
  std::vector<Edgel> sure;
  EdgeMap possible;  // and sure
};

DrawnView DrawVisible(const Witnesses& witnesses, const View& view, const RunContext& context) {
  const auto count = static_cast<size_t>(witnesses.samples.size());
  std::vector<std::optional<Edgel>> projected(count);
  std::vector<Visibility> visibility(count, Visibility::kNot);
  ParallelFor(context, "held-out views", (count + kChunk - 1) / kChunk, [&](size_t chunk) {
    for (size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) {
      const int sample = static_cast<int>(i);
      projected[i] = ProjectSample(view, witnesses.samples, sample);
      if (projected[i]) visibility[i] = witnesses.VisibilityIn(view, sample);
    }
  });
  DrawnView drawn;
  for (size_t i = 0; i < count; ++i) {
    if (visibility[i] == Visibility::kNot) continue;
    drawn.possible.edgels.push_back(*projected[i]);
    if (visibility[i] == Visibility::kSurely) drawn.sure.push_back(*projected[i]);
  }
  return drawn;
}

double DistanceToNearest(const Edgel& from, const EdgeMap& to, const EdgelIndex& index,
                         const HeldOutOptions& options) {
  const double max_angle = options.max_angle_deg * kRadiansPerDegree;
  double nearest = options.cap_px;
  index.ForEachWithin(from.position_px, options.cap_px, [&](EdgelId id) {
    const Edgel& edgel = to.edgels[id];
    if (UndirectedAngle(from.tangent_rad, edgel.tangent_rad) > max_angle) return;
    const Eigen::Vector2d offset = from.position_px - edgel.position_px;
    const double across = offset.dot(edgel.Normal());
    const double along = std::max(0.0, std::abs(offset.dot(edgel.Tangent())) - 0.5 * kSpacingPx);
    nearest = std::min(nearest, std::hypot(across, along));
  });
  return nearest;
}

void AppendDistances(const std::vector<Edgel>& from, const EdgeMap& to, const EdgelIndex& index,
                     const HeldOutOptions& options, const RunContext& context,
                     std::vector<double>* distances) {
  const size_t begin = distances->size();
  distances->resize(begin + from.size());
  ParallelFor(context, "held-out distances", (from.size() + kChunk - 1) / kChunk, [&](size_t c) {
    for (size_t i = c * kChunk; i < std::min(from.size(), (c + 1) * kChunk); ++i) {
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
  LIMN_CHECK_OPTION(max_viewing_angle_deg, > 0);
  LIMN_CHECK_OPTION(max_viewing_angle_deg, <= 180);
  LIMN_CHECK_OPTION(shown_distance_px, > 0);
  LIMN_CHECK_OPTION(shown_angle_deg, > 0);
  LIMN_CHECK_OPTION(max_angle_deg, > 0);
  LIMN_CHECK_OPTION(cap_px, > 0);
  LIMN_CHECK_OPTION(min_fragment_length_px, >= 0);
}

std::vector<SupportedCurve> ToSupportedCurves(const DrawingGraph& graph) {
  std::vector<SupportedCurve> curves;
  for (const DrawingLink& link : graph.links) {
    curves.push_back({link.points_in_world, link.supporting_views});
  }
  return curves;
}

std::vector<SupportedCurve> ToSupportedCurves(const CurveSketch& sketch) {
  std::vector<SupportedCurve> curves;
  for (const Curve3D& curve : sketch.curves) {
    SupportedCurve supported{curve.points_in_world, {}};
    if (curve.closed && curve.size() > 1) {
      supported.points_in_world.push_back(curve.points_in_world.front());
    }
    std::set<ViewId> views;
    for (const EdgelRef& edgel : curve.support.edgels) views.insert(edgel.view);
    supported.supporting_views.assign(views.begin(), views.end());
    curves.push_back(std::move(supported));
  }
  return curves;
}

HeldOutReport MeasureHeldOut(const std::vector<SupportedCurve>& curves, const HeldOutInput& input,
                             const HeldOutOptions& options, const RunContext& context) {
  options.Check();
  const SupportGate gate = ShownGate(options);
  const Evidence training =
      BuildEvidence(input.training_views, input.training_curves, gate, context);
  const Evidence held_out =
      BuildEvidence(input.held_out_views, input.held_out_curves, gate, context);
  const CurveSamples samples = SampleByPixels(curves, input.training_views);
  const Witnesses witnesses{curves, samples, input, training, options};
  std::vector<double> there, back;
  for (size_t v = 0; v < input.held_out_views.size(); ++v) {
    const DrawnView drawn = DrawVisible(witnesses, input.held_out_views[v], context);
    const EdgeMap& possible = drawn.possible;
    const EdgelIndex possible_index(possible, std::vector<bool>(possible.edgels.size(), true));
    const ImageCurves& image = input.held_out_curves[v];
    AppendDistances(drawn.sure, image.edge_map, held_out[v]->edgels, options, context, &there);
    AppendDistances(EdgelsOfLongFragments(image, options.min_fragment_length_px), possible,
                    possible_index, options, context, &back);
  }
  return {Summarize(there, options.cap_px), Summarize(back, options.cap_px)};
}

}  // namespace limn
