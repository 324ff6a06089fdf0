#pragma once

#include <optional>
#include <vector>

#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn {

// Per view, how far the points of the sparse model project from where the view sees them: median,
// stored px. A point behind the view, or farther than the diagonal of the image, counts as the
// diagonal. Nothing for a view with fewer than ten such points. Time: linear.
std::vector<std::optional<double>> MedianReprojectionErrors(const std::vector<View>& views,
                                                            const std::vector<ScenePoint>& points);

}  // namespace limn
