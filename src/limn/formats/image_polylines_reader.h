// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace limn {

using ImagePolyline = std::vector<Eigen::Vector2d>;

// Reads linked curves and line segments of an image of width x height pixels as text (also
// gzipped): one curve per line, "x1 y1 x2 y2 ...", at least two points; blanks, tabs or commas
// between numbers. A curve whose last point equals its first is closed. Empty lines and those that
// begin with '#' are skipped. The center of the top-left pixel is (0, 0).
//
// Throws IoError with the line: something else than numbers, half a point, a curve shorter than
// 1e-6 px, a point more than a pixel outside the image or not finite, or curves that are together
// longer than the image has pixels.
std::vector<ImagePolyline> ReadImagePolylines(const std::string& path, int width, int height);

}  // namespace limn
