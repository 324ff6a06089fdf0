// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A pixel of a photograph as stored, as COLMAP counts them: the middle of the top-left one is
// (0.5, 0.5).
struct ImagePoint {
  std::string image;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

// "a.jpg 120,340".
std::string TextOf(const ImagePoint& point);

// The place of a drawing that a photograph shows at a pixel.
struct DrawingPlace {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  // By the sigma of the link there, and along it by kClickSigmaPx; zero: unknown.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  LinkId link = -1;
  double distance_px = 0;  // from the pixel
};

// The place on the nearest link, at most kMaxSnapPx away; of several within a pixel more, the one
// in front. Links that the image supports come before all others, which may be hidden there. `view`
// is the photograph as stored (pixels of its file). Throws InputError if there is none, or the lens
// does not see that pixel. Linear in the points of the links.
DrawingPlace SnapToDrawing(const ImagePoint& point, const View& view, ViewId id,
                           const DrawingGraph& graph);

constexpr double kMaxSnapPx = 6;
// How well a pixel is clicked.
constexpr double kClickSigmaPx = 1;

}  // namespace limn
