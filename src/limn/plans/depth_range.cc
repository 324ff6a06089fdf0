// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/depth_range.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "limn/geometry/shape_part.h"
#include "limn/plans/link_parts.h"

namespace limn {
namespace {

// Of a shape; between two of them it crosses each plane once at most.
constexpr int kSamples = 256;
constexpr int kHalvings = 60;
// Parts of points of a cut shape are within this share of the link's length of it.
constexpr double kSampling = 1e-4;

struct Part {
  double from = 0;
  double to = 0;
};

double Crossing(const std::function<double(double)>& depth_at, double first, double second,
                double level) {
  const bool first_is_below = depth_at(first) < level;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = std::midpoint(first, second);
    (depth_at(middle) < level) == first_is_below ? first = middle : second = middle;
  }
  return std::midpoint(first, second);
}

// The parts within a range of a curve that is given by its depth, from its ascending parameters.
std::vector<Part> PartsWithin(const DepthRange& range, const std::vector<double>& samples,
                              const std::function<double(double)>& depth_at) {
  std::vector<Part> parts;
  for (size_t i = 1; i < samples.size(); ++i) {
    const double depths[] = {depth_at(samples[i - 1]), depth_at(samples[i])};
    std::vector<double> cuts = {samples[i - 1], samples[i]};
    for (const double level : {range.near, range.far}) {
      if ((depths[0] < level) == (depths[1] < level)) continue;
      cuts.push_back(Crossing(depth_at, samples[i - 1], samples[i], level));
    }
    std::sort(cuts.begin(), cuts.end());
    for (size_t k = 1; k < cuts.size(); ++k) {
      const double depth = depth_at(std::midpoint(cuts[k - 1], cuts[k]));
      if (cuts[k] <= cuts[k - 1] || depth < range.near || depth > range.far) continue;
      if (!parts.empty() && parts.back().to == cuts[k - 1]) {
        parts.back().to = cuts[k];
      } else {
        parts.push_back({cuts[k - 1], cuts[k]});
      }
    }
  }
  return parts;
}

Eigen::Vector3d PointOn(const Polyline3d& points, double t) {
  const auto i = std::min(static_cast<size_t>(t), points.size() - 2);
  const double part = t - static_cast<double>(i);
  return (1 - part) * points[i] + part * points[i + 1];
}

Polyline3d PartOfPoints(const Polyline3d& points, const Part& part) {
  Polyline3d result = {PointOn(points, part.from)};
  for (auto i = static_cast<size_t>(part.from) + 1; static_cast<double>(i) < part.to; ++i) {
    result.push_back(points[i]);
  }
  result.push_back(PointOn(points, part.to));
  return result;
}

void ClipShape(const DrawingLink& link, const DepthRange& range, LinkPartsBuilder* builder) {
  const CurveShape& shape = link.primitive->shape;
  std::vector<double> samples;
  for (int k = 0; k <= kSamples; ++k) samples.push_back(static_cast<double>(k) / kSamples);
  const double tolerance = kSampling * Length(link.points_in_world);
  for (const Part& part :
       PartsWithin(range, samples, [&](double t) { return range.DepthOf(PointAt(shape, t)); })) {
    const bool is_whole = part.from == 0 && part.to == 1;
    CurveShape of_part = PartOf(shape, part.from, part.to);
    Polyline3d points = is_whole ? link.points_in_world : SampleShape(of_part, tolerance);
    if (Length(points) == 0) continue;
    builder->Add(link, part.from == 0, part.to == 1, {std::move(points), std::move(of_part)});
  }
}

void ClipPoints(const DrawingLink& link, const DepthRange& range, LinkPartsBuilder* builder) {
  const Polyline3d& points = link.points_in_world;
  std::vector<double> samples(points.size());
  std::iota(samples.begin(), samples.end(), 0.0);
  for (const Part& part :
       PartsWithin(range, samples, [&](double t) { return range.DepthOf(PointOn(points, t)); })) {
    Polyline3d of_part = PartOfPoints(points, part);
    if (Length(of_part) == 0) continue;
    builder->Add(link, part.from == 0, part.to == samples.back(), {std::move(of_part), {}});
  }
}

// The part of a convex polygon on one side of a plane, by Sutherland and Hodgman.
Polyline3d HalfOf(const Polyline3d& polygon, const Eigen::Vector3d& direction, double least) {
  Polyline3d half;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d& from = polygon[i];
    const Eigen::Vector3d& to = polygon[(i + 1) % polygon.size()];
    const double before = direction.dot(from) - least, after = direction.dot(to) - least;
    if (before >= 0) half.push_back(from);
    if ((before >= 0) != (after >= 0))
      half.push_back(from + before / (before - after) * (to - from));
  }
  return half;
}

bool HasPlaces(const DrawingDimension& dimension, const DepthRange& range) {
  return range.Has(dimension.from) && range.Has(dimension.to);
}

}  // namespace

DrawingGraph Clipped(const DrawingGraph& graph, const DepthRange& range) {
  LinkPartsBuilder builder(graph.nodes);
  for (const DrawingLink& link : graph.links) {
    (link.primitive ? ClipShape : ClipPoints)(link, range, &builder);
  }
  DrawingGraph clipped = std::move(builder).Build();
  for (const DrawingDimension& dimension : graph.dimensions) {
    if (HasPlaces(dimension, range)) clipped.dimensions.push_back(dimension);
  }
  return clipped;
}

TriangleMesh Clipped(const TriangleMesh& mesh, const DepthRange& range) {
  TriangleMesh clipped;
  for (const auto& [a, b, c] : mesh.triangles) {
    Polyline3d polygon = {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    if (std::isfinite(range.near)) polygon = HalfOf(polygon, range.forward, range.near);
    if (std::isfinite(range.far)) polygon = HalfOf(polygon, -range.forward, -range.far);
    const int first = static_cast<int>(clipped.vertices.size());
    clipped.vertices.insert(clipped.vertices.end(), polygon.begin(), polygon.end());
    for (int i = 2; i < static_cast<int>(polygon.size()); ++i) {
      clipped.triangles.push_back({first, first + i - 1, first + i});
    }
  }
  return clipped;
}

}  // namespace limn
