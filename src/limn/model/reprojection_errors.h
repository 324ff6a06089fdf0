// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn {

// Per image, how far the points of the sparse model project from where its views see them: median,
// stored px. A point behind the view, or farther than the diagonal of the view, counts as the
// diagonal. Nothing for an image with fewer than ten such points. `image_of_view`, ascending from
// 0: several views are one image where they are its parts. Time: linear.
std::vector<std::optional<double>> MedianReprojectionErrors(const std::vector<View>& views,
                                                            const std::vector<ScenePoint>& points,
                                                            const std::vector<int>& image_of_view);

}  // namespace limn
