// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/face_scores.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "limn/evaluation/area_samples.h"
#include "limn/evaluation/smooth_regions.h"
#include "limn/geometry/triangle_index.h"
#include "limn/model/footprint.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "limn/visibility/face_surface.h"
#include "limn/visibility/render_depth.h"

namespace limn {
namespace {

// Depth pixels per pixel.
constexpr double kDepthPixelsPerPx = 2;
constexpr size_t kSamplesPerTask = 512;
constexpr double kNotFound = std::numeric_limits<double>::infinity();

// Zero for a triangle without area.
std::vector<Eigen::Vector3d> NormalsOf(const PartedSurface& surface) {
  std::vector<Eigen::Vector3d> normals;
  normals.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const Eigen::Vector3d& origin = surface.vertices[a];
    normals.push_back(
        (surface.vertices[b] - origin).cross(surface.vertices[c] - origin).normalized());
  }
  return normals;
}

// A surface with what is needed to look at it.
struct JudgedSurface {
  const PartedSurface& surface;
  std::vector<Eigen::Vector3d> normals;
  TriangleIndex index;
  std::vector<AreaSample> samples;
};

JudgedSurface PrepareSurface(const PartedSurface& surface, const std::vector<View>& views,
                             const FaceScoreOptions& options, const RunContext& context) {
  const auto footprint = [&](const Eigen::Vector3d& point) { return PixelFootprint(views, point); };
  return {surface, NormalsOf(surface), TriangleIndex(surface.vertices, surface.triangles),
          SampleArea(surface.vertices, surface.triangles, options.spacing_px, footprint,
                     options.region, context)};
}

// In how many views each sample of the truth is visible. Views add up in any order: counts are the
// same whatever the threads.
std::vector<int> CountSeeingViews(const JudgedSurface& truth, const TriangleMesh& mesh,
                                  const std::vector<View>& views, const FaceScoreOptions& options,
                                  const RunContext& context) {
  std::vector<int> counts(truth.samples.size(), 0);
  const double min_sine = std::sin(options.min_grazing_deg * kDeg);
  ParallelFor(context, "visibility of the true surface", views.size(), [&](size_t v) {
    const View& view = views[v];
    const DepthImage depth = RenderDepth(mesh, view, kDepthPixelsPerPx);
    const Eigen::Vector3d center = Inverse(view.cam_from_world).translation;
    for (size_t i = 0; i < truth.samples.size(); ++i) {
      const AreaSample& sample = truth.samples[i];
      const Eigen::Vector3d ray = (sample.position - center).normalized();
      if (std::abs(ray.dot(truth.normals[sample.triangle])) < min_sine) continue;
      if (!IsVisible(view, depth, sample.position, options.occlusion_px)) continue;
      std::atomic_ref<int>(counts[i]).fetch_add(1, std::memory_order_relaxed);
    }
  });
  return counts;
}

// The distance of each sample that counts from the other surface where that has its direction,
// footprints; kNotFound beyond the largest tau.
std::vector<double> DistancesTo(const JudgedSurface& from, const std::vector<uint8_t>& counts,
                                const JudgedSurface& to, const FaceScoreOptions& options,
                                const RunContext& context) {
  const double min_cosine = std::cos(options.max_angle_deg * kDeg);
  const double reach = *std::max_element(options.taus.begin(), options.taus.end());
  std::vector<double> distances(from.samples.size(), kNotFound);
  const size_t num_tasks = (from.samples.size() + kSamplesPerTask - 1) / kSamplesPerTask;
  ParallelFor(context, "distances of surfaces", num_tasks, [&](size_t task) {
    const size_t end = std::min((task + 1) * kSamplesPerTask, from.samples.size());
    for (size_t i = task * kSamplesPerTask; i < end; ++i) {
      if (!counts[i]) continue;
      const AreaSample& sample = from.samples[i];
      const Eigen::Vector3d& normal = from.normals[sample.triangle];
      const auto has_direction = [&](int triangle) {
        return std::abs(normal.dot(to.normals[triangle])) >= min_cosine;
      };
      if (const auto nearest =
              to.index.Nearest(sample.position, reach * sample.unit, has_direction)) {
        distances[i] = nearest->distance / sample.unit;
      }
    }
  });
  return distances;
}

// Sums over the samples of a part.
struct PartSums {
  double area = 0;
  double square_footprints = 0;
  std::vector<double> area_within;  // per tau
};

std::vector<PartSums> SumParts(const JudgedSurface& judged, const std::vector<uint8_t>& counts,
                               const std::vector<double>& distances,
                               const std::vector<double>& taus) {
  std::vector<PartSums> parts(judged.surface.num_parts);
  for (PartSums& part : parts) part.area_within.assign(taus.size(), 0);
  for (size_t i = 0; i < judged.samples.size(); ++i) {
    if (!counts[i]) continue;
    const AreaSample& sample = judged.samples[i];
    PartSums& part = parts[judged.surface.part_of_triangle[sample.triangle]];
    part.area += sample.area;
    part.square_footprints += sample.area / (sample.unit * sample.unit);
    for (size_t t = 0; t < taus.size(); ++t) {
      if (distances[i] <= taus[t]) part.area_within[t] += sample.area;
    }
  }
  return parts;
}

// Of a whole surface.
struct SurfaceScore {
  double area = 0;
  std::vector<std::optional<double>> within;  // per tau
  std::vector<PartScore> parts;
};

SurfaceScore SummarizeParts(const std::vector<PartSums>& parts, double min_side_px,
                            size_t num_taus) {
  SurfaceScore score;
  std::vector<double> within(num_taus, 0);
  for (size_t p = 0; p < parts.size(); ++p) {
    const PartSums& part = parts[p];
    score.area += part.area;
    for (size_t t = 0; t < num_taus; ++t) within[t] += part.area_within[t];
    if (!(part.area > 0) || part.square_footprints < min_side_px * min_side_px) continue;
    PartScore& scored = score.parts.emplace_back();
    scored.part = static_cast<int>(p);
    scored.area = part.area;
    for (const double area : part.area_within) scored.within.push_back(area / part.area);
  }
  score.within.resize(num_taus);
  if (!(score.area > 0)) return score;
  for (size_t t = 0; t < num_taus; ++t) score.within[t] = within[t] / score.area;
  return score;
}

int CountAbove(const std::vector<PartScore>& parts, size_t tau, double share) {
  return static_cast<int>(std::count_if(
      parts.begin(), parts.end(), [&](const PartScore& part) { return part.within[tau] > share; }));
}

std::optional<double> HarmonicMean(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return std::nullopt;
  return *a + *b > 0 ? 2 * *a * *b / (*a + *b) : 0.0;
}

PartedSurface WithSmoothParts(const TriangleMesh& mesh, double max_bend_deg) {
  PartedSurface surface = SurfaceOf(mesh);
  surface.part_of_triangle = SmoothRegions(mesh, max_bend_deg);
  for (const int part : surface.part_of_triangle) {
    surface.num_parts = std::max(surface.num_parts, part + 1);
  }
  return surface;
}

std::vector<uint8_t> SeenByEnough(const std::vector<int>& num_views, int min_views) {
  std::vector<uint8_t> seen;
  seen.reserve(num_views.size());
  for (const int count : num_views) seen.push_back(count >= min_views);
  return seen;
}

}  // namespace

