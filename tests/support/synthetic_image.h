// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/image.h"

namespace limn::testing {

// Signed distance to the border of a shape, positive inside, px. Need be exact near the border
// only.
using Shape = std::function<double(const Eigen::Vector2d&)>;

// The side of the line through `point` that `normal` (unit) points to.
Shape HalfPlane(const Eigen::Vector2d& point, const Eigen::Vector2d& normal);
Shape Disc(const Eigen::Vector2d& center, double radius);
// Points within half the width of a segment.
Shape Stroke(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width);
// Any simple polygon, either orientation.
Shape Polygon(const std::vector<Eigen::Vector2d>& corners);
Shape Complement(const Shape& a);

Image ConstantImage(int width, int height, const std::vector<float>& levels);

// Blend the shape over the image by the area of each pixel it covers: every pixel near the border
// is split in 4 x 4 squares, and the shape is taken for a half plane in each (exact for straight
// edges).
void Paint(const Shape& shape, const std::vector<float>& levels, Image* image);

// Independent Gaussian noise on every value; not rounded, not clipped.
void AddNoise(double sigma, unsigned seed, Image* image);

// Round to integers and clip to 0..255, as a file would.
void Quantize(Image* image);

}  // namespace limn::testing
