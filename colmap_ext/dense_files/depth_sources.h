#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limn/dense/dense_point.h"
#include "limn/dense/sample_sights.h"
#include "limn/geometry/triangle_mesh.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Depth maps of a folder stereo/ with the normal maps beside them: the geometric ones, else the
// photometric ones. A view without a map knows no depths. The source throws IoError for maps that
// are damaged or of another shape than their view.
DepthSource DepthMapSource(const std::filesystem::path& stereo_dir, const std::vector<View>& views);

// Number of views that have a depth map there.
size_t CountDepthMaps(const std::filesystem::path& stereo_dir, const std::vector<View>& views);

// Depths that the views see of a cloud (SplatPoints), made for several views at a time; to be asked
// in ascending order.
DepthSource CloudDepthSource(DensePointStream points, const std::vector<View>& views);

// Depths of a mesh (RenderDepth), at one depth pixel per pixel.
DepthSource MeshDepthSource(TriangleMesh mesh, const std::vector<View>& views);

}  // namespace limn::colmap_ext
