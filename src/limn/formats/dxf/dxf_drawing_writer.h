#pragma once

#include <iosfwd>
#include <optional>
#include <vector>

#include "limn/formats/dimension_lines.h"
#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"
#include "limn/plans/section.h"
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

// What a flat drawing (flat_drawing.h) shows besides its links, in its coordinates.
struct DxfPlan {
  // Hidden parts, on the layer "hidden".
  std::vector<Polyline3d> hidden;
  // On the layers "section" (closed or open polylines) and "section_points".
  Section section;
  // True lengths of the drawing's dimensions.
  std::vector<double> lengths;
  double text_height = 1;
};

struct DxfOptions {
  DxfLayers layers = DxfLayers::kClass;
  // Junctions as points, on a layer "junctions".
  bool junctions = true;
  std::optional<DxfPlan> plan;
  // Of dimensions.
  DimensionText dimension_text;
};

// Writes a drawing as ASCII DXF of AutoCAD 2000 (AC1015): per link a LINE, ARC, CIRCLE, SPLINE of
// degree 3, or a 3D POLYLINE where it has no primitive. Arcs and circles are in their object
// coordinate system (arbitrary axis algorithm). Faces are polyface meshes of their triangles, on
// the layer "faces" unless each has its own; edges between triangles are invisible. Every entity
// has extended data of the application LIMN: the id of its link, or of its node for points, or of
// its face, or of its dimension or the line or point of the plan (code 1071). Dimensions are
// DIMENSION entities, aligned, each with its block, on the layer "dimensions"; their text, which is
// 1 % of the drawing high but in plans, is the true length. Colors are those of the layers.
void WriteDrawingDxf(const DrawingGraph& graph, const DxfOptions& options, LengthUnit unit,
                     std::ostream& out);

}  // namespace limn
