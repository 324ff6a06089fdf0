// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "colmap_ext/host/project.h"
#include "colmap_ext/verbs/drawing_in_scene.h"

namespace limn::colmap_ext {

// Call it before the work: throws IoError if aligned/ cannot be written or replaced
// (CheckAlignedFolder), or the run reads from it.
void CheckAlignedProject(const Project& project, const RunOptions& options);

// Writes aligned/ beside the drawing: the project as its alignment puts it into the world, which
// COLMAP and limn open as a workspace. In it are the model that the drawing fits, links to the
// images, the cloud and the meshes of the dense workspace, the drawing and its page. Depth maps are
// left out: they are in the unit of the model.
//
// Where the world's origin is far away, all coordinates are relative to a point among the cameras,
// which offset.txt tells, so that those in single precision keep their millimeters. The drawing's
// alignment, with which it is stored, is then the way to the world.
//
// Damaged clouds and meshes are left out, with a warning. Throws IoError; then nothing is changed.
// Preconditions: CheckAlignedProject; the drawing has an alignment.
void WriteAlignedProject(const Project& project, const RunOptions& options,
                         const DrawingInScene& drawing, Console* console);

}  // namespace limn::colmap_ext
