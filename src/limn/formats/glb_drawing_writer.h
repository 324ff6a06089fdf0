#pragma once

#include <iosfwd>
#include <vector>

#include <Eigen/Core>

#include "limn/formats/colors.h"
#include "limn/model/drawing_graph.h"

namespace limn {

struct GlbPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Color color;
};

struct GlbOptions {
  // The junctions of the graph as points.
  bool junctions = true;
  // Points of a cloud to go with the drawing, in its coordinates; finite.
  std::vector<GlbPoint> cloud;
};

// A drawing as binary glTF 2.0 (.glb), for Blender and other programs of scenes:
//   node "drawing"           its translation is the middle of the links
//     node "link_<id>"       a line strip with the link's points in its color (ColorOfCurve), an
//                            object of its own; a closed one returns to its first vertex by index.
//                            extras: "link", "length", "closed", "residual_px", "views", and where
//                            known "primitive" and "class"
//     node "junctions"       points, white; extras: "nodes", their ids in order
//     node "cloud"           points in their colors
// The graph has z up, glTF y up: (x, y, z) is written as (x, z, -y), which Blender's import turns
// back. Positions are floats from the middle of the links, so that places far from the origin keep
// their digits; the translation is written with all of them. Colors are linear, as glTF asks.
// Throws InputError if the file would be too large for the format (4 GB), or a coordinate is for a
// float.
void WriteDrawingGlb(const DrawingGraph& graph, const GlbOptions& options, std::ostream& out);

}  // namespace limn
