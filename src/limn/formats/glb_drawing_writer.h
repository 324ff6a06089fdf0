// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <vector>

#include <Eigen/Core>

#include "limn/formats/colors.h"
#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"

namespace limn {

struct GlbPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Color color;
};

// What becomes an object of its own.
enum class GlbObjects {
  kKind,  // all links of a kind of edge: programs take long for thousands of objects
  kLink,
};

struct GlbOptions {
  GlbObjects objects = GlbObjects::kKind;
  // The junctions of the graph as points.
  bool junctions = true;
  // Rods as tubes of their radius.
  bool rods_as_tubes = false;
  // Points of a cloud to export with the drawing, in its coordinates; finite.
  std::vector<GlbPoint> cloud;
};

// Writes a drawing as binary glTF 2.0 (.glb), for Blender and other 3D programs:
//   node "drawing"           its translation is the middle of the links
//     node "<kind>"          the lines of all links of a kind ("edge", "paint", ...; "tentative" of
//                            any kind) with their points in the color of their curve; per vertex
//                            the attribute _LINK, the id of its link. extras: "kind", "links" (how
//                            many), "length"
//     node "link_<id>"       instead, if each link is an object: a line strip; a closed one returns
//                            to its first vertex by index. extras: "link", "curve", "length",
//                            "closed", "residual_px", "views", and where known "primitive",
//                            "class", "kind" and "kind_confidence"; "tentative" if it is,
//                            "rod_radius" of rods. With rods_as_tubes a rod is in any case such a
//                            node, of triangles with smooth normals, of the material "rods", which
//                            is like "faces"
//     node "face_<id>"       triangles with normals, of the material "faces" (matt, seen from both
//                            sides). extras: "face", "surface", "area", "confidence", "views"
//     node "junctions"       points, white; extras: "nodes", their ids in order
//     node "cloud"           points in their colors
// glTF is in meters: coordinates in another known unit are converted. The graph has z up, glTF y
// up: (x, y, z) is written as (x, z, -y), which Blender's importer reverts. Positions are floats
// relative to the middle of the links, so that places far from the origin keep their digits; the
// translation is written with full precision. Colors are linear, as glTF requires. Throws
// InputError if the file exceeds the format's 4 GB, or a coordinate the range of float.
void WriteDrawingGlb(const DrawingGraph& graph, const GlbOptions& options, LengthUnit unit,
                     std::ostream& out);

}  // namespace limn
