// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/formats/colors.h"
#include "limn/model/image.h"
#include "limn/pictures/picture.h"

namespace limn {

// A picture to draw on. Positions are in pixels of the view (center of the top-left pixel at (0,
// 0)) at any enlargement. Lines and marks are anti-aliased.
class Canvas {
 public:
  // White, or a photograph multiplied by `brightness`, enlarged `scale` times.
  Canvas(int width, int height, int scale);
  Canvas(const Image& photo, double brightness, int scale);

  // Widths and radii are in pixels of the picture.
  void DrawLine(const std::vector<Eigen::Vector2d>& points, const Color& color, int width);
  void DrawDisc(const Eigen::Vector2d& center, double radius, const Color& color);
  void DrawSquare(const Eigen::Vector2d& center, double radius, const Color& color);
  void DrawDiamond(const Eigen::Vector2d& center, double radius, const Color& color);

  const Picture& picture() const { return picture_; }

 private:
  void DrawPolygon(const Eigen::Vector2d& center, const std::vector<Eigen::Vector2d>& corners,
                   const Color& color);
  Eigen::Vector2d OnPicture(const Eigen::Vector2d& pixel) const;

  Eigen::Array2d scale_;  // pixels of the picture per pixel of the view
  Picture picture_;
};

}  // namespace limn
