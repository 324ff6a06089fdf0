// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// Keys that differ if the inputs of a result differ; see ContentHash.

// The key of a box, or of its absence.
std::string BoxKey(const std::optional<Eigen::AlignedBox3d>& box);

// Name, camera, pose and region of a view, all of its edgels, and its fragments. Linear in the
// number of edgels.
std::string ViewKey(const View& view, const ImageCurves& curves);

// The same of every view.
std::vector<std::string> ViewKeys(const std::vector<View>& views,
                                  const std::vector<ImageCurves>& curves,
                                  const RunContext& context);

// Of all views together: the key of a sketch made from these curves.
std::string CurvesKey(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                      const RunContext& context);

// Of their edgels, where these are in the stored images, and of the fragments: the same for any
// cameras.
std::string StoredCurvesKey(const std::vector<ImageCurves>& curves);

}  // namespace limn
