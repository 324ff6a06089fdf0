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

// The surface beside a curve, as a view sees it.
enum class Side : uint8_t {
  kUnknown,
  kNear,    // goes on at the curve's depth
  kBehind,  // is farther away: the curve stands out before it
  kFront,   // is nearer: it belongs to something that stands before the curve
};

// What one view says of one sample.
struct SampleSight {
  Sight sight = Sight::kUnknown;
  // One of the nine cells around is nearer in depth than near_px and what a slope makes of a cell.
  bool touches = false;
  std::array<Side, 2> sides = {Side::kUnknown, Side::kUnknown};  // left, right of the curve
  // Of the near sides, in the world.
  std::array<std::optional<Eigen::Vector3d>, 2> normals;
};

// Compare a sample with the depths around its projection. The nine cells around it are asked: it is
// visible if one of them is at its depth or if at least as many are behind it as are nearer, and
// occluded if more, and three or more, are nearer;
// the tolerance is that of the options, plus what a surface at 60 degrees gains in depth. Sides are
// looked at across the projected curve, at side_offset_px or two cells, whichever is more.
SampleSight LookAtSample(const View& view, const DepthImage& image, const Eigen::Vector3d& position,
                         const Eigen::Vector3d& tangent, const DenseOptions& options);

// What all views together say of a sample.
struct SampleSupport {
  std::vector<ViewId> visible_in;  // ascending
  std::vector<ViewId> occluded_in;
  int num_touching = 0;  // views
  // Views in which the surface goes on at both sides, at one of them, at none.
  int num_surface = 0;
  int num_boundary = 0;
  int num_free = 0;
  // Means over the views of the normals on either side; zero if unknown. Left and right as seen
  // from outside the surface, walking along the tangent.
  std::array<Eigen::Vector3d, 2> normal = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

// The depths that a view sees; nothing if none are known for it.
using DepthSource = std::function<std::optional<DepthImage>(ViewId)>;

// Ask all views of all samples. Depth images are asked for once per view, one at a time per thread.
// Time: samples times views.
std::vector<SampleSupport> FindSampleSupport(const DrawingSamples& samples,
                                             const std::vector<View>& views,
                                             const DepthSource& depths, const DenseOptions& options,
                                             const RunContext& context);

}  // namespace limn
