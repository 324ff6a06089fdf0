// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/link.h"

#include <algorithm>
#include <cmath>

#include "limn/formats/svg/shape.h"
#include "limn/formats/tracks_writer.h"
#include "limn/geometry/bezier.h"
#include "limn/geometry/polyline.h"

namespace limn {
namespace {

// The center of the top-left pixel in SVG.
constexpr double kSvgFromOurs = 0.5;

// A polyline by arc length.
class PolylineAt {
 public:
  explicit PolylineAt(const Polyline3d& points)
      : points_(points), lengths_(CumulativeLength(points)) {}

  Eigen::Vector3d operator()(double t) const {
    const auto next = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, t);
    const size_t i = next - lengths_.begin();
    const double step = lengths_[i] - lengths_[i - 1];
    const double part = step > 0 ? std::clamp((t - lengths_[i - 1]) / step, 0.0, 1.0) : 0;
    return (1 - part) * points_[i - 1] + part * points_[i];
  }

  // Steps of about a pixel; `footprint_at` tells the length of one, or 0 where there is none.
  template <typename Footprint>
  std::vector<CurveSample> Samples(const Footprint& footprint_at) const {
    constexpr double kMaxSteps = 4096;
    constexpr double kBlindSteps = 64;
    std::vector<CurveSample> samples = {{0, 0}};
    for (size_t i = 1; i < points_.size(); ++i) {
      const double length = lengths_[i] - lengths_[i - 1];
      const double footprint = std::min(footprint_at(points_[i - 1]), footprint_at(points_[i]));
      const double length_px = footprint > 0 ? length / footprint : 0;
      const double steps =
          std::clamp(footprint > 0 ? std::ceil(length_px) : kBlindSteps, 1.0, kMaxSteps);
      const CurveSample before = samples.back();
      for (int k = 1; k <= steps; ++k) {
        samples.push_back(
            {before.t + k / steps * length, before.length_px + k / steps * length_px});
      }
      samples.back().t = lengths_[i];
    }
    return samples;
  }

 private:
  const Polyline3d& points_;
  std::vector<double> lengths_;
};

std::vector<CurveSample> SamplesOf(const CurveShape& shape, double length, const SvgSheet& sheet) {
  constexpr double kMaxSteps = 65536;
  const int steps = static_cast<int>(std::clamp(std::ceil(length / sheet.px()), 8.0, kMaxSteps));
  std::vector<CurveSample> samples = {{0, 0}};
  Eigen::Vector2d before = sheet.ToSheet(PointAt(shape, 0));
  for (int k = 1; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const Eigen::Vector2d at = sheet.ToSheet(PointAt(shape, t));
    samples.push_back({t, samples.back().length_px + (at - before).norm() / sheet.px()});
    before = at;
  }
  return samples;
}

LinkPath EmptyPath(const LinkPathOptions& options) {
  return {SvgPath(options.decimals), SvgPath(options.decimals)};
}

void SetEnds(const std::vector<ShownRun>& runs, LinkPath* path) {
  path->end_is_open[0] = !runs.front().hidden;
  path->end_is_open[1] = !runs.back().hidden;
}

bool HasShape(const DrawingLink& link, const LinkPathOptions& options) {
  return options.use_primitives && link.primitive.has_value();
}

// Smallest footprint of the link's points before the camera; 0 if there is none.
double SmallestFootprint(const View& view, const DrawingLink& link) {
  double smallest = 0;
  for (const Eigen::Vector3d& point : link.points_in_world) {
    const double z = (view.cam_from_world * point).z();
    if (z > 0 && (smallest == 0 || z < smallest)) smallest = z;
  }
  return smallest / view.camera.MeanFocal();
}

// Chords take no more than a quarter of the tolerance. Points close to the camera do not make it
// finer than a hundred thousandth of the link.
Polyline3d PointsFor(const View& view, const DrawingLink& link, const LinkPathOptions& options) {
  if (!HasShape(link, options)) return link.points_in_world;
  const double tolerance = std::max(0.25 * options.tolerance_px * SmallestFootprint(view, link),
                                    1e-5 * Length(link.points_in_world));
  return SampleShape(link.primitive->shape, tolerance);
}

void AppendRun(const SvgSheet& sheet, const Polyline3d& points, const ShownRun& run,
               double tolerance, SvgPath* path) {
  std::vector<Eigen::Vector2d> places;
  for (const Eigen::Vector3d& point : CutPolyline(points, run.from, run.to)) {
    places.push_back(sheet.ToSheet(point));
  }
  AppendFitted(places, tolerance, path);
}

}  // namespace

LinkPath DrawLink(const View& view, const DrawingLink& link, const IsHidden& is_hidden,
                  const LinkPathOptions& options) {
  const Polyline3d points = PointsFor(view, link, options);
  const PolylineAt point_at(points);
  const auto footprint_at = [&](const Eigen::Vector3d& point) {
    return std::max((view.cam_from_world * point).z(), 0.0) / view.camera.MeanFocal();
  };
  const std::vector<ShownRun> runs =
      FindRuns(point_at, point_at.Samples(footprint_at), is_hidden, options.min_run_px);
  LinkPath path = EmptyPath(options);
  for (const ShownRun& run : runs) {
    for (std::vector<Eigen::Vector2d>& pixels :
         ProjectPolyline(view, CutPolyline(points, run.from, run.to))) {
      for (Eigen::Vector2d& pixel : pixels) pixel.array() += kSvgFromOurs;
      AppendFitted(pixels, options.tolerance_px, run.hidden ? &path.hidden : &path.visible);
    }
  }
  SetEnds(runs, &path);
  return path;
}

LinkPath DrawLink(const SvgSheet& sheet, const DrawingLink& link, const IsHidden& is_hidden,
                  const LinkPathOptions& options) {
  const LinkRuns runs = RunsOnSheet(sheet, link, is_hidden, options);
  const double tolerance = options.tolerance_px * sheet.px();
  LinkPath path = EmptyPath(options);
  for (const ShownRun& run : runs.runs) {
    SvgPath* const into = run.hidden ? &path.hidden : &path.visible;
    if (runs.of_shape) {
      AppendShape(sheet, link.primitive->shape, run.from, run.to, tolerance, into);
    } else {
      AppendRun(sheet, link.points_in_world, run, tolerance, into);
    }
  }
  SetEnds(runs.runs, &path);
  return path;
}

LinkRuns RunsOnSheet(const SvgSheet& sheet, const DrawingLink& link, const IsHidden& is_hidden,
                     const LinkPathOptions& options) {
  const Polyline3d& points = link.points_in_world;
  if (HasShape(link, options)) {
    const CurveShape& shape = link.primitive->shape;
    const auto point_at = [&](double t) { return PointAt(shape, t); };
    return {
        FindRuns(point_at, SamplesOf(shape, Length(points), sheet), is_hidden, options.min_run_px),
        true};
  }
  const PolylineAt point_at(points);
  const auto footprint_at = [&](const Eigen::Vector3d&) { return sheet.px(); };
  return {FindRuns(point_at, point_at.Samples(footprint_at), is_hidden, options.min_run_px), false};
}

}  // namespace limn
