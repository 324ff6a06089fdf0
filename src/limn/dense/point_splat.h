#pragma once

#include <vector>

#include "limn/dense/dense_point.h"
#include "limn/visibility/depth_image.h"

namespace limn {

// How many points of a cloud each view sees: those that project into it and face it; points that
// say by which views they are seen are only seen by those. Reads the cloud once.
std::vector<size_t> CountSeenPoints(const DensePointStream& points, const std::vector<View>& views);

// The depths that views see of a cloud: in every cell the nearest of the points seen there. Cells
// are so large that the points seen by a view (`num_seen`, of all views) would fill them if they
// were evenly spread, from 1 to 16 px. Returns an image per view of [begin, end), without a cell
// where no point is seen. Reads the cloud once; memory: the images, NumSplatCells() each.
std::vector<DepthImage> SplatPoints(const DensePointStream& points, const std::vector<View>& views,
                                    const std::vector<size_t>& num_seen, size_t begin, size_t end);

size_t NumSplatCells(const View& view, size_t num_seen);

}  // namespace limn
