#pragma once

#include <vector>

#include "limn/dense/dense_point.h"
#include "limn/visibility/depth_image.h"

namespace limn {

// The depths that views see of a cloud: in every cell the nearest of the points that project into
// it and face the view; points that say by which views they are seen are only seen by those. Cells
// are so large that a view's points would fill them if they were evenly spread, and no larger than
// 16 px. Returns an image per view of [begin, end), without a cell where no point is seen. Reads
// the cloud twice; memory: the images.
std::vector<DepthImage> SplatPoints(const DensePointStream& points, const std::vector<View>& views,
                                    size_t begin, size_t end);

}  // namespace limn
