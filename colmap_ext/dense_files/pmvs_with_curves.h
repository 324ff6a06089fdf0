// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "colmap_ext/dense_files/dense_cloud.h"
#include "limn/dense/curve_points.h"
#include "limn/files/output_path.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Writes, for PMVS's tools: <base>.patch, the patches of `files` if these are .patch files, then
// one oriented patch per sample of the curves with the images that see it (see PmvsNumbers); and
// <base>.ply, all points of these files (opened as `cloud`) and of the curves in PMVS's PLY format,
// with its `quality`, and its colors also as `red`, `green`, `blue`, which other programs read.
// Throws IoError.
void WritePmvsWithCurves(const OutputPath& base, const std::vector<std::filesystem::path>& files,
                         const DenseCloud& cloud, const std::vector<CurvePoint>& points,
                         const std::vector<View>& views);

}  // namespace limn::colmap_ext
