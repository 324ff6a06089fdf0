#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// Texts that differ whenever something differs that results are made from; see ContentHash.

// A box, or that there is none.
std::string BoxKey(const std::optional<Eigen::AlignedBox3d>& box);

// Name, camera, pose and region of a view, all of its edgels, and its fragments. Linear in the
// number of edgels.
std::string ViewKey(const View& view, const ImageCurves& curves);

// The same of every view.
std::vector<std::string> ViewKeys(const std::vector<View>& views,
                                  const std::vector<ImageCurves>& curves,
                                  const RunContext& context);

// Of all views together: what a sketch made from these curves is valid for.
std::string CurvesKey(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                      const RunContext& context);

}  // namespace limn
