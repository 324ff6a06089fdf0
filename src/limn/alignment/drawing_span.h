// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/alignment/image_point.h"
#include "limn/model/alignment.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Two places of a drawing, as options name them: the ends of a link, two nodes, or what photographs
// show at two pixels.
struct DrawingSpan {
  LinkId link = -1;
  NodeId node0 = -1;
  NodeId node1 = -1;
  std::vector<ImagePoint> pixels = {};    // two, or none
  std::vector<DrawingPlace> places = {};  // of the pixels, once they are known (SnapToDrawing)
};

// From "link 12", "from 3 to 7" or "a.jpg 120,340 to b.jpg 500,220". Nothing for other texts.
std::optional<DrawingSpan> ParseSpan(const std::string& text);

// From the first place of a span to the second; of a link from its first end to its last. Throws
// InputError if the drawing has no such link or node, or both places are the same.
Eigen::Vector3d WayOf(const DrawingGraph& graph, const DrawingSpan& span);

struct MeasuredLength {
  double length = 0;
  double sigma = 0;  // standard deviation; 0: unknown
};

// Of a link that of its primitive, which does not follow the noise of its points; of a spline or a
// link without a primitive that of its points. Otherwise the distance between two places. The
// standard deviation is that of the places along the line through both (algorithm/belief.md#nodes);
// of an arc also of its radius, and of a link that ends where it begins of this alone. Throws
// InputError if the drawing has no such link or node, or two places are the same. Precondition:
// places are known.
MeasuredLength MeasureSpan(const DrawingGraph& graph, const DrawingSpan& span);

// Between any two places of the drawing: each is a node if one is there, else the nearest point of
// a link, known by its sigma. Linear in nodes and points.
MeasuredLength MeasureBetween(const DrawingGraph& graph, const Eigen::Vector3d& from,
                              const Eigen::Vector3d& to);

// Sets the standard deviations of the dimensions, with that of the scale (InWorld).
void MeasureDimensions(const Alignment& alignment, DrawingGraph* graph);

// In the world: in its unit, and with the standard deviation of its scale, without which that of a
// length in meters is unknown.
MeasuredLength InWorld(const MeasuredLength& in_model, const Alignment& alignment);

}  // namespace limn
