// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/similarity3.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/drawing_stamp.h"
#include "limn/model/link_selection.h"
#include "limn/model/view.h"

namespace limn {

// A small picture of a view's virtual pinhole image.
struct ViewerThumbnail {
  // The rectangle of the virtual image that the picture covers, from edge to edge (the top-left
  // pixel begins at (-0.5, -0.5)), px.
  Eigen::Vector2d min_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d max_px = Eigen::Vector2d::Zero();
  // A JPEG file; empty = the view has no picture.
  std::string jpeg;
};

struct ViewerPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::array<uint8_t, 3> color = {};
};

// Everything that a page shows. Positions are in the coordinates that the page displays, the
// model's or the world's.
struct ViewerScene {
  std::string title;
  // How the displayed coordinates come from those of drawing.json, in which edits are written.
  Similarity3d shown_from_model;
  // The unit of displayed lengths.
  std::string unit = "model units";
  // Relative standard deviation of the scale that makes it this unit; 0: unknown.
  double scale_sigma = 0;
  // Whether z points up, as in the world.
  bool z_is_up = false;
  // The file that the graph is from.
  DrawingStamp drawing;
  DrawingGraph graph;
  // What of it is shown at first.
  Detail detail = Detail::kNormal;
  // The views that the links' supporting views are indices into.
  std::vector<View> views;
  // One per view, or none at all.
  std::vector<ViewerThumbnail> thumbnails;
  std::vector<ViewerPoint> cloud;
  // The text of a JSON object for the tab "Report" (members: page/README.md); empty = no such tab.
  std::string report_json;
  // The text of a JSON object for those who make the page anew; empty = none. The page ignores it.
  std::string settings_json;
};

}  // namespace limn
