// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/pictures/overlays.h"

namespace limn {

// A camera on a circle around a drawing. Angles in degrees.
struct OrbitOptions {
  // Around `up`, from an arbitrary but fixed direction; any value.
  double azimuth_deg = 30.0;
  // Above the plane across `up`, in (-90, 90).
  double elevation_deg = 25.0;
  // Size of the picture, pixels.
  int width = 1200;
  int height = 900;
  // Share of the points of the drawing that must be in the picture, in (0, 1], so that stray links
  // do not decide the distance of the camera. Raising it moves the camera back.
  double kept_share = 0.98;

  void Check() const;
};

// Mean upward direction of the cameras (against the y axis of their images), unit length; the z
// axis if they cancel out.
Eigen::Vector3d UpDirection(const std::vector<View>& views);

// Throws InputError if the drawing has no links.
View OrbitView(const DrawingGraph& graph, const Eigen::Vector3d& up, const OrbitOptions& options);

// The drawing alone on white, one color per curve, with its nodes.
Picture RenderDrawing(const DrawingGraph& graph, const View& view,
                      const PictureOptions& options = {});

}  // namespace limn
