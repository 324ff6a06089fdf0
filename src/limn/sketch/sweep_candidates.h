#pragma once

#include <vector>

#include "limn/sketch/depth_fusion.h"
#include "limn/sketch/epipolar_crossings.h"

namespace limn {

// Depths of one sample on which the image curves of several views agree (algorithm.md 0.2, with
// crossings of epipolar lines in place of sampled depths). Every view has one vote for a depth: its
// crossing with the nearest depth and slope, weighted by tangency. Inverse depth and slope of a
// candidate are the means of its voters by their information. `crossings` are grouped by view;
// `focal_px` is the primary view's. The best come first. Time: crossings x
// crossings per depth.
std::vector<DepthMode> FindAgreeingDepths(const std::vector<EpipolarCrossing>& crossings,
                                          double focal_px, const SketchOptions& options);

}  // namespace limn
