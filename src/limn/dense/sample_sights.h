// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/dense/dense_options.h"
#include "limn/dense/drawing_samples.h"
#include "limn/util/parallel.h"
#include "limn/visibility/depth_image.h"

namespace limn {

enum class Sight : uint8_t {
  kUnknown,   // outside the image, or no depth is known around
  kVisible,   // on the surface or in front of it
  kOccluded,  // behind it
};

// The surface on one side of a curve, as a view sees it.
enum class Side : uint8_t {
  kUnknown,
  kNear,    // continues at the curve's depth
  kBehind,  // is farther away: the curve stands in front of it
  kFront,   // is nearer: it belongs to something in front of the curve
};

// One sample as one view sees it.
struct SampleSight {
  Sight sight = Sight::kUnknown;
  // Whether one of the nine cells around it agrees in depth to within near_px plus the change of a
  // sloped surface over a cell.
  bool touches = false;
  std::array<Side, 2> sides = {Side::kUnknown, Side::kUnknown};  // left, right of the curve
  // Normals of the near sides, in the world.
  std::array<std::optional<Eigen::Vector3d>, 2> normals;
};

// Compares a sample with the depths in the nine cells around its projection
// (algorithm/dense.md#samples-against-depths). It is visible if one of them is at its depth or if
// at least as many are behind it as in front, and occluded if more, and at least three, are in
// front. The tolerance is that of the options plus the gain in depth of a surface at 60 degrees.
// Sides are examined across the projected curve, at 4 px or two cells, whichever is more.
SampleSight LookAtSample(const View& view, const DepthImage& image, const Eigen::Vector3d& position,
                         const Eigen::Vector3d& tangent, const DenseOptions& options);

// Summary of a sample over all views.
struct SampleSupport {
  std::vector<ViewId> visible_in;  // ascending
  std::vector<ViewId> occluded_in;
  int num_touching = 0;  // views
  // Views in which the surface continues on both sides, on one side, on neither.
  int num_surface = 0;
  int num_boundary = 0;
  int num_free = 0;
  // Means over the views of the normals on either side; zero if unknown. Left and right as seen
  // from outside the surface, walking along the tangent.
  std::array<Eigen::Vector3d, 2> normal = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

// Returns the depth image of a view; empty if it has none.
using DepthSource = std::function<std::optional<DepthImage>(ViewId)>;

// Looks at all samples in all views. The depth image of a view is requested once, and each thread
// holds one at a time. Time: samples times views.
std::vector<SampleSupport> FindSampleSupport(const DrawingSamples& samples,
                                             const std::vector<View>& views,
                                             const DepthSource& depths, const DenseOptions& options,
                                             const RunContext& context);

}  // namespace limn
