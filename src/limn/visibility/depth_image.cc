// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/depth_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace limn {
namespace {

// The farthest of the depth pixels around a position in depth pixels; infinite where there is
// nothing.
double FarthestAround(const DepthImage& image, const Eigen::Vector2d& at) {
  const auto clamped = [](double value, int count) {
    return static_cast<int>(std::clamp(value, 0.0, count - 1.0));
  };
  const int columns[] = {clamped(std::floor(at.x()), image.width),
                         clamped(std::ceil(at.x()), image.width)};
  const int rows[] = {clamped(std::floor(at.y()), image.height),
                      clamped(std::ceil(at.y()), image.height)};
  double farthest = 0;
  for (const int row : rows) {
    for (const int column : columns) {
      const double depth = image.At(column, row);
      if (!(depth > 0)) return std::numeric_limits<double>::infinity();
      farthest = std::max(farthest, depth);
    }
  }
  return farthest;
}

// Depths of neighboring cells belong to one surface when they differ by less than this many cells.
constexpr double kMaxStepCells = 4;

std::optional<Eigen::Vector3d> PointAt(const View& view, const DepthImage& image, int column,
                                       int row) {
  const double depth = image.DepthOr0(column, row);
  if (!(depth > 0)) return std::nullopt;
  return depth * view.camera.RayFromPixel(image.PixelOf(column, row));
}

// From one neighbor to the other, in the camera; nothing across a step.
std::optional<Eigen::Vector3d> Across(const View& view, const DepthImage& image, int column,
                                      int row, int dx, int dy) {
  const auto before = PointAt(view, image, column - dx, row - dy);
  const auto after = PointAt(view, image, column + dx, row + dy);
  if (!before || !after) return std::nullopt;
  const double here = image.DepthOr0(column, row);
  const double cell =
      here * (dx * image.cell_px.x() + dy * image.cell_px.y()) / view.camera.MeanFocal();
  for (const Eigen::Vector3d& point : {*before, *after}) {
    if (std::abs(point.z() - here) > kMaxStepCells * cell) return std::nullopt;
  }
  return *after - *before;
}

}  // namespace

DepthImage MakeDepthImage(const View& view, double scale) {
  const Eigen::Vector2d extent = view.region.max_px - view.region.min_px;
  DepthImage image;
  image.cell_px = Eigen::Vector2d::Constant(1 / scale);
  image.origin_px = view.region.min_px;
  image.width = std::max(0, static_cast<int>(std::ceil(extent.x() * scale))) + 1;
  image.height = std::max(0, static_cast<int>(std::ceil(extent.y() * scale))) + 1;
  image.depth.assign(static_cast<size_t>(image.width) * image.height, 0);
  return image;
}

bool IsBehind(const DepthImage& depth, const Eigen::Vector2d& virtual_px, double z,
              double tolerance) {
  return z > FarthestAround(depth, depth.FromVirtual(virtual_px)) + tolerance;
}

bool IsVisible(const View& view, const DepthImage& depth, const Eigen::Vector3d& point_in_world,
               double tolerance_px) {
  const auto pixel = view.Project(point_in_world);
  if (!pixel) return false;
  const double z = (view.cam_from_world * point_in_world).z();
  const double tolerance = tolerance_px * z / view.camera.MeanFocal();
  return !IsBehind(depth, *pixel, z, tolerance);
}

std::optional<Eigen::Vector3d> NormalAt(const View& view, const DepthImage& image, int column,
                                        int row) {
  if (!(image.DepthOr0(column, row) > 0)) return std::nullopt;
  if (!image.normal_in_world.empty()) {
    const Eigen::Vector3f& stored = image.normal_in_world[image.Index(column, row)];
    if (stored.squaredNorm() > 0.5f) return stored.cast<double>().normalized();
  }
  const auto x = Across(view, image, column, row, 1, 0);
  const auto y = Across(view, image, column, row, 0, 1);
  if (!x || !y) return std::nullopt;
  Eigen::Vector3d normal = x->cross(*y);
  if (!(normal.norm() > 0)) return std::nullopt;
  normal.normalize();
  if (normal.dot(*PointAt(view, image, column, row)) > 0) normal = -normal;
  return view.cam_from_world.rotation.conjugate() * normal;
}

}  // namespace limn
