// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/geometry/triangle_mesh.h"
#include "limn/visibility/depth_image.h"

namespace limn {

// The depth of the nearest triangle at the center of every depth pixel of the view's region, both
// sides of a triangle alike. A center on a common edge of two triangles belongs to both, so there
// are no cracks. Triangles that reach behind the camera are clipped. A triangle seen edge on, or
// thinner than the depth pixels, may cover no center. Depths are exact up to rounding to float.
// Deterministic. Time: triangles plus rows and pixels covered.
// Throws InputError if these are too many (RasterWork).
DepthImage RenderDepth(const TriangleMesh& mesh, const View& view, double scale);

}  // namespace limn
