// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/link_selection.h"
#include "limn/model/view.h"

namespace limn {

// Projects a 3D polyline into a photograph: its runs in front of the camera, inside the view's
// region and within the lens model's range, in stored pixels, center of the top-left pixel at (0,
// 0). Segments are cut where they enter and leave, to a tenth of a pixel. Occlusion is ignored.
std::vector<std::vector<Eigen::Vector2d>> ProjectPolyline(
    const View& view, const std::vector<Eigen::Vector3d>& points_in_world);

// Writes the selected links of a drawing in the images as text with an explanatory header, like
// COLMAP's images.txt: one line per link, supporting view and visible run; pixels in COLMAP's
// convention (the center of the top-left pixel is (0.5, 0.5)). Throws InputError if a supporting
// view is out of range.
void WriteTracks(const DrawingGraph& graph, const LinkSelection& selection,
                 const std::vector<View>& views, std::ostream& out);

}  // namespace limn
