// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/formats/dxf/options.h"
#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"

namespace limn {

// Writes a drawing as ASCII DXF of AutoCAD 2000 (AC1015): per link a LINE, ARC, CIRCLE, SPLINE of
// degree 3, or a 3D POLYLINE where it has no primitive. Arcs and circles are in their object
// coordinate system (arbitrary axis algorithm). Faces are polyface meshes of their triangles, on
// the layer "faces" unless each has its own; edges between triangles are invisible. In plans chains
// of lines and arcs are LWPOLYLINEs (chains.h), arcs seen at an angle ELLIPSEs, and the paper space
// is a sheet (layout.h). Every entity of the model space has extended data of the application LIMN:
// the number of its link (of chains those of all), or of its node for points, or of its face, or of
// its dimension or the line or point of the plan (code 1071); of rods also the radius, as a
// distance that is scaled with the entity (code 1041). Dimensions are DIMENSION entities, aligned,
// each with its block, on the layer "dimensions"; their text, which is 1 % of the drawing high but
// in plans, is the true length. Colors are those of the layers.
void WriteDrawingDxf(const DrawingGraph& graph, const DxfOptions& options, LengthUnit unit,
                     std::ostream& out);

}  // namespace limn
