#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/alignment/image_point.h"
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

struct SpanEnd {
  Eigen::Vector3d position;
  double sigma = 0;
};
struct SpanEnds {
  SpanEnd from, to;
};

// A link's ends are those of its primitive if that is a line. Throws InputError if the drawing has
// no such link or node. Precondition: places are known.
SpanEnds EndsOf(const DrawingGraph& graph, const DrawingSpan& span);

}  // namespace limn
