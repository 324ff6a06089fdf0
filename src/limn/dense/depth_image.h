#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// What a view sees of a dense surface: depths along the optical axis on a grid of cells over its
// virtual image.
struct DepthImage {
  int width = 0;
  int height = 0;
  // The cell (column, row) stands for the pixel origin_px + cell_px * (column, row), virtual px.
  Eigen::Vector2d origin_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d cell_px = Eigen::Vector2d::Ones();
  std::vector<float> depth;  // rows in order; 0 = unknown
  // Unit normals in the world, facing the view; zero = unknown. Empty: none is known.
  std::vector<Eigen::Vector3f> normal_in_world;

  bool Contains(int column, int row) const {
    return column >= 0 && column < width && row >= 0 && row < height;
  }
  // 0 outside.
  float DepthAt(int column, int row) const {
    return Contains(column, row) ? depth[static_cast<size_t>(row) * width + column] : 0;
  }
  // The nearest cell's column and row, perhaps outside.
  Eigen::Vector2i CellAt(const Eigen::Vector2d& pixel) const {
    return ((pixel - origin_px).array() / cell_px.array()).round().cast<int>();
  }
  Eigen::Vector2d PixelOf(int column, int row) const {
    return origin_px + Eigen::Vector2d(column * cell_px.x(), row * cell_px.y());
  }
};

// The normal of the surface at a cell, in the world, facing the view: the one that is stored, else
// that of the four depths around, if there is no step between them. Nothing if unknown.
std::optional<Eigen::Vector3d> NormalAt(const View& view, const DepthImage& image, int column,
                                        int row);

}  // namespace limn
