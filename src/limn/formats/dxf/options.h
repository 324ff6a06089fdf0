// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/formats/dimension_lines.h"
#include "limn/formats/dxf/layout.h"
#include "limn/formats/svg/svg_drawing_writer.h"
#include "limn/plans/section.h"

namespace limn {

// How links are assigned to layers of a DXF file.
enum class DxfLayers {
  // "line", "arc", "circle", "spline", "polyline" (links without a primitive); after drawing_fuser
  // with the class appended: "line_boundary".
  kClass,
  // A layer per kind of edge: "edge", "paint", "shadow", "contour", "rod", "texture", "unknown".
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
  // Of the links that are written.
  std::vector<std::optional<EllipticalArc>> ellipses;
  // On the layer "hidden".
  FlatLinks hidden;
  // On the layers "section" (closed or open polylines) and "section_points".
  Section section;
  // True lengths of the drawing's dimensions.
  std::vector<double> lengths;
  DxfLayout layout;
};

struct DxfOptions {
  DxfLayers layers = DxfLayers::kKind;
  // Junctions as points, on a layer "junctions".
  bool junctions = true;
  std::optional<DxfPlan> plan;
  // Plans: a sheet in the paper space, which LibreCAD shows in the model.
  bool paper_space = true;
  // Of dimensions.
  DimensionText dimension_text;
};

}  // namespace limn