void FaceScoreOptions::Check() const {
  LIMN_CHECK_OPTION(taus.size(), > 0);
  for (const double tau : taus) {
    CheckOption(tau > 0 && tau <= 1e4, "taus", tau, "> 0 and <= 1e4");
  }
  LIMN_CHECK_RANGE(max_angle_deg, > 0, <= 90);
  LIMN_CHECK_RANGE(min_views, >= 1, <= 1e6);
  LIMN_CHECK_RANGE(min_grazing_deg, >= 0, <= 89);
  LIMN_CHECK_RANGE(occlusion_px, >= 0, <= 1e4);
  LIMN_CHECK_RANGE(spacing_px, >= 0.1, <= 1e4);
  LIMN_CHECK_RANGE(max_bend_deg, > 0, <= 180);
  LIMN_CHECK_RANGE(min_region_px, >= 0, <= 1e5);
  if (region && region->isEmpty()) throw OptionError("region: its minimum exceeds its maximum");
}

PartedSurface SurfaceOf(const std::vector<DrawingFace>& faces) {
  TriangleMesh mesh = MeshOf(faces);
  PartedSurface surface = {std::move(mesh.vertices), std::move(mesh.triangles), {}, 0};
  for (const DrawingFace& face : faces) {
    surface.part_of_triangle.insert(surface.part_of_triangle.end(), face.triangles.size(),
                                    surface.num_parts++);
  }
  return surface;
}

PartedSurface SurfaceOf(const TriangleMesh& mesh) {
  return {mesh.vertices, mesh.triangles, std::vector<int>(mesh.triangles.size(), 0), 1};
}

FaceScores ScoreFaces(const PartedSurface& surface, const TriangleMesh& truth,
                      const std::vector<View>& views, const FaceScoreOptions& options,
                      const RunContext& context) {
  options.Check();
  if (views.empty()) throw InputError("pixel footprints need at least one view");
  CheckOption(options.min_views <= static_cast<int>(views.size()), "min_views", options.min_views,
              "at most the number of views");
  const PartedSurface regions = WithSmoothParts(truth, options.max_bend_deg);
  const JudgedSurface found = PrepareSurface(surface, views, options, context);
  const JudgedSurface real = PrepareSurface(regions, views, options, context);
  const std::vector<uint8_t> all(found.samples.size(), 1);
  const std::vector<uint8_t> seen =
      SeenByEnough(CountSeeingViews(real, truth, views, options, context), options.min_views);
  const size_t num_taus = options.taus.size();
  SurfaceScore precision = SummarizeParts(
      SumParts(found, all, DistancesTo(found, all, real, options, context), options.taus), 0,
      num_taus);
  SurfaceScore recall = SummarizeParts(
      SumParts(real, seen, DistancesTo(real, seen, found, options, context), options.taus),
      options.min_region_px, num_taus);

  FaceScores scores;
  for (size_t t = 0; t < num_taus; ++t) {
    scores.rows.push_back({options.taus[t], precision.within[t], recall.within[t],
                           HarmonicMean(precision.within[t], recall.within[t]),
                           CountAbove(precision.parts, t, kRightShare),
                           CountAbove(recall.parts, t, kCoveredShare)});
  }
  scores.max_angle_deg = options.max_angle_deg;
  scores.area = precision.area;
  scores.true_area = recall.area;
  scores.faces = std::move(precision.parts);
  scores.regions = std::move(recall.parts);
  return scores;
}

}  // namespace limn
