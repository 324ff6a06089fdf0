#pragma once

#include <iosfwd>

#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"

namespace limn {

// How links are assigned to layers of a DXF file.
enum class DxfLayers {
  // "line", "arc", "circle", "spline", "polyline" (links without a primitive); after drawing_fuser
  // with the class appended: "line_boundary".
  kClass,
  // A layer per kind of edge: "edge", "paint", "shadow", "contour", "unknown".
  kKind,
  // A layer per connected component: "component_1" is the longest.
  kComponent,
  // All on "drawing".
  kSingle,
  // A layer per face, "face_<id>", with the links that bound it; those of several faces are with
  // the largest. Links without a face are on "no_face".
  kFace,
};

struct DxfOptions {
  DxfLayers layers = DxfLayers::kClass;
  // Junctions as points, on a layer "junctions".
  bool junctions = true;
};

// Writes a drawing as ASCII DXF of AutoCAD 2000 (AC1015): per link a LINE, ARC, CIRCLE, SPLINE of
// degree 3, or a 3D POLYLINE where it has no primitive. Arcs and circles are in their object
// coordinate system (arbitrary axis algorithm). Faces are polyface meshes of their triangles, on
// the layer "faces" unless each has its own; edges between triangles are invisible. Every entity
// has extended data of the application LIMN: the id of its link, or of its node for points, or of
// its face (code 1071). Colors are those of the layers.
void WriteDrawingDxf(const DrawingGraph& graph, const DxfOptions& options, LengthUnit unit,
                     std::ostream& out);

}  // namespace limn
