// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/sample_sights.h"

#include <algorithm>
#include <cmath>

#include "limn/dense/depth_tolerance.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

// A single depth in front may be an outlier: at least this many of the nine cells must be nearer.
constexpr int kMinFrontCells = 3;
// Number of further steps to either side at which the surface is examined.
constexpr int kNumProbes = 3;
// Distance to either side of a curve at which the surface is examined, px: there dense depths are
// no longer fattened or rounded.
constexpr double kSideOffsetPx = 4;

class Look {
 public:
  Look(const View& view, const DepthImage& image, const DenseOptions& options, double depth)
      : view_(view),
        image_(image),
        depth_(depth),
        footprint_(depth / view.camera.MeanFocal()),
        cell_px_(image.cell_px.maxCoeff()),
        tolerance_px_(options.depth_tolerance_px),
        near_px_(options.near_px) {}

  Sight SightAt(const Eigen::Vector2i& cell, bool* touches) const {
    int num_near = 0;
    int num_front = 0;
    int num_behind = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Eigen::Vector2i around = cell + Eigen::Vector2i(dx, dy);
        *touches |= IsNear(around, near_px_, cell_px_);
        switch (Compare(around, cell_px_)) {
          case Side::kNear:
            ++num_near;
            break;
          case Side::kFront:
            ++num_front;
            break;
          case Side::kBehind:
            ++num_behind;
            break;
          case Side::kUnknown:
            break;
        }
      }
    }
    if (num_near > 0) return Sight::kVisible;
    if (num_front > num_behind) {
      return num_front >= kMinFrontCells ? Sight::kOccluded : Sight::kUnknown;
    }
    return num_behind > 0 ? Sight::kVisible : Sight::kUnknown;
  }

  // The nearest of the probes in this direction that is at the curve's depth decides, else most.
  void LookAside(const Eigen::Vector2d& pixel, const Eigen::Vector2d& direction, double offset_px,
                 Side* side, std::optional<Eigen::Vector3d>* normal) const {
    int num_front = 0;
    int num_behind = 0;
    for (int k = 0; k < kNumProbes; ++k) {
      const double distance = offset_px + k * cell_px_;
      const Eigen::Vector2i cell = image_.CellAt(pixel + distance * direction);
      const Side here = Compare(cell, distance);
      num_front += here == Side::kFront;
      num_behind += here == Side::kBehind;
      if (here != Side::kNear) continue;
      *side = Side::kNear;
      *normal = NormalAt(view_, image_, cell.x(), cell.y());
      return;
    }
    if (num_front + num_behind > 0) *side = num_front > num_behind ? Side::kFront : Side::kBehind;
  }

  double cell_px() const { return cell_px_; }

 private:
  bool IsNear(const Eigen::Vector2i& cell, double allowed_px, double distance_px) const {
    const double surface = image_.DepthOr0(cell.x(), cell.y());
    return surface > 0 &&
           std::abs(surface - depth_) <= DepthTolerancePx(allowed_px, distance_px) * footprint_;
  }

  Side Compare(const Eigen::Vector2i& cell, double distance_px) const {
    const double surface = image_.DepthOr0(cell.x(), cell.y());
    if (!(surface > 0)) return Side::kUnknown;
    if (IsNear(cell, tolerance_px_, distance_px)) return Side::kNear;
    return surface < depth_ ? Side::kFront : Side::kBehind;
  }

  const View& view_;
  const DepthImage& image_;
  double depth_;
  double footprint_;
  double cell_px_;
  double tolerance_px_;
  double near_px_;
};

// Left and right are the same for all views that look at a surface from outside.
void Add(const SampleSight& sight, ViewId view, SampleSupport* support) {
  if (sight.sight == Sight::kOccluded) support->occluded_in.push_back(view);
  if (sight.sight != Sight::kVisible) return;
  support->visible_in.push_back(view);
  support->num_touching += sight.touches;
  const auto count = [&](Side side) {
    return std::count(sight.sides.begin(), sight.sides.end(), side);
  };
  for (const int s : {0, 1}) {
    if (sight.normals[s]) support->normal[s] += *sight.normals[s];
  }
  if (count(Side::kUnknown) > 0 || count(Side::kFront) > 0) return;
  support->num_surface += count(Side::kNear) == 2;
  support->num_boundary += count(Side::kNear) == 1;
  support->num_free += count(Side::kNear) == 0;
}

}  // namespace

SampleSight LookAtSample(const View& view, const DepthImage& image, const Eigen::Vector3d& position,
                         const Eigen::Vector3d& tangent, const DenseOptions& options) {
  SampleSight result;
  const auto pixel = view.Project(position);
  if (!pixel) return result;
  const Look look(view, image, options, (view.cam_from_world * position).z());
  result.sight = look.SightAt(image.CellAt(*pixel), &result.touches);
  const auto direction = ProjectedDirection(view, position, tangent);
  if (result.sight != Sight::kVisible || !direction) return result;
  // Left of the direction, where y points down.
  const Eigen::Vector2d left(direction->y(), -direction->x());
  const double offset_px = std::max(kSideOffsetPx, 2 * look.cell_px());
  look.LookAside(*pixel, left, offset_px, &result.sides[0], &result.normals[0]);
  look.LookAside(*pixel, -left, offset_px, &result.sides[1], &result.normals[1]);
  return result;
}

std::vector<SampleSupport> FindSampleSupport(const DrawingSamples& samples,
                                             const std::vector<View>& views,
                                             const DepthSource& depths, const DenseOptions& options,
                                             const RunContext& context) {
  std::vector<SampleSupport> support(samples.size());
  RunContext quiet = context;  // one report per view would drown the others
  quiet.progress = nullptr;
  for (size_t v = 0; v < views.size(); ++v) {
    const std::optional<DepthImage> image = depths(static_cast<ViewId>(v));
    if (!image) continue;
    ParallelFor(quiet, "looking at samples", samples.size(), [&](size_t s) {
      Add(LookAtSample(views[v], *image, samples.position[s], samples.tangent[s], options),
          static_cast<ViewId>(v), &support[s]);
    });
  }
  for (SampleSupport& of_sample : support) {
    for (Eigen::Vector3d& normal : of_sample.normal) {
      if (normal.norm() > 0) normal.normalize();
    }
  }
  return support;
}

}  // namespace limn
