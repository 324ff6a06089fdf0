// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/dense/dense_point.h"
#include "limn/visibility/depth_image.h"

namespace limn {

// Number of points of a cloud that each view sees: those that project into it and face it. Points
// that list their views are seen by those only. Reads the cloud once.
std::vector<size_t> CountSeenPoints(const DensePointStream& points, const std::vector<View>& views);

// Depth images of a cloud: in every cell the depth of the nearest point seen there, if any. Cells,
// from 1 to 16 px, are so large that the points seen by a view (`num_seen`, of all views) would
// fill them if evenly spread. Returns an image per view of [begin, end). Reads the cloud once;
// memory: the images, NumSplatCells() each.
std::vector<DepthImage> SplatPoints(const DensePointStream& points, const std::vector<View>& views,
                                    const std::vector<size_t>& num_seen, size_t begin, size_t end);

size_t NumSplatCells(const View& view, size_t num_seen);

}  // namespace limn
