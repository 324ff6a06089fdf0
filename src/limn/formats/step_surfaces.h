#pragma once

#include <vector>

#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>

namespace limn {

// Surfaces of faces; only for the writer of STEP files. Sides are edges in the order and direction
// of the border. Null if there is none; may throw Standard_Failure.

// Of four sides, of which the first and the third are rails. A cylinder or a cone if both rails are
// arcs around one axis, to `tolerance` (a length); its parameters do not wrap around within it.
opencascade::handle<Geom_Surface> RuledSurface(const std::vector<std::vector<TopoDS_Edge>>& sides,
                                               double tolerance);

// Between all sides.
opencascade::handle<Geom_Surface> PatchSurface(const std::vector<std::vector<TopoDS_Edge>>& sides,
                                               double tolerance);

}  // namespace limn
