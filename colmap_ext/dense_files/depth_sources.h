// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limn/dense/dense_point.h"
#include "limn/dense/sample_sights.h"
#include "limn/geometry/triangle_mesh.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Depth maps of a folder stereo/ with their normal maps: the geometric ones, else the photometric
// ones. All depths of a view without a map are unknown. The source throws IoError for maps that are
// damaged or whose aspect is not that of their view.
DepthSource DepthMapSource(const std::filesystem::path& stereo_dir, const std::vector<View>& views);

// Number of views with a depth map in that folder.
size_t CountDepthMaps(const std::filesystem::path& stereo_dir, const std::vector<View>& views);

// Depths of a cloud (SplatPoints), made for several views at a time; views must be requested in
// ascending order.
DepthSource CloudDepthSource(DensePointStream points, const std::vector<View>& views);

// Depths of a mesh (RenderDepth), one depth pixel per pixel.
DepthSource MeshDepthSource(TriangleMesh mesh, const std::vector<View>& views);

}  // namespace limn::colmap_ext
