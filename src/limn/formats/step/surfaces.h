// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>

namespace limn {

// Surfaces that faces may have, the best first; only for the writer of STEP files. Sides are edges
// in the order and direction of the border, and must live as long as the result. Each function
// returns null if there is no such surface, and may throw Standard_Failure. `tolerance` is a
// length.
using StepSurfaces = std::vector<std::function<opencascade::handle<Geom_Surface>()>>;

// Of four sides, of which the first and the third are rails: a cylinder or a cone if both rails are
// arcs around one axis, to the tolerance (its parameters do not wrap around between the sides),
// then straight lines from rail to rail.
StepSurfaces RuledSurfaces(const std::vector<std::vector<TopoDS_Edge>>& sides, double tolerance);

// Between all sides: of four the surface of Coons, then the smoothest one through the sides.
StepSurfaces PatchSurfaces(const std::vector<std::vector<TopoDS_Edge>>& sides, double tolerance);

}  // namespace limn
