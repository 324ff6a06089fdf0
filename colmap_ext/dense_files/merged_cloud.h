// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "limn/dense/curve_points.h"
#include "limn/files/output_path.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// A point of a cloud as COLMAP's fused.ply has it.
struct CloudPoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
  std::array<uint8_t, 3> color;
  std::vector<ViewId> views;
};

// The points of the curves for meshers: every sample once for each known face beside it, with that
// face's normal. Samples without a known face are left out, since a mesher would put a surface
// there. (Additional points on the faces beside the curve made the sample scene's mesh worse.)
std::vector<CloudPoint> PointsForMeshing(const std::vector<CurvePoint>& points);

// Writes a folder for COLMAP's meshers: fused-with-curves.ply, the points of `fused` followed by
// those of the curves, in COLMAP's own format, and fused-with-curves.ply.vis, if `fused` has one,
// in the order of the model's images. fused.ply, fused.ply.vis and sparse/ link to these two and to
// the model (copies where the file system has no links), so that the folder is also a workspace for
// delaunay_mesher. Existing files of these names are replaced; nothing else is touched. Throws
// IoError.
void WriteMeshingFolder(const OutputPath& folder, const std::filesystem::path& fused,
                        const std::filesystem::path& model_dir,
                        const std::vector<CloudPoint>& curve_points,
                        const std::vector<View>& views);

}  // namespace limn::colmap_ext
