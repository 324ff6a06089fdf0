#include "limn/dense/depth_image.h"

#include <cmath>

#include <Eigen/Geometry>

namespace limn {
namespace {

// Depths of neighbouring cells belong to one surface when they differ by less than so many cells.
constexpr double kMaxStepCells = 4;

std::optional<Eigen::Vector3d> PointAt(const View& view, const DepthImage& image, int column,
                                       int row) {
  const double depth = image.DepthAt(column, row);
  if (!(depth > 0)) return std::nullopt;
  return depth * view.camera.RayFromPixel(image.PixelOf(column, row));
}

// From one neighbour to the other, in the camera; nothing across a step.
std::optional<Eigen::Vector3d> Across(const View& view, const DepthImage& image, int column,
                                      int row, int dx, int dy) {
  const auto before = PointAt(view, image, column - dx, row - dy);
  const auto after = PointAt(view, image, column + dx, row + dy);
  if (!before || !after) return std::nullopt;
  const double here = image.DepthAt(column, row);
  const double cell =
      here * (dx * image.cell_px.x() + dy * image.cell_px.y()) / view.camera.MeanFocal();
  for (const Eigen::Vector3d& point : {*before, *after}) {
    if (std::abs(point.z() - here) > kMaxStepCells * cell) return std::nullopt;
  }
  return *after - *before;
}

}  // namespace

std::optional<Eigen::Vector3d> NormalAt(const View& view, const DepthImage& image, int column,
                                        int row) {
  if (!(image.DepthAt(column, row) > 0)) return std::nullopt;
  if (!image.normal_in_world.empty()) {
    const Eigen::Vector3f& stored =
        image.normal_in_world[static_cast<size_t>(row) * image.width + column];
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
