// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "limn/formats/step/borders.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// A sheet as a face of OpenCASCADE between the edges of its border (MakeBorderEdges); only for the
// writer of STEP files. Its side that is seen is that of its orientation. Surfaces: a plane; for
// ruled ones between arcs around one axis a cylinder or cone, else of straight lines from rail to
// rail; for patches of four sides Coons', for others the smoothest surface through the sides.
// Tolerances of edges grow to their distances from the surface. Nothing if these exceed
// `max_gap_rel` of the size of the sheet, the border has more than 500 edges, or OpenCASCADE finds
// no surface or calls the face invalid.
std::optional<TopoDS_Face> MakeStepFace(const DrawingGraph& graph, const BorderSheet& sheet,
                                        const std::vector<TopoDS_Edge>& edges, double max_gap_rel);

}  // namespace limn
