// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <vector>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// An image with a pose by rigs and frames.
struct MountedImage {
  size_t image = 0;   // index into the model's images
  size_t frame = 0;   // into its frames
  size_t rig = 0;     // into its rigs
  size_t sensor = 0;  // into the rig's sensors
};

// All but images in no frame, of an unknown rig or of a camera without a pose in its rig. The first
// frame of an image counts.
std::vector<MountedImage> MountedImages(const SparseModel& model);

// Those of these images (indices) that are mounted in a rig on which these images show several
// cameras, so that their poses depend on each other.
std::set<size_t> ImagesOfSharedRigs(const std::set<size_t>& images, const SparseModel& model);

// The pose that rigs and frames give to an image.
Rigid3d ComposedPose(const SparseModel& model, const MountedImage& mounted);

// Replaces the poses of the images file by the composed ones, as COLMAP does. The two differ if a
// tool edited only the images file: a warning counts the images whose pose changed by more than
// 1e-6 (rad, or relative to the distances). Images that are not mounted keep their pose, which is
// counted in a warning, as are images in two frames.
void ApplyRigs(SparseModel* model);

}  // namespace limn::colmap_ext
